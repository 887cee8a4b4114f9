#pragma once
/// The real numbers of the field of exp(2 pi i/n), exact. For sources.

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>

#include <memory>
#include <optional>
#include <vector>

namespace subcert::vertex {

/// cos(k t) as a polynomial in cos(t). Domain: k >= 0.
LaurentPolynomial chebyshev(long k);

/// Numbers known to so many bits.
class BallField {
 public:
  using Number = Ball;
  BallField(long valence, slong bits) : BallField(Ball(Rational(Integer(1), Integer(valence)), bits)) {}
  /// For all 1/n in a ball.
  explicit BallField(const Ball& over_valence) : over_valence_(over_valence), first_(cosine_of(1)) {}

  /// A polynomial in c = cos(2 pi/n).
  Ball number(const LaurentPolynomial& p) const;
  Ball number(long value) const { return {value, bits()}; }
  /// cos(2 pi k/n).
  Ball cosine(long k) const { return k == 1 ? first_ : cosine_of(k); }
  slong bits() const { return over_valence_.bits(); }

 private:
  Ball cosine_of(long k) const { return cos(Ball::pi(bits()) * over_valence_ * (2 * k)); }
  Ball over_valence_, first_;
};

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

/// Polynomials over the field, the lowest coefficient first. Canonical: the last coefficient is not zero.
using FieldPolynomial = std::vector<CosineField::Number>;

/// Monic. Domain: not both zero.
FieldPolynomial gcd(FieldPolynomial a, FieldPolynomial b);
/// p(x^2).
FieldPolynomial in_squares(const FieldPolynomial& p, const CosineField& field);
/// Domain: b not zero.
FieldPolynomial quotient(FieldPolynomial a, const FieldPolynomial& b, const CosineField& field);
FieldPolynomial derivative(const FieldPolynomial& p, const CosineField& field);
ComplexBall value_at(const FieldPolynomial& p, const ComplexBall& x, const BallField& balls);
/// All zeros, in disjoint balls; nothing where the bits do not do. Domain: no multiple zeros, a degree >= 1.
std::optional<std::vector<ComplexBall>> zeros(const FieldPolynomial& p, const BallField& balls);

}  // namespace subcert::vertex
