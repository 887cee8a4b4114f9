#include "row_lines.hpp"

#include <algorithm>
#include <iterator>

namespace subcert::data {

void RowLines::add(std::size_t line) {
  if (runs_.empty() || line != at(rows_)) runs_.emplace_back(rows_, line);
  ++rows_;
}

std::size_t RowLines::at(std::size_t row) const {
  const auto after = std::ranges::upper_bound(runs_, row, {}, &std::pair<std::size_t, std::size_t>::first);
  const auto& [first, line] = *std::prev(after);
  return line + row - first;
}

}  // namespace subcert::data
