#include "cosine_field.hpp"

#include "real_roots.hpp"

#include <utility>

namespace subcert {
namespace {

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

}  // namespace

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

std::vector<std::size_t> reduce(std::vector<std::vector<CosineField::Number>>& rows) {
  std::vector<std::size_t> pivots;
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t row = pivots.size();
    std::size_t found = row;
    while (found < rows.size() && rows[found][column].is_zero()) ++found;
    if (found == rows.size()) continue;
    std::swap(rows[row], rows[found]);
    const CosineField::Number inverse = rows[row][column].inverse();
    for (CosineField::Number& entry : rows[row]) entry = inverse * entry;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == row || rows[i][column].is_zero()) continue;
      const CosineField::Number factor = rows[i][column];
      for (std::size_t j = column; j < columns; ++j) rows[i][j] = rows[i][j] - factor * rows[row][j];
    }
    pivots.push_back(column);
  }
  return pivots;
}

}  // namespace subcert
