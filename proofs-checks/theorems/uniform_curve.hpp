#pragma once
/// Bounds of mean, ripple and slope of the variance curves of one degree for all sizes N >= N_1, for the sources of
/// this floor. Proofs: docs/theorems/variance-curves.tex, section 7; its notation is used.

#include "kernel/uniform_symbol.hpp"

#include <vector>

namespace subcert::theorems {

/// Factors of X_0 that are kept.
constexpr int kept_factors = 5;

/// The numbers behind the stated constants of section 7: upper bounds, rounded upward and then exact.
class UniformNumbers {
 public:
  UniformNumbers(Evaluation evaluation, int degree, const Rational& first_N);

  UniformSymbol::Disc difference_disc;  ///< what H bounds, and how far it holds
  UniformSymbol::Disc slope_disc;       ///< what F bounds
  UniformSymbol::Disc alias_disc;       ///< the same of order k
  Ball slope;                           ///< E
  std::vector<Ball> decays;             ///< A_j, j < kept_factors
  Ball any_decay;                       ///< A for all v >= 1
  Ball far;                             ///< alpha on v >= 2^12

  /// With a stated H. B: products of suprema of |m| over different shells.
  Ball products(const Ball& H) const;
  /// K: N^3 |the integral of |transform|^2/(2 pi) over |xi| <= pi - 2 C_d/N|. Domain: far < 1/4, pi N_1 < 2^12.
  Ball mean(const Ball& H) const;

 private:
  UniformSymbol::Cell cell(int octave, int part, const Ball& H) const;
  Ball near_product(const Ball& H) const;

  int degree_;
  Ball N_;
  std::vector<UniformSymbol::Cell> cells_;
  UniformSymbol::Growth growth_;
};

/// Kept for the next call. Domain: as UniformSymbol. Errors: throws std::logic_error where N_1 is too small.
/// Cost: for degree 13 a few seconds.
const UniformNumbers& uniform_numbers(Evaluation evaluation, int degree, const Rational& first_N);

}  // namespace subcert::theorems
