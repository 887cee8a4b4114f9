#pragma once
/// Sparse Laurent polynomials in one, two or three variables over the rationals: the symbols of surface and volume
/// schemes, and of those of curves where these are to be seen as one case of several.

#include "laurent_polynomial.hpp"
#include "monomial.hpp"

#include <memory>
#include <vector>

namespace subcert {

/// A finite sum of terms c x^i y^j (z^k). Canonical: no term twice, none zero, terms in descending lexicographic
/// order of their exponents.
class MultivariatePolynomial {
 public:
  using Exponents = std::vector<long>;
  using Monomial = subcert::Monomial;
  struct Division;

  /// Zero. Domain: 1 <= variables <= 5, up to 3 for texts.
  explicit MultivariatePolynomial(int variables);
  MultivariatePolynomial(int variables, const Rational& constant);
  /// The sum of `terms`; repeated exponents add up. Errors: throws Error where a term has another
  /// number of exponents than there are variables.
  MultivariatePolynomial(int variables, const std::vector<Monomial>& terms);
  MultivariatePolynomial(const MultivariatePolynomial& other);
  MultivariatePolynomial(MultivariatePolynomial&& other) noexcept;
  MultivariatePolynomial& operator=(const MultivariatePolynomial& other);
  MultivariatePolynomial& operator=(MultivariatePolynomial&& other) noexcept;
  ~MultivariatePolynomial();

  /// p(x) q(y) (r(z)): the symbol of a tensor product. Domain: one to three factors.
  static MultivariatePolynomial tensor_product(const std::vector<LaurentPolynomial>& factors);
  /// p in the variable with this index (0 for x).
  static MultivariatePolynomial in_variable(int variables, int index, const LaurentPolynomial& p);
  /// Reads what to_text() prints. Errors: throws ParseError.
  static MultivariatePolynomial parse(std::string_view text, int variables);

  int variables() const;
  bool is_zero() const;
  bool is_canonical() const;
  /// Number of terms.
  long count() const;
  std::vector<Monomial> terms() const;
  Rational coefficient(const Exponents& exponents) const;
  /// Smallest and largest exponent of each variable. Errors: throws Error for zero.
  Exponents lowest() const;
  Exponents highest() const;

  /// Value at a point with rational, non-zero coordinates.
  Rational operator()(const std::vector<Rational>& point) const;

  MultivariatePolynomial operator-() const;
  MultivariatePolynomial& operator+=(const MultivariatePolynomial& other);
  MultivariatePolynomial& operator-=(const MultivariatePolynomial& other);
  MultivariatePolynomial& operator*=(const MultivariatePolynomial& other);
  friend MultivariatePolynomial operator+(MultivariatePolynomial a, const MultivariatePolynomial& b) { return a += b; }
  friend MultivariatePolynomial operator-(MultivariatePolynomial a, const MultivariatePolynomial& b) { return a -= b; }
  friend MultivariatePolynomial operator*(MultivariatePolynomial a, const MultivariatePolynomial& b) { return a *= b; }
  bool operator==(const MultivariatePolynomial& other) const;

  MultivariatePolynomial shifted(const Exponents& exponents) const;
  /// Every variable to its factor-th power. Domain: factor >= 1.
  MultivariatePolynomial dilated(long factor) const;
  /// Every variable to its inverse.
  MultivariatePolynomial reversed() const;
  /// Partial derivative by the variable with this index.
  MultivariatePolynomial derivative(int index) const;
  /// Terms whose exponents are congruent to `residue` modulo the arity in every variable, exponents divided down.
  MultivariatePolynomial coset(int arity, const Exponents& residue) const;

  /// this = quotient * divisor + remainder, where no term of the remainder is divisible by the leading term of the
  /// divisor (lexicographic order, after the lowest exponents of both were moved to zero). Domain: divisor != 0.
  Division divided_by(const MultivariatePolynomial& divisor) const;
  std::optional<MultivariatePolynomial> exact_quotient(const MultivariatePolynomial& divisor) const;
  /// The largest m such that factor^m divides this. Domain: this != 0, factor has at least two terms.
  int multiplicity(const MultivariatePolynomial& factor) const;

  std::string to_text() const;
  std::string to_latex() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  friend MultivariatePolynomial gcd(const MultivariatePolynomial& a, const MultivariatePolynomial& b);
};

struct MultivariatePolynomial::Division {
  MultivariatePolynomial quotient;
  MultivariatePolynomial remainder;
};

/// Greatest common divisor up to units: lowest exponents 0, leading coefficient 1; 0 for two zeros.
MultivariatePolynomial gcd(const MultivariatePolynomial& a, const MultivariatePolynomial& b);

}  // namespace subcert
