#include "parametric_family.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

namespace subcert {
namespace {

/// sum over k of factors[k] matrices[k]
RationalMatrix combination(const std::vector<Rational>& factors, const std::vector<RationalMatrix>& matrices) {
  const std::size_t n = matrices.front().rows();
  RationalMatrix result(n, n);
  for (std::size_t k = 0; k < matrices.size(); ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) result(i, j) += factors[k] * matrices[k](i, j);
  return result;
}

}  // namespace

std::vector<std::vector<Rational>> bernstein_factors(long n, const Rational& low, const Rational& high) {
  std::vector<std::vector<Rational>> result;
  for (long i = 0; i <= n; ++i) {
    // The blossom of w^k with n - i arguments `low` and i arguments `high`: their elementary symmetric polynomials over
    // binomials.
    const LaurentPolynomial product = LaurentPolynomial({1, low}, 0).pow(n - i) *
                                      LaurentPolynomial({1, high}, 0).pow(i);
    result.emplace_back();
    Rational binomial = 1;
    for (long k = 0; k <= n; ++k) {
      result.back().push_back(product.coefficient(k) / binomial);
      binomial *= Rational(n - k, k + 1);
    }
  }
  return result;
}

MatrixFamily ParametricFamily::numerators_at(const Rational& w) const {
  std::vector<Rational> factors;
  for (int k = 0; k <= degree; ++k) factors.push_back(power(w, k));
  std::vector<RationalMatrix> matrices;
  for (const auto& one : powers) matrices.push_back(combination(factors, one));
  return matrices;
}

MatrixFamily ParametricFamily::at(const Rational& w) const {
  const Rational below = denominator(w);
  require(below != 0, "parametric family: need a value where the denominator is not zero, got {}", w);
  MatrixFamily result = numerators_at(w);
  if (below == 1) return result;
  std::vector<RationalMatrix> matrices;
  for (const RationalMatrix& matrix : result) matrices.push_back(Rational(1 / below) * matrix);
  return matrices;
}

std::optional<MatrixFamily> ParametricFamily::controls(const Rational& low, const Rational& high) const {
  std::vector<std::vector<Rational>> factors = bernstein_factors(degree, low, high);
  for (std::vector<Rational>& control : factors) {
    Rational below = 0;
    for (int k = 0; k <= degree; ++k) below += control[static_cast<std::size_t>(k)] * denominator.coefficient(k);
    if (below <= 0) return std::nullopt;
    for (Rational& factor : control) factor /= below;
  }
  std::vector<RationalMatrix> matrices;
  for (const auto& one : powers)
    for (const std::vector<Rational>& control : factors) matrices.push_back(combination(control, one));
  return MatrixFamily(std::move(matrices));
}

ParametricFamily BiparametricFamily::slice(const Rational& w) const {
  std::vector<Rational> factors;
  for (std::size_t j = 0; j < rows(); ++j) factors.push_back(power(w, static_cast<long>(j)));
  ParametricFamily result{{}, 1, static_cast<int>(columns) - 1};
  for (const auto& one : powers) {
    result.powers.emplace_back();
    for (std::size_t i = 0; i < columns; ++i) {
      std::vector<RationalMatrix> column;
      for (std::size_t j = 0; j < rows(); ++j) column.push_back(one[i + columns * j]);
      result.powers.back().push_back(combination(factors, column));
    }
  }
  return result;
}

MatrixFamily BiparametricFamily::controls(const std::array<Rational, 2>& low,
                                          const std::array<Rational, 2>& high) const {
  std::vector<std::vector<Rational>> factors;
  for (const auto& in_w : bernstein_factors(static_cast<long>(rows()) - 1, low[1], high[1]))
    for (const auto& in_v : bernstein_factors(static_cast<long>(columns) - 1, low[0], high[0])) {
      factors.emplace_back();
      for (const Rational& y : in_w)
        for (const Rational& x : in_v) factors.back().push_back(x * y);
    }
  std::vector<RationalMatrix> matrices;
  for (const auto& one : powers)
    for (const std::vector<Rational>& control : factors) matrices.push_back(combination(control, one));
  return matrices;
}

ParametricFamily transition_matrices(const ParametricMask& mask, const Rational& inside) {
  const IndexRange support = mask.support();
  const IndexRange window{0, TransitionWindow(support.last - support.first, mask.arity()).width - 1};
  const LaurentPolynomial sign = mask.denominator()(inside) < 0 ? -1 : 1;
  ParametricFamily result{{}, sign * mask.denominator(), mask.degree()};
  for (long t = 0; t < mask.arity(); ++t) {
    result.powers.emplace_back();
    for (const LaurentPolynomial& power : mask.powers())
      result.powers.back().push_back(
          transition_block((sign * power).shifted(-support.first), mask.arity(), t, window, window));
  }
  return result;
}

ParametricFamily central_matrices(const ParametricMask& mask) {
  const std::vector<LaurentPolynomial>& powers = mask.powers();
  std::vector<LaurentPolynomial> autocorrelation(2 * powers.size() - 1);
  for (std::size_t j = 0; j < powers.size(); ++j)
    for (std::size_t k = 0; k < powers.size(); ++k) autocorrelation[j + k] += powers[j] * powers[k].reversed();
  const IndexRange support = mask.support();
  const long reach = (support.last - support.first) / (mask.arity() - 1);
  ParametricFamily result{{{}}, mask.denominator() * mask.denominator(), 2 * mask.degree()};
  for (const LaurentPolynomial& power : autocorrelation)
    result.powers.front().push_back(central_matrix(power, mask.arity(), reach));
  return result;
}

}  // namespace subcert
