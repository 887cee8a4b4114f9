"""Exact numbers go in and come out; masks, symbols, limits and variances agree with fractions computed here."""

import decimal
from fractions import Fraction

import numpy
import pytest
import subcert
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st

small = st.fractions(min_value=-3, max_value=3, max_denominator=60)
large = st.fractions() | st.integers(min_value=-(10**40), max_value=10**40).map(Fraction)


@given(large)
@settings(max_examples=200, deadline=None)
def test_numbers_survive_the_journey(x):
    assert subcert.Symbol((x, Fraction(1)), 0)(0) == x
    matrix = [[x, 0], [0, 0]]
    radius = subcert.jsr([matrix], budget=5)
    assert radius.lower <= abs(x) <= radius.upper
    assert str(subcert.Symbol((x,), 0)) == str(x)


@pytest.mark.parametrize(
    "value, expected",
    [
        (3, Fraction(3)),
        ("-7/4", Fraction(-7, 4)),
        ("1e-3", Fraction(1, 1000)),
        (decimal.Decimal("0.1"), Fraction(1, 10)),
        (numpy.int64(-5), Fraction(-5)),
        (sympy.Rational(2, 6), Fraction(1, 3)),
        (sympy.Integer(4), Fraction(4)),
    ],
)
def test_what_is_exact(value, expected):
    assert subcert.fraction(value) == expected


@pytest.mark.parametrize("value", [0.5, numpy.float64(0.5), sympy.Float(0.5), sympy.sqrt(2), None, [1]])
def test_what_is_not_exact(value):
    with pytest.raises(TypeError, match="exact number"):
        subcert.fraction(value)


@pytest.mark.parametrize("text", ["", "x", "1/0", "nan", "inf", "1/2/3"])
def test_texts_that_are_no_numbers(text):
    with pytest.raises(subcert.UsageError, match="expected an exact number"):
        subcert.fraction(text)


def affine_masks(arity):
    """Masks with coset sums 1: each coset is free but for one coefficient."""

    def complete(cosets):
        cosets = [c + [1 - sum(c)] for c in cosets]
        length = max(map(len, cosets))
        return [c[k] if k < len(c) else Fraction(0) for k in range(length) for c in cosets]

    return st.lists(st.lists(small, max_size=4), min_size=arity, max_size=arity).map(complete)


def times(p, q):
    result = [Fraction(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            result[i + j] += a * b
    return result


def divided(p, q):
    """The quotient of polynomials, or None."""
    p, quotient = list(p), []
    while len(p) >= len(q):
        c = p[-1] / q[-1]
        quotient.append(c)
        for k in range(len(q)):
            p[len(p) - len(q) + k] -= c * q[k]
        p.pop()
    return quotient[::-1] if not any(p) else None


@given(st.integers(2, 4).flatmap(lambda a: st.tuples(st.just(a), affine_masks(a))), st.integers(-9, 9))
@settings(max_examples=150, deadline=None)
def test_masks_and_symbols(case, first):
    arity, coefficients = case
    s = subcert.mask(coefficients, first=first, arity=arity)
    kept = [c for c in range(len(coefficients)) if coefficients[c] != 0]
    assert list(s.mask) == coefficients[kept[0] : kept[-1] + 1]
    assert s.first_index == first + kept[0]
    assert s.symbol(1) == arity
    assert s.symbol(Fraction(2, 3)) == sum(c * Fraction(2, 3) ** (first + k) for k, c in enumerate(coefficients))
    assert s.symbol.to_sympy().subs("z", sympy.Rational(2, 3)) == sympy.Rational(str(s.symbol(Fraction(2, 3))))
    # Sum rules by division, one by one.
    rest, rules = list(s.mask), 0
    while len(rest) >= arity and (quotient := divided(rest, [Fraction(1)] * arity)) is not None:
        rest, rules = quotient, rules + 1
    assert s.sum_rules == rules
    assert list(s.remaining_factor.coefficients) == rest
    assert subcert.scheme(s.specification) == s


@pytest.mark.parametrize(
    "name", ["primal:n=3", "dual:n=2", "four-point:w=1/16", "ary:a=3,points=4,d=3", "bspline:degree=3"]
)
def test_limits_satisfy_the_refinement_equation(name):
    s = subcert.scheme(name)
    x, y = s.limit(2, exact=True)
    phi = dict(zip(x, y))
    for point, value in phi.items():
        assert (
            value == sum(a * phi.get(s.arity * point - (s.first_index + k), 0) for k, a in enumerate(s.mask))
            or s.arity * point not in phi
        )
    # The shifts sum to 1, and the variance curve is the sum of their squares.
    variance = s.variance(2)
    for i in range(s.arity**2):
        shifts = [v for u, v in phi.items() if (u - Fraction(i, s.arity**2)).denominator == 1]
        assert sum(shifts) == 1
        assert sum(v * v for v in shifts) == variance[i]


@given(affine_masks(2), st.lists(st.integers(-100, 100), min_size=12, max_size=20))
@settings(max_examples=60, deadline=None)
def test_closed_refinement_is_the_convolution(coefficients, data):
    s = subcert.mask(coefficients, first=-3)
    refined = s.refine(numpy.array(data, dtype=float), 1, closed=True)
    n = len(data)
    expected = [Fraction(0)] * (2 * n)
    for j, f in enumerate(data):
        for k, a in enumerate(coefficients):
            expected[(2 * j + k - 3) % (2 * n)] += a * f
    # Where the cycle begins is a matter of the parametrization.
    assert any(numpy.allclose(refined, numpy.roll(numpy.array(expected, float), k), atol=1e-9) for k in range(2 * n))


def test_equality_with_numbers_is_decided_or_raises():
    two = subcert.scheme("four-point:w=1/16").holder()
    for value in (two, two.enclosure):
        assert (value == 2) is True and (value != 2) is False and (2 == value) is True
        assert (value == "2") is True and (value == Fraction(5, 2)) is False and (value != Fraction(5, 2)) is True
        assert hash(value) == hash(2) and value in {2, 3} and 2 in {value}
        assert (value == None) is False  # noqa: E711
        for other in (2.0, [2], object()):
            with pytest.raises(TypeError):
                value == other
            with pytest.raises(TypeError):
                value != other
        with pytest.raises(ValueError):
            value == "two"
    golden = subcert.jsr([[[1, 1], [0, 1]], [[1, 0], [1, 1]]])
    middle = (golden.lower + golden.upper) / 2
    for value in (golden, golden.enclosure):
        assert (value == 2) is False and (value != 1) is True
        for question in (lambda: value == middle, lambda: value != middle, lambda: middle == value):
            with pytest.raises(subcert.UndecidedError):
                question()
    assert two == subcert.scheme("four-point:w=1/16").holder() and two != subcert.scheme("dd:n=3").holder()
    open_end = subcert.Enclosure(Fraction(1), None)
    assert open_end == subcert.Enclosure(Fraction(1), None) and open_end != 0
    with pytest.raises(subcert.UndecidedError):
        open_end == 1


def test_a_scheme_is_a_text():
    for wrong in (["x"], 3, None, b"dd:n=2"):
        with pytest.raises(TypeError, match="expected a text"):
            subcert.scheme(wrong)
