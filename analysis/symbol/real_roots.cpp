#include "real_roots.hpp"

#include "flint.hpp"

#include <flint/fmpz_poly_factor.h>
#include <flint/ulong_extras.h>

#include <stdexcept>

namespace subcert {
namespace {

using flint::IntegerPolynomial;

LaurentPolynomial from_flint(const fmpz_poly_t p) {
  std::vector<Rational> coefficients;
  for (slong i = 0; i < fmpz_poly_length(p); ++i) coefficients.emplace_back(flint::to_integer(p->coeffs + i));
  return LaurentPolynomial(coefficients, 0);
}

/// c with c(z + 1/z) = p(z), for p = its own reversal, as a polynomial c in its variable.
LaurentPolynomial in_sum_of_inverses(LaurentPolynomial p) {
  LaurentPolynomial result;
  const LaurentPolynomial sum({1, 0, 1}, -1);
  while (!p.is_zero()) {
    const long degree = p.highest();
    const LaurentPolynomial term = LaurentPolynomial(p.coefficient(degree));
    result += term.shifted(degree);
    p -= term * sum.pow(degree);
  }
  return result;
}

/// (1 + t^2)^d c(2 (1 - t^2) / (1 + t^2)): its real zeros t > 0 and t < 0 both run once over the zeros of c in (-2, 2),
/// t = 0 over 2; -2 is left out.
LaurentPolynomial on_whole_line(const LaurentPolynomial& c) {
  const long degree = c.highest();
  const LaurentPolynomial plus({1, 0, 1}, 0), minus({2, 0, -2}, 0);
  LaurentPolynomial result;
  for (long k = 0; k <= degree; ++k)
    result += LaurentPolynomial(c.coefficient(k)) * minus.pow(k) * plus.pow(degree - k);
  return result;
}

/// Whether c has a zero x with -2 < x < 2.
bool has_root_between(const LaurentPolynomial& c) {
  if (c.highest() == 0) return false;
  const LaurentPolynomial line = on_whole_line(c);
  return count_real_roots(line) > (line.coefficient(0) == 0 ? 1 : 0);
}

}  // namespace

int count_real_roots(const LaurentPolynomial& p) {
  if (p.is_zero()) throw std::domain_error("count_real_roots: need a non-zero polynomial, got 0");
  // A factor z^k, k > 0, brings the zero 0; it is not in IntegerPolynomial.
  IntegerPolynomial q(p), derivative(p);
  fmpz_poly_derivative(derivative.get(), q.get());
  if (fmpz_poly_is_zero(derivative.get())) return p.lowest() > 0 ? 1 : 0;
  fmpz_poly_gcd(derivative.get(), derivative.get(), q.get());
  fmpz_poly_div(q.get(), q.get(), derivative.get());
  return static_cast<int>(fmpz_poly_num_real_roots(q.get())) + (p.lowest() > 0 ? 1 : 0);
}

bool has_root_on_unit_circle(const LaurentPolynomial& p) {
  if (p.is_zero()) throw std::domain_error("has_root_on_unit_circle: need a non-zero polynomial, got 0");
  if (p(1) == 0 || p(-1) == 0) return true;
  LaurentPolynomial common = gcd(p, p.reversed());
  if (common.length() == 1) return false;
  // Zeros come as z, 1/z and differ from +-1: even degree, and centred it is its own reversal.
  common = common.shifted(-(common.length() - 1) / 2);
  return has_root_between(in_sum_of_inverses(common));
}

bool is_nonnegative_on_unit_circle(const LaurentPolynomial& p) {
  if (!(p.reversed() == p)) throw std::invalid_argument("is_nonnegative_on_unit_circle: need p(z) = p(1/z)");
  if (p.is_zero()) return true;
  const LaurentPolynomial c = in_sum_of_inverses(p);
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
  if (order < 1 || order > 1'000'000)
    throw std::invalid_argument("cyclotomic: need 1 <= order <= 1000000, got " + std::to_string(order));
  fmpz_poly_t value;
  fmpz_poly_init(value);
  fmpz_poly_cyclotomic(value, static_cast<ulong>(order));
  LaurentPolynomial result = from_flint(value);
  fmpz_poly_clear(value);
  return result;
}

long totient(long order) {
  if (order < 1) throw std::invalid_argument("totient: need order >= 1, got " + std::to_string(order));
  return static_cast<long>(n_euler_phi(static_cast<ulong>(order)));
}

}  // namespace subcert
