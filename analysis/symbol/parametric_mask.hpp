#pragma once
/// Masks whose coefficients are polynomials in one parameter, or quotients of them.

#include "budget.hpp"
#include "mask.hpp"
#include "rational_function.hpp"

namespace subcert {

/// a(z, w) = sum over k of w^k a_k(z) / q(w) with an arity. Canonical: at least one power, the last of them not zero; q
/// as in RationalFunction, without a factor that all coefficients have.
class ParametricMask {
 public:
  /// Domain: canonical, but for powers at the end that are zero. Errors: throws Error for arity < 2, or where all
  /// powers are zero.
  ParametricMask(std::vector<LaurentPolynomial> powers, int arity, LaurentPolynomial denominator = 1);
  /// The first coefficient belongs to the index `first`. Errors: as above.
  ParametricMask(const std::vector<RationalFunction>& coefficients, long first, int arity);

  /// a_0, a_1, ...
  const std::vector<LaurentPolynomial>& powers() const { return powers_; }
  /// q, which is 1 where all coefficients are polynomials.
  const LaurentPolynomial& denominator() const { return denominator_; }
  /// In w, of numerators and denominator.
  int degree() const;
  int arity() const { return arity_; }
  /// The indices at which some coefficient is not zero.
  IndexRange support() const;
  /// The coefficient at an index times the denominator, as a polynomial in w.
  LaurentPolynomial coefficient(long index) const;
  /// Errors: throws Error where all coefficients vanish at w, or the denominator does.
  Mask at(const Rational& w) const;

  /// `[-w,0,1/2+w,1,1/2+w,0,-w]@-3` with this letter, or `[1,1+w,1]/(2+w)@-1`.
  std::string to_text(char letter) const;

 private:
  std::vector<LaurentPolynomial> powers_;
  LaurentPolynomial denominator_;
  int arity_;
};

/// A mask with coefficients that are polynomials in v and w: the factor of v^i w^j is the power i + columns * j of
/// `flat`.
struct BiparametricMask {
  ParametricMask flat;
  int columns;  ///< one more than the degree in v

  /// Errors: throws Error where all coefficients vanish there.
  Mask at(const Rational& v, const Rational& w) const;
};

/// The number of sum rules that hold for all w.
int sum_rules(const ParametricMask& mask);

/// The scheme for the divided differences of this order, for all w. Domain: 0 <= order <= sum_rules(mask).
ParametricMask divided_difference_scheme(const ParametricMask& mask, int order);

/// The values of w at which one more sum rule holds are the zeros of this polynomial; 1 where there are none. Domain:
/// coset sums 1 for all w.
LaurentPolynomial special_values(const ParametricMask& mask);

/// A polynomial in w that vanishes wherever the shifts are not stable: elsewhere the sub-symbols have no
/// common zero, and there are no cyclic zeros (proofs-checks/certificates/SPEC.md, theorem 4). Zero where none was
/// found before the deadline. Cost: a resultant by interpolation.
LaurentPolynomial unstable_values(const ParametricMask& mask, const Deadline& deadline = {});

}  // namespace subcert
