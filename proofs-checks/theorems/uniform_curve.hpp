#pragma once
/// Bounds of mean, ripple and slope of the variance curves of one odd degree for all n >= n_1, for the sources of
/// this floor. Proofs: docs/theorems/variance-curves.tex, section 7; its notation is used.

#include "uniform_symbol.hpp"

#include <vector>

namespace subcert::theorems {

/// Factors of X_0 that are kept.
constexpr int kept_factors = 5;

/// The numbers behind the stated constants of section 7: upper bounds, rounded upward and then exact.
struct UniformNumbers {
  Ball near_zero_difference;  ///< H_R
  Ball near_zero_slope;       ///< E_R
  Ball slope;                 ///< E
  std::vector<Ball> decays;   ///< A_j, j < factors
  Ball products;              ///< B: products of suprema of |m| over different shells
  Ball mean;                  ///< K: N^3 |the integral of |transform|^2/(2 pi) over |xi| <= pi - 2 C_d/N|
};

/// For all n >= first_n; kept for the next call. Domain: odd degree, first_n large enough for the degree.
/// Errors: throws undecided or std::logic_error where it is not. Cost: a second.
const UniformNumbers& uniform_numbers(int degree, int first_n);

}  // namespace subcert::theorems
