"""Surfaces at the vertices of meshes."""

from __future__ import annotations

import dataclasses
from typing import Iterable, Optional, Union

from ._calls import core as _core
from ._exact import Decision, Enclosure, optional_enclosure
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


def vertices(
    surface: Union[str, Named, MultivariateScheme],
    valences: Iterable[int] = range(3, 13),
    *,
    budget: float = 60,
    progress: Progress = None,
) -> list[Vertex]:
    """Whether the surfaces of a scheme are smooth at vertices of these valences, 3 to 1000 each, with proof.

    `surface`: one with rules at vertices: loop, catmull-clark, doo-sabin, midedge, butterfly, modified-butterfly,
    sqrt3. `budget`: seconds of processor time, of the part away from vertices. Raises DomainError for other schemes and
    valences.

    >>> import subcert
    >>> [str(at.c1.truth) for at in subcert.vertices("butterfly:w=1/16", range(4, 9))]
    ['yes', 'yes', 'yes', 'yes', 'no']
    """
    meant = surface if isinstance(surface, MultivariateScheme) else scheme(surface)
    found = _core.vertices(meant._handle, [int(n) for n in valences], budget, progress)
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
    surface: Union[str, Named, MultivariateScheme],
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
    meant = surface if isinstance(surface, MultivariateScheme) else scheme(surface)
    least, c1, open_ranges, intervals = _core.every_valence(meant._handle, int(first), budget, progress)
    return EveryValence(least, Decision._of(c1), open_ranges, intervals)


def vertex_stencils(
    surface: Union[str, Named, MultivariateScheme], valence: int, *, budget: float = 60, progress: Progress = None
) -> VertexStencils:
    """The limit and tangent stencils at vertices of one valence, 3 to 1000.

    `surface`, `budget`: as of `vertices`. Raises DomainError for other schemes and valences.

    >>> import subcert
    >>> [weight.exact for weight in subcert.vertex_stencils("loop", 6).limit[:2]]
    ['1/2', '1/12']
    """
    meant = surface if isinstance(surface, MultivariateScheme) else scheme(surface)
    limit, first, second = (
        [StencilWeight(point, sector, Enclosure._of(weight), exact) for point, sector, weight, exact in stencil]
        for stencil in _core.vertex_stencils(meant._handle, int(valence), budget, progress)
    )
    return VertexStencils(limit, (first, second))
