#pragma once
/// Laurent polynomials in one variable over the rationals: the symbols of univariate schemes.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <memory>
#include <vector>

namespace subcert {

/// sum of coefficient(k) z^k for lowest() <= k <= highest().
/// Canonical: the coefficients at both ends are non-zero; they are kept as integers over one positive common
/// denominator that has no factor in common with all of them; zero has no coefficient and its shift is 0.
class LaurentPolynomial {
 public:
  /// The zero polynomial.
  LaurentPolynomial();
  LaurentPolynomial(const Rational& constant);
  LaurentPolynomial(int constant) : LaurentPolynomial(Rational(constant)) {}
  /// sum of coefficients[i] z^(lowest + i); zeros at the ends are allowed and dropped.
  LaurentPolynomial(const std::vector<Rational>& coefficients, long lowest);
  LaurentPolynomial(const LaurentPolynomial& other);
  LaurentPolynomial(LaurentPolynomial&& other) noexcept;
  LaurentPolynomial& operator=(const LaurentPolynomial& other);
  LaurentPolynomial& operator=(LaurentPolynomial&& other) noexcept;
  ~LaurentPolynomial();

  static LaurentPolynomial monomial(const Rational& coefficient, long exponent);
  /// 1 + z + ... + z^(count-1). Domain: count >= 1.
  static LaurentPolynomial all_ones(int count);
  /// Reads what to_text() prints: a sum of terms `c`, `z`, `c*z^k` with exact rational c. Errors: throws
  /// ParseError; exponents beyond +-10^6 are refused.
  static LaurentPolynomial parse(std::string_view text);
  /// Reads what to_mask_text() prints; without @first the first exponent is 0. Errors: throws ParseError.
  static LaurentPolynomial parse_mask(std::string_view text);

  bool is_zero() const;
  bool is_canonical() const;
  /// Smallest and largest exponent. Errors: throws Error for zero, which has none.
  long lowest() const;
  long highest() const;
  /// highest() - lowest() + 1, and 0 for zero.
  long length() const;
  /// The coefficient of z^exponent, 0 outside the range.
  Rational coefficient(long exponent) const;
  /// All coefficients from lowest() to highest(); empty for zero.
  std::vector<Rational> coefficients() const;
  /// coefficient(lowest() + i) * denominator().
  std::vector<Integer> numerators() const;
  /// Positive common denominator; 1 for zero.
  Integer denominator() const;

  /// Value at z. Domain: z != 0 unless lowest() >= 0. Errors: throws Error. Cost: quasi-linear.
  Rational operator()(const Rational& z) const;

  LaurentPolynomial operator-() const;
  LaurentPolynomial& operator+=(const LaurentPolynomial& other);
  LaurentPolynomial& operator-=(const LaurentPolynomial& other);
  LaurentPolynomial& operator*=(const LaurentPolynomial& other);
  friend LaurentPolynomial operator+(LaurentPolynomial a, const LaurentPolynomial& b) { return a += b; }
  friend LaurentPolynomial operator-(LaurentPolynomial a, const LaurentPolynomial& b) { return a -= b; }
  friend LaurentPolynomial operator*(LaurentPolynomial a, const LaurentPolynomial& b) { return a *= b; }
  bool operator==(const LaurentPolynomial& other) const;

  /// Domain: exponent >= 0.
  LaurentPolynomial pow(long exponent) const;
  /// z^exponent times this.
  LaurentPolynomial shifted(long exponent) const;
  /// z -> z^factor. Domain: factor >= 1. Errors: throws where the result would pass 10^8 coefficients.
  LaurentPolynomial dilated(long factor) const;
  /// z -> 1/z.
  LaurentPolynomial reversed() const;
  LaurentPolynomial derivative() const;
  /// The coset (sub-symbol) sum over j of coefficient(arity*j + residue) z^j. Domain: arity >= 1, any residue.
  LaurentPolynomial coset(int arity, long residue) const;

  std::string to_text() const;
  std::string to_latex() const;
  /// Mask vector `[p,q,...]/D@lowest`; `[0]@0` for zero.
  std::string to_mask_text() const;

  struct Division;
  /// Quotient and remainder after the lowest exponents of both were moved to zero: this = quotient * divisor +
  /// remainder, and the remainder is shorter than the divisor. Domain: divisor != 0. Errors: throws Error.
  Division divided_by(const LaurentPolynomial& divisor) const;
  /// The quotient where the division leaves no remainder. Domain: divisor != 0.
  std::optional<LaurentPolynomial> exact_quotient(const LaurentPolynomial& divisor) const;
  /// The largest m such that factor^m divides this. Domain: this != 0, factor has at least two terms.
  int multiplicity(const LaurentPolynomial& factor) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  friend LaurentPolynomial gcd(const LaurentPolynomial& a, const LaurentPolynomial& b);
};

struct LaurentPolynomial::Division {
  LaurentPolynomial quotient;
  LaurentPolynomial remainder;
};

/// Greatest common divisor, made unique up to the units c z^k: lowest exponent 0 and leading coefficient 1; 0 for two
/// zeros. Cost: modular, quasi-linear in the size of the coefficients.
LaurentPolynomial gcd(const LaurentPolynomial& a, const LaurentPolynomial& b);

/// The polynomial of least degree with these values at these nodes. Domain: as many values as nodes, the nodes
/// different. Cost: quadratic.
LaurentPolynomial interpolation(const std::vector<Rational>& nodes, std::vector<Rational> values);

}  // namespace subcert
