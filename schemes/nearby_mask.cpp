#include "nearby_mask.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr long guard_bits = 40;  // below the accuracy

/// What brings the sum to the arity.
std::optional<Rational> factor_of(const Rational& sum, int arity, const Rational& error) {
  if (abs(sum - arity) <= error) return Rational(1);
  if (abs(sum - 1) <= error || (sum > 0 && abs(sum * sum - arity) <= 2 * sum * error)) return arity / sum;
  return std::nullopt;
}

/// The q with the sum arity^(1 - order) for which the coefficients of sigma^order q are nearest to these.
std::vector<Rational> nearest_factor(const std::vector<Rational>& a, const LaurentPolynomial& sigma, int arity,
                                     int order) {
  const std::size_t size = a.size() - static_cast<std::size_t>(sigma.highest());
  RationalMatrix system(size + 1, size + 1), right(size + 1, 1);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j)
      for (long k = 0; k <= sigma.highest(); ++k)
        system(i, j) += sigma.coefficient(k) * sigma.coefficient(k + static_cast<long>(i) - static_cast<long>(j));
    for (long k = 0; k <= sigma.highest(); ++k)
      right(i, 0) += sigma.coefficient(k) * a[i + static_cast<std::size_t>(k)];
    system(i, size) = system(size, i) = 1;
  }
  right(size, 0) = power(Rational(arity), 1 - order);
  const RationalMatrix solution = solve(system, right);
  std::vector<Rational> q;
  for (std::size_t i = 0; i < size; ++i) q.push_back(solution(i, 0));
  return q;
}

}  // namespace

std::optional<NearbyMask> nearby_mask(const std::vector<Rational>& coefficients, long first, int arity,
                                      const Rational& accuracy) {
  const auto count = static_cast<long>(coefficients.size());
  Rational sum = 0;
  for (const Rational& c : coefficients) sum += c;
  const auto factor = factor_of(sum, arity, count * accuracy);
  if (!factor) return std::nullopt;
  std::vector<Rational> a;
  for (const Rational& c : coefficients) a.push_back(*factor * c);
  const Rational unit = power(Rational(2), binary_exponent(accuracy) - guard_bits), most = *factor * accuracy;
  const LaurentPolynomial step(std::vector<Rational>(static_cast<std::size_t>(arity), 1), 0);
  std::optional<NearbyMask> best;
  LaurentPolynomial sigma = 1;
  for (int order = 1; count - order * (arity - 1) >= 1; ++order) {
    sigma *= step;
    std::vector<Rational> q = nearest_factor(a, sigma, arity, order);
    Rational rest = power(Rational(arity), 1 - order);
    for (Rational& c : q) rest -= c = to_multiple(c, unit, Rounding::nearest);
    q.front() += rest;
    const LaurentPolynomial symbol = sigma * LaurentPolynomial(q, 0);
    Rational change = 0;
    for (long i = 0; i < count; ++i)
      change = std::max(change, Rational(abs(symbol.coefficient(i) - a[static_cast<std::size_t>(i)])));
    if (change > most) break;
    best = {symbol.shifted(first), order, *factor, change};
  }
  return best;
}

}  // namespace subcert
