#include "named_radius.hpp"

#include "leading_factor.hpp"

#include <algorithm>

namespace subcert {
namespace {

constexpr std::size_t most_rows = 64;
constexpr slong root_bits = 600;

/// Whether p(-z) is p(z) or -p(z).
bool is_even_or_odd(const LaurentPolynomial& p) {
  for (long k = 0; k <= p.highest(); ++k)
    if ((p.highest() - k) % 2 != 0 && p.coefficient(k) != 0) return false;
  return true;
}

/// Whether all zeros with such a modulus have the modulus of the one that was found.
bool is_told_by(const Enclosure& modulus, const radius::LeadingFactor& found) {
  const auto may_be_there = [&](const ComplexBall& zero) {
    const Enclosure size = abs(zero).enclosure(root_bits);
    return *size.lower <= *modulus.upper && *modulus.lower <= *size.upper;
  };
  const bool real = imaginary_part(found.zero).enclosure(root_bits).contains(0);
  return may_be_there(found.zero) &&
         std::ranges::count_if(found.zeros, may_be_there) <= (real ? 1 : 2) * (is_even_or_odd(found.factor) ? 2 : 1);
}

}  // namespace

std::optional<AttainedNumber> named_radius(const RationalMatrix& product, std::size_t length,
                                           const RationalComplex& near, const Enclosure& radius, long degree) {
  if (product.rows() > most_rows || !radius.is_bounded() || *radius.lower <= 0) return std::nullopt;
  // Zeros that are about as large as 1 are found fast.
  const auto times = static_cast<long>(length);
  const Rational unit = power(Rational(2), binary_exponent(*radius.upper)), less = power(unit, -times);
  const Enclosure modulus{less * power(*radius.lower, times), less * power(*radius.upper, times)};
  const auto found = radius::leading_factor(less * product, less * near, root_bits, {});
  if (!found || found->factor.highest() > degree || !is_told_by(modulus, *found)) return std::nullopt;
  const AttainedNumber number = found->number(length);
  const bool negative = number.point.im == 0 && number.point.re < 0;
  return scaled(negative ? found->negated().number(length) : number, unit);
}

std::optional<AttainedNumber> named_radius(const MatrixFamily& family, const JointSpectralRadius& radius, long degree) {
  const ProductEvidence& product = radius.product;
  if (!radius.exact.is_yes() || product.word.empty() || family.size() > most_rows) return std::nullopt;
  return named_radius(family.product(product.word), product.word.size(), product.eigenvalue, radius.radius, degree);
}

}  // namespace subcert
