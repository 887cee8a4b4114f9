#pragma once
/// Balls with cos(2 pi/n), and polynomials over the field of that number. For sources.

#include <subcert/analysis/symbol/masks/sector_rules.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/polynomials/cosine_field.hpp>

#include <optional>
#include <vector>

namespace subcert::vertex {

/// Numbers known to so many bits.
class BallField {
 public:
  using Number = Ball;
  BallField(long valence, slong bits) : BallField(Ball(Rational(Integer(1), Integer(valence)), bits)) {}
  /// With letters in the weights of rules, see letter_stride. Domain: one letter or more.
  BallField(long valence, const std::vector<Ball>& letters) : BallField(valence, letters.front().bits()) {
    letters_ = letters;
  }
  /// For all 1/n in a ball.
  explicit BallField(const Ball& over_valence) : over_valence_(over_valence), first_(cosine_of(1)) {}

  /// A polynomial in c = cos(2 pi/n), and in the letters.
  Ball number(const LaurentPolynomial& p) const;
  Ball number(long value) const { return {value, bits()}; }
  /// cos(2 pi k/n).
  Ball cosine(long k) const { return k == 1 ? first_ : cosine_of(k); }
  slong bits() const { return over_valence_.bits(); }

 private:
  Ball cosine_of(long k) const { return cos(Ball::pi(bits()) * over_valence_ * (2 * k)); }
  Ball over_valence_, first_;
  std::vector<Ball> letters_ = {};
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
