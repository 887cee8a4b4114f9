"""Exponents and radii, enclosed with proof."""

from __future__ import annotations

import dataclasses
import json
import os
from fractions import Fraction
from typing import Any, Callable, Iterable, Optional, Sequence

from ._calls import core as _core
from ._certificates import Certificate, Verification, strongest
from ._errors import CertificateError
from ._exact import Decision, Enclosure, Exact, Truth, bits_of, fraction, optional_enclosure

Progress = Optional[Callable[[float], Any]]
"""Called ten times a second with the seconds that have passed. An exception that it raises ends the work."""


@dataclasses.dataclass(frozen=True)
class Bound:
    """What norms of so many levels of the difference scheme prove."""

    levels: int
    norm: Fraction
    exponent: Enclosure


@dataclasses.dataclass(frozen=True)
class Computation:
    """A function of the library with its arguments, to be called again; it can be pickled."""

    function: str
    arguments: tuple[Any, ...]

    def __call__(self) -> Any:
        return getattr(_core, self.function)(*self.arguments)


class _Certified:
    """An enclosure with what is known of it. It remembers its evidence until it is pickled or copied; after that a
    certificate is computed anew. Compared with numbers it is its enclosure; two of one kind are equal where all that is
    known of them is."""

    enclosure: Enclosure
    exact: bool
    _evidence: Any
    _again: Computation

    @property
    def lower(self) -> Optional[Fraction]:
        return self.enclosure.lower

    @property
    def upper(self) -> Optional[Fraction]:
        return self.enclosure.upper

    def __float__(self) -> float:
        return float(self.enclosure)

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return self.enclosure == other
        compared = [field.name for field in dataclasses.fields(self) if field.compare]
        return all(getattr(self, name) == getattr(other, name) for name in compared)

    def __hash__(self) -> int:
        return hash(self.enclosure)

    def __gt__(self, other: Exact) -> Truth:  # type: ignore[misc]
        return self.enclosure > other

    def __ge__(self, other: Exact) -> Truth:  # type: ignore[misc]
        return self.enclosure >= other

    def __lt__(self, other: Exact) -> Truth:
        return self.enclosure < other

    def __le__(self, other: Exact) -> Truth:
        return self.enclosure <= other

    def __str__(self) -> str:
        return str(self.enclosure)

    def to_latex(self, digits: int = 14) -> str:
        """See Enclosure.to_latex."""
        return self.enclosure.to_latex(digits)

    def to_dict(self) -> dict[str, Any]:
        """What is known of it, as plain values for JSON: the enclosure, `exact`, `product`, ..."""
        known = {field.name: getattr(self, field.name) for field in dataclasses.fields(self) if field.compare}
        return {key: _plain(value) for key, value in known.items()}

    def _repr_latex_(self) -> str:
        return self.enclosure._repr_latex_()

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self}{', exact' if self.exact else ''}>"

    @property
    def certificate(self) -> Certificate:
        """A proof for the independent checker. Computes anew, with the same budget, where the evidence at hand is
        none that a certificate can hold. Raises CertificateError, or the error of the library, where nothing is to be
        had."""
        found = self._evidence.certificate() if self._evidence is not None else None
        if found is None:
            object.__setattr__(self, "_evidence", self._again())
            found = self._evidence.certificate()
        if found is None:
            raise CertificateError(f"{self!r}: no evidence that a certificate can hold")
        return strongest(found)

    def verify(self) -> Verification:
        """Asks the independent checker about the certificate."""
        return self.certificate.verify()

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_evidence": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)


def _plain(value: Any) -> Any:
    if isinstance(value, Enclosure):
        return value.to_dict()
    if isinstance(value, Fraction):
        return str(value)
    if isinstance(value, (Decision, Bound)):
        return {field.name: _plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, Truth):
        return value.value
    return list(value) if isinstance(value, tuple) else value


