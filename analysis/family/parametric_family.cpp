#include "parametric_family.hpp"

#include <subcert/analysis/transition/transition.hpp>

namespace subcert {
namespace {

/// sum over k of factors[k] matrices[k]
RationalMatrix combination(const std::vector<Rational>& factors, const std::vector<RationalMatrix>& matrices) {
  const std::size_t n = matrices.front().rows();
  RationalMatrix result(n, n);
  for (std::size_t k = 0; k < factors.size(); ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) result(i, j) += factors[k] * matrices[k](i, j);
  return result;
}

/// The factors of the powers of w in the i-th Bernstein coefficient of degree n on [low, high]: the blossom of w^k with
/// n - i arguments `low` and i arguments `high`.
std::vector<Rational> blossom(long n, long i, const Rational& low, const Rational& high) {
  // The elementary symmetric polynomials of the arguments over binomials.
  const LaurentPolynomial product = LaurentPolynomial({1, low}, 0).pow(n - i) * LaurentPolynomial({1, high}, 0).pow(i);
  std::vector<Rational> result;
  Rational binomial = 1;
  for (long k = 0; k <= n; ++k) {
    result.push_back(product.coefficient(k) / binomial);
    binomial *= Rational(n - k, k + 1);
  }
  return result;
}

}  // namespace

MatrixFamily ParametricFamily::at(const Rational& w) const {
  std::vector<Rational> factors;
  for (int k = 0; k <= degree(); ++k) factors.push_back(power(w, k));
  std::vector<RationalMatrix> matrices;
  for (const auto& one : powers) matrices.push_back(combination(factors, one));
  return matrices;
}

MatrixFamily ParametricFamily::controls(const Rational& low, const Rational& high) const {
  std::vector<RationalMatrix> matrices;
  for (const auto& one : powers)
    for (int i = 0; i <= degree(); ++i) matrices.push_back(combination(blossom(degree(), i, low, high), one));
  return matrices;
}

ParametricFamily transition_matrices(const ParametricMask& mask) {
  const IndexRange support = mask.support();
  const IndexRange window{0, TransitionWindow(support.last - support.first, mask.arity()).width - 1};
  ParametricFamily result;
  for (long t = 0; t < mask.arity(); ++t) {
    result.powers.emplace_back();
    for (const LaurentPolynomial& power : mask.powers())
      result.powers.back().push_back(transition_block(power.shifted(-support.first), mask.arity(), t, window, window));
  }
  return result;
}

}  // namespace subcert
