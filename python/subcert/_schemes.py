"""Schemes: their masks and symbols, and what is proved about them."""

from __future__ import annotations

import dataclasses
import functools
import json
import math
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Iterable, Optional, Sequence, Union

from . import _display, _plots
from ._calls import core as _core
from ._certificates import Certificate, strongest
from ._errors import DomainError
from ._exact import Decision, Enclosure, Exact, bits_of, fraction, optional_enclosure
from ._regularity import Computation, HolderExponent, Progress, exponent_of

if TYPE_CHECKING:
    import numpy


@dataclasses.dataclass(frozen=True, repr=False)
class Symbol:
    """The Laurent polynomial sum of coefficients[k] z^(lowest + k) with exact coefficients.

    >>> import subcert
    >>> a = subcert.mask([1, 3, 3, 1], 4).symbol
    >>> a(1), a(-1), str(a)
    (Fraction(2, 1), Fraction(0, 1), '1/4*z^-2 + 3/4*z^-1 + 3/4 + 1/4*z')
    """

    coefficients: tuple[Fraction, ...]
    lowest: int

    def __call__(self, z: Exact) -> Fraction:
        """The exact value at z, not 0 where an exponent is negative."""
        x = fraction(z)
        value = Fraction(0)
        for c in reversed(self.coefficients):
            value = value * x + c
        return value * x**self.lowest

    def __str__(self) -> str:
        return _core.symbol_text((list(self.coefficients), self.lowest))

    def __repr__(self) -> str:
        text = str(self)
        return f"<Symbol {text if len(text) <= 60 else text[:57] + '...'}>"

    def to_latex(self) -> str:
        """The sum of its terms, for a formula.

        >>> print(Symbol((Fraction(1, 4), Fraction(-1)), -2).to_latex())
        \\frac{1}{4} z^{-2} - z^{-1}
        """
        return _core.symbol_latex((list(self.coefficients), self.lowest))

    def _repr_latex_(self) -> str:
        return f"${self.to_latex()}$"

    def to_sympy(self, z: Any = None) -> Any:
        """The same for sympy; `z`: the symbol to use, named z where none is given."""
        import sympy

        z = sympy.Symbol("z") if z is None else z
        return sum(
            (
                sympy.Rational(c.numerator, c.denominator) * z ** (self.lowest + k)
                for k, c in enumerate(self.coefficients)
            ),
            sympy.Integer(0),
        )


def _symbol(pair: tuple[list[Fraction], int]) -> Symbol:
    return Symbol(tuple(pair[0]), pair[1])


@dataclasses.dataclass(frozen=True)
class LimitRange:
    """Bounds of the basic limit function phi over the line, each with its width."""

    maximum: Enclosure
    minimum: Enclosure
    sup_norm: Enclosure
    slope: Optional[Enclosure]
    """Of |phi'|; None where nothing is proved, and slope_reason says why."""
    slope_reason: str
    l1_norm: Enclosure
    complete: bool
    """All enclosures are as narrow as was asked for."""


@dataclasses.dataclass(frozen=True)
class VarianceRange:
    """Bounds of the variance curve psi over a period."""

    maximum: Enclosure
    minimum: Enclosure
    slope: Optional[Enclosure]
    slope_reason: str
    mean: Fraction
    complete: bool


class Named:
    """What schemes and families share: they are equal, hashed, printed and pickled by their specification."""

    _handle: Any

    def __init__(self, handle: Any) -> None:
        self._handle = handle

    @property
    def specification(self) -> str:
        """The canonical text that names the scheme."""
        return self._handle.specification

    @property
    def title(self) -> str:
        """A name for people."""
        return self._handle.title

    def __repr__(self) -> str:
        text = self.specification
        return f"<subcert {text if len(text) <= 60 else text[:57] + '...'}: {self.title}>"

    def __str__(self) -> str:
        return self.specification

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Named) and type(other) is type(self) and self.specification == other.specification

    def __hash__(self) -> int:
        return hash(self.specification)

    def __reduce__(self) -> Any:
        return scheme, (self.specification,)

    def refine(self, data: Any, levels: int = 1, **options: Any) -> Any:
        """Applies the scheme to data: see subcert.refine."""
        from ._data import refine

        return refine(self, data, levels, **options)


