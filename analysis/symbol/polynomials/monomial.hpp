#pragma once
/// One term of a polynomial in several variables.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <vector>

namespace subcert {

/// coefficient * x_1^exponents[0] * x_2^exponents[1] * ...
struct Monomial {
  Rational coefficient;
  std::vector<long> exponents;
};

}  // namespace subcert
