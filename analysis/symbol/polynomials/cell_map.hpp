#pragma once
/// A property over a box of values of letters, by cells.

#include "box.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <string>

namespace subcert {

/// On all of a box the property holds (yes), for none of its values (no), or neither is proved.
struct MapCell {
  Box box;
  Truth holds = Truth::unknown;
  std::string reason = {};  ///< why it is not decided
};

struct CellMap {
  std::vector<MapCell> cells = {};  ///< they cover the box that was asked for, and have no inner point in common
  bool complete = true;             ///< all cells that are not decided are as small as they may be

  /// The share of the area, or volume, with this answer.
  Rational share(Truth holds) const;
};

struct MapOptions {
  int resolution = 64;  ///< cells along each side, at most; rounded up to a power of 2
  int jobs = 1;
  Budget budget{Deadline::in(60)};
};

/// Errors: throws Error unless there are two letters or more, low < high for each, and 1 <= resolution <= 1024.
void require_map(const Box& box, const MapOptions& options);

}  // namespace subcert
