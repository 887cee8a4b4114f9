"""Families with a parameter: for which values a property holds, and the exponent as a function of it."""

from __future__ import annotations

import dataclasses
import decimal
from fractions import Fraction
from typing import Any, Iterable, Optional, Union

from . import _plots
from ._calls import core as _core
from ._calls import threads as _threads
from ._certificates import Certificate
from ._exact import Decision, Enclosure, Exact, Truth, fraction, optional_enclosure
from ._regularity import Progress
from ._schemes import Named, Scheme, Symbol, VectorScheme, _symbol, scheme


@dataclasses.dataclass(frozen=True)
class Piece:
    """Values of the parameter from low to high, and whether the property holds for all (yes) or none (no) of them."""

    low: Fraction
    high: Fraction
    low_included: bool
    high_included: bool
    holds: Truth
    reason: str = ""
    """Why it is not decided."""


@dataclasses.dataclass(frozen=True)
class RangeEnd:
    """An end between a proved and a refuted piece: the zero of the polynomial in the enclosure, where the radius of the
    product crosses the threshold."""

    value: Enclosure
    polynomial: Symbol
    product: tuple[int, ...]
    holds: Truth


@dataclasses.dataclass(frozen=True)
class SpecialValue:
    """A single value, why it stands apart, and what holds there."""

    value: Enclosure
    polynomial: Symbol
    why: str
    holds: Truth
    exponent: Optional[Enclosure] = None


@dataclasses.dataclass(frozen=True)
class IntervalCertificate:
    """For all values from low to high."""

    low: Fraction
    high: Fraction
    holds: Truth
    certificate: Certificate


@dataclasses.dataclass(frozen=True, repr=False)
class PropertyRange:
    """For which values a property is proved, refuted, or not decided."""

    pieces: tuple[Piece, ...]
    ends: tuple[RangeEnd, ...]
    special: tuple[SpecialValue, ...]
    sum_rules: int
    complete: bool
    """No undecided piece is longer than the width asked for."""
    parameter: str = "w"
    summary: str = ""
    """The answer in one sentence; empty where more is open than pieces of the width."""
    _evidence: Any = dataclasses.field(default=None, repr=False, compare=False)

    def __repr__(self) -> str:
        if self.summary:
            return f"<PropertyRange: {self.summary}>"
        open_pieces = sum(piece.holds.is_unknown for piece in self.pieces)
        return f"<PropertyRange over {self.parameter}: {len(self.pieces)} pieces, {open_pieces} of them undecided>"

    def proved(self) -> tuple[Piece, ...]:
        """The pieces on which the property holds."""
        return tuple(piece for piece in self.pieces if piece.holds.is_yes)

    def certificates(self) -> list[IntervalCertificate]:
        """One for each decided interval."""
        return _certificates(self._evidence)

    def to_dict(self) -> list[dict[str, Any]]:
        """The pieces, as plain values for JSON."""
        return [
            {"from": str(p.low), "to": str(p.high), "verdict": _verdict(p.holds), "reason": p.reason}
            for p in self.pieces
        ]

    def to_latex(self) -> str:
        """A tabular of the pieces."""
        name = _core.latex_formula(self.parameter)
        lines = ["\\begin{tabular}{rcll}", "\\toprule"]
        for p in self.pieces:
            low, high = _ends_text(p)
            signs = ["\\le" if included else "<" for included in (p.low_included, p.high_included)]
            values = f"{low} & ${signs[0]}\\;{name}\\;{signs[1]}$ & {high}"
            lines.append(f"{values} & {_verdict(p.holds)} \\\\")
        return "\n".join([*lines, "\\bottomrule", "\\end{tabular}"])

    def plot(self, ax: Any = None) -> Any:
        """Draws the pieces, and returns the axes of matplotlib."""
        return _plots.pieces(ax, self, self.parameter)

    def _repr_html_(self) -> str:
        rows = "".join(
            "<tr><td>{}</td><td>{}</td><td>{}</td></tr>".format(*_ends_text(p), _verdict(p.holds)) for p in self.pieces
        )
        return f"<table><tr><th>from</th><th>to</th><th>verdict</th></tr>{rows}</table>"