def _exponent(
    scheme: Named,
    levels: int,
    budget: float,
    memory: int,
    width: Optional[Exact],
    certificate: bool,
    component: Optional[int],
    progress: Progress,
) -> HolderExponent:
    arguments = (scheme._handle, levels, budget, memory, bits_of(width))
    again = Computation("holder", (*arguments, True, component, None))
    return exponent_of(_core.holder(*arguments, certificate, component, progress), again)


class LinearScheme(Named):
    """A scheme with a mask."""

    @functools.cached_property
    def facts(self) -> dict[str, Any]:
        """What follows from the mask alone, by the keys of `subcert analyze --json`; exact numbers are texts."""
        return json.loads(_core.facts(self._handle))

    def to_dict(self) -> dict[str, Any]:
        """These facts, as plain values for JSON."""
        return dict(self.facts)

    def analyze(self, levels: int = 16, budget: float = 10, progress: Progress = None) -> dict[str, Any]:
        """The page of `subcert analyze --json`: these facts, convergence, smoothness and what else the time allows.

        >>> import subcert
        >>> subcert.scheme("dd:n=2").analyze()["smoothness"]["proved"]
        1
        """
        return json.loads(_core.analyze(self._handle, levels, budget, progress))

    def _holder(
        self, levels: int, budget: float, memory: int, width: Optional[Exact], certificate: bool, progress: Progress
    ) -> HolderExponent:
        return _exponent(self, levels, budget, memory, width, certificate, None, progress)