def _hidden() -> Any:
    return dataclasses.field(default=None, repr=False, compare=False)


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class JointSpectralRadius(_Certified):
    """A joint spectral radius between two rational numbers.

    >>> import subcert
    >>> golden = subcert.jsr([[[1, 1], [0, 1]], [[1, 0], [1, 1]]])
    >>> print(golden)
    1.6180339887499
    >>> golden.exact, golden.product, golden.formula
    (True, (1, 0), '(3/2+1/2*sqrt(5))^(1/2)')
    >>> golden.verify().accepted
    True
    """

    enclosure: Enclosure
    exact: bool
    """Whether the product is proved to attain the radius, which is then an algebraic number that the ends isolate."""
    exactness: str
    product: tuple[int, ...]
    method: str
    vertices: int
    closed: bool
    """Whether the ends are within 1e-12 of each other."""
    formula: Optional[str] = None
    """The radius in closed form, where it is a number of small degree that the product is proved to attain."""
    _evidence: Any = _hidden()
    _again: Any = _hidden()


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class JointSpectralSubradius(_Certified):
    """A joint spectral subradius between two rational numbers.

    >>> import subcert
    >>> slow = subcert.subradius([[[7, 2], [0, 3]], [[2, 0], [4, 8]]])
    >>> print(slow)
    6.0093134895301
    >>> slow.exact, slow.product
    (True, (1, 0, 1, 0, 0, 1, 0, 0))
    >>> slow.verify().accepted
    True
    """

    enclosure: Enclosure
    exact: bool
    """Whether the product is proved to attain the subradius."""
    exactness: str
    product: tuple[int, ...]
    vertices: int
    closed: bool
    """Whether the ends are within 1e-12 of each other."""
    _evidence: Any = _hidden()
    _again: Any = _hidden()


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class HolderExponent(_Certified):
    """The Hoelder exponent of the limits between two rational numbers. No ends where convergence is not proved.

    >>> import subcert
    >>> s = subcert.scheme("primal:n=5").holder()
    >>> print(s)
    1.9901439593863
    >>> s.exact, s.product, s > 1
    (True, (1, 0), <Truth.yes: 'yes'>)
    """

    enclosure: Enclosure
    exact: bool
    """Whether the product is proved to attain the joint spectral radius."""
    exactness: str
    product: tuple[int, ...]
    radius: Enclosure
    method: str
    vertices: int
    closed: bool
    converges: Decision
    stable: Decision
    """Of the integer shifts. Only with stable shifts is the upper end that of this mask."""
    sum_rules: int
    bound: Optional[Bound] = None
    logarithm: tuple[int, Optional[int]] = (0, None)
    """Between which powers of |log h| the modulus of continuity lies; (0, 0): the exponent is attained."""
    sobolev: Optional[Enclosure] = None
    """Of surfaces: the Sobolev exponent."""
    facts: dict[str, Any] = dataclasses.field(default_factory=dict, repr=False, compare=False)
    """All that `subcert regularity --json` says of it."""
    _evidence: Any = _hidden()
    _again: Any = _hidden()

    @property
    def formula(self) -> Optional[str]:
        """The exponent in closed form, where it is known and no rational number.

        >>> import subcert
        >>> subcert.scheme("daubechies:n=2").holder().formula
        '2 - log_2(1+sqrt(3))'
        """
        formula: Optional[str] = self.facts["formula"]
        return formula

    def _repr_html_(self) -> str:
        rows = {
            "Hölder exponent": str(self),
            "exact": f"yes, by the product {_core.word_text(self.product)}" if self.exact else f"no: {self.exactness}",
            "method": self.method,
            "converges": str(self.converges),
            "stable": str(self.stable),
        }
        cells = "".join(
            f"<tr><th style='text-align:left'>{k}</th><td style='text-align:left'>{v}</td></tr>"
            for k, v in rows.items()
        )
        return f"<table>{cells}</table>"


def _product_fields(facts: dict[str, Any]) -> dict[str, Any]:
    return {
        "exact": facts["exact"],
        "exactness": facts["exactness"],
        "product": tuple(facts["product"]),
        "vertices": facts["vertices"],
        "closed": facts["closed"],
    }


def _radius_fields(facts: dict[str, Any]) -> dict[str, Any]:
    return {"method": facts["method"], **_product_fields(facts)}


