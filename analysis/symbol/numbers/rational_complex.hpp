#pragma once
/// Complex numbers with rational parts.

#include "numbers.hpp"

#include <vector>

namespace subcert {

/// re + i im, exact.
struct RationalComplex {
  Rational re = 0;
  Rational im = 0;

  RationalComplex& operator+=(const RationalComplex& b) {
    re += b.re;
    im += b.im;
    return *this;
  }
  friend RationalComplex operator+(RationalComplex a, const RationalComplex& b) { return a += b; }
  friend RationalComplex operator-(const RationalComplex& a, const RationalComplex& b) {
    return {a.re - b.re, a.im - b.im};
  }
  friend RationalComplex operator*(const RationalComplex& a, const RationalComplex& b) {
    return {a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re};
  }
  friend RationalComplex operator*(const Rational& a, const RationalComplex& b) { return {a * b.re, a * b.im}; }
  bool operator==(const RationalComplex&) const = default;

  RationalComplex conjugate() const { return {re, -im}; }
  Rational squared_modulus() const { return re * re + im * im; }
};

using ComplexVector = std::vector<RationalComplex>;

/// |x|_1, real and imaginary parts apart.
inline Rational one_norm(const ComplexVector& x) {
  Rational sum = 0;
  for (const RationalComplex& c : x) sum += abs(c.re) + abs(c.im);
  return sum;
}

/// <v, w> / <v, v>: the number that w is of v, nearly or exactly. Domain: v not 0, of the size of w.
inline RationalComplex rayleigh_quotient(const ComplexVector& v, const ComplexVector& w) {
  RationalComplex sum;
  Rational size = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    sum += v[i].conjugate() * w[i];
    size += v[i].squared_modulus();
  }
  return (1 / size) * sum;
}

}  // namespace subcert
