#include "cosine_field.hpp"

#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <utility>

namespace subcert::vertex {
namespace {

/// cos(k t) as a polynomial in cos(t).
LaurentPolynomial chebyshev(long k) {
  LaurentPolynomial last = 1, current = LaurentPolynomial::monomial(1, 1);
  if (k == 0) return last;
  const LaurentPolynomial twice = LaurentPolynomial::monomial(2, 1);
  for (; k > 1; --k) {
    LaurentPolynomial next = twice * current - last;
    last = std::move(current);
    current = std::move(next);
  }
  return current;
}

struct Division {
  LaurentPolynomial quotient, remainder;
};

/// Of polynomials without negative exponents, which the division of Laurent polynomials would shift.
Division divided(LaurentPolynomial p, const LaurentPolynomial& divisor) {
  Division result;
  while (!p.is_zero() && p.highest() >= divisor.highest()) {
    const LaurentPolynomial factor = LaurentPolynomial::monomial(
        p.coefficient(p.highest()) / divisor.coefficient(divisor.highest()), p.highest() - divisor.highest());
    p -= factor * divisor;
    result.quotient += factor;
  }
  result.remainder = std::move(p);
  return result;
}

void trim(FieldPolynomial& p) {
  while (!p.empty() && p.back().is_zero()) p.pop_back();
}

/// a modulo b, and the quotient where it is asked for.
FieldPolynomial reduced(FieldPolynomial a, const FieldPolynomial& b, FieldPolynomial* quotient) {
  const CosineField::Number inverse = b.back().inverse();
  while (a.size() >= b.size()) {
    const CosineField::Number factor = a.back() * inverse;
    const std::size_t shift = a.size() - b.size();
    for (std::size_t i = 0; i < b.size(); ++i) a[shift + i] = a[shift + i] - factor * b[i];
    if (quotient) (*quotient)[shift] = factor;
    a.pop_back();  // which is zero
    trim(a);
  }
  return a;
}

}  // namespace

Ball BallField::number(const LaurentPolynomial& p) const {
  Ball value(0, bits_);
  for (long k = p.is_zero() ? -1 : p.highest(); k >= 0; --k) value = value * first_ + Ball(p.coefficient(k), bits_);
  return value;
}

Ball BallField::cosine_of(long k) const {
  return cos(Ball::pi(bits_) * Ball(Rational(Integer(2 * k), Integer(valence_)), bits_));
}

CosineField::CosineField(long valence) {
  // Of z + 1/z = 2c from the cyclotomic polynomial, whose coefficients are symmetric. Those of order 1 and 2 never
  // come.
  const LaurentPolynomial phi = cyclotomic(valence);
  const long half = phi.highest() / 2;
  LaurentPolynomial p = phi.coefficient(half);
  for (long j = 1; j <= half; ++j) p += LaurentPolynomial(2 * phi.coefficient(half + j)) * chebyshev(j);
  modulus_ = std::make_shared<const LaurentPolynomial>(p);
}

void CosineField::Number::reduce() {
  if (!value_.is_zero() && value_.highest() >= modulus_->highest())
    value_ = divided(std::move(value_), *modulus_).remainder;
}

CosineField::Number CosineField::Number::inverse() const {
  // a value + b modulus = r, down to a constant r.
  LaurentPolynomial r = *modulus_, next = value_, a, next_a = 1;
  while (!next.is_zero()) {
    Division division = divided(r, next);
    LaurentPolynomial after = a - division.quotient * next_a;
    a = std::exchange(next_a, std::move(after));
    r = std::exchange(next, std::move(division.remainder));
  }
  return {LaurentPolynomial(Rational(1 / r.coefficient(0))) * a, modulus_};
}

CosineField::Number CosineField::cosine(long k) const { return number(chebyshev(k)); }

FieldPolynomial characteristic_polynomial(const std::vector<std::vector<CosineField::Number>>& matrix,
                                          const CosineField& field) {
  // M_1 = A, c_j = -tr(M_j)/j, M_(j+1) = A (M_j + c_j) [Faddeev and LeVerrier].
  const std::size_t n = matrix.size();
  FieldPolynomial result(n + 1, field.number(1));
  auto product = matrix;
  for (std::size_t j = 1; j <= n; ++j) {
    CosineField::Number trace = field.number(0);
    for (std::size_t i = 0; i < n; ++i) trace = trace + product[i][i];
    result[n - j] = field.number(LaurentPolynomial(Rational(-1) / Rational(static_cast<long>(j)))) * trace;
    if (j == n) break;
    for (std::size_t i = 0; i < n; ++i) product[i][i] = product[i][i] + result[n - j];
    auto next = matrix;
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) {
        next[r][c] = field.number(0);
        for (std::size_t k = 0; k < n; ++k)
          if (!matrix[r][k].is_zero() && !product[k][c].is_zero())
            next[r][c] = next[r][c] + matrix[r][k] * product[k][c];
      }
    product = std::move(next);
  }
  return result;
}

FieldPolynomial gcd(FieldPolynomial a, FieldPolynomial b) {
  trim(a);
  trim(b);
  while (!b.empty()) {
    FieldPolynomial rest = reduced(std::move(a), b, nullptr);
    a = std::exchange(b, std::move(rest));
  }
  const CosineField::Number inverse = a.back().inverse();
  for (CosineField::Number& entry : a) entry = inverse * entry;
  return a;
}

FieldPolynomial in_squares(const FieldPolynomial& p, const CosineField& field) {
  FieldPolynomial result(2 * p.size() - 1, field.number(0));
  for (std::size_t i = 0; i < p.size(); ++i) result[2 * i] = p[i];
  return result;
}

FieldPolynomial quotient(FieldPolynomial a, const FieldPolynomial& b, const CosineField& field) {
  FieldPolynomial result(a.size() < b.size() ? 0 : a.size() - b.size() + 1, field.number(0));
  reduced(std::move(a), b, &result);
  return result;
}

FieldPolynomial derivative(const FieldPolynomial& p, const CosineField& field) {
  FieldPolynomial result;
  for (std::size_t i = 1; i < p.size(); ++i) result.push_back(field.number(static_cast<long>(i)) * p[i]);
  return result;
}

ComplexBall value_at(const FieldPolynomial& p, const ComplexBall& x, const BallField& balls) {
  ComplexBall value(Ball(0, x.bits()));
  for (std::size_t i = p.size(); i-- > 0;) value = value * x + balls.number(p[i].polynomial());
  return value;
}

std::optional<std::vector<ComplexBall>> zeros(const FieldPolynomial& p, const BallField& balls) {
  std::vector<Ball> coefficients;
  for (const CosineField::Number& entry : p) coefficients.push_back(balls.number(entry.polynomial()));
  return complex_roots(coefficients);
}

}  // namespace subcert::vertex