class Scheme(LinearScheme):
    """A linear scheme of one variable.

    >>> import subcert
    >>> s = subcert.scheme("primal:n=2")
    >>> s.mask
    (Fraction(1, 4), Fraction(1, 3), Fraction(1, 4), Fraction(1, 3), Fraction(1, 4), Fraction(1, 3), Fraction(1, 4))
    """

    @property
    def arity(self) -> int:
        return self._handle.arity

    @functools.cached_property
    def symbol(self) -> Symbol:
        return _symbol(self._handle.symbol)

    @property
    def mask(self) -> tuple[Fraction, ...]:
        """The coefficients a_i of f'_i = sum over j of a_(i - arity j) f_j, from `first_index` on."""
        return self.symbol.coefficients

    @property
    def first_index(self) -> int:
        return self.symbol.lowest

    @property
    def rounding(self) -> Optional[Fraction]:
        """Where the coefficients that are meant are not rational: how far the rational ones are from them at most."""
        return self._handle.rounding

    @property
    def sum_rules(self) -> int:
        """The multiplicity of 1 + z + ... + z^(arity-1) in the symbol."""
        return self.facts["sum_rules"]

    @property
    def remaining_factor(self) -> Symbol:
        """The symbol divided by all of these factors."""
        return _symbol(_core.remaining_factor(self._handle))

    @property
    def support(self) -> tuple[Fraction, Fraction]:
        """Of the basic limit function."""
        ends = self.facts["support"]
        return Fraction(ends["lower"]), Fraction(ends["upper"])

    @property
    def symmetry(self) -> str:
        """``odd`` about an integer, ``even`` about a half-integer, or ``none``."""
        return self.facts["symmetry"]

    @property
    def generation_degree(self) -> int:
        return self.facts["generation_degree"]

    @property
    def reproduction_degree(self) -> int:
        """Polynomials of this degree are reproduced, the datum f_j attached to j + parametrization; -1: not even
        constants."""
        return self.facts["reproduction_degree"]

    @property
    def parametrization(self) -> Fraction:
        return Fraction(self.facts["parametrization"])

    def converges(self, levels: int = 16, budget: float = 20, progress: Progress = None) -> Decision:
        """Whether the scheme converges uniformly for all bounded data."""
        return Decision._of(_core.converges(self._handle, levels, budget, progress))

    def stable(self) -> Decision:
        """Whether the integer shifts of the basic limit function are stable. Domain: schemes that converge."""
        return Decision._of(_core.stable(self._handle))

    def smoothness(self, levels: int = 16, budget: float = 20, progress: Progress = None) -> tuple[int, str, str]:
        """The largest k for which C^k limits are proved by contraction (-1: none), the evidence, and what stops k +
        1. For the true order ask holder()."""
        return _core.smoothness(self._handle, levels, budget, progress)

    def holder(
        self,
        budget: float = 60,
        *,
        levels: int = 16,
        memory: int = 1024,
        width: Optional[Exact] = None,
        certificate: bool = False,
        progress: Progress = None,
    ) -> HolderExponent:
        """The Hoelder exponent, enclosed with proof.

        `budget`: seconds of processor time. `memory`: MiB. `width`: at most so wide, where a product is proved to
        attain the radius. `certificate`: look at once for evidence that a certificate can hold, also where a shorter
        argument exists.
        Raises DomainError for coset sums other than 1."""
        return self._holder(levels, budget, memory, width, certificate, progress)

    def frequency_bound(self, progress: Progress = None) -> Optional[Fraction]:
        """A proved lower end of the Hoelder exponent by a function of frequency; None where none is found.

        For masks of any size and arity within seconds. Raises DomainError for a mask that is not exact.

        >>> import subcert
        >>> float(subcert.scheme("primal:n=100").frequency_bound()) > 1.9999
        True
        """
        return _core.frequency_bound(self._handle, progress)

    def sobolev(self, budget: float = 60, progress: Progress = None) -> Optional[Enclosure]:
        """The Sobolev (L2) exponent; None where it takes longer than that. No upper end: a lower bound."""
        return optional_enclosure(_core.sobolev(self._handle, budget, progress))

    def limit(
        self, level: int = 8, *, derivative: int = 0, exact: bool = False, progress: Progress = None
    ) -> tuple[Any, Any]:
        """x and y: the basic limit function, or a derivative, at the points i / arity^level of its support.

        Arrays of numpy, rounded from the exact values; with `exact` lists of Fractions. Raises DomainError for a
        scheme that does not converge or a derivative that is not continuous, UndecidedError where neither that nor the
        contrary is proved.

        >>> import subcert
        >>> x, y = subcert.scheme("four-point:w=1/16").limit(1, exact=True)
        >>> y[5], x[5]
        (Fraction(9, 16), Fraction(-1, 2))
        """
        if not exact:
            return _core.rounded_limit_values(self._handle, level, derivative, progress)
        first, values = _core.limit_values(self._handle, level, derivative, progress)
        return [Fraction(first + i, self.arity**level) for i in range(len(values))], values

    def limit_range(self, width: Exact = "1e-6", budget: float = 60, progress: Progress = None) -> LimitRange:
        """Bounds of the basic limit function between all points. `width`: relative."""
        facts = _core.limit_range(self._handle, fraction(width), budget, progress)
        return LimitRange(**{k: _ends(v) for k, v in facts.items()})

    def variance(self, level: int = 8, progress: Progress = None) -> list[Fraction]:
        """psi(i / arity^level), i = 0, ..., arity^level: the variance of the limit for data with independent noise of
        variance 1, exact."""
        return _core.variance_grid(self._handle, level, progress)

    def variance_range(self, width: Exact = "1e-6", budget: float = 60, progress: Progress = None) -> VarianceRange:
        """The certified maximum, minimum and largest slope of psi.

        >>> import subcert
        >>> print(subcert.scheme("primal:n=2").variance_range().maximum.text(6))
        0.548387
        """
        facts = _core.variance_range(self._handle, fraction(width), budget, progress)
        return VarianceRange(**{k: _ends(v) for k, v in facts.items()})

    def smooth(self, y: Any, **options: Any) -> Any:
        """Smooths samples by the limit of this scheme: see subcert.smooth."""
        from ._data import smooth

        return smooth(y, scheme=self, **options)

    def to_latex(self) -> str:
        """The mask over its common denominator.

        >>> import subcert
        >>> print(subcert.scheme("dd:n=2").to_latex())
        \\frac{1}{16}\\left[-1,\\,0,\\,9,\\,16,\\,9,\\,0,\\,-1\\right]
        """
        below = math.lcm(*(c.denominator for c in self.mask))
        numbers = ",\\,".join(str(c * below) for c in self.mask)
        return ("" if below == 1 else f"\\frac{{1}}{{{below}}}") + f"\\left[{numbers}\\right]"

    def plot(self, ax: Any = None, *, level: int = 8, derivative: int = 0) -> Any:
        """Draws the basic limit function, or a derivative, and returns the axes of matplotlib. Errors: as limit."""
        x, y = self.limit(level, derivative=derivative)
        return _plots.line(ax, x, y, self.specification, f"{self.specification}, basic limit function")

    def plot_variance(self, ax: Any = None, *, level: int = 8) -> Any:
        """Draws the variance curve over a period, and returns the axes of matplotlib."""
        values = self.variance(level)
        x = [i / self.arity**level for i in range(len(values))]
        return _plots.line(ax, x, values, self.specification, f"{self.specification}, variance")

    def _repr_latex_(self) -> str:
        return f"$a(z) = {self.symbol.to_latex()}$"

    def _repr_html_(self) -> str:
        """The mask, and the basic limit function as a picture where convergence is proved."""
        return _display.scheme_html(self)


