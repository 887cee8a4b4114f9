#include "real_roots.hpp"
#include "flint_polynomial.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <flint/fmpz_poly_factor.h>
#include <flint/ulong_extras.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace subcert {
namespace {

using flint::IntegerPolynomial;
using flint::Whole;

LaurentPolynomial from_flint(const fmpz_poly_t p) {
  std::vector<Rational> coefficients;
  for (slong i = 0; i < fmpz_poly_length(p); ++i) coefficients.emplace_back(flint::to_integer(p->coeffs + i));
  return LaurentPolynomial(coefficients, 0);
}

/// z and the factors that a FLINT factorisation finds, with their multiplicities.
template <class Factorise>
std::vector<PolynomialFactor> factors_of(const LaurentPolynomial& p, const Factorise& factorise) {
  std::vector<PolynomialFactor> result;
  if (p.lowest() > 0) result.push_back({LaurentPolynomial::monomial(1, 1), static_cast<int>(p.lowest())});
  IntegerPolynomial q(p);
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  factorise(factors, q.get());
  for (slong i = 0; i < factors->num; ++i)
    result.push_back({from_flint(factors->p + i), static_cast<int>(factors->exp[i])});
  fmpz_poly_factor_clear(factors);
  return result;
}

/// c with c(z + 1/z) = p(z), for p = its own reversal, as a polynomial c in its variable. With V_k(z + 1/z) = z^k +
/// z^-k, V_k(x) = x V_{k-1}(x) - V_{k-2}(x), by Clenshaw's recurrence.
LaurentPolynomial in_sum_of_inverses(const LaurentPolynomial& p) {
  if (p.is_zero()) return p;
  LaurentPolynomial next, after;
  for (long k = p.highest(); k >= 1; --k) {
    LaurentPolynomial current = LaurentPolynomial(p.coefficient(k)) + next.shifted(1) - after;
    after = std::move(next);
    next = std::move(current);
  }
  return LaurentPolynomial(p.coefficient(0)) + next.shifted(1) - LaurentPolynomial(2) * after;
}

/// Whether c has a zero x with -2 < x < 2.
bool has_root_between(const LaurentPolynomial& c) {
  LaurentPolynomial inside = c;
  for (const int end : {2, -2})
    while (inside.length() > 1 && inside(end) == 0) inside = *inside.exact_quotient(LaurentPolynomial({-end, 1}, 0));
  return inside.highest() > 0 && count_real_roots(inside, -2, 2) > 0;
}

/// Whether c is negative at some of a few points x with -2 < x < 2.
bool is_negative_somewhere(const LaurentPolynomial& c) {
  const long points = 2 * c.highest() + 3;
  for (long k = 1; k < points; ++k) {
    const auto cosine = static_cast<long>(
        std::lround(2048 * std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(points))));
    if (c(Rational(2 * cosine, 2049)) < 0) return true;
  }
  return false;
}

/// Of the largest coefficient.
slong bits_of(const IntegerPolynomial& q) { return std::abs(fmpz_poly_max_bits(q.get())); }

/// Disjoint balls around the real zeros of a squarefree polynomial, in ascending order.
std::vector<Ball> isolate(const IntegerPolynomial& q, slong bits) {
  // The real zeros come first, with imaginary parts that are exactly zero; the balls are disjoint.
  const slong degree = fmpz_poly_degree(q.get());
  acb_ptr roots = _acb_vec_init(degree);
  arb_fmpz_poly_complex_roots(roots, q.get(), 0, bits);
  std::vector<Ball> result;
  for (slong k = 0; k < degree && arb_is_zero(acb_imagref(roots + k)); ++k) {
    result.emplace_back();
    arb_set(result.back().get(), acb_realref(roots + k));
  }
  _acb_vec_clear(roots, degree);
  return result;
}

