
#include "numerical_recipe.hpp"

#include "checks.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace subcert::statements::dyn_2015 {
namespace {

constexpr int first_level = 5, last_level = 10;
constexpr int farthest = 2;  // windows end at n - farthest, ..., n + farthest

/// The samples f(i / 2^level) as the coefficients of z^i.
LaurentPolynomial samples(const SampledVariance& curve, const Mask& mask) {
  if (!curve.refined_pulse) {
    const LimitValues values = limit_values(mask, curve.level);
    return LaurentPolynomial(values.values, values.first_index);
  }
  LaurentPolynomial data(1);
  for (int k = 0; k < curve.level; ++k) data = data.dilated(2) * mask.symbol();
  return data;
}

/// Squares of the samples over one denominator.
struct Squares {
  long first;
  std::vector<Integer> values;
  Integer denominator;
  int level;

  Squares(const LaurentPolynomial& f, int of_level)
      : first(f.lowest()), values(f.numerators()), denominator(f.denominator() * f.denominator()), level(of_level) {
    for (Integer& value : values) value *= value;
  }

  std::size_t steps() const { return std::size_t{1} << level; }
  /// Beyond this no j adds anything.
  long shifts() const {
    return static_cast<long>(values.size() / steps()) + std::abs(first) / static_cast<long>(steps()) + 2;
  }

  /// Adds f(x - j)^2 to a curve.
  void add(std::vector<Integer>& curve, long j) const {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const long index = static_cast<long>(i) - j * static_cast<long>(steps()) - first;
      if (index >= 0 && index < static_cast<long>(values.size())) curve[i] += values[static_cast<std::size_t>(index)];
    }
  }

  /// First and last j of a sum.
  std::pair<long, long> bounds(const std::optional<SampledVariance::Window>& window, int n) const {
    if (!window) return {-shifts(), shifts()};
    return {-(n + window->beyond), n + window->beyond + (window->one_more ? 1 : 0)};
  }

  RecipeValues of(const std::vector<Integer>& curve, bool two_steps) const {
    const std::size_t apart = two_steps ? 2 : 1;
    Integer most = 0;
    for (std::size_t i = apart; i < curve.size(); ++i) most = std::max(most, Integer(abs(curve[i] - curve[i - apart])));
    const Rational unit = Rational(1) / Rational(denominator);
    return {Rational(*std::max_element(curve.begin(), curve.end())) * unit,
            Rational(most) * unit * power(Rational(2), level) / Rational(static_cast<long>(apart))};
  }
};

std::vector<std::optional<SampledVariance::Window>> windows() {
  std::vector<std::optional<SampledVariance::Window>> result{std::nullopt};
  for (int beyond = -farthest; beyond <= farthest; ++beyond)
    for (bool one_more : {false, true}) result.push_back(SampledVariance::Window{beyond, one_more});
  return result;
}

/// The sum over growing ranges of j.
class GrowingSum {
 public:
  explicit GrowingSum(const Squares& squares) : squares_(squares), curve_(squares.steps() + 1, 0) {}

  /// Domain: `first` and `last` enclose the range before, or it was empty.
  const std::vector<Integer>& grow(long first, long last) {
    if (first > last) return curve_;
    if (low_ > high_) {
      low_ = first;
      high_ = first - 1;
    }
    while (high_ < last) squares_.add(curve_, ++high_);
    while (low_ > first) squares_.add(curve_, --low_);
    return curve_;
  }

 private:
  const Squares& squares_;
  std::vector<Integer> curve_;
  long low_ = 1, high_ = 0;  // nothing added
};

std::string bound_text(int beyond) {
  if (beyond == 0) return "n";
  return beyond > 0 ? "n+" + std::to_string(beyond) : "n-" + std::to_string(-beyond);
}

}  // namespace

std::string NumericalRecipe::text(bool slope) const {
  std::string text = curve.refined_pulse ? "a pulse refined " + std::to_string(curve.level) + " times"
                                         : "phi at the multiples of 2^-" + std::to_string(curve.level);
  if (curve.window) {
    const int left = curve.window->beyond, right = left + (curve.window->one_more ? 1 : 0);
    text += ", squares summed over j = -" + (left == 0 ? "n" : "(" + bound_text(left) + ")") + ", ..., " +
            bound_text(right) + " alone";
  } else {
    text += ", squares summed over all j";
  }
  if (slope) text += ", divided differences of step 2^-" + std::to_string(curve.level - (two_steps ? 1 : 0));
  return text;
}

const std::vector<NumericalRecipe>& numerical_recipes() {
  static const std::vector<NumericalRecipe> all = [] {
    std::vector<NumericalRecipe> list;
    for (const auto& window : windows())
      for (bool refined : {false, true})
        for (int level = first_level; level <= last_level; ++level)
          for (bool two_steps : {false, true}) list.push_back({{refined, level, window}, two_steps});
    return list;
  }();
  return all;
}

RecipeValues evaluate_numerical_recipe(const NumericalRecipe& recipe, const Mask& mask, int n) {
  const Squares squares(samples(recipe.curve, mask), recipe.curve.level);
  const auto [first, last] = squares.bounds(recipe.curve.window, n);
  return squares.of(GrowingSum(squares).grow(first, last), recipe.two_steps);
}

std::vector<RecipeValues> evaluate_numerical_recipes(const Mask& mask, int n) {
  std::vector<RecipeValues> result(numerical_recipes().size());
  const auto sums = windows();
  constexpr std::size_t levels = last_level - first_level + 1;
  for (std::size_t source = 0; source < 2 * levels; ++source) {
    const int level = first_level + static_cast<int>(source % levels);
    const Squares squares(samples({source >= levels, level, std::nullopt}, mask), level);
    GrowingSum sum(squares);
    for (std::size_t k = 1; k <= sums.size(); ++k) {  // the windows grow; the whole sum, the first, comes last
      const std::size_t w = k % sums.size();
      const auto [first, last] = squares.bounds(sums[w], n);
      const std::vector<Integer>& curve = sum.grow(first, last);
      for (std::size_t two_steps : {0, 1})
        result[(w * 2 * levels + source) * 2 + two_steps] = squares.of(curve, two_steps == 1);
    }
  }
  return result;
}

bool gives_digits(const Rational& value, const std::string& printed) {
  const std::size_t point = printed.find('.');
  const int places = point == std::string::npos ? 0 : static_cast<int>(printed.size() - point - 1);
  return to_fixed(value, places, Rounding::nearest) == printed || to_fixed(value, places, Rounding::down) == printed;
}

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
