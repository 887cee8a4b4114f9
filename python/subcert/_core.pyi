# The extension module, which takes and gives plain values: pairs of ends for enclosures, of a word and a reason for
# answers, of coefficients and the lowest exponent for polynomials. What users call stands in the other modules.
from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, Optional

import numpy

_Certificates = list[tuple[str, Optional[str], Optional[str], Optional[str], Optional[str]]]
_Ends = tuple[Optional[Fraction], Optional[Fraction]]
_Answer = tuple[str, str]
_Polynomial = tuple[list[Fraction], int]
_Progress = Optional[Callable[[float], Any]]
_Array = numpy.ndarray[Any, numpy.dtype[numpy.float64]]

version: str
default_bits: int

def bits_for_width(width: Fraction) -> int: ...
def word_text(word: Sequence[int]) -> str: ...
def enclosure_text(enclosure: _Ends, digits: int) -> str: ...
def latex_formula(text: str) -> str: ...

class Scheme:
    specification: str
    title: str
    dimension: int
    dilation: list[list[int]]
    components: int
    terms: list[tuple[list[int], int, int, Fraction]]
    arity: int
    symbol: _Polynomial
    rounding: Optional[Fraction]

class DataDependentScheme:
    specification: str
    title: str
    dimension: int

class ParametricScheme:
    specification: str
    title: str
    parameter: str
    sum_rules: int
    def at(self, value: Fraction) -> str: ...

class HolderEvidence:
    facts: str
    exact: dict[str, Any]
    def certificate(self) -> Optional[_Certificates]: ...

class RadiusEvidence:
    facts: dict[str, Any]
    def certificate(self) -> _Certificates: ...

class SubradiusEvidence:
    facts: dict[str, Any]
    def certificate(self) -> _Certificates: ...

class RangeEvidence:
    facts: dict[str, Any]
    def certificates(self) -> list[tuple[Fraction, Fraction, str, str, Optional[str], Optional[str]]]: ...

class LevelsEvidence:
    facts: dict[str, Any]
    def certificates(self) -> list[tuple[Fraction, Fraction, str, str, Optional[str], Optional[str]]]: ...

class LocalEvidence:
    order: int
    exponent: tuple[Optional[Fraction], Optional[Fraction]]
    def certificates(self) -> list[tuple[Fraction, Fraction, str, str, Optional[str], Optional[str]]]: ...

class ListEvidence:
    facts: dict[str, Any]
    def certificates(self) -> list[tuple[str, Optional[str], Optional[str], Optional[str], Optional[int]]]: ...

class CurveEvidence:
    facts: dict[str, Any]
    def certificates(self) -> list[tuple[Fraction, Fraction, str, str, Optional[str], Optional[str]]]: ...

