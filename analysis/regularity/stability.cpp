
#include "stability.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_cycles.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace subcert {
namespace {

/// Coefficients and how far they may be off.
struct RoundedPolynomial {
  std::vector<Rational> values, errors;
  std::size_t last = 0;  ///< one more than the place of the last coefficient that may differ from 0

  void add(const Rational& value, const Rational& error) {
    values.push_back(value);
    errors.push_back(error);
    if (value != 0 || error != 0) last = values.size();
  }
  std::size_t first() const {
    std::size_t place = 0;
    while (place < last && values[place] == 0 && errors[place] == 0) ++place;
    return place;
  }
  std::size_t length() const { return last - first(); }
  /// Without what is 0 at both ends.
  RoundedPolynomial trimmed() const {
    RoundedPolynomial result;
    for (std::size_t i = first(); i < last; ++i) result.add(values[i], errors[i]);
    return result;
  }
  void add_multiple(const Rational& factor, const RoundedPolynomial& other) {
    RoundedPolynomial result;
    for (std::size_t i = 0; i < std::max(values.size(), other.values.size()); ++i)
      result.add((i < values.size() ? values[i] : 0) + (i < other.values.size() ? factor * other.values[i] : 0),
                 (i < errors.size() ? errors[i] : 0) + (i < other.errors.size() ? factor * other.errors[i] : 0));
    *this = std::move(result);
  }
  static Rational sum_of_moduli(const std::vector<Rational>& list) {
    Rational sum = 0;
    for (const Rational& x : list) sum += abs(x);
    return sum;
  }
  Rational norm() const { return sum_of_moduli(values); }
  Rational error() const { return sum_of_moduli(errors); }
};

constexpr slong cycle_bits = 256;

/// The modulus of the polynomial at e^(2 pi i turns).
Ball modulus_at(const std::vector<Rational>& coefficients, const Rational& turns) {
  const Ball angle = Ball::pi(cycle_bits) * Ball(Rational(2 * turns), cycle_bits);
  Ball re(cycle_bits), im(cycle_bits);
  for (std::size_t k = 0; k < coefficients.size(); ++k) {
    const Ball turned = angle * static_cast<long>(k), factor(coefficients[k], cycle_bits);
    re = re + factor * cos(turned);
    im = im + factor * sin(turned);
  }
  return sqrt(re * re + im * im);
}

}  // namespace

Decision has_stable_shifts(const Mask& mask) {
  // Zeros shared by z, zeta z, ..., zeta^(a-1) z are the a-th roots of the common zeros of the cosets.
  const LaurentPolynomial common = common_factor_of_cosets(mask);
  if (common.is_zero() || has_root_on_unit_circle(common))
    return {Truth::no, "the sub-symbols have a common zero on the unit circle"};
  if (const auto order = cyclic_order(mask))
    return {Truth::no, "the symbol vanishes on a cycle of roots of unity of order " + std::to_string(*order)};
  return {Truth::yes, common.length() == 1 ? "the sub-symbols have no common zero, and there are no cyclic zeros"
                                           : "no common zero of the sub-symbols lies on the unit circle, and there are "
                                             "no cyclic zeros"};
}

Decision has_stable_shifts(const Mask& mask, const Rational& distance, int sum_rules) {
  return has_stable_shifts(mask, std::vector<Rational>(static_cast<std::size_t>(mask.symbol().length()), distance),
                           sum_rules);
}

