"""Exact numbers, enclosures and three-valued answers."""

from __future__ import annotations

import dataclasses
import decimal
import enum
import numbers
from fractions import Fraction
from typing import Any, Optional, Union

from ._calls import core as _core
from ._errors import DomainError, UndecidedError, UsageError

Exact = Union[int, Fraction, str, decimal.Decimal, numbers.Rational]
"""What is read as an exact number: int, Fraction, Decimal, the integers of numpy and rationals of sympy, and texts as
``"1/16"`` or ``"0.1"``. A float is none: write ``Fraction(0.1)`` where its exact binary value is meant."""


def fraction(value: Exact) -> Fraction:
    """The exact number.

    >>> fraction("1/16"), fraction("0.1"), fraction(3)
    (Fraction(1, 16), Fraction(1, 10), Fraction(3, 1))
    """
    if isinstance(value, (str, decimal.Decimal)):
        try:
            return Fraction(value)
        except (ValueError, OverflowError, ZeroDivisionError):
            raise UsageError(f"expected an exact number as 3, 1/16 or 0.1, got {str(value)[:40]!r}") from None
    if isinstance(value, numbers.Rational) or (
        hasattr(value, "numerator") and hasattr(value, "denominator") and not isinstance(value, float)
    ):
        try:
            return Fraction(int(value.numerator), int(value.denominator))
        except (TypeError, ValueError):
            pass
    hint = "; a float is exact only as Fraction(x)" if isinstance(value, (float, numbers.Real)) else ""
    raise TypeError(f"expected an exact number (int, Fraction, Decimal or text), got {type(value).__name__}{hint}")


class Truth(enum.Enum):
    """A proof says yes or no, or none was found. It is no bool: ``if truth:`` raises, as `unknown` is neither.

    >>> Truth.yes.is_yes, Truth.unknown.is_no
    (True, False)
    >>> bool(Truth.unknown)
    Traceback (most recent call last):
    ...
    TypeError: a three-valued answer is no bool; ask .is_yes, .is_no or .is_unknown
    """

    yes = "yes"
    no = "no"
    unknown = "unknown"

    @property
    def is_yes(self) -> bool:
        return self is Truth.yes

    @property
    def is_no(self) -> bool:
        return self is Truth.no

    @property
    def is_unknown(self) -> bool:
        return self is Truth.unknown

    def __bool__(self) -> bool:
        raise TypeError("a three-valued answer is no bool; ask .is_yes, .is_no or .is_unknown")

    def __str__(self) -> str:
        return self.value


@dataclasses.dataclass(frozen=True)
class Decision:
    """A three-valued answer with the argument for it, or with what is missing."""

    truth: Truth
    reason: str

    @classmethod
    def _of(cls, pair: tuple[str, str]) -> Decision:
        return cls(Truth(pair[0]), pair[1])

    @property
    def is_yes(self) -> bool:
        return self.truth.is_yes

    @property
    def is_no(self) -> bool:
        return self.truth.is_no

    @property
    def is_unknown(self) -> bool:
        return self.truth.is_unknown

    def __bool__(self) -> bool:
        return bool(self.truth)

    def __str__(self) -> str:
        return f"{self.truth}: {self.reason}" if self.reason else str(self.truth)


Ends = tuple[Optional[Fraction], Optional[Fraction]]