/// Interval Newton: the zero in `ball`, the only one there, to this many bits if the derivative has no zero in the
/// ball.
void refine(const IntegerPolynomial& q, Ball& ball, slong bits) {
  IntegerPolynomial derivative;
  fmpz_poly_derivative(derivative.get(), q.get());
  Ball middle, value, slope;
  for (slong reached = 0;;) {
    const slong precision = 2 * bits + bits_of(q) + 64;
    arb_get_mid_arb(middle.get(), ball.get());
    arb_fmpz_poly_evaluate_arb(value.get(), q.get(), middle.get(), precision);
    arb_fmpz_poly_evaluate_arb(slope.get(), derivative.get(), ball.get(), precision);
    if (arb_contains_zero(slope.get())) return;
    arb_div(value.get(), value.get(), slope.get(), precision);
    arb_sub(middle.get(), middle.get(), value.get(), precision);
    if (arb_intersection(ball.get(), ball.get(), middle.get(), precision) == 0) return;
    const slong accuracy = arb_rel_accuracy_bits(ball.get());
    if (accuracy >= bits || accuracy <= reached) return;
    reached = accuracy;
  }
}

/// The largest real zero of a squarefree polynomial, if there is one.
std::optional<Enclosure> largest_simple_root(const LaurentPolynomial& factor, int bits) {
  IntegerPolynomial q(factor);
  slong start = 64;
  std::vector<Ball> roots = isolate(q, start);
  if (roots.empty()) return std::nullopt;
  Ball& ball = roots.back();
  // A rational zero times the leading coefficient is an integer, at most twice the largest coefficient.
  const Whole leading(factor.numerators().back());
  for (slong wanted = std::max<slong>(bits, bits_of(q) + 8);; wanted *= 2) {
    while (refine(q, ball, wanted), arb_rel_accuracy_bits(ball.get()) < wanted) ball = isolate(q, start *= 2).back();
    Ball multiple;
    arb_mul_fmpz(multiple.get(), ball.get(), leading.get(), 2 * wanted);
    Whole candidate;
    if (arb_get_unique_fmpz(candidate.get(), multiple.get()) != 0) {
      const Rational rational(flint::to_integer(candidate.get()), factor.numerators().back());
      if (factor(rational) == 0) return Enclosure::exactly(rational);
      break;
    }
    if (!arb_contains_int(multiple.get())) break;
  }
  return ball.enclosure(256);
}

/// Takes the zeros 0 out; whether there were any.
bool take_zero(IntegerPolynomial& q) {
  slong zeros = 0;
  while (zeros < fmpz_poly_length(q.get()) && fmpz_is_zero(q.get()->coeffs + zeros)) ++zeros;
  fmpz_poly_shift_right(q.get(), q.get(), zeros);
  return zeros > 0;
}

/// Sign variations of the Bernstein coefficients on (0, 1): as many as zeros there, or more by an even number
/// (Descartes).
int variations(const IntegerPolynomial& q) {
  IntegerPolynomial moved;  // with x = 1/(1 + s), s > 0
  fmpz_poly_reverse(moved.get(), q.get(), fmpz_poly_length(q.get()));
  fmpz_poly_taylor_shift(moved.get(), moved.get(), Whole(1).get());
  int count = 0, last = 0;
  for (slong i = 0; i < fmpz_poly_length(moved.get()); ++i)
    if (const int sign = fmpz_sgn(moved.get()->coeffs + i); sign != 0) {
      count += sign * last < 0 ? 1 : 0;
      last = sign;
    }
  return count;
}

/// 2^n q(x/2)
void halve(IntegerPolynomial& q) {
  const slong length = fmpz_poly_length(q.get());
  for (slong i = 0; i < length; ++i)
    fmpz_mul_2exp(q.get()->coeffs + i, q.get()->coeffs + i, static_cast<ulong>(length - 1 - i));
}

/// The distinct zeros in (0, 1); nothing past the deadline, if there is one.
std::optional<int> count_in_unit_interval(IntegerPolynomial& whole, const Deadline* deadline) {
  take_zero(whole);
  if (const int count = variations(whole); count <= 1) return count;
  // Of simple zeros alone the halving comes to an end.
  IntegerPolynomial common;
  fmpz_poly_derivative(common.get(), whole.get());
  fmpz_poly_gcd(common.get(), common.get(), whole.get());
  fmpz_poly_div(whole.get(), whole.get(), common.get());
  std::vector<std::unique_ptr<IntegerPolynomial>> open;
  const auto add = [&](const IntegerPolynomial& q) {
    open.push_back(std::make_unique<IntegerPolynomial>());
    fmpz_poly_set(open.back()->get(), q.get());
  };
  int count = 0;
  for (add(whole); !open.empty();) {
    if (deadline && deadline->expired()) return std::nullopt;
    IntegerPolynomial q;
    fmpz_poly_swap(q.get(), open.back()->get());
    open.pop_back();
    const int signs = variations(q);
    if (signs <= 1) {
      count += signs;
      continue;
    }
    halve(q);
    add(q);
    fmpz_poly_taylor_shift(q.get(), q.get(), Whole(1).get());
    if (take_zero(q)) ++count;  // in the middle
    add(q);
  }
  return count;
}