def exponent_of(evidence: Any, again: Computation) -> HolderExponent:
    facts, exact = json.loads(evidence.facts), evidence.exact
    bound = exact["bound"]
    return HolderExponent(
        enclosure=Enclosure._of(exact["exponent"]),
        exact=facts["exact"],
        exactness=facts["exactness"],
        product=tuple(exact["product"]),
        radius=Enclosure._of(exact["radius"]),
        method=facts["method"],
        vertices=facts["vertices"] or 0,
        closed=exact["closed"],
        converges=Decision._of(exact["converges"]),
        stable=Decision._of(exact["stable"]),
        sum_rules=facts["sum_rules"],
        bound=Bound(bound[0], bound[1], Enclosure._of(bound[2])) if bound else None,
        logarithm=exact["logarithm"],
        sobolev=optional_enclosure(exact["sobolev"]),
        facts=facts,
        _evidence=evidence,
        _again=again,
    )


def _lists(matrices: Iterable[Any]) -> list[list[list[Fraction]]]:
    """Nested lists, integer or object arrays, and matrices of sympy, as Fractions."""
    if isinstance(matrices, (str, os.PathLike)):
        file = "those of a file are json.load(file)['matrices']"
        raise TypeError(f"matrices: expected a list of matrices, got {matrices!r}; {file}")
    result = []
    for matrix in matrices:
        if hasattr(matrix, "tolist"):  # arrays of numpy, matrices of sympy
            matrix = matrix.tolist()
        try:
            rows = [list(row) for row in matrix]
        except TypeError:
            raise TypeError(
                f"matrices: expected a list of matrices, each a list of rows, got the matrix {matrix!r}"
            ) from None
        result.append([[fraction(entry) for entry in row] for row in rows])
    return result


def jsr(
    matrices: Iterable[Any],
    *,
    edges: Sequence[tuple[int, int, int]] = (),
    budget: float = 60,
    memory: int = 1024,
    width: Optional[Exact] = None,
    progress: Progress = None,
) -> JointSpectralRadius:
    """The joint spectral radius of rational matrices, enclosed with proof.

    `matrices`: square, of one size, with exact entries: nested lists, integer or object arrays of numpy, matrices of
    sympy. `edges`: (from, to, matrix) where a graph says which matrix may follow which. `budget`: seconds of
    processor time. `memory`: MiB. `width`: at most so wide, where a product is proved to attain the radius. Raises
    DomainError for matrices of other shapes, TypeError for floats."""
    arguments = (_lists(matrices), list(edges), budget, memory, bits_of(width))
    evidence = _core.jsr(*arguments, progress)
    return JointSpectralRadius(
        enclosure=Enclosure._of(evidence.facts["radius"]),
        _evidence=evidence,
        formula=evidence.facts["formula"],
        _again=Computation("jsr", (*arguments, None)),
        **_radius_fields(evidence.facts),
    )


def subradius(
    matrices: Iterable[Any],
    *,
    budget: float = 60,
    memory: int = 1024,
    width: Optional[Exact] = None,
    progress: Progress = None,
) -> JointSpectralSubradius:
    """The joint spectral subradius, also called lower spectral radius, of matrices without negative entries: how slowly
    products can grow. The arguments are those of `jsr`. Raises DomainError for negative entries."""
    arguments = (_lists(matrices), budget, memory, bits_of(width))
    evidence = _core.subradius(*arguments, progress)
    return JointSpectralSubradius(
        enclosure=Enclosure._of(evidence.facts["radius"]),
        _evidence=evidence,
        _again=Computation("subradius", (*arguments, None)),
        **_product_fields(evidence.facts),
    )


def p_radius(
    matrices: Iterable[Any],
    p: int,
    *,
    budget: float = 60,
    width: Optional[Exact] = None,
    progress: Progress = None,
) -> Enclosure:
    """The p-radius: how averages of p-th powers of norms of products grow; p even, or no entry negative.

    >>> import subcert
    >>> print(subcert.p_radius([[[1, 1], [0, 1]], [[1, 0], [1, 1]]], 2))
    1.5102239590221
    """
    return Enclosure._of(_core.p_radius(_lists(matrices), p, bits_of(width), budget, progress))
