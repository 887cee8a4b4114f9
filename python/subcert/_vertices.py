"""Surfaces at the vertices of meshes."""

from __future__ import annotations

import dataclasses
import numbers
import os
from fractions import Fraction
from typing import Any, Iterable, Mapping, Optional, Union

from . import _plots
from ._calls import core as _core
from ._calls import threads as _threads
from ._errors import MissingFileError
from ._exact import Decision, Enclosure, Exact, Truth, fraction, optional_enclosure
from ._regularity import Progress
from ._schemes import MultivariateScheme, Named, scheme


@dataclasses.dataclass(frozen=True)
class Vertex:
    """What is proved of the surfaces of a scheme at vertices of one valence, of dual schemes in faces of so many
    corners: of all initial data but a set of measure zero."""

    valence: int
    c1: Decision
    """Whether the surface is, near the vertex, the graph of a C1 function over its tangent plane."""
    frequency: int
    """That of the subdominant eigenvalue."""
    subdominant: Optional[Enclosure]
    """That eigenvalue, where it is one number, real and positive."""
    next: Optional[Enclosure]
    """The largest modulus of the others."""
    exponent: Optional[Enclosure]
    """Of Hölder at the vertex, where the surface is C1."""
    curvature: Optional[str]
    """"zero", "bounded" or "unbounded" towards the vertex; None where that is not told."""


@dataclasses.dataclass(frozen=True)
class StencilWeight:
    """What one datum counts."""

    point: tuple[int, int]
    """In its sector: (0, 0) is the vertex, (1, 0) and (0, 1) the ends of two edges at it; of dual schemes (0, 0) is a
    corner of the face."""
    sector: int
    weight: Enclosure
    exact: Optional[str]
    """A polynomial in c = cos(2 pi/n), with s = sin(2 pi/n) as a factor in the second tangent; None where the
    eigenvalue is no number of that field, or n is large."""


@dataclasses.dataclass(frozen=True)
class VertexStencils:
    """The sums of weights times data that give a point of the surface and its tangent plane."""

    limit: list[StencilWeight]
    tangents: tuple[list[StencilWeight], list[StencilWeight]]
    """Their cross product is the normal; empty where the largest eigenvalue is not proved to be one of frequency 1."""


@dataclasses.dataclass(frozen=True)
class EveryValence:
    """What is proved of the surfaces of a scheme at vertices of all valences from one on."""

    first: int
    c1: Decision
    """As `Vertex.c1`, of all of them; never no."""
    open: list[tuple[int, Optional[int]]]
    """First and last of the valences where it is not proved; no last one: all that follow."""
    intervals: int
    """Of 1/n, in which it is proved."""


@dataclasses.dataclass(frozen=True)
class WeightPiece:
    """Values of a weight from low to high, both included, and whether the property holds for all (yes) or none (no)."""

    low: Fraction
    high: Fraction
    holds: Truth
    reason: str


@dataclasses.dataclass(frozen=True)
class WeightEnd:
    """The one value in an enclosure where what is said on both sides of it meets."""

    value: Enclosure
    exact: Optional[str]
    """A polynomial in c = cos(2 pi/n), where the value is one."""
    polynomial: str
    """In c and the letter, with the value as its only zero in the enclosure."""
    holds: Truth
    """At the value itself."""
    reason: str


@dataclasses.dataclass(frozen=True)
class WeightRange:
    """For which values of a weight surfaces are smooth at vertices of one valence."""

    valence: int
    parameter: str
    pieces: tuple[WeightPiece, ...]
    ends: tuple[WeightEnd, ...]
    """Each in a piece that is not decided."""

    def proved(self) -> tuple[WeightPiece, ...]:
        """The pieces on which the property holds."""
        return tuple(piece for piece in self.pieces if piece.holds.is_yes)

    def plot(self, ax: Any = None) -> Any:
        """Draws the pieces, and returns the axes of matplotlib."""
        return _plots.pieces(ax, self, self.parameter)


@dataclasses.dataclass(frozen=True)
class WeightCell:
    """Values of weights from low to high, and whether the property holds for all (yes) or none (no) of them."""

    low: tuple[Fraction, ...]
    high: tuple[Fraction, ...]
    holds: Truth
    reason: str
    """Why it is not decided."""

    @property
    def volume(self) -> Fraction:
        """The product of the sides."""
        result = Fraction(1)
        for low, high in zip(self.low, self.high):
            result *= high - low
        return result