@dataclasses.dataclass(frozen=True, repr=False, eq=False)
class Enclosure:
    """A set lower <= x <= upper that contains the true value. None: no end is proved.

    Comparisons of size with numbers are three-valued, and proved where they say yes or no. ``==`` and ``!=`` are bools:
    with a number they say whether the true value is that number, and raise UndecidedError where the enclosure leaves it
    open; with an enclosure they say whether both have the same ends.

    >>> from fractions import Fraction
    >>> e = Enclosure(Fraction(3, 2), Fraction(8, 5))
    >>> e > 1, e < Fraction(3, 2), e >= Fraction(31, 20)
    (<Truth.yes: 'yes'>, <Truth.no: 'no'>, <Truth.unknown: 'unknown'>)
    >>> print(e)
    1.5 ... 1.6
    >>> e == 2, e != 1, Enclosure(Fraction(2), Fraction(2)) == 2
    (False, True, True)
    >>> e == Fraction(31, 20)
    Traceback (most recent call last):
    ...
    subcert.UndecidedError: 1.5 ... 1.6 == 31/20 is not decided
    """

    lower: Optional[Fraction]
    upper: Optional[Fraction]

    @classmethod
    def _of(cls, ends: Ends) -> Enclosure:
        return cls(ends[0], ends[1])

    @property
    def is_bounded(self) -> bool:
        """Whether both ends are proved."""
        return self.lower is not None and self.upper is not None

    @property
    def is_point(self) -> bool:
        """Whether the enclosure is one number."""
        return self.lower is not None and self.lower == self.upper

    @property
    def width(self) -> Fraction:
        """The distance of the ends. Raises DomainError where one is absent."""
        if self.lower is None or self.upper is None:
            raise DomainError("width: need both ends of the enclosure")
        return self.upper - self.lower

    def __contains__(self, value: Exact) -> bool:
        x = fraction(value)
        return (self.lower is None or self.lower <= x) and (self.upper is None or x <= self.upper)

    def __float__(self) -> float:
        """The middle. Raises DomainError where an end is absent."""
        if self.lower is None or self.upper is None:
            raise DomainError("float: need both ends of the enclosure")
        return float((self.lower + self.upper) / 2)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Enclosure):
            return (self.lower, self.upper) == (other.lower, other.upper)
        if other is None:
            return False
        x = fraction(other)  # type: ignore[arg-type]
        if x not in self:
            return False
        if self.is_point:
            return True
        raise UndecidedError(f"{self} == {x} is not decided")

    def __hash__(self) -> int:
        return hash(self.lower) if self.is_point else hash((self.lower, self.upper))

    def __gt__(self, other: Exact) -> Truth:  # type: ignore[misc]
        x = fraction(other)
        if self.lower is not None and self.lower > x:
            return Truth.yes
        return Truth.no if self.upper is not None and self.upper <= x else Truth.unknown

    def __ge__(self, other: Exact) -> Truth:  # type: ignore[misc]
        x = fraction(other)
        if self.lower is not None and self.lower >= x:
            return Truth.yes
        return Truth.no if self.upper is not None and self.upper < x else Truth.unknown

    def __lt__(self, other: Exact) -> Truth:
        return _negation(self >= other)

    def __le__(self, other: Exact) -> Truth:
        return _negation(self > other)

    def text(self, digits: int = 14) -> str:
        """Decimal ends, rounded outward, or one number where both round to it."""
        return _core.enclosure_text((self.lower, self.upper), digits)

    def __str__(self) -> str:
        return self.text()

    def __repr__(self) -> str:
        return f"<Enclosure {self}>"

    def to_dict(self) -> dict[str, Optional[str]]:
        """The exact ends as texts, None where there is none."""
        return {end: None if x is None else str(x) for end, x in (("lower", self.lower), ("upper", self.upper))}

    def to_latex(self, digits: int = 14) -> str:
        """A number, with dots where it goes on and no digit rounded up; an interval; or a relation.

        >>> from fractions import Fraction
        >>> Enclosure(Fraction(2), Fraction(2)).to_latex(), Enclosure(Fraction(1), None).to_latex()
        ('2', '\\\\ge 1')
        >>> print(Enclosure(Fraction(3, 2), Fraction(8, 5)).to_latex())
        [1.5,\\,1.6]
        """
        if self.lower is None and self.upper is None:
            return "?"
        if self.lower is None or self.upper is None:
            return self.text(digits).replace(">=", "\\ge").replace("<=", "\\le")
        if self.is_point and len(str(self.lower)) <= 24:
            n, d = self.lower.numerator, self.lower.denominator
            return str(n) if d == 1 else f"\\frac{{{n}}}{{{d}}}"
        low, high = truncated(self.lower, digits), truncated(self.upper, digits)
        if low == high:
            return f"{low}\\ldots"
        low, _, high = self.text(digits).partition(" ... ")
        return f"[{low},\\,{high or low}]"

    def _repr_latex_(self) -> str:
        return f"${self.to_latex()}$"


def truncated(value: Fraction, digits: int) -> str:
    """The first significant digits, with zeros where these are some, not rounded up.

    >>> truncated(Fraction(2, 3), 4), truncated(Fraction(3, 2), 4)
    ('0.6666', '1.500')
    """
    with decimal.localcontext() as context:
        context.prec, context.rounding = digits, decimal.ROUND_FLOOR
        number = decimal.Decimal(value.numerator) / value.denominator
        return str(number.quantize(decimal.Decimal(1).scaleb(number.adjusted() - digits + 1)) if number else number)


def _negation(truth: Truth) -> Truth:
    return {Truth.yes: Truth.no, Truth.no: Truth.yes, Truth.unknown: Truth.unknown}[truth]


def optional_enclosure(ends: Optional[Ends]) -> Optional[Enclosure]:
    return None if ends is None else Enclosure._of(ends)


def bits_of(width: Optional[Exact]) -> int:
    """Of enclosures that are to be at most so wide."""
    return _core.default_bits if width is None else _core.bits_for_width(fraction(width))
