#pragma once
/// The maxima of a variance curve and of its slope as finitely many numbers give them: candidates for how a printed
/// value came about. Domain, results and what they mean: docs/table-3.md.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/proofs-checks/statements/statement.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace subcert::statements::dyn_2015 {

/// The sum of the squares f(x - j)^2 over j at x = i / 2^level, 0 <= i <= 2^level. f is the basic limit function, or
/// the unit pulse after `level` refinements; j runs over all integers, or from -(n + beyond) to n + beyond, or one
/// more.
struct SampledVariance {
  bool refined_pulse = false;
  int level = 0;
  struct Window {
    int beyond;
    bool one_more;
  };
  std::optional<Window> window;
};

/// A sampled curve, its maximum, and its largest divided difference: of neighbours, or of points two steps apart.
struct NumericalRecipe {
  SampledVariance curve;
  bool two_steps = false;

  /// In words; the divided difference only where `slope`.
  std::string text(bool slope = true) const;
};

/// All that are tried, the simple ones first: 264.
const std::vector<NumericalRecipe>& numerical_recipes();

struct RecipeValues {
  Rational maximum;
  Rational slope;
};

/// What numerical_recipes() give, in that order, exact. Domain: a binary convergent scheme on 2n data, n >= 1.
/// Cost: for n = 7 some tenths of a second. Errors: as limit_values.
std::vector<RecipeValues> evaluate_numerical_recipes(const Mask& mask, int n);

/// One of them alone.
RecipeValues evaluate_numerical_recipe(const NumericalRecipe& recipe, const Mask& mask, int n);

/// Whether the value, rounded to nearest or cut, is printed like this. Domain: `printed` is a decimal number.
bool gives_digits(const Rational& value, const std::string& printed);

class NumericalRecipeSearch {
 public:
  /// What all recipes give, by scheme.
  using Values = std::map<std::string, std::vector<RecipeValues>>;

  /// Domain: Table 3, and evaluate_numerical_recipes() of each of its schemes.
  NumericalRecipeSearch(const PublishedTable& table, Values values);

  /// The index of the recipe that gives the digits of the most cells; of several the first.
  std::size_t best() const { return best_; }
  std::size_t cells_given() const { return cells_given_; }
  std::size_t cells() const { return table_.cells.size(); }

  Rational value(const PublishedCell& cell, std::size_t recipe) const;
  bool gives(const PublishedCell& cell, std::size_t recipe) const;

  /// For a cell whose printed value is wrong: the best recipe where it gives the digits, else the first other one
  /// that does, else that none tried does.
  std::string note(const PublishedCell& cell) const;

  /// How far one recipe explains the table, in sentences.
  std::string summary() const;

 private:
  const PublishedTable& table_;
  Values values_;
  std::size_t best_ = 0;
  std::size_t cells_given_ = 0;
};

}  // namespace subcert::statements::dyn_2015