std::optional<int> count_between(const LaurentPolynomial& p, const Rational& low, const Rational& high,
                                 const Deadline* deadline) {
  // x = low + (high - low) v. With x = y/d all is integral.
  const Integer d = lcm(denominator(low), denominator(high));
  std::vector<Rational> coefficients;
  for (long k = 0; k <= p.highest() - p.lowest(); ++k)
    coefficients.push_back(p.coefficient(p.lowest() + k) / Rational(pow(d, static_cast<unsigned long>(k))));
  IntegerPolynomial q(LaurentPolynomial(coefficients, 0)), line;
  fmpz_poly_set_coeff_fmpz(line.get(), 0, Whole(numerator(low * d)).get());
  fmpz_poly_set_coeff_fmpz(line.get(), 1, Whole(numerator((high - low) * d)).get());
  fmpz_poly_compose(q.get(), q.get(), line.get());
  const auto count = count_in_unit_interval(q, deadline);
  if (!count) return std::nullopt;
  return *count + (p.lowest() > 0 && low < 0 && high > 0 ? 1 : 0);
}

}  // namespace

int count_real_roots(const LaurentPolynomial& p) {
  require(!p.is_zero(), "count_real_roots: need a non-zero polynomial, got 0");
  // A factor z^k, k > 0, brings the zero 0; it is not in IntegerPolynomial.
  IntegerPolynomial q(p), derivative(p);
  fmpz_poly_derivative(derivative.get(), q.get());
  if (fmpz_poly_is_zero(derivative.get())) return p.lowest() > 0 ? 1 : 0;
  fmpz_poly_gcd(derivative.get(), derivative.get(), q.get());
  fmpz_poly_div(q.get(), q.get(), derivative.get());
  return static_cast<int>(fmpz_poly_num_real_roots(q.get())) + (p.lowest() > 0 ? 1 : 0);
}

int count_real_roots(const LaurentPolynomial& p, const Rational& low, const Rational& high) {
  return *count_between(p, low, high, nullptr);
}

std::optional<int> count_real_roots(const LaurentPolynomial& p, const Rational& low, const Rational& high,
                                    const Deadline& deadline) {
  return count_between(p, low, high, &deadline);
}

bool has_no_real_root(const LaurentPolynomial& p, const Rational& low, const Rational& high) {
  return !p.is_zero() && p(low) != 0 && p(high) != 0 && count_real_roots(p, low, high) == 0;
}

bool has_no_real_root(const LaurentPolynomial& p, const Rational& low, const Rational& high, const Deadline& deadline) {
  return !p.is_zero() && p(low) != 0 && p(high) != 0 && count_real_roots(p, low, high, deadline) == 0;
}

bool has_no_real_root_from(const LaurentPolynomial& p, const Rational& low) {
  // The zeros x are 1/t.
  return !p.is_zero() && has_no_real_root(p.reversed().shifted(p.highest()), 0, 1 / low);
}

std::optional<Rational> zero_of_linear(const LaurentPolynomial& p) {
  if (p.is_zero() || p.highest() != 1) return std::nullopt;
  return Rational(-p.coefficient(0) / p.coefficient(1));
}

std::vector<PolynomialFactor> irreducible_factors(const LaurentPolynomial& p) {
  require(!p.is_zero(), "irreducible_factors: need a non-zero polynomial, got 0");
  return factors_of(p, fmpz_poly_factor);
}

