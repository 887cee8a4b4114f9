#include "numerical_recipe_search.hpp"

#include "checks.hpp"

#include <algorithm>
#include <numeric>

namespace subcert::statements::dyn_2015 {

NumericalRecipeSearch::NumericalRecipeSearch(const PublishedTable& table, Values values)
    : table_(table), values_(std::move(values)) {
  for (std::size_t s = 0; s < numerical_recipes().size(); ++s) {
    const auto count = static_cast<std::size_t>(
        std::count_if(table.cells.begin(), table.cells.end(), [&](const auto& cell) { return gives(cell, s); }));
    if (count > cells_given_) {
      cells_given_ = count;
      best_ = s;
    }
  }
}

Rational NumericalRecipeSearch::value(const PublishedCell& cell, std::size_t recipe) const {
  const ScaledMaximum what = scaled_maximum(cell);
  const RecipeValues& values = values_.at(cell.scheme).at(recipe);
  return what.factor * (what.slope ? values.slope : values.maximum);
}

bool NumericalRecipeSearch::gives(const PublishedCell& cell, std::size_t recipe) const {
  return gives_digits(value(cell, recipe), cell.printed);
}

std::string NumericalRecipeSearch::note(const PublishedCell& cell) const {
  std::vector<std::size_t> order(numerical_recipes().size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(best_),
              order.begin() + static_cast<std::ptrdiff_t>(best_) + 1);
  for (std::size_t s : order)
    if (gives(cell, s))
      return "the printed digits agree with " + numerical_recipes()[s].text(scaled_maximum(cell).slope) + ": " +
             to_fixed(value(cell, s), 6, Rounding::nearest);
  return "no recipe tried reproduces it";
}

std::string NumericalRecipeSearch::summary() const {
  std::string others;
  for (const PublishedCell& cell : table_.cells)
    if (!gives(cell, best_)) others += (others.empty() ? "" : " and ") + cell.column + " of " + cell.row;
  return "Of " + std::to_string(numerical_recipes().size()) +
         " numerical recipes, each evaluated exactly, one agrees with the printed digits (rounded or cut) of " +
         std::to_string(cells_given_) + " of the " + std::to_string(table_.cells.size()) +
         " cells: " + numerical_recipes()[best_].text() + "." +
         (others.empty() ? "" : " It does not agree with " + others + ".");
}

}  // namespace subcert::statements::dyn_2015
