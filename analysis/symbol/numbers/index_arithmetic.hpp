#pragma once
/// Integers that number coefficients and the points of grids: rounding and remainders that go down.

#include "numbers.hpp"

namespace subcert {

/// The largest integer that is not above x, and the least that is not below it. Domain: results fit in a long.
inline long floor_index(const Rational& x) { return to_integer(x, Rounding::down).convert_to<long>(); }
inline long ceil_index(const Rational& x) { return to_integer(x, Rounding::up).convert_to<long>(); }

/// a = b * floor_divide(a, b) + modulo(a, b) with 0 <= modulo(a, b) < b. Domain: b > 0.
inline long floor_divide(long a, long b) { return a / b - (a % b < 0 ? 1 : 0); }
inline long modulo(long a, long b) { return a - b * floor_divide(a, b); }

}  // namespace subcert