def make_any_scheme(specification: str) -> Scheme | DataDependentScheme: ...
def make_parametric_scheme(specification: str) -> ParametricScheme: ...
def families() -> list[tuple[str, str, str]]: ...
def multivariate_families() -> list[tuple[str, str, str]]: ...
def vector_families() -> list[tuple[str, str, str]]: ...
def facts(scheme: Scheme) -> str: ...
def analyze(scheme: Scheme, levels: int, budget: float, progress: _Progress) -> str: ...
def analyze_l1(scheme: DataDependentScheme, steps: int, order: int, budget: float, progress: _Progress) -> str: ...
def remaining_factor(scheme: Scheme) -> _Polynomial: ...
def symbol_text(symbol: _Polynomial) -> str: ...
def symbol_latex(symbol: _Polynomial) -> str: ...
def stable(scheme: Scheme) -> _Answer: ...
def converges(scheme: Scheme, levels: int, budget: float, progress: _Progress) -> _Answer: ...
def smoothness(scheme: Scheme, levels: int, budget: float, progress: _Progress) -> tuple[int, str, str]: ...
def holder(
    scheme: Scheme, levels: int, budget: float, memory: int, bits: int, certificate: bool, component: Optional[int],
    progress: _Progress
) -> HolderEvidence: ...
def vector_scheme_certificate(
    scheme: Scheme, budget: float, progress: _Progress
) -> list[tuple[str, Optional[str], Optional[str], Optional[str], Optional[str], Optional[int], Optional[str]]]: ...
def frequency_bound(scheme: Scheme, progress: _Progress) -> Optional[Fraction]: ...
def sobolev(scheme: Scheme, budget: float, progress: _Progress) -> Optional[_Ends]: ...
def jsr(
    matrices: Sequence[Sequence[Sequence[Fraction]]],
    edges: Sequence[tuple[int, int, int]],
    budget: float,
    memory: int,
    bits: int,
    progress: _Progress,
) -> RadiusEvidence: ...
def subradius(
    matrices: Sequence[Sequence[Sequence[Fraction]]], budget: float, memory: int, bits: int, progress: _Progress
) -> SubradiusEvidence: ...
def p_radius(
    matrices: Sequence[Sequence[Sequence[Fraction]]], p: int, bits: int, budget: float, progress: _Progress
) -> _Ends: ...
def limit_values(scheme: Scheme, level: int, derivative: int, progress: _Progress) -> tuple[int, list[Fraction]]: ...
def rounded_limit_values(scheme: Scheme, level: int, derivative: int, progress: _Progress) -> tuple[_Array, _Array]: ...
def surface_limit_values(
    scheme: Scheme, level: int, budget: float, progress: _Progress
) -> tuple[list[list[Fraction]], list[Fraction]]: ...
def vector_limit_values(
    scheme: Scheme, level: int, budget: float, exact: bool, progress: _Progress
) -> tuple[list[list[Fraction]], list[list[Any]]]: ...
def limit_range(scheme: Scheme, width: Fraction, budget: float, progress: _Progress) -> dict[str, Any]: ...
def variance_grid(scheme: Scheme, level: int, progress: _Progress) -> list[Fraction]: ...
def variance_range(scheme: Scheme, width: Fraction, budget: float, progress: _Progress) -> dict[str, Any]: ...
def property_range(
    scheme: ParametricScheme,
    property: str,
    low: Fraction,
    high: Fraction,
    width: Fraction,
    budget: float,
    jobs: int,
    progress: _Progress,
) -> RangeEvidence: ...
def property_of_levels(
    scheme: ParametricScheme,
    property: str,
    low: Fraction,
    high: Fraction,
    recurrence: Optional[str],
    start: tuple[Fraction, Optional[Fraction]],
    budget: float,
    progress: _Progress,
) -> LevelsEvidence: ...
def exponent_of_levels(
    schemes: Sequence[str],
    period: Sequence[int],
    follows: Sequence[tuple[int, int]],
    budget: float,
    progress: _Progress,
) -> ListEvidence: ...
def local_levels(
    scheme: ParametricScheme, low: Fraction, high: Fraction, budget: float, progress: object
) -> LocalEvidence: ...
def limit_of_levels(
    scheme: ParametricScheme, recurrence: str, low: Fraction, high: Fraction, budget: float, progress: object
) -> dict[str, Any]: ...
def exponent_curve(
    scheme: ParametricScheme, low: Fraction, high: Fraction, pieces: int, budget: float, jobs: int, progress: _Progress
) -> CurveEvidence: ...
def masks_of_levels(scheme: ParametricScheme, recurrence: str, start: Fraction, levels: int) -> list[str]: ...
def limit_values_of_levels(
    scheme: ParametricScheme, recurrence: str, start: Fraction, level: int, progress: _Progress
) -> tuple[int, int, list[_Ends]]: ...
def limit_values_in_turn(
    first: Sequence[str], again: Sequence[str], level: int, budget: float, progress: _Progress
) -> tuple[int, list[int], list[Any]]: ...
def refine(
    specifications: Sequence[str],
    values: _Array,
    closed: Sequence[bool],
    levels: int,
    boundary: str,
    constant: float,
    limit: bool,
    jobs: int,
    progress: _Progress,
) -> tuple[_Array, list[tuple[Fraction, Fraction]]]: ...
def refine_mesh(
    scheme: Any,
    vertices: _Array,
    corners: Any,
    sides: Any,
    levels: int,
    limit: bool,
    normals: bool,
    crease: Optional[float],
    keep_faces: bool,
    progress: _Progress,
) -> tuple[_Array, _Array, _Array]: ...
def vertex_scheme(scheme: Any) -> Any: ...
def read_vertex_rules(text: str, file: str) -> Any: ...
def vertices(
    scheme: Any, valences: Sequence[int], budget: float, progress: _Progress
) -> list[tuple[Any, ...]]: ...
def every_valence(
    scheme: Any, first: int, budget: float, progress: _Progress
) -> tuple[int, Any, list[tuple[int, Optional[int]]], int]: ...
def vertex_stencils(
    scheme: Any, valence: int, budget: float, progress: _Progress
) -> list[list[tuple[tuple[int, int], int, Any, Optional[str]]]]: ...
def vertex_ranges(
    scheme: Any,
    letter: str,
    property: str,
    low: Fraction,
    high: Fraction,
    width: Fraction,
    valences: Sequence[int],
    budget: float,
    jobs: int,
    progress: _Progress,
) -> list[tuple[int, list[tuple[Any, ...]], list[tuple[Any, ...]]]]: ...
def vertex_map(
    scheme: Any,
    letters: Sequence[str],
    property: str,
    low: Sequence[Fraction],
    high: Sequence[Fraction],
    valence: int,
    resolution: int,
    budget: float,
    jobs: int,
    progress: _Progress,
) -> tuple[list[tuple[Any, ...]], bool]: ...
def smooth(
    y: _Array,
    x: Optional[_Array],
    weights: Sequence[Fraction],
    origin: Fraction,
    spacing: Optional[Fraction],
    scheme: str,
    boundary: str,
    constant: float,
    level: int,
    derivative: int,
    bands: float,
    kind: str,
    irregular: Optional[bool],
    at: str,
    places: Optional[_Array],
    noise: Optional[float],
    slopes: Optional[_Array],
    slope_noise: Optional[float],
    select: str,
    resamples: int,
    seed: int,
    jobs: int,
    progress: _Progress,
) -> dict[str, Any]: ...
def smooth_grid(
    values: _Array,
    scheme: str,
    boundary: str,
    constant: float,
    level: int,
    bands: float,
    kind: str,
    at: str,
    noise: Optional[float],
    missing: str,
    jobs: int,
    progress: _Progress,
) -> dict[str, Any]: ...
def finds_its_noise(specification: str) -> bool: ...
def remark_on_correlations(found: Sequence[tuple[str, float]]) -> str: ...
def all_cores() -> int: ...
def check_file(text: str, file: str, program: str) -> tuple[bool, str]: ...
def check_certificate(text: str, matrices: str, program: str) -> tuple[bool, str]: ...
def statements(wanted: Sequence[str]) -> str: ...
def check_statements(wanted: Sequence[str], wide: bool, jobs: int, progress: _Progress) -> str: ...
def check_properties(text: str, budget: float, jobs: int, progress: _Progress) -> list[dict[str, Any]]: ...
def papers() -> dict[str, list[str]]: ...
def reproduce(paper: str, only: Sequence[str], jobs: int, progress: _Progress) -> str: ...
