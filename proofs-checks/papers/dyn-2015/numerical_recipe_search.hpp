#pragma once
/// Which recipe gives the digits that Table 3 of [DHHS15] prints: a search over all of numerical_recipes().

#include "numerical_recipe.hpp"

#include <subcert/proofs-checks/statements/published_table.hpp>

#include <map>

namespace subcert::statements::dyn_2015 {

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
