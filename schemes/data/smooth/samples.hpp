#pragma once
/// Samples of functions on one uniform grid.

#include <subcert/analysis/symbol/numbers.hpp>

#include <vector>

namespace subcert::data {

/// columns[c][i] is the datum of function c at origin + i * spacing. Canonical: one column or more, all of one size;
/// as many weights as data, or none.
struct Samples {
  std::vector<std::vector<double>> columns;
  std::vector<Rational> weights = {};  ///< prior, inverse to the variance of the noise; 0: missing; none: all 1
  Rational origin = 0;
  Rational spacing = 1;

  std::size_t count() const { return columns.empty() ? 0 : columns.front().size(); }

  std::vector<double> rounded_weights() const;
};

}  // namespace subcert::data
