// Masks with a parameter, for all its values from one number to another: section 6 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// Values of the parameter of this letter: w = (low v + high u) / (u + v) for u, v >= 0.
struct Range {
  char letter;
  mpq_class low, high;
  bool unbounded = false;  // from `low` on; there is no `high`
};

/// w=LOW..HIGH
Range parse_range(std::string_view text);

/// The coefficients of u^j v^(n-j) in (low v + high u)^k (u + v)^(n-k), times the n-th power of the denominator of the
/// range, for k = 0, ..., n; without an upper end in (low v + u)^k v^(n-k).
std::vector<Vector> power_forms(const Range& range, std::size_t n);

/// The form of a polynomial with as many coefficients.
Vector divisor_form(const Vector& polynomial, const std::vector<Vector>& forms);

/// The control matrices of a range: for each matrix those of u^0, u^1, ..., one after another, and the weights of these
/// powers, positive integers.
struct Controls {
  Family family;
  Vector weights;

  std::size_t degree() const { return weights.size() - 1; }
};

/// Of the matrices of all powers, one after another for each matrix, over the divisor of the mask. Rejects where a
/// weight would not be positive.
Controls control_family(const Family& powers, const Vector& divisor, const Range& range, Arithmetic& arithmetic);

/// Conditions (i) and (ii) of Theorem 4 for all values of the range, of masks that have so many sum rules. Without a
/// parameter: with an empty range, and for all masks whose coefficients, times the denominator, are off by at most
/// `error`.
void check_stability(const Mask& mask, unsigned arity, std::size_t sum_rules, const Range& range,
                     const mpq_class& error, Arithmetic& arithmetic);

/// Section 6.4: rejects unless the mask has no further sum rule for any value of the range. `powers`: the matrices of
/// all powers up to the degree, one after another for each matrix.
void check_full_sum_rules(const Family& powers, std::size_t degree, const Range& range, Arithmetic& arithmetic);

/// Rejects unless for all values of the range the product of the letters has a real eigenvalue beyond `re`, or two
/// eigenvalues whose product is above im^2. `family`: the control matrices, or one of their diagonal blocks. Domain:
/// one of re and im is 0.
void check_eigenvalue(const Family& family, const Vector& weights, const std::vector<std::size_t>& letters,
                      const mpq_class& re, const mpq_class& im, Arithmetic& arithmetic);

}  // namespace subcert_check