@dataclasses.dataclass(frozen=True)
class Levels:
    """Whether all sequences of values, one for each level, have a property (yes), or one does not (no)."""

    holds: Truth
    reason: str
    """Why it is not decided."""
    period: tuple[Fraction, ...]
    """Of a sequence without the property: these values again and again."""
    sum_rules: int
    first_level: Optional[int] = None
    """With a recurrence: the level from which on the values are in the range; None where no one level is that for all
    first values."""
    _evidence: Any = dataclasses.field(default=None, repr=False, compare=False)

    def certificates(self) -> list[IntervalCertificate]:
        """One where it is proved for all sequences, with a recurrence of its values; another one of the exponent where
        these tend to a number; none where neither is proved."""
        return _certificates(self._evidence)


@dataclasses.dataclass(frozen=True)
class LevelsExponent:
    """The least exponent of all sequences of masks."""

    exponent: Enclosure
    """All limits have at least the lower end, those of `sequence` at most the upper one."""
    exact: Decision
    sum_rules: int
    sequence: tuple[int, ...]
    """The numbers of the masks whose limits are the least smooth, again and again."""
    stable: bool
    """Of the shifts of `sequence`; of masks of numbers."""
    formula: Optional[str] = None
    """The exponent in closed form, where it is exact and no rational number."""
    sum_rules_alone: tuple[int, ...] = ()
    """Of masks of matrices: the number for each mask by itself."""
    hermite_order: Optional[int] = None
    """Of Hermite schemes: the largest k for which HC^k is proved for all sequences."""
    _evidence: Any = dataclasses.field(default=None, repr=False, compare=False)

    def certificates(self) -> list[Certificate]:
        """Of all sequences, of numbers unless they are in a period, and of the one with the least exponent; of masks of
        matrices two of that one: of its functions and of its scheme; of Hermite schemes HC^k of all sequences, too."""
        return [
            Certificate(text, lower, upper, None, exact, logarithm)
            for text, lower, upper, exact, logarithm in self._evidence.certificates()
        ]


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class LocalExponent(Enclosure):
    """The exponent where each new point of each level takes a value of its own: all limits have at least the lower end,
    those of one value everywhere at most the upper one."""

    order: int = 0
    """Each rule by itself keeps polynomials of lower degree."""
    _evidence: Any = dataclasses.field(default=None, repr=False, compare=False)

    def certificates(self) -> list[IntervalCertificate]:
        """One about all choices of values, where there is a lower end."""
        return _certificates(self._evidence)


@dataclasses.dataclass(frozen=True)
class LevelsLimit:
    """Of a scheme whose parameter follows a recurrence and tends to `value`."""

    value: Fraction
    sum_rules: int
    exponentials: tuple[int, ...]
    """The power of 1 + 2 T_j(v) z + z^2 in the symbol, for j = 1, 2, ...: x^i e^(+-ijtx) is generated for lower i."""
    exponent: Enclosure
    """All limits have at least the lower end, those of some data at late levels at most the upper one."""
    exact: bool
    formula: Optional[str] = None
    """The exponent in closed form, where it is exact and no rational number."""


@dataclasses.dataclass(frozen=True)
class CurvePiece:
    """For all values from low to high the exponent lies in the enclosure."""

    low: Fraction
    high: Fraction
    exponent: Enclosure
    product: tuple[int, ...]


@dataclasses.dataclass(frozen=True, repr=False)
class ExponentCurve:
    """The exponent over the parameter, between certified envelopes."""

    pieces: tuple[CurvePiece, ...]
    special: tuple[SpecialValue, ...]
    sum_rules: int
    parameter: str = "w"
    _evidence: Any = dataclasses.field(default=None, repr=False, compare=False)

    def __repr__(self) -> str:
        return f"<ExponentCurve over {self.parameter}: {len(self.pieces)} pieces>"

    def certificates(self) -> list[IntervalCertificate]:
        return _certificates(self._evidence)

    def plot(self, ax: Any = None) -> Any:
        """Draws what lies between the proved ends, and returns the axes of matplotlib."""
        return _plots.envelope(ax, self, self.parameter)


