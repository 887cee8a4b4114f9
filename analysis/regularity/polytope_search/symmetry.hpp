#pragma once
/// Finite groups that permute the matrices of a family. This is the one place that knows which groups there are and
/// how their elements act; whoever uses them runs over 0, ..., order() - 1, 0 being the identity.

#include "dense.hpp"

#include "polytope_kind.hpp"

#include <algorithm>

namespace subcert::polytope {

/// How the elements of a symmetry act on vectors of one size: on those of the family, or in working coordinates, in
/// which the reversal of the coordinates has become a change of sign of the trailing ones.
class GroupAction {
 public:
  /// Of the trivial group.
  explicit GroupAction(std::size_t dimension) : dimension_(dimension) {}
  /// Of the flip as the reversal of all coordinates.
  static GroupAction reversal(std::size_t dimension) { return {dimension, 2, 0}; }
  /// Of the flip in coordinates of which the last `odd` change their sign.
  static GroupAction sign_change(std::size_t dimension, std::size_t odd) { return {dimension, 2, odd, false}; }

  int order() const { return order_; }
  std::size_t dimension() const { return dimension_; }
  /// Coordinates that the flip negates; 0 where it reverses them.
  std::size_t odd() const { return odd_; }
  /// The element that acts like `second` after `first`.
  int composed(int first, int second) const { return first ^ second; }

  /// x becomes its image. Domain: 0 <= element < order(); dimension() numbers from x on.
  template <class Number>
  void apply(int element, Number* x) const {
    if (element == 0) return;
    if (reverses_) return std::reverse(x, x + dimension_);
    for (std::size_t k = dimension_ - odd_; k < dimension_; ++k) x[k] = -x[k];
  }

 private:
  GroupAction(std::size_t dimension, int order, std::size_t odd, bool reverses = true)
      : dimension_(dimension), order_(order), odd_(odd), reverses_(reverses) {}
  std::size_t dimension_;
  int order_ = 1;
  std::size_t odd_ = 0;
  bool reverses_ = false;
};

/// A group G with g A_i g^-1 = A_{g(i)} for every matrix A_i of a family: images of vertices come for free.
class SymmetryGroup {
 public:
  /// The trivial group.
  SymmetryGroup() = default;
  /// The identity and the flip J, the reversal of the coordinates: J A_i J = A_{m-1-i} for m matrices.
  static SymmetryGroup flip() {
    SymmetryGroup result;
    result.order_ = 2;
    return result;
  }

  int order() const { return order_; }
  /// g(letter).
  int letter(int element, int letter, std::size_t letter_count) const {
    return element == 0 ? letter : static_cast<int>(letter_count) - 1 - letter;
  }
  /// g(w_1) ... g(w_k).
  std::vector<int> word(int element, std::vector<int> word, std::size_t letter_count) const {
    for (int& l : word) l = letter(element, l, letter_count);
    return word;
  }
  /// On vectors in the coordinates of the family.
  GroupAction action(std::size_t dimension) const {
    return order_ == 1 ? GroupAction(dimension) : GroupAction::reversal(dimension);
  }
  /// g M g^-1.
  Matrix conjugated(int element, const Matrix& matrix) const;

  /// An orthogonal matrix q, x' = q x, in whose coordinates the elements are diagonal, those of equal signs together:
  /// symmetric matrices that commute with the group fall apart into diagonal blocks of the sizes `blocks`.
  Matrix adapted_coordinates(std::size_t dimension) const;
  std::vector<std::size_t> blocks(std::size_t dimension) const;
  /// On vectors in adapted coordinates.
  GroupAction adapted_action(std::size_t dimension) const {
    return order_ == 1 ? GroupAction(dimension) : GroupAction::sign_change(dimension, dimension / 2);
  }

 private:
  int order_ = 1;
};

}  // namespace subcert::polytope
