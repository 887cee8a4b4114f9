// Polynomials whose coefficients are polynomials in c = cos(2 pi/n), C = cos(2 pi k/n) and 1/n, and their zeros for all
// of these in intervals: section 5.12 of ../../certificates/SPEC.md.
#pragma once

#include "turning.hpp"

#include <array>
#include <map>
#include <optional>
#include <vector>

namespace subcert_check {

enum Letter : std::size_t { letter_c, letter_frequency, letter_share, letters };

/// Canonical: no coefficient is 0.
using LetterPolynomial = std::map<std::array<unsigned, letters>, mpq_class>;
LetterPolynomial letter(Letter which, const mpq_class& factor = 1);
LetterPolynomial operator+(const LetterPolynomial& x, const LetterPolynomial& y);
LetterPolynomial times(const LetterPolynomial& x, const LetterPolynomial& y, Arithmetic& arithmetic);
LetterPolynomial derivative(const LetterPolynomial& x, Letter by);

/// a + b w, w^2 = 2 cosine w - 1.
struct LetterTurning {
  LetterPolynomial a, b;
};
LetterTurning operator+(const LetterTurning& x, const LetterTurning& y);
LetterTurning times(const LetterTurning& x, const LetterTurning& y, const LetterPolynomial& cosine,
                    Arithmetic& arithmetic);
LetterTurning turned(LetterTurning x, long turns, const LetterPolynomial& cosine, Arithmetic& arithmetic);

/// det(x - matrix), the lowest coefficient first. Rejects one that is not real.
std::vector<LetterPolynomial> characteristic_polynomial(const std::vector<std::vector<LetterTurning>>& matrix,
                                                        const LetterPolynomial& cosine, Arithmetic& arithmetic);

using Letters = std::array<Interval, letters>;
/// A polynomial in x, the lowest coefficient first.
using IntervalPolynomial = std::vector<Interval>;

IntervalPolynomial values(const std::vector<LetterPolynomial>& p, const Letters& at, const Intervals& intervals);
IntervalPolynomial derivatives(const std::vector<LetterPolynomial>& p, Letter by, const Letters& at,
                               const Intervals& intervals);
Interval value_at(const IntervalPolynomial& p, const Interval& x, const Intervals& intervals);
Interval slope_at(const IntervalPolynomial& p, const Interval& x, const Intervals& intervals);
/// x/y, where y is not near 0.
std::optional<Interval> quotient(const Interval& x, const Interval& y, const Intervals& intervals);

/// Near a zero, if steps from the start come to one: nothing is proved.
mpz_class approach_zero(const IntervalPolynomial& p, mpz_class start, const Intervals& intervals);
/// An interval with one zero for all coefficients, which is simple.
std::optional<Interval> zero_near(const IntervalPolynomial& p, const mpz_class& start, const Intervals& intervals);
/// Without the factor x - zero, of the zero that belongs to the coefficients.
IntervalPolynomial deflated(const IntervalPolynomial& p, const Interval& zero, const Intervals& intervals);
/// Whether all zeros are shown to have moduli below `radius`. Domain: monic.
bool has_zeros_below(IntervalPolynomial p, const mpz_class& radius, const Intervals& intervals);

}  // namespace subcert_check
