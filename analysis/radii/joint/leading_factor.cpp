#include "leading_factor.hpp"

#include "cost.hpp"
#include "subspace.hpp"

#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <algorithm>

namespace subcert {

namespace {

constexpr int newton_steps = 400;  // zeros close together are approached by a factor of 2 or less at a time

/// (-1)^d p(-z), d the degree.
LaurentPolynomial mirrored(const LaurentPolynomial& p) {
  std::vector<Rational> coefficients;
  for (long k = 0; k <= p.highest(); ++k)
    coefficients.push_back((p.highest() - k) % 2 == 0 ? p.coefficient(k) : Rational(-p.coefficient(k)));
  return LaurentPolynomial(coefficients, 0);
}

}  // namespace

namespace radius {

LeadingFactor LeadingFactor::negated() const {
  const auto minus = [](const ComplexBall& z) { return z * Ball(-1L, z.bits()); };
  LeadingFactor result{mirrored(factor), mirrored(others), multiplicity, minus(zero), {}};
  for (const ComplexBall& other : zeros) result.zeros.push_back(minus(other));
  return result;
}

AttainedNumber LeadingFactor::number(std::size_t length) const {
  if (const auto rational = zero_of_linear(factor)) return {factor, {*rational, 0}, length};
  RationalComplex point = exact_middle(zero);
  if (imaginary_part(zero).enclosure(zero.bits()).contains(0)) point.im = 0;
  return {factor, point, length};
}

std::optional<LeadingFactor> nearest_factor(const LaurentPolynomial& p, const RationalComplex& near, slong bits) {
  const ComplexBall point = ball_around(near, bits);
  LeadingFactor best{{}, {}, 0, ComplexBall::indeterminate(bits), {}};
  for (const PolynomialFactor& own : irreducible_factors(p)) {
    if (own.polynomial.lowest() != 0) continue;
    for (const ComplexBall& zero : complex_roots(own.polynomial, bits)) {
      best.zeros.push_back(zero);
      if (abs(best.zero - point).is_less(abs(zero - point))) continue;
      best.zero = zero;
      best.factor = own.polynomial;
      best.multiplicity = own.multiplicity;
    }
  }
  if (best.multiplicity == 0) return std::nullopt;
  best.others = *p.exact_quotient(best.factor.pow(best.multiplicity));
  return best;
}

std::optional<LeadingFactor> leading_factor(const RationalMatrix& matrix, const RationalComplex& near, slong bits,
                                            const Deadline& deadline) {
  const auto characteristic = characteristic_polynomial(matrix, deadline);
  if (!characteristic || !has_time_for_roots(*characteristic, deadline)) return std::nullopt;
  return nearest_factor(*characteristic, near, bits);
}

ComplexBall refined_zero(const LaurentPolynomial& p, ComplexBall z) {
  const LaurentPolynomial derivative = p.derivative();
  const slong enough = z.bits() * 3 / 4;
  for (int k = 0; k < newton_steps; ++k) {
    const ComplexBall step = value_at(p, z) / value_at(derivative, z);
    if (!step.is_finite()) break;
    z = middle(z - step);
    if (abs(step.scaled(enough)).is_less(abs(z))) break;
  }
  return z;
}

std::optional<std::vector<Integer>> seed_of(const RationalMatrix& matrix, const LeadingFactor& factor,
                                            const ComplexVector& start) {
  const auto times = [&](const LaurentPolynomial& p, const Vector& vector) {
    Vector value(matrix.rows());
    for (long k = p.highest(); k >= 0; --k) {
      value = matrix * value;
      for (std::size_t i = 0; i < value.size(); ++i) value[i] += p.coefficient(k) * vector[i];
    }
    return value;
  };
  const auto is_zero = [](const Vector& v) { return std::ranges::all_of(v, [](const Rational& x) { return x == 0; }); };
  Vector vector(matrix.rows()), seed(matrix.rows());
  if (factor.multiplicity > 1) {
    if (start.empty()) return std::nullopt;
    // Its imaginary part is one of conjugate eigenvectors, to which the sum of images gives no weight.
    std::ranges::transform(start, vector.begin(), &RationalComplex::re);
    seed = times(factor.others, vector);
  } else {
    for (std::size_t i = 0; i < vector.size() && is_zero(seed); ++i) {
      vector.assign(vector.size(), 0);
      vector[i] = 1;
      seed = times(factor.others, vector);
    }
  }
  if (is_zero(seed) || !is_zero(times(factor.factor, seed))) return std::nullopt;
  return primitive(seed);
}

}  // namespace radius
}  // namespace subcert
