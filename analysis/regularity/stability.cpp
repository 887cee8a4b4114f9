#include "stability.hpp"

#include <subcert/analysis/symbol/rational_matrix.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace subcert {

Decision has_stable_shifts(const Mask& mask) {
  const int arity = mask.arity();
  // Zeros shared by z, zeta z, ..., zeta^(a-1) z are the a-th roots of the common zeros of the cosets.
  const LaurentPolynomial common = common_factor_of_cosets(mask);
  if (common.is_zero() || has_root_on_unit_circle(common))
    return {Truth::no, "the sub-symbols have a common zero on the unit circle"};
  // Cyclic zeros of a rational symbol: an m coprime to the arity with Phi_{m d} | a for all divisors d > 1 of it.
  const long degree = mask.symbol().length() - 1;
  // Orders k with totient(k) <= degree are at most 7 degree: k / totient(k) < e^gamma log log k + 2.51 / log log k for
  // k >= 3 [RS62], which stays below 7 for 30 <= k <= 10^9; below 30 it is at most 3.
  for (long m = 2; arity * m <= 7 * degree; ++m) {
    if (std::gcd(m, static_cast<long>(arity)) != 1) continue;
    bool cyclic = true;
    for (long d = 2; d <= arity && cyclic; ++d)
      if (arity % d == 0)
        cyclic = totient(m * d) <= degree && mask.symbol().exact_quotient(cyclotomic(m * d)).has_value();
    if (cyclic) return {Truth::no, "the symbol vanishes on a cycle of roots of unity of order " + std::to_string(m)};
  }
  return {Truth::yes, common.length() == 1 ? "the sub-symbols have no common zero, and there are no cyclic zeros"
                                           : "no common zero of the sub-symbols lies on the unit circle, and there are "
                                             "no cyclic zeros"};
}

Decision has_stable_shifts(const Mask& mask, const Rational& distance) {
  const Decision unknown{Truth::unknown, "the shifts may be unstable for other masks that round to this one"};
  const std::vector<Rational> coefficients = mask.symbol().coefficients();
  const auto arity = static_cast<std::size_t>(mask.arity());
  // (i) of theorem 4: two combinations of the parts, with all coefficients that may differ from 0.
  std::vector<std::vector<Rational>> parts(std::min(arity, coefficients.size()));
  for (std::size_t i = 0; i < coefficients.size(); ++i) parts[i % arity].push_back(coefficients[i]);
  std::stable_sort(parts.begin(), parts.end(), [](const auto& p, const auto& q) { return p.size() < q.size(); });
  std::vector<Rational> rest(parts.back().size(), 0);
  Rational most = 1;  // errors of the rest
  for (std::size_t j = 1; j < parts.size(); ++j) {
    const Rational factor = static_cast<long>(j * j);
    most += factor;
    for (std::size_t i = 0; i < parts[j].size(); ++i) rest[i] += factor * parts[j][i];
  }
  const std::size_t p_degree = parts[0].size() - 1, q_degree = rest.size() - 1, size = p_degree + q_degree;
  RationalMatrix sylvester(size, size);
  for (std::size_t row = 0; row < size; ++row) {
    const std::vector<Rational>& polynomial = row < q_degree ? parts[0] : rest;
    const std::size_t shift = row < q_degree ? row : row - q_degree;
    for (std::size_t i = 0; i < polynomial.size(); ++i) sylvester(shift + i, row) = polynomial[i];
  }
  const auto n = static_cast<long>(size);
  const Rational norm = one_norm(sylvester), error = n * most * distance;
  if (!(abs(determinant(sylvester)) > power(norm + error, n) - power(norm, n))) return unknown;
  // (ii) Phi_n divides no such symbol if it leaves a larger remainder than errors can make.
  const long degree = static_cast<long>(coefficients.size()) - 1, step = mask.arity();
  for (long order = 2 * step; order < 6 * (degree + 1); order += step) {
    if (std::gcd(order / step, step) != 1 || totient(order) > degree) continue;
    LaurentPolynomial product = mask.symbol();
    Rational moved = Rational(degree + 1) * distance;
    for (long q = 2, left = order; left > 1; ++q) {
      if (left % q != 0) continue;
      while (left % q == 0) left /= q;
      product *= LaurentPolynomial(1) - LaurentPolynomial::monomial(1, order / q);
      moved *= 2;
    }
    Rational squares = 0;
    for (long residue = 0; residue < order; ++residue) {
      Rational sum = 0;
      for (const Rational& c : product.coset(static_cast<int>(order), residue).coefficients()) sum += c;
      squares += sum * sum;
    }
    if (!(squares > order * moved * moved)) return unknown;
  }
  return {Truth::yes,
          "the sub-symbols have no common zero, and there are no cyclic zeros, also with all rounding errors"};
}

}  // namespace subcert