def _ends(value: Any) -> Any:
    return Enclosure(*value) if isinstance(value, tuple) else value


class _OnLattice(Named):
    """What schemes on Z^s with a dilation matrix share."""

    @property
    def dimension(self) -> int:
        return self._handle.dimension

    @property
    def dilation(self) -> tuple[tuple[int, ...], ...]:
        return tuple(tuple(row) for row in self._handle.dilation)


class MultivariateScheme(LinearScheme, _OnLattice):
    """A linear scheme of two or three variables.

    >>> import subcert
    >>> loop = subcert.scheme("loop")
    >>> loop.dimension, loop.dilation
    (2, ((2, 0), (0, 2)))
    >>> print(loop.holder())
    3
    """

    @functools.cached_property
    def mask(self) -> dict[tuple[int, ...], Fraction]:
        """The coefficients by their multi-indices."""
        return {tuple(index): value for index, _, _, value in self._handle.terms}

    def holder(
        self,
        budget: float = 60,
        *,
        memory: int = 1024,
        width: Optional[Exact] = None,
        certificate: bool = False,
        progress: Progress = None,
    ) -> HolderExponent:
        """The Hoelder exponent, enclosed with proof; the smallest over the directions of the dilation."""
        return self._holder(16, budget, memory, width, certificate, progress)

    def converges(self, budget: float = 60, progress: Progress = None) -> Decision:
        """Whether the scheme converges uniformly for all bounded data."""
        return self.holder(budget, progress=progress).converges

    def limit(
        self, level: int = 2, *, exact: bool = False, budget: float = 60, progress: Progress = None
    ) -> tuple[Any, Any]:
        """The points M^-level i, i with integer coordinates, at which the basic limit function is not 0, and its values
        there: arrays of numpy of shape (n, dimension) and (n,), or with `exact` lists of Fractions. Errors: as those of
        Scheme.limit.

        >>> import subcert
        >>> points, values = subcert.scheme("loop").limit(0, exact=True)
        >>> sum(values), max(values)
        (Fraction(1, 1), Fraction(1, 2))
        """
        points, values = _core.surface_limit_values(self._handle, level, budget, progress)
        if exact:
            return [tuple(point) for point in points], values
        import numpy

        return numpy.array(points, dtype=float), numpy.array(values, dtype=float)

    def to_latex(self) -> str:
        """The mask of two variables as a matrix, x to the right and y upwards. Raises DomainError for three.

        >>> import subcert
        >>> print(subcert.mask([[1, 2, 1], [2, 4, 2], [1, 2, 1]], 4).to_latex())
        \\frac{1}{4}\\begin{bmatrix}1 & 2 & 1\\\\ 2 & 4 & 2\\\\ 1 & 2 & 1\\end{bmatrix}
        """
        if self.dimension != 2:
            raise DomainError(f"to_latex: need a mask of two variables, got {self.dimension}")
        below = math.lcm(*(c.denominator for c in self.mask.values()))
        columns, rows = (sorted({index[k] for index in self.mask}) for k in (0, 1))
        lines = [
            " & ".join(str(self.mask.get((i, j), Fraction(0)) * below) for i in range(columns[0], columns[-1] + 1))
            for j in range(rows[-1], rows[0] - 1, -1)
        ]
        matrix = "\\begin{bmatrix}" + "\\\\ ".join(lines) + "\\end{bmatrix}"
        return ("" if below == 1 else f"\\frac{{1}}{{{below}}}") + matrix

    def plot(self, ax: Any = None, *, level: int = 4) -> Any:
        """Draws the basic limit function of two variables, and returns the axes of matplotlib. Errors: as limit."""
        if self.dimension != 2:
            raise DomainError(f"plot: need a scheme of two variables, got {self.dimension}")
        points, values = self.limit(level)
        return _plots.surface(ax, points, values, f"{self.specification}, basic limit function")

    def _repr_html_(self) -> str:
        return _display.surface_html(self)


