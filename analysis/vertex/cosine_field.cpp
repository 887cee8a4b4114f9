#include "cosine_field.hpp"

#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>

#include <algorithm>
#include <utility>

namespace subcert::vertex {
namespace {

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

Ball BallField::in_cosine(const LaurentPolynomial& p, long from, long to) const {
  Ball value(0, bits());
  for (long k = to; k >= from; --k) value = value * first_ + Ball(p.coefficient(k), bits());
  return value;
}

Ball BallField::number(const LaurentPolynomial& p) const {
  const long highest = p.is_zero() ? -1 : p.highest();
  if (!letter_) return in_cosine(p, 0, highest);
  Ball value(0, bits());
  for (long power = highest / letter_stride; power >= 0; --power)
    value = value * *letter_ + in_cosine(p, power * letter_stride, std::min(highest, (power + 1) * letter_stride - 1));
  return value;
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
