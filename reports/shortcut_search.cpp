#include "shortcut_search.hpp"

#include <subcert/schemes/data/runtime/parallel.hpp>

#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <numeric>

namespace subcert::reports {

VarianceCell::VarianceCell(const formats::PublishedCell& cell)
    : n(std::stoi(cell.row.substr(cell.row.find("n=") + 2))),
      slope(cell.quantity.find("slope") != std::string::npos),
      factor(cell.quantity == "n*variance"  ? n
             : cell.quantity == "n^2*slope" ? n * n
                                            : 1) {}

ShortcutSearch::ShortcutSearch(const formats::PublishedTable& table, int jobs) : table_(table) {
  std::map<std::string, int> sizes;
  for (const formats::PublishedCell& cell : table.cells) sizes[cell.scheme] = VarianceCell(cell).n;
  std::vector<std::pair<const std::string, std::vector<ShortcutValues>>*> entries;
  for (const auto& [scheme, n] : sizes) entries.push_back(&*values_.try_emplace(scheme).first);
  runtime::parallel_for_each(entries.size(), jobs, [&](std::size_t i) {
    entries[i]->second = evaluate_shortcuts(make_scheme(entries[i]->first).mask, sizes.at(entries[i]->first));
  });
  for (std::size_t s = 0; s < variance_shortcuts().size(); ++s) {
    const auto count = static_cast<std::size_t>(
        std::count_if(table.cells.begin(), table.cells.end(), [&](const auto& cell) { return gives(cell, s); }));
    if (count > cells_given_) {
      cells_given_ = count;
      best_ = s;
    }
  }
}

Rational ShortcutSearch::value(const formats::PublishedCell& cell, std::size_t shortcut) const {
  const VarianceCell what(cell);
  const ShortcutValues& values = values_.at(cell.scheme).at(shortcut);
  return what.factor * (what.slope ? values.slope : values.maximum);
}

bool ShortcutSearch::gives(const formats::PublishedCell& cell, std::size_t shortcut) const {
  return gives_digits(value(cell, shortcut), cell.printed);
}

std::string ShortcutSearch::note(const formats::PublishedCell& cell) const {
  std::vector<std::size_t> order(variance_shortcuts().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(best_),
              order.begin() + static_cast<std::ptrdiff_t>(best_) + 1);
  for (std::size_t s : order)
    if (gives(cell, s))
      return "the printed digits are those of " + variance_shortcuts()[s].text(VarianceCell(cell).slope) + ": " +
             to_fixed(value(cell, s), 6, Rounding::nearest);
  return "no shortcut tried reproduces it";
}

std::string ShortcutSearch::summary() const {
  std::string others;
  for (const formats::PublishedCell& cell : table_.cells)
    if (!gives(cell, best_)) others += (others.empty() ? "" : " and ") + cell.column + " of " + cell.row;
  return "Of " + std::to_string(variance_shortcuts().size()) +
         " numerical shortcuts, each evaluated exactly, one gives the printed digits (rounded or cut) of " +
         std::to_string(cells_given_) + " of the " + std::to_string(table_.cells.size()) +
         " cells: " + variance_shortcuts()[best_].text() + "." +
         (others.empty() ? "" : " It does not give " + others + ".");
}

}  // namespace subcert::reports
