#pragma once
/// Data that are zero on one side and repeat themselves there, smaller, at each level: their limits are no smoother
/// than the factor says.

#include "piecewise_rule.hpp"

#include <optional>
#include <vector>

namespace subcert::piecewise {

/// Zeros followed by `values` give, at the next level, zeros followed by factor * values and at least one value more
/// that these determine. The limit L of such data is not zero near the edge t, where L(t + s/2) = factor * L(t + s): no
/// limit has more than -log2(factor) derivatives in the sense of Hoelder.
struct EdgeOrbit {
  std::vector<Rational> values;
  Rational factor;
  /// With so many zeros before the values, the data of each level stand at offset * 2^level of the next one, times the
  /// factor; the pieces of all windows, level after level, until 2 * points - 1 values in a row are positive.
  std::size_t zeros = 0, offset = 0;
  std::vector<std::vector<std::size_t>> pieces = {};
};

/// Looks for one from a step and a kink, and checks it by substitution. What descends from 2 * points - 1 positive
/// values in a row is at least the least of these. Domain: a binary function whose values never leave the range of the
/// data. Nothing where none was found, as where the factor is not rational. Cost: some hundred steps on few windows.
std::optional<EdgeOrbit> edge_orbit(const Rule& rule);

}  // namespace subcert::piecewise
