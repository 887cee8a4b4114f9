#pragma once
/// Quotients of polynomials in one letter or in several.

#include "multivariate_polynomial.hpp"

#include <concepts>

namespace subcert {

/// A constant in as many letters as p has.
inline LaurentPolynomial constant_like(const LaurentPolynomial&, const Rational& constant) { return constant; }
inline MultivariatePolynomial constant_like(const MultivariatePolynomial& p, const Rational& constant) {
  return {p.variables(), constant};
}

/// p(w)/q(w). Canonical: no common factor; q has integer coefficients without a common factor, the last of them in the
/// order of the terms (of one letter: that of the lowest power) positive; 0 is 0/1.
template <class Polynomial>
class QuotientOf {
 public:
  QuotientOf(Polynomial polynomial = {})
      : numerator_(std::move(polynomial)), denominator_(constant_like(numerator_, 1)) {}
  QuotientOf(const Rational& constant) requires std::constructible_from<Polynomial, const Rational&>
      : QuotientOf(Polynomial(constant)) {}
  QuotientOf(int constant) requires std::constructible_from<Polynomial, const Rational&>
      : QuotientOf(Polynomial(constant)) {}
  /// Domain: the denominator not zero, as many letters in both.
  QuotientOf(Polynomial numerator, Polynomial denominator);

  /// Reads sums, products, quotients and whole powers of exact numbers and the letters, with parentheses:
  /// `(1-w)^2/(2+3*w)`. Domain: degrees up to 64 in one letter, 24 in each of two or three; powers up to 64,
  /// parentheses 50 deep. Errors: throws ParseError.
  static QuotientOf parse(std::string_view text, std::string_view letters);

  const Polynomial& numerator() const { return numerator_; }
  const Polynomial& denominator() const { return denominator_; }
  bool is_polynomial() const { return denominator_ == constant_like(denominator_, 1); }
  bool is_zero() const { return numerator_.is_zero(); }
  /// Domain: the denominator does not vanish there. Errors: throws Error.
  Rational operator()(const Rational& w) const requires std::same_as<Polynomial, LaurentPolynomial>;

  QuotientOf operator-() const { return {-numerator_, denominator_}; }
  friend QuotientOf operator+(const QuotientOf& a, const QuotientOf& b) {
    if (a.denominator_ == b.denominator_) return {a.numerator_ + b.numerator_, a.denominator_};
    return {a.numerator_ * b.denominator_ + b.numerator_ * a.denominator_, a.denominator_ * b.denominator_};
  }
  friend QuotientOf operator-(const QuotientOf& a, const QuotientOf& b) { return a + -b; }
  friend QuotientOf operator*(const QuotientOf& a, const QuotientOf& b) {
    return {a.numerator_ * b.numerator_, a.denominator_ * b.denominator_};
  }
  /// Domain: b not zero.
  friend QuotientOf operator/(const QuotientOf& a, const QuotientOf& b) {
    return {a.numerator_ * b.denominator_, a.denominator_ * b.numerator_};
  }
  QuotientOf& operator+=(const QuotientOf& other) { return *this = *this + other; }
  QuotientOf& operator*=(const QuotientOf& other) { return *this = *this * other; }
  bool operator==(const QuotientOf& other) const = default;

  /// What parse reads, without blanks.
  std::string to_text(std::string_view letters) const;
  std::string to_text(char letter) const { return to_text({&letter, 1}); }

 private:
  Polynomial numerator_, denominator_;
};

using RationalFunction = QuotientOf<LaurentPolynomial>;
using LetterFunction = QuotientOf<MultivariatePolynomial>;
template <>
RationalFunction RationalFunction::parse(std::string_view text, std::string_view letters);
template <>
LetterFunction LetterFunction::parse(std::string_view text, std::string_view letters);
extern template class QuotientOf<LaurentPolynomial>;
extern template class QuotientOf<MultivariatePolynomial>;

/// A polynomial in a parameter of this name, as to_text() prints those in z.
std::string to_text(const LaurentPolynomial& polynomial, char letter);

}  // namespace subcert