@dataclasses.dataclass(frozen=True)
class WeightMap:
    """For which values of several weights surfaces are smooth at vertices of one valence."""

    valence: int
    parameters: tuple[str, ...]
    cells: tuple[WeightCell, ...]
    complete: bool
    """All cells that are not decided are as small as they may be."""

    def share(self, holds: Truth) -> Fraction:
        """The share of the area, or volume, with this answer."""
        found = sum((cell.volume for cell in self.cells if cell.holds is holds), Fraction(0))
        return found / sum((cell.volume for cell in self.cells), Fraction(0))

    def plot(self, ax: Any = None) -> Any:
        """Draws the cells of two weights, and returns the axes of matplotlib."""
        return _plots.cells(ax, self)


class VertexRules:
    """A tuned scheme: one that is known, with rules at vertices of its own."""

    def __init__(self, handle: Any) -> None:
        self._handle = handle

    @property
    def title(self) -> str:
        """What it is called, and the scheme that it changes."""
        return str(self._handle.title)

    def __repr__(self) -> str:
        return f"<{self.title}>"


def vertex_rules(text: str) -> VertexRules:
    """Reads rules at vertices in TOML, the text of what `subcert vertex FILE.toml` takes. Raises DataError, with line
    and key, for what is no such text.

    >>> import subcert
    >>> half = subcert.vertex_rules('''
    ... scheme = "loop"
    ... [[rule]]
    ... weights = {vertex = "1/2", neighbours = "1/(2*n)"}
    ... ''')
    >>> [str(at.c1.truth) for at in subcert.vertices(half, [3, 7])]
    ['yes', 'yes']
    """
    return VertexRules(_core.read_vertex_rules(text, "rules"))


Surface = Union[str, "os.PathLike[str]", Named, MultivariateScheme, VertexRules]


def _read_rules(surface: Any) -> Any:
    """The rules of one's own that are meant, or None."""
    if isinstance(surface, VertexRules):
        return surface._handle
    if isinstance(surface, os.PathLike) or (isinstance(surface, str) and surface.endswith(".toml")):
        try:
            with open(surface, encoding="utf-8") as file:
                text = file.read()
        except OSError as error:
            raise MissingFileError(f"{os.fspath(surface)}: {error.strerror}") from None
        return _core.read_vertex_rules(text, os.fspath(surface))
    return None


def _number(valence: Any) -> int:
    if not isinstance(valence, numbers.Integral):
        raise TypeError(f"valence: expected an integer, as 5, got {valence!r}")
    return int(valence)


def _numbers(valences: Any) -> list[int]:
    """One valence, or several."""
    if isinstance(valences, numbers.Integral):
        return [_number(valences)]
    if isinstance(valences, str) or not hasattr(valences, "__iter__"):
        raise TypeError(f"valences: expected integers, as 5 or range(3, 13), got {valences!r}")
    return [_number(n) for n in valences]


def _rules(surface: Any) -> Any:
    own = _read_rules(surface)
    if own is not None:
        return own
    meant = surface if isinstance(surface, MultivariateScheme) else scheme(surface)
    return _core.vertex_scheme(meant._handle)


def vertices(
    surface: Surface,
    valences: Union[int, Iterable[int]] = range(3, 13),
    *,
    budget: float = 60,
    progress: Progress = None,
) -> list[Vertex]:
    """Whether the surfaces of a scheme are smooth at vertices of these valences, 3 to 1000 each, with proof.

    `surface`: one with rules at vertices: loop, catmull-clark, doo-sabin, midedge, butterfly, modified-butterfly,
    kobbelt, sqrt3, four-eight, triangular:, or rules of one's own, by `vertex_rules` or as a file, "FILE.toml".
    `budget`: seconds of processor time, of the part away from vertices. Raises DomainError for other schemes and
    valences.

    >>> import subcert
    >>> [str(at.c1.truth) for at in subcert.vertices("butterfly:w=1/16", range(4, 9))]
    ['yes', 'yes', 'yes', 'yes', 'no']
    """
    found = _core.vertices(_rules(surface), _numbers(valences), budget, progress)
    return [
        Vertex(
            valence,
            Decision._of(c1),
            frequency,
            optional_enclosure(subdominant),
            optional_enclosure(behind),
            optional_enclosure(exponent),
            curvature,
        )
        for valence, c1, frequency, subdominant, behind, exponent, curvature in found
    ]