Decision has_stable_shifts(const Mask& mask, const std::vector<Rational>& errors, int sum_rules) {
  Decision unknown{Truth::unknown, "the shifts may be unstable for other masks that are as near"};
  const std::vector<Rational> coefficients = mask.symbol().coefficients();
  require(errors.size() == coefficients.size(),
          "has_stable_shifts: need an error of each of the {} coefficients, got {}", coefficients.size(),
          errors.size());
  const auto arity = static_cast<std::size_t>(mask.arity());
  // (i) of theorem 4: two combinations of the parts, with all coefficients that may differ from 0.
  std::vector<RoundedPolynomial> parts(arity);
  for (std::size_t i = 0; i < coefficients.size(); ++i) parts[i % arity].add(coefficients[i], errors[i]);
  std::erase_if(parts, [](const RoundedPolynomial& part) { return part.last == 0; });
  std::stable_sort(parts.begin(), parts.end(), [](const auto& p, const auto& q) { return p.length() < q.length(); });
  const RoundedPolynomial p = parts.front().trimmed();
  RoundedPolynomial q;
  for (std::size_t j = 1; j < parts.size(); ++j) q.add_multiple(static_cast<long>(j * j), parts[j]);
  q = q.trimmed();
  if (q.last == 0) return unknown;
  const std::size_t p_degree = p.length() - 1, q_degree = q.length() - 1, size = p_degree + q_degree;
  RationalMatrix sylvester(size, size);
  for (std::size_t column = 0; column < size; ++column) {
    const RoundedPolynomial& polynomial = column < q_degree ? p : q;
    const std::size_t shift = column < q_degree ? column : column - q_degree;
    for (std::size_t i = 0; i < polynomial.length(); ++i) sylvester(shift + i, column) = polynomial.values[i];
  }
  // A determinant is at most the product of the norms of its columns.
  const auto columns = [&](const Rational& in_p, const Rational& in_q) {
    return power(in_p, static_cast<long>(q_degree)) * power(in_q, static_cast<long>(p_degree));
  };
  const Rational change = columns(p.norm() + p.error(), q.norm() + q.error()) - columns(p.norm(), q.norm());
  if (!(abs(size == 0 ? Rational(1) : determinant(sylvester)) > change)) return unknown;
  // (ii) On each cycle of roots of unity with few enough numbers there is a value that errors cannot make 0.
  Rational moved = 0;
  for (const Rational& error : errors) moved += error;
  const long step = mask.arity(), zeros = static_cast<long>(coefficients.size()) - 1 - sum_rules * (step - 1);
  const auto cycles = root_cycles(step, zeros / (step - 1));
  if (!cycles) return unknown;
  const auto is_moved_away = [&](const RootCycle& cycle) {
    return std::ranges::any_of(cycle.half, [&](long e) {
      for (long r = 1; r < step; ++r)
        if (Ball(moved, cycle_bits).is_less(modulus_at(coefficients, Rational(e, cycle.order) + Rational(r, step))))
          return true;
      return false;
    });
  };
  if (!std::ranges::all_of(*cycles, is_moved_away)) return unknown;
  return {Truth::yes,
          "the sub-symbols have no common zero, and there are no cyclic zeros, also with all rounding errors"};
}

std::optional<long> cyclic_order(const Mask& mask) {
  const int arity = mask.arity();
  // Phi_{m d} | a for all divisors d > 1 of the arity, m coprime to it. Orders k with totient(k) <= degree are at most
  // 7 degree: k / totient(k) < e^gamma log log k + 2.51 / log log k for k >= 3 [RS62], which stays below 7 for
  // 30 <= k <= 10^9; below 30 it is at most 3.
  const long degree = mask.symbol().length() - 1;
  for (long m = 2; arity * m <= 7 * degree; ++m) {
    if (std::gcd(m, static_cast<long>(arity)) != 1) continue;
    bool cyclic = true;
    for (long d = 2; d <= arity && cyclic; ++d)
      if (arity % d == 0)
        cyclic = totient(m * d) <= degree && mask.symbol().exact_quotient(cyclotomic(m * d)).has_value();
    if (cyclic) return m;
  }
  return std::nullopt;
}

ReducedMask reduced(const Mask& mask) {
  ReducedMask result{1, mask};
  for (;;) {
    LaurentPolynomial factor = common_factor_of_cosets(result.mask);
    factor = factor.shifted(-factor.lowest());
    if (factor.length() == 1) {
      const auto order = cyclic_order(result.mask);
      if (!order) return result;
      factor = cyclotomic(*order);
    }
    const int arity = mask.arity();
    result.factor *= factor;
    result.mask = Mask(*(result.mask.symbol() * factor).exact_quotient(factor.dilated(arity)), arity);
  }
}

}  // namespace subcert
