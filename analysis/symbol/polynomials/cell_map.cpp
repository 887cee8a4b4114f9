#include "cell_map.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert {

Rational CellMap::share(Truth holds) const {
  Rational all = 0, found = 0;
  for (const MapCell& cell : cells) {
    const Rational volume = cell.box.volume();
    all += volume;
    if (cell.holds == holds) found += volume;
  }
  return found / all;
}

void require_map(const Box& box, const MapOptions& options) {
  require(box.letters() >= 2, "map: need ranges for two or more letters, got {}", box.letters());
  for (std::size_t v = 0; v < box.letters(); ++v)
    require(box.low[v] < box.high[v], "map: need low < high, got {} and {}", box.low[v], box.high[v]);
  require(options.resolution >= 1 && options.resolution <= 1024, "map: need a resolution from 1 to 1024, got {}",
          options.resolution);
}

}  // namespace subcert
