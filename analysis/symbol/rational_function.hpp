#pragma once
/// Quotients of polynomials in one parameter.

#include "laurent_polynomial.hpp"

namespace subcert {

/// p(w)/q(w). Canonical: no common factor; q has integer coefficients without a common factor, the lowest of them
/// positive; 0 is 0/1.
class RationalFunction {
 public:
  RationalFunction(LaurentPolynomial polynomial = {}) : numerator_(std::move(polynomial)) {}
  RationalFunction(const Rational& constant) : numerator_(constant) {}
  RationalFunction(int constant) : numerator_(constant) {}
  /// Domain: no negative exponents, the denominator not zero.
  RationalFunction(LaurentPolynomial numerator, LaurentPolynomial denominator);

  /// Reads sums, products, quotients and whole powers of exact numbers and the letter, with parentheses:
  /// `(1-w)^2/(2+3*w)`. Domain: degrees up to 64, powers up to 64, parentheses 50 deep. Errors: throws ParseError.
  static RationalFunction parse(std::string_view text, char letter);

  const LaurentPolynomial& numerator() const { return numerator_; }
  const LaurentPolynomial& denominator() const { return denominator_; }
  bool is_polynomial() const { return denominator_ == LaurentPolynomial(1); }
  /// Domain: the denominator does not vanish there. Errors: throws Error.
  Rational operator()(const Rational& w) const;

  RationalFunction operator-() const { return {-numerator_, denominator_}; }
  friend RationalFunction operator+(const RationalFunction& a, const RationalFunction& b);
  friend RationalFunction operator-(const RationalFunction& a, const RationalFunction& b) { return a + -b; }
  friend RationalFunction operator*(const RationalFunction& a, const RationalFunction& b);
  /// Domain: b not zero.
  friend RationalFunction operator/(const RationalFunction& a, const RationalFunction& b);
  RationalFunction& operator+=(const RationalFunction& other) { return *this = *this + other; }
  RationalFunction& operator*=(const RationalFunction& other) { return *this = *this * other; }
  bool operator==(const RationalFunction& other) const = default;

  /// What parse reads, without blanks.
  std::string to_text(char letter) const;

 private:
  LaurentPolynomial numerator_, denominator_ = 1;
};

/// A polynomial in a parameter of this name, as to_text() prints those in z.
std::string to_text(const LaurentPolynomial& polynomial, char letter);

}  // namespace subcert