class Family(Named):
    """A scheme of one variable whose coefficients, numbers or matrices, depend on a parameter.

    >>> import subcert
    >>> f = subcert.family("four-point:w")
    >>> f.at("1/16").specification
    'mask:[-1,0,9,16,9,0,-1]/16@-3'
    >>> found = f.range("C1", -1, 1)
    >>> print(found.ends[-1].value.text(9), "zero of", found.ends[-1].polynomial)
    0.192729249 zero of -1 + 4*z + 32*z^3
    >>> merrien = subcert.family("merrien:lambda=-1/8,mu")
    >>> [p.holds.value for p in merrien.range("HC1", 0, 3, width="1e-3").pieces]
    ['yes', 'unknown', 'no']
    >>> print(merrien.at("-1/2").holder())
    2
    """

    @property
    def parameter(self) -> str:
        return self._handle.parameter

    @property
    def sum_rules(self) -> int:
        """Those that hold for all values."""
        return self._handle.sum_rules

    def __repr__(self) -> str:
        return f"<subcert family {self.specification} over {self.parameter}>"

    def __reduce__(self) -> Any:
        return family, (self.specification,)

    def at(self, value: Exact) -> Union[Scheme, VectorScheme]:
        """The scheme at one value of the parameter."""
        return scheme(self._handle.at(fraction(value)))

    def range(
        self,
        property: str,
        low: Exact,
        high: Exact,
        *,
        width: Exact = "1e-9",
        budget: float = 60,
        jobs: Optional[int] = None,
        progress: Progress = None,
    ) -> PropertyRange:
        """For which values between low and high a property holds: convergent, C1, C2, ..., holder>=3/2, sobolev>=1,
        stable, positive, monotone or convex; of matrices convergent, C1, ..., HC1, ... or holder>=3/2."""
        evidence = _core.property_range(
            self._handle, property, fraction(low), fraction(high), fraction(width), budget, _threads(jobs), progress
        )
        facts = evidence.facts
        return PropertyRange(
            pieces=tuple(Piece(p[0], p[1], p[2], p[3], Truth(p[4]), p[5]) for p in facts["pieces"]),
            ends=tuple(RangeEnd(Enclosure._of(e[0]), _symbol(e[1]), tuple(e[2]), Truth(e[3])) for e in facts["ends"]),
            special=_special(facts["special"]),
            sum_rules=facts["sum_rules"],
            complete=facts["complete"],
            parameter=self.parameter,
            summary=facts["summary"],
            _evidence=evidence,
        )

    def levels(
        self,
        property: str,
        low: Exact,
        high: Exact,
        *,
        recurrence: Optional[str] = None,
        start: Any = None,
        budget: float = 60,
        progress: Progress = None,
    ) -> Levels:
        """Whether a property holds for all sequences of values between low and high, one for each level: convergent,
        C1, C2, ..., holder>=3/2 or, of Hermite schemes, HC1. With a recurrence: for those where each value follows from
        the one before, from the level on at which all of them are between low and high. `start`: the first value, or a
        pair of the least and the largest one, which is None where there is none.

        >>> import subcert
        >>> subcert.family("four-point:w").levels("C1", "1/1000", "19/100").holds.value
        'yes'
        >>> conic = subcert.family("conic-four-point:v")
        >>> conic.levels("C1", "9/20", 1000, recurrence="v=sqrt((1+v)/2)", start=(-1, 1000000)).first_level
        2
        >>> found = conic.levels("C1", "9/20", 1000, recurrence="v=sqrt((1+v)/2)", start=(-1, None))
        >>> [c.certificate.verify().accepted for c in found.certificates()]
        [True, True]
        >>> hermite = subcert.family("merrien:lambda=-1/8,mu").levels("HC1", -1, 0)
        >>> hermite.holds.value, hermite.certificates()[0].certificate.verify().accepted
        ('yes', True)
        """
        if (recurrence is None) != (start is None):
            raise ValueError("levels: recurrence and start need each other")
        first, last = start if isinstance(start, tuple) else (start, start)
        ends = (fraction(first or 0), None if last is None and start is not None else fraction(last or 0))
        evidence = _core.property_of_levels(
            self._handle, property, fraction(low), fraction(high), recurrence, ends, budget, progress
        )
        facts = evidence.facts
        return Levels(
            holds=Truth(facts["holds"]),
            reason=facts["reason"],
            period=tuple(facts["period"]),
            sum_rules=facts["sum_rules"],
            first_level=facts["first_level"],
            _evidence=evidence,
        )

    def levels_limit(
        self, recurrence: str, low: Exact, high: Exact, *, budget: float = 60, progress: Progress = None
    ) -> Optional[LevelsLimit]:
        """The exponent where each level takes the parameter from the one before, for all first values between low and
        high; nothing where the values were not proved to tend to one rational number.

        >>> import subcert
        >>> limit = subcert.family("exponential-six-point:v").levels_limit("v=sqrt((1+v)/2)", "1/2", 10)
        >>> limit.exponentials, round(float(limit.exponent.lower), 5), limit.formula
        ((2,), 2.83007, '6 - log_2(9)')
        """
        facts = _core.limit_of_levels(self._handle, recurrence, fraction(low), fraction(high), budget, progress)
        if not facts:
            return None
        return LevelsLimit(
            value=facts["value"],
            sum_rules=facts["sum_rules"],
            exponentials=tuple(facts["exponentials"]),
            exponent=Enclosure._of(facts["exponent"]),
            exact=facts["exact"],
            formula=facts["formula"],
        )

    def levels_schemes(self, recurrence: str, start: Exact, levels: int) -> list[Scheme]:
        """The schemes of so many levels, where each takes the parameter from the one before; numbers that are not
        rational are replaced by some within 2^-100. For `refine`.

        >>> import subcert
        >>> f = subcert.family("conic-four-point:v")
        >>> schemes = f.levels_schemes("v=sqrt((1+v)/2)", "1/2", 4)
        >>> triangle = [[1, 0], [-0.5, 0.75**0.5], [-0.5, -(0.75**0.5)]]
        >>> circle = subcert.refine(schemes, triangle, 4, closed=True)
        >>> bool(abs((circle**2).sum(axis=1) - 1).max() < 1e-14)
        True
        """
        found = _core.masks_of_levels(self._handle, recurrence, fraction(start), levels)
        return [scheme(one) for one in found]

    def levels_values(
        self, recurrence: str, start: Exact, level: int = 8, *, progress: Progress = None
    ) -> tuple[list[Fraction], list[Enclosure]]:
        """x and y: what encloses the limit of these levels from the unit datum, at the points i / arity^level. Raises
        UndecidedError where differences were not proved to shrink.

        >>> import subcert
        >>> x, y = subcert.family("exponential-bspline:v").levels_values("v=sqrt((1+v)/2)", "1/2", 0)
        >>> y[x.index(0)].text(12)
        '0.608997781044'
        """
        arity, first, ends = _core.limit_values_of_levels(self._handle, recurrence, fraction(start), level, progress)
        return [Fraction(first + i, arity**level) for i in range(len(ends))], [Enclosure._of(e) for e in ends]

    def local_levels(self, low: Exact, high: Exact, *, budget: float = 60, progress: Progress = None) -> LocalExponent:
        """The exponent where each new point of each level takes a value of its own between low and high: the lower end
        holds for all choices, the upper one for one value everywhere.

        >>> import subcert
        >>> found = subcert.family("four-point:w").local_levels("1/1000", "3/20")
        >>> found > 1, found.order, found.certificates()[0].certificate.verify().accepted
        (<Truth.yes: 'yes'>, 2, True)
        """
        evidence = _core.local_levels(self._handle, fraction(low), fraction(high), budget, progress)
        return LocalExponent(*evidence.exponent, evidence.order, evidence)

    def curve(
        self,
        low: Exact,
        high: Exact,
        *,
        pieces: int = 200,
        budget: float = 60,
        jobs: Optional[int] = None,
        progress: Progress = None,
    ) -> ExponentCurve:
        """The Hoelder exponent between low and high, piece by piece."""
        evidence = _core.exponent_curve(
            self._handle, fraction(low), fraction(high), pieces, budget, _threads(jobs), progress
        )
        facts = evidence.facts
        return ExponentCurve(
            pieces=tuple(CurvePiece(p[0], p[1], Enclosure._of(p[2]), tuple(p[3])) for p in facts["pieces"]),
            special=_special(facts["special"]),
            sum_rules=facts["sum_rules"],
            parameter=self.parameter,
            _evidence=evidence,
        )