def every_valence(
    surface: Surface,
    first: int = 13,
    *,
    budget: float = 60,
    progress: Progress = None,
) -> EveryValence:
    """Whether the surfaces of a scheme are smooth at vertices of all valences n >= `first`, with proof.

    `first`: 7 or more. `surface`, `budget`: as of `vertices`. Raises DomainError for other schemes and valences.

    >>> import subcert
    >>> str(subcert.every_valence("catmull-clark").c1.truth)
    'yes'
    """
    least, c1, open_ranges, intervals = _core.every_valence(_rules(surface), _number(first), budget, progress)
    return EveryValence(least, Decision._of(c1), open_ranges, intervals)


def vertex_stencils(
    surface: Surface, valence: int, *, budget: float = 60, progress: Progress = None
) -> VertexStencils:
    """The limit and tangent stencils at vertices of one valence, 3 to 1000.

    `surface`, `budget`: as of `vertices`. Raises DomainError for other schemes and valences.

    >>> import subcert
    >>> [weight.exact for weight in subcert.vertex_stencils("loop", 6).limit[:2]]
    ['1/2', '1/12']
    """
    limit, first, second = (
        [StencilWeight(point, sector, Enclosure._of(weight), exact) for point, sector, weight, exact in stencil]
        for stencil in _core.vertex_stencils(_rules(surface), _number(valence), budget, progress)
    )
    return VertexStencils(limit, (first, second))


def vertex_ranges(
    surface: Surface,
    letter: str,
    low: Exact,
    high: Exact,
    valences: Union[int, Iterable[int]] = range(3, 13),
    *,
    property: str = "C1",
    width: Exact = "1e-6",
    budget: float = 60,
    jobs: Optional[int] = None,
    progress: Progress = None,
) -> list[WeightRange]:
    """For which values of a letter of rules the surfaces are "C1", or have "bounded-curvature", at vertices of these
    valences. Other letters of the rules keep their values.

    `width`: values are told apart down to it. Raises UsageError for rules without the letter.

    >>> import subcert
    >>> rules = subcert.vertex_rules('''
    ... scheme = "loop"
    ... letter = "b"
    ... [[rule]]
    ... weights = {vertex = "1 - b", neighbours = "b/n"}
    ... ''')
    >>> [four] = subcert.vertex_ranges(rules, "b", 0, "4/5", [4])
    >>> [str(piece.holds) for piece in four.pieces], four.ends[0].exact
    (['no', 'unknown', 'yes'], '1/4')
    """
    found = _core.vertex_ranges(
        _rules(surface),
        letter,
        property,
        fraction(low),
        fraction(high),
        fraction(width),
        _numbers(valences),
        budget,
        _threads(jobs),
        progress,
    )
    return [
        WeightRange(
            valence,
            letter,
            tuple(WeightPiece(p[0], p[1], Truth(p[2]), p[3]) for p in pieces),
            tuple(WeightEnd(Enclosure._of(e[0]), e[1], e[2], Truth(e[3]), e[4]) for e in ends),
        )
        for valence, pieces, ends in found
    ]


def vertex_map(
    surface: Surface,
    over: Mapping[str, tuple[Exact, Exact]],
    valence: int,
    *,
    property: str = "C1",
    resolution: int = 64,
    budget: float = 60,
    jobs: Optional[int] = None,
    progress: Progress = None,
) -> WeightMap:
    """The same for two or three letters, as a map of cells: `over` has the least and the largest value of each.

    `resolution`: cells along each side, at most. Raises UsageError for rules without these letters.

    >>> import subcert
    >>> rules = subcert.vertex_rules('''
    ... scheme = "catmull-clark"
    ... letter = ["a", "b"]
    ... [[rule]]
    ... weights = {vertex = "1 - a - b", neighbours = "a/n", across = "b/n"}
    ... ''')
    >>> found = subcert.vertex_map(rules, {"a": (0, 1), "b": (-1, 1)}, 5, resolution=4)
    >>> found.complete, found.share(subcert.Truth.yes) > 0
    (True, True)
    """
    letters = list(over)
    cells, complete = _core.vertex_map(
        _rules(surface),
        letters,
        property,
        [fraction(over[letter][0]) for letter in letters],
        [fraction(over[letter][1]) for letter in letters],
        _number(valence),
        int(resolution),
        budget,
        _threads(jobs),
        progress,
    )
    return WeightMap(
        _number(valence),
        tuple(letters),
        tuple(WeightCell(c[0], c[1], Truth(c[2]), c[3]) for c in cells),
        complete,
    )