class VectorScheme(_OnLattice):
    """A vector of functions phi_1, phi_2, ... with phi(x) = sum over k of A_k phi(2x - k), A_k matrices: those of a
    vector or Hermite scheme, of multiwavelets, of finite elements.

    >>> import subcert
    >>> s = subcert.scheme("merrien:lambda=-1/8,mu=1/2")
    >>> s.components, s.matrices[(0,)]
    (2, ((Fraction(1, 1), Fraction(0, 1)), (Fraction(0, 1), Fraction(1, 2))))
    >>> print(subcert.scheme("ghm").holder())
    1
    """

    @property
    def components(self) -> int:
        """How many functions there are."""
        return self._handle.components

    @functools.cached_property
    def matrices(self) -> dict[tuple[int, ...], tuple[tuple[Fraction, ...], ...]]:
        """The matrices A_k of phi's equation by their multi-indices k, where they are not 0."""
        found: dict[tuple[int, ...], list[list[Fraction]]] = {}
        for index, row, column, value in self._handle.terms:
            empty = [[Fraction(0)] * self.components for _ in range(self.components)]
            found.setdefault(tuple(index), empty)[row][column] = value
        return {index: tuple(map(tuple, rows)) for index, rows in sorted(found.items())}

    def holder(
        self,
        budget: float = 60,
        *,
        component: Optional[int] = None,
        memory: int = 1024,
        width: Optional[Exact] = None,
        certificate: bool = False,
        progress: Progress = None,
    ) -> HolderExponent:
        """The Hoelder exponent of the continuous solution phi, enclosed with proof: that of its worst function, or of
        the one with this number, from 1. Its facts have the exponents of all functions.

        >>> import subcert
        >>> rough = subcert.refinable([[[1, 0], [2, 3 / 2]], [[2, 0], [0, 3 / 2]], [[1, 0], [0, 0]]], 2, first=0)
        >>> print(rough.holder(component=1), rough.holder().enclosure.lower > 0.415)
        1 True
        >>> subcert.scheme("cl:2").holder().facts["exact"]  # of matrices with a square root
        True
        """
        if component is not None and not 1 <= component <= self.components:
            raise DomainError(f"component: expected 1 to {self.components}, got {component}")
        chosen = None if component is None else component - 1
        return _exponent(self, 16, budget, memory, width, certificate, chosen, progress)

    def converges(self, budget: float = 60, progress: Progress = None) -> Decision:
        """Whether the scheme f'_i = sum over j of A_(i-2j)^T f_j converges for all bounded data; of a Hermite scheme
        to a function and its derivatives. The functions may be smooth where it does not.

        >>> import subcert
        >>> subcert.scheme("merrien:lambda=-1/8,mu=1").converges().reason
        'limit 1 is not the derivative of limit 0'
        >>> subcert.scheme("hermite-dd:points=4,order=2").holder().facts["hermite"]["order"]
        2
        """
        return self.holder(budget, progress=progress).converges

    def convergence_certificate(self, budget: float = 60, progress: Progress = None) -> Certificate:
        """A proof that the scheme converges, or of a Hermite scheme that it is HC^k, k the lower end, or that it does
        not. Raises DomainError of a Hermite scheme that does not keep the values and derivatives of polynomials, of
        dilations that are not isotropic, and where nothing is decided.

        >>> import subcert
        >>> proof = subcert.scheme("hermite-dd:points=4,order=2").convergence_certificate()
        >>> proof.lower, proof.verify().accepted
        ('2', True)
        >>> plane = subcert.scheme("tensor:(ghm)x(bspline:degree=1)").convergence_certificate()
        >>> plane.lower, plane.verify().accepted
        ('0', True)
        """
        return strongest(_core.vector_scheme_certificate(self._handle, budget, progress))

    def limit(
        self, level: int = 2, *, exact: bool = False, budget: float = 60, progress: Progress = None
    ) -> tuple[Any, Any]:
        """The points M^-level i, i with integer coordinates, at which not all functions are 0, and their values there:
        arrays of numpy of shape (n, dimension) and (n, components), or with `exact` lists of tuples of Fractions, of
        numbers with a square root of texts such as '1/2-3/4*sqrt(7)'. The
        factor that the equation leaves open is such that the values at integers sum to 1, or that the first is 1.
        Raises DomainError where there is no continuous solution, or not one alone.

        >>> import subcert
        >>> points, values = subcert.scheme("merrien:lambda=-1/8,mu=-1/2").limit(1, exact=True)
        >>> points[2], values[2]
        ((Fraction(1, 2),), (Fraction(1, 2), Fraction(1, 8)))
        """
        points, values = _core.vector_limit_values(self._handle, level, budget, exact, progress)
        if exact:
            return [tuple(point) for point in points], [tuple(numbers) for numbers in values]
        import numpy

        return numpy.array(points, dtype=float), numpy.array(values, dtype=float)

    def plot(self, ax: Any = None, *, level: int = 7) -> Any:
        """Draws all functions of a vector of one variable, and returns the axes of matplotlib. Errors: as limit."""
        if self.dimension != 1:
            raise DomainError(f"plot: need functions of one variable, got {self.dimension}")
        points, values = self.limit(level)
        for component in range(self.components):
            label = f"phi_{component + 1}"
            ax = _plots.line(ax, points[:, 0], values[:, component], label, self.specification)
        ax.legend()
        return ax


