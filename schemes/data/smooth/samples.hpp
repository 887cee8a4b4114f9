#pragma once
/// Samples of functions at the same positions.

#include "extension.hpp"

#include <optional>
#include <vector>

namespace subcert::data {

/// columns[c][i] is the datum of function c at positions[i] or, where there are none, at origin + i * spacing.
/// Canonical: one column or more, all of one size; as many weights as data, or none; positions likewise.
struct Samples {
  std::vector<std::vector<double>> columns;
  std::vector<Rational> weights = {};  ///< prior, inverse to the variance of the noise; 0: missing; none: all 1
  Rational origin = 0;                 ///< of the outputs
  Rational spacing = 1;                ///< likewise
  std::vector<double> positions = {};  ///< increasing from `origin`, so far apart that their distances to it increase
  std::optional<double> noise = {};    ///< standard deviation for weight 1, where it is known

  std::size_t count() const { return columns.empty() ? 0 : columns.front().size(); }
  bool uniform() const { return positions.empty(); }
  /// With positions in spacings, rounded.
  DataSites sites() const;
  std::vector<double> rounded_weights() const;
  /// Leaves out the data of weight 0, which are not needed where positions are given. Domain: not all of them.
  void drop_missing();
};

}  // namespace subcert::data