def family(specification: str) -> Family:
    """The family of this specification, with a letter, or a name as ``mu``, where a number may stand:
    ``four-point:w``, ``mask:[-w,0,1/2+w,1,1/2+w,0,-w]``, ``merrien:lambda=-1/8,mu``. Raises UsageError for a text
    that names none."""
    if not isinstance(specification, str):
        raise TypeError(f"family: expected a text, as 'four-point:w', got {type(specification).__name__}")
    return Family(_core.make_parametric_scheme(specification))


def _ends_text(piece: Piece) -> tuple[str, str]:
    """What is said of a decided piece is true as it is printed: it is rounded inward, the others outward."""
    inward = not piece.holds.is_unknown and piece.low < piece.high

    def text(x: Fraction, up: bool) -> str:
        if len(str(x)) <= 12:
            return str(x)
        with decimal.localcontext() as context:
            context.prec, context.rounding = 12, decimal.ROUND_CEILING if up else decimal.ROUND_FLOOR
            return str(decimal.Decimal(x.numerator) / x.denominator)

    return text(piece.low, inward), text(piece.high, not inward)


def _verdict(truth: Truth) -> str:
    return {Truth.yes: "proved", Truth.no: "refuted", Truth.unknown: "undecided"}[truth]


def _special(values: Iterable[dict[str, Any]]) -> tuple[SpecialValue, ...]:
    return tuple(
        SpecialValue(
            Enclosure._of(v["value"]),
            _symbol(v["polynomial"]),
            v["why"],
            Truth(v["holds"]),
            optional_enclosure(v.get("exponent")),
        )
        for v in values
    )


