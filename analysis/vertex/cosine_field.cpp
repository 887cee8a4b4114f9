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

Ball BallField::number(const LaurentPolynomial& p) const {
  // By Horner's rule in c and in each letter: the coefficient of what is left of the powers from `at` on.
  const long highest = p.is_zero() ? -1 : p.highest();
  const auto value_of = [&](const auto& self, long at, long step, std::size_t place) -> Ball {
    const bool is_last = place == letters_.size();
    const long below = place == 0 ? letter_stride : letter_powers, most = highest < at ? -1 : (highest - at) / step;
    Ball value(0, bits());
    for (long k = is_last ? most : std::min(most, below - 1); k >= 0; --k)
      value = value * (place == 0 ? first_ : letters_[place - 1]) +
              (place == 0 ? Ball(p.coefficient(at + k), bits())
                          : self(self, at + k * step, step / (place == 1 ? letter_stride : letter_powers), place - 1));
    return value;
  };
  long step = 1;
  for (std::size_t place = 0; place < letters_.size(); ++place) step *= place == 0 ? letter_stride : letter_powers;
  return value_of(value_of, 0, step, letters_.size());
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
