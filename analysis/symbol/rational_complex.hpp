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

}  // namespace subcert