class DataDependentScheme(Named):
    """A scheme without a mask, which only acts on data, as ``l1:points=6``."""

    @property
    def dimension(self) -> int:
        return self._handle.dimension

    def analyze(self, steps: int = 0, order: int = 0, budget: float = 60, progress: Progress = None) -> dict[str, Any]:
        """The page of `subcert l1 --json`: what is proved of the exact rule behind a scheme of curves.

        Raises UsageError for schemes of grids.

        >>> import subcert
        >>> subcert.scheme("l1:points=6").analyze()["contraction"]["bound"]
        '3/5'
        """
        return json.loads(_core.analyze_l1(self._handle, steps, order, budget, progress))


AnyScheme = Union[Scheme, MultivariateScheme, DataDependentScheme]


def scheme(specification: Union[str, Named]) -> Any:
    """The scheme of this specification: a Scheme, MultivariateScheme, VectorScheme or DataDependentScheme.

    Raises UsageError for a text that names none; the line says which part, and what would be right.

    >>> import subcert
    >>> subcert.scheme("primal:n=5").holder().product
    (1, 0)
    >>> subcert.scheme("primal:k=5")
    Traceback (most recent call last):
    ...
    subcert.UsageError: scheme specification, position 8: 'k'; expected the key 'n', as in primal:n=3,d=1
    """
    if isinstance(specification, Named):
        return specification
    if not isinstance(specification, str):
        coefficients = hasattr(specification, "__len__")
        raise TypeError(
            f"scheme: expected a text, as 'primal:n=3', or a scheme, got {type(specification).__name__}"
            + ("; subcert.mask takes coefficients" if coefficients else "")
        )
    core = _core.make_any_scheme(specification)
    if isinstance(core, _core.DataDependentScheme):
        return DataDependentScheme(core)
    if core.components > 1:
        return VectorScheme(core)
    return (Scheme if core.dimension == 1 else MultivariateScheme)(core)


def limit_in_turn(
    schemes: Iterable[Union[str, Named]],
    level: int = 8,
    *,
    first: Iterable[Union[str, Named]] = (),
    budget: float = 60,
    progress: Progress = None,
) -> tuple[list[Fraction], list[Any]]:
    """x and y: the exact limit, from the unit datum, of masks that change from level to level, at the points i /
    arity^level: those of `first`, one for each level, and then these schemes in turn. Of vector and Hermite schemes
    y has the values of all functions, where they are not all 0, as VectorScheme.limit has them of one.

    >>> import subcert
    >>> x, y = subcert.limit_in_turn(["dd:n=2", "bspline:degree=3"], 0)
    >>> y[x.index(0)]
    Fraction(82, 93)
    >>> x, y = subcert.limit_in_turn(["merrien:lambda=-1/8,mu=3/2", "merrien:lambda=-1/8,mu=-1/2"], 1)
    >>> y[x.index(0.5)]
    (Fraction(1, 2), Fraction(1, 8))
    """
    texts = [str(one) for one in schemes]
    arity, indices, values = _core.limit_values_in_turn([str(one) for one in first], texts, level, budget, progress)
    y = [tuple(one) if isinstance(one, list) else one for one in values]
    return [Fraction(index, arity**level) for index in indices], y


