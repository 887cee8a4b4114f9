#pragma once
/// What outliers can do to least absolute deviations, exactly.

#include "least_absolute.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace subcert::data {

/// Of windows of N data, degree D, all outputs, for every choice of minimisers.
struct LeastAbsoluteRobustness {
  /// The largest modulus of an output where one datum, at each place in turn, is arbitrary and the others are in
  /// [-1, 1]; nothing where there is none: the fit breaks down.
  std::vector<std::optional<Rational>> one;
  std::vector<std::pair<int, int>> two_break;  ///< pairs of places, from 0, at which two data break the fit down
  std::optional<Rational> two;                 ///< the largest modulus for all other pairs, if there are any
  /// The largest k such that F(p) - F(p*) >= k |p(c) - p*(c)| for all data, polynomials and outputs, F the sum of
  /// moduli and p* its minimiser; where minimisers are unique.
  std::optional<Rational> sharpness;
};

/// Domain: 0 <= D <= 3, D + 2 <= N <= 12, arity >= 2, else throws a domain error. Cost: for each output less than N^2
/// binom(N, D + 1) binom(N, D) N operations. Ref: docs/l1.md, section 9.
LeastAbsoluteRobustness least_absolute_robustness(int points, int degree, int arity = 2);

}  // namespace subcert::data
