#pragma once
/// Masks whose coefficients are polynomials in one or more letters, or quotients of them.

#include <subcert/analysis/symbol/polynomials/box.hpp>
#include <subcert/analysis/symbol/polynomials/rational_function.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>
#include "mask.hpp"

namespace subcert {

/// A polynomial in one letter, without negative exponents, as that many powers at least; and back. Errors: throws Error
/// for more letters.
Powers<Rational> in_powers(const LaurentPolynomial& p, std::size_t least = 1);
LaurentPolynomial in_one_letter(const Powers<Rational>& powers);

/// a(z, w) = sum over k of w^k a_k(z) / q(w) with an arity, where w^k stands for w_1^k_1 w_2^k_2 ... Canonical: the
/// last power of each letter that is kept is that of some coefficient. Of one letter q is as in RationalFunction,
/// without a factor that all coefficients have.
///
/// Its coefficients are numbers or, with r > 1 components, r x r matrices A_k, as those of a LatticeMask. Then a(z, w)
/// stands for their entries, row by row: that of row i and column j of A_k has the power r^2 k + r i + j of z.
class ParametricMask {
 public:
  /// Of one letter. Domain: canonical, but for powers at the end that are zero. Errors: throws Error for arity < 2, or
  /// where all powers are zero.
  ParametricMask(const std::vector<LaurentPolynomial>& powers, int arity, const LaurentPolynomial& denominator = 1);
  /// The first coefficient belongs to the index `first`. Errors: as above.
  ParametricMask(const std::vector<LetterFunction>& coefficients, long first, int arity, std::size_t components = 1);
  ParametricMask(const std::vector<RationalFunction>& coefficients, long first, int arity);
  /// Of as many letters as there are sizes. Domain and errors: as above.
  ParametricMask(const Powers<LaurentPolynomial>& powers, int arity, Powers<Rational> denominator,
                 std::size_t components = 1);

  /// r; 1 where the coefficients are numbers.
  std::size_t components() const { return components_; }
  std::size_t letters() const { return powers_.sizes.size(); }
  /// a_0, a_1, ...; the powers of the first letter run fastest.
  const std::vector<LaurentPolynomial>& powers() const { return powers_.entries; }
  /// q, which is 1 where all coefficients are polynomials.
  const Powers<Rational>& denominators() const { return denominator_; }
  /// Of one letter. Errors: throws Error for more.
  LaurentPolynomial denominator() const { return in_one_letter(denominator_); }
  /// One more than the degree in each letter, of numerators and denominator.
  std::vector<std::size_t> sizes() const;
  /// In the first letter, of numerators and denominator.
  int degree() const;
  int arity() const { return arity_; }
  /// The indices at which some coefficient is not zero.
  IndexRange support() const;
  /// Of numbers: the coefficient at an index times the denominator, as a polynomial in the one letter. Errors: throws
  /// Error for more.
  LaurentPolynomial coefficient(long index) const;
  /// a(z, w). Errors: throws Error where the denominator vanishes.
  LaurentPolynomial entries_at(const Values& values) const;
  /// Those of a polynomial as a(z, w) is for some w: the entries of the A_k.
  std::vector<LatticeMask::Term> terms_of(const LaurentPolynomial& entries) const;
  /// Of numbers. Errors: throws Error for matrices, where all coefficients vanish there, or the denominator does.
  Mask at(const Values& values) const;
  Mask at(const Rational& w) const { return at(Values{w}); }
  /// Of numbers or matrices. Errors: throws Error where all coefficients vanish there, or the denominator does.
  LatticeMask lattice_mask_at(const Values& values) const;

  /// The same with other polynomials in place of the a_k. Domain: linear, not zero for all of them.
  template <class Map>
  ParametricMask mapped(Map map) const {
    Powers<LaurentPolynomial> result{powers_.sizes, {}};
    for (const LaurentPolynomial& power : powers()) result.entries.push_back(map(power));
    return {result, arity_, denominator_, components_};
  }

  /// a(z, w) q(w).
  LaurentPolynomial numerator_at(const Values& values) const { return value_at(powers_, values); }
  /// With Bernstein polynomials B_i of a box numerator and denominator are sums of B_i(w) n_i(z) and B_i(w) q_i. Where
  /// all q_i have one sign the symbol of each w in the box is in the convex hull of the n_i/q_i. Nothing where they do
  /// not: the denominator may vanish.
  std::optional<std::vector<LaurentPolynomial>> controls(const Box& box) const;

  bool operator==(const ParametricMask& other) const = default;

  /// `[-w,0,1/2+w,1,1/2+w,0,-w]@-3` with this letter, or `[1,1+w,1]/(2+w)@-1`; matrices are lists of rows. Errors:
  /// throws Error for more letters.
  std::string to_text(char letter) const;

 private:
  Powers<LaurentPolynomial> powers_;
  Powers<Rational> denominator_;
  int arity_;
  std::size_t components_;
};

/// A mask of numbers that are polynomials in a zero of an irreducible polynomial with lowest exponent 0, of a degree
/// below its own.
struct AlgebraicMask {
  ParametricMask mask;
  LaurentPolynomial polynomial;
};

/// The mask with all matrices transposed.
ParametricMask transposed(const ParametricMask& mask);

/// The same mask for all values of one letter. Domain: one variable, an arity.
ParametricMask without_letters(const LatticeMask& mask);

/// The number of sum rules that hold for all w; of matrices that of the data of kept_polynomials.
int sum_rules(const ParametricMask& mask);

/// The scheme for the divided differences of this order, for all w. Domain: numbers, 0 <= order <= sum_rules(mask).
ParametricMask divided_difference_scheme(const ParametricMask& mask, int order);

/// The values of w at which one more sum rule holds are the zeros of this polynomial; 1 where there are none, and for
/// matrices, of which none are looked for. Domain: one letter, coset sums 1 for all w.
LaurentPolynomial special_values(const ParametricMask& mask);

/// A polynomial in w that vanishes wherever the shifts are not stable: elsewhere the sub-symbols have no
/// common zero, and there are no cyclic zeros (proofs-checks/certificates/SPEC.md, theorems 4 and 43). Zero where none
/// was found before the deadline, or where too many cycles of roots of unity would have to be looked at, and for
/// matrices. Domain: one letter. Cost: a resultant by interpolation, and one for each order of such a cycle that is not
/// all of its order.
LaurentPolynomial unstable_values(const ParametricMask& mask, const Deadline& deadline = {});

}  // namespace subcert
