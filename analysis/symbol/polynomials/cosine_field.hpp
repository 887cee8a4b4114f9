#pragma once
/// The real numbers of the field of exp(2 pi i/n), exact.

#include "laurent_polynomial.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace subcert {

/// cos(k t) as a polynomial in cos(t). Domain: k >= 0.
LaurentPolynomial chebyshev(long k);

/// Q(c): polynomials in c of a degree below that of the minimal polynomial of c.
class CosineField {
 public:
  explicit CosineField(long valence);

  class Number {
   public:
    Number(LaurentPolynomial value, const LaurentPolynomial* modulus) : value_(std::move(value)), modulus_(modulus) {
      reduce();
    }
    const LaurentPolynomial& polynomial() const { return value_; }
    bool is_zero() const { return value_.is_zero(); }
    bool is_rational() const { return value_.is_zero() || value_.highest() == 0; }
    Number operator-() const { return {-value_, modulus_}; }
    friend Number operator+(const Number& a, const Number& b) { return {a.value_ + b.value_, a.modulus_}; }
    friend Number operator-(const Number& a, const Number& b) { return {a.value_ - b.value_, a.modulus_}; }
    friend Number operator*(const Number& a, const Number& b) { return {a.value_ * b.value_, a.modulus_}; }
    /// Domain: not zero.
    Number inverse() const;

   private:
    void reduce();
    LaurentPolynomial value_;
    const LaurentPolynomial* modulus_;
  };

  Number number(const LaurentPolynomial& p) const { return {p, modulus_.get()}; }
  Number number(long value) const { return number(LaurentPolynomial(Rational(value))); }
  Number cosine(long k) const;
  /// The minimal polynomial of c = cos(2 pi/n).
  const LaurentPolynomial& modulus() const { return *modulus_; }

 private:
  std::shared_ptr<const LaurentPolynomial> modulus_;
};

/// Brings rows to reduced echelon form; the columns of the pivots. Domain: rows of one length. Cost: one elimination.
std::vector<std::size_t> reduce(std::vector<std::vector<CosineField::Number>>& rows);

}  // namespace subcert