def _certificates(evidence: Any) -> list[IntervalCertificate]:
    return [
        IntervalCertificate(low, high, Truth(holds), Certificate(text, lower, upper))
        for low, high, holds, text, lower, upper in evidence.certificates()
    ]


def exponent_of_levels(
    schemes: Iterable[Union[str, Scheme]],
    *,
    period: Iterable[int] = (),
    follows: Iterable[tuple[int, int]] = (),
    budget: float = 60,
    progress: Progress = None,
) -> LevelsExponent:
    """The least exponent of the limits where each level takes one of these masks, of numbers or of matrices: any of
    them; or those of a period, numbers from 0, again and again; or so that each pair (before, after) is one of
    `follows`.

    >>> import subcert
    >>> found = subcert.exponent_of_levels(["four-point:w=1/4", "four-point:w=1/16"], follows=[(0, 1), (1, 0), (1, 1)])
    >>> round(float(found.exponent.lower), 5), found.sequence, len(found.certificates())
    (0.99734, (0, 1), 2)
    >>> hermite = subcert.exponent_of_levels(["merrien:lambda=-1/8,mu=1/2", "merrien:lambda=-1/8,mu=-1/2"])
    >>> hermite.formula, hermite.sum_rules_alone, hermite.hermite_order
    ('3 - log_2(3)', (3, 4), 1)
    """
    texts = [one if isinstance(one, str) else one.specification for one in schemes]
    evidence = _core.exponent_of_levels(texts, list(period), list(follows), budget, progress)
    facts = evidence.facts
    return LevelsExponent(
        exponent=Enclosure._of(facts["exponent"]),
        exact=Decision._of(facts["exact"]),
        sum_rules=facts["sum_rules"],
        sequence=tuple(facts["sequence"]),
        stable=facts["stable"],
        formula=facts["formula"],
        sum_rules_alone=tuple(facts["sum_rules_alone"]),
        hermite_order=facts["hermite_order"],
        _evidence=evidence,
    )