std::vector<Enclosure> real_roots(const LaurentPolynomial& p, const Rational& low, const Rational& high,
                                  const Rational& width) {
  std::vector<Enclosure> result;
  for (const PolynomialFactor& factor : irreducible_factors(p)) {
    if (const auto root = zero_of_linear(factor.polynomial)) {
      if (low < *root && *root < high) result.push_back(Enclosure::exactly(*root));
      continue;
    }
    const IntegerPolynomial q(factor.polynomial);
    for (slong bits = 64;; bits *= 2) {
      std::vector<Enclosure> roots;
      for (const Ball& ball : isolate(q, bits)) roots.push_back(ball.enclosure(bits + 30));
      // The zeros are irrational: enough bits tell them from the ends.
      const auto is_open = [&](const Enclosure& root) {
        return *root.upper - *root.lower > width || (*root.lower <= low && low <= *root.upper) ||
               (*root.lower <= high && high <= *root.upper);
      };
      if (std::ranges::any_of(roots, is_open)) continue;
      for (const Enclosure& root : roots)
        if (low < *root.lower && *root.upper < high) result.push_back(root);
      break;
    }
  }
  std::ranges::sort(result, {}, [](const Enclosure& root) -> const Rational& { return *root.lower; });
  return result;
}

std::optional<RealRoot> largest_real_root(const LaurentPolynomial& p, int bits) {
  require(!p.is_zero(), "largest_real_root: need a non-zero polynomial, got 0");
  const std::vector<PolynomialFactor> candidates = factors_of(p, fmpz_poly_factor_squarefree);
  // The squarefree factors are coprime, so that enough bits tell which zero is the largest.
  for (;; bits *= 2) {
    std::vector<RealRoot> roots;
    std::size_t best = 0;
    for (const PolynomialFactor& factor : candidates) {
      const auto value = factor.polynomial.lowest() > 0 ? std::optional(Enclosure::exactly(0))
                                                        : largest_simple_root(factor.polynomial, bits);
      if (!value) continue;
      roots.push_back({*value, factor.multiplicity});
      if (*value->lower > *roots[best].value.lower) best = roots.size() - 1;
    }
    if (roots.empty()) return std::nullopt;
    const auto separated = [&](const RealRoot& root) {
      return &root == &roots[best] || *root.value.upper < *roots[best].value.lower;
    };
    if (std::all_of(roots.begin(), roots.end(), separated)) return roots[best];
  }
}

bool has_root_on_unit_circle(const LaurentPolynomial& p) {
  require(!p.is_zero(), "has_root_on_unit_circle: need a non-zero polynomial, got 0");
  if (p(1) == 0 || p(-1) == 0) return true;
  LaurentPolynomial common = gcd(p, p.reversed());
  if (common.length() == 1) return false;
  // Zeros come as z, 1/z and differ from +-1: even degree, and centred it is its own reversal.
  common = common.shifted(-(common.length() - 1) / 2);
  return has_root_between(in_sum_of_inverses(common));
}

bool is_nonnegative_on_unit_circle(const LaurentPolynomial& p) {
  if (!(p.reversed() == p)) fail(ErrorKind::domain, "is_nonnegative_on_unit_circle: need p(z) = p(1/z)");
  if (p.is_zero()) return true;
  const LaurentPolynomial c = in_sum_of_inverses(p);
  if (is_negative_somewhere(c)) return false;
  // The product of the squarefree factors of odd multiplicity has the same sign changes.
  LaurentPolynomial odd_part(1);
  if (c.lowest() % 2 != 0) odd_part = LaurentPolynomial::monomial(1, 1);
  IntegerPolynomial q(c);
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor_squarefree(factors, q.get());
  for (slong i = 0; i < factors->num; ++i)
    if (factors->exp[i] % 2 != 0) odd_part *= from_flint(factors->p + i);
  fmpz_poly_factor_clear(factors);
  if (has_root_between(odd_part)) return false;
  // One sign on (-2, 2): that of any value there which is not zero.
  for (long k = 2;; ++k) {
    const Rational value = c(Rational(1, k));
    if (value != 0) return value > 0;
  }
}

LaurentPolynomial cyclotomic(long order) {
  if (order < 1 || order > 1'000'000) fail(ErrorKind::domain, "cyclotomic: need 1 <= order <= 1000000, got {}", order);
  fmpz_poly_t value;
  fmpz_poly_init(value);
  fmpz_poly_cyclotomic(value, static_cast<ulong>(order));
  LaurentPolynomial result = from_flint(value);
  fmpz_poly_clear(value);
  return result;
}

long totient(long order) {
  require(order >= 1, "totient: need order >= 1, got {}", order);
  return static_cast<long>(n_euler_phi(static_cast<ulong>(order)));
}

}  // namespace subcert