def mask(
    coefficients: Iterable[Any],
    denominator: Exact = 1,
    *,
    first: Union[int, Sequence[int], None] = None,
    arity: int = 2,
    dilation: Optional[Sequence[Sequence[int]]] = None,
) -> Any:
    """The scheme with these coefficients over a common denominator, from the index `first` on (default: centred).

    Nested lists are masks of two or three variables, the last one outermost, with as many first indices; `dilation`:
    their matrix, else `arity` times the identity.

    >>> import subcert
    >>> subcert.mask([1, 3, 3, 1], 4).specification
    'mask:[1,3,3,1]/4@-2'
    >>> subcert.mask([[1, 1], [1, 1]], 1, first=(0, 0)).mask[1, 1]
    Fraction(1, 1)
    """
    numbers, levels = _listed(coefficients, denominator)
    family = f"mask{levels if levels > 1 else ''}"
    return scheme(f"{family}:{numbers}{_fields(first, arity, dilation)}")


def refinable(
    matrices: Iterable[Any],
    denominator: Exact = 1,
    *,
    first: Union[int, Sequence[int], None] = None,
    arity: int = 2,
    dilation: Optional[Sequence[Sequence[int]]] = None,
    integral: Optional[Sequence[Exact]] = None,
) -> VectorScheme:
    """The vector of functions with phi(x) = sum over k of A_k phi(2x - k), of matrices A_k over a common denominator
    from the index `first` on; the rest as in mask(). Where several functions solve this, `integral` chooses one.
    Entries may be texts with one square root, '1/2-sqrt(7)'.

    >>> import subcert
    >>> hats = subcert.refinable([[[1, 0], [2, 1]], [[2, 0], [0, 1]], [[1, 0], [0, 0]]], 2, first=0)
    >>> hats.components, hats.specification
    (2, 'refinable:[[[1,0],[2,1]],[[2,0],[0,1]],[[1,0],[0,0]]]/2@0')
    >>> both = [[[2, 0], [0, 1]], [[4, 0], [0, 3]], [[2, 0], [0, 3]], [[0, 0], [0, 1]]]
    >>> print(subcert.refinable(both, 4, first=-1, integral=[0, 1]).holder())
    2
    >>> print(subcert.refinable(both, 4, first=-1, integral=["1-sqrt(2)", "1/3"]).holder(component=2))
    2
    """
    chosen = "" if integral is None else f",integral={_listed(integral, 1)[0]}"
    return scheme(f"refinable:{_listed(matrices, denominator)[0]}{_fields(first, arity, dilation)}{chosen}")


def _listed(coefficients: Iterable[Any], denominator: Exact) -> tuple[str, int]:
    """As specifications have them, and how deep they are nested."""
    below = fraction(denominator)
    if below == 0:
        raise ZeroDivisionError("mask: need a denominator other than 0")

    def listed(entries: Any) -> tuple[str, int]:
        if hasattr(entries, "tolist"):  # arrays of numpy, matrices of sympy
            entries = entries.tolist()
        if isinstance(entries, (list, tuple)):
            inner = [listed(entry) for entry in entries]
            return "[" + ",".join(text for text, _ in inner) + "]", 1 + max((depth for _, depth in inner), default=0)
        if isinstance(entries, str) and "sqrt(" in entries:
            return (entries if below == 1 else f"({entries})/({below})"), 0
        return str(fraction(entries) / below), 0

    return listed(coefficients if hasattr(coefficients, "tolist") else list(coefficients))


def _fields(
    first: Union[int, Sequence[int], None], arity: int, dilation: Optional[Sequence[Sequence[int]]]
) -> str:
    indices = [] if first is None else [first] if isinstance(first, int) else list(first)
    text = "@" + ",".join(str(int(i)) for i in indices) if indices else ""
    if dilation is not None:
        return text + ",dilation=[" + ";".join(",".join(str(int(d)) for d in row) for row in dilation) + "]"
    return text + ("" if arity == 2 else f",arity={int(arity)}")


def families() -> dict[str, str]:
    """How each named family of schemes is written, and what it is."""
    return {usage: meaning for _, usage, meaning in [
        *_core.families(),
        *_core.multivariate_families(),
        *_core.vector_families(),
    ]}
