#pragma once
/// A quadratic form for each context, the last letters that were read, in floating point. Inner header. Nothing of it
/// is proved.

#include "ellipsoidal_coordinates.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>

namespace subcert::quadratic {

/// A letter that leads from the coordinates of one state to those of another one, which an element of the group moves:
/// x' = to[to] element x.
struct Step {
  std::size_t from = 0, to = 0;
  int element = 0;
  polytope::Matrix matrix;  ///< of the letter; its image is in the coordinates of `from`
};

/// Coordinates for the states of a reader of words.
struct StateForms {
  std::vector<polytope::Matrix> to, from;  ///< of each state: x' = to x, x = from x'; the form is to^T to
  std::vector<Step> steps;                 ///< of each state with each letter, in this order
  std::vector<std::vector<Step>> ends;     ///< where words may end that come to another state by these steps
  double bound = 0;                        ///< no step has a larger norm, nor is the joint spectral radius larger
  std::vector<int> product;                ///< from left to right, round which the last states are, if there is one

  std::size_t states() const { return to.size(); }
  std::size_t first_of_product() const { return states() - product.size(); }
};

/// Forms of contexts of growing length; of several states a group other than the flip is not made use of. Ref:
/// [AJPR14], de Bruijn graphs.
class ContextForms {
 public:
  /// Of no letters, one state. Domain: coordinates of the family.
  ContextForms(const polytope::SearchFamily& family, EllipsoidalCoordinates for_letters);

  /// Longer contexts, by one letter mostly; several states. Of those that the flip exchanges there is one. False where
  /// there would be too many, or the time seems too short. Minimises the largest norm g of all steps B by L-BFGS for t
  /// log g^2 - sum log det (1 - B^T B/g^2) with growing t, which is geodesically convex in the forms. Cost: some
  /// thousand inverses for each step.
  bool grow(const Budget& budget);

  const StateForms& forms() const { return forms_; }

  /// The same with a state for each letter of a product whose radius is the joint spectral radius, perhaps: words that
  /// have followed the product long enough end there. Its form is c^2 u u^T + W, u the left leading eigenvector, c the
  /// largest norm of the orbits of the right one, W contracted along the product: so the product keeps it, where forms
  /// of contexts of any length lose a little with each letter. Nothing unless the leading eigenvalue is simple, or one
  /// of a pair, nor where the memory or the time is too short. Domain: letters from left to right. Cost: that of a few
  /// hundred products of matrices for each letter.
  std::optional<StateForms> with_cycle(const std::vector<int>& product, const Budget& budget) const;

 private:
  /// The state of a context, and the element that moves it there.
  std::pair<std::size_t, int> state_of(const std::vector<int>& context) const;
  /// The context itself where it is that of a state.
  std::vector<int> least_image(const std::vector<int>& context) const;
  /// Forms of contexts of one letter more, as they are for shorter ones.
  StateForms lengthen();
  void add_steps(StateForms& forms, std::size_t state, const std::vector<int>& context) const;

  polytope::SearchFamily family_;
  EllipsoidalCoordinates for_letters_;
  StateForms forms_;
  std::vector<std::vector<int>> contexts_;  // of the states, in order
  double seconds_ = 0;                      // that the last growth took
};

}  // namespace subcert::quadratic
