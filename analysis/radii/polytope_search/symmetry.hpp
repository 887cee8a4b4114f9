#pragma once
/// Finite groups that permute the matrices of a family. This is the one place that knows which groups there are and
/// how their elements act; whoever uses them runs over 0, ..., order() - 1, 0 being the identity.

#include "dense.hpp"

#include "polytope_kind.hpp"

#include <algorithm>
#include <memory>

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
  /// By matrices, that of the identity first.
  static GroupAction dense(std::vector<Matrix> matrices) {
    GroupAction result(matrices.front().rows());
    result.order_ = static_cast<int>(matrices.size());
    result.matrices_ = std::make_shared<const std::vector<Matrix>>(std::move(matrices));
    return result;
  }

  int order() const { return order_; }
  std::size_t dimension() const { return dimension_; }
  /// Whether it acts by matrices.
  bool is_dense() const { return matrices_ != nullptr; }
  /// Coordinates that the flip negates; 0 where it reverses them.
  std::size_t odd() const { return odd_; }
  /// The element of the flip that acts like `second` after `first`.
  int composed(int first, int second) const { return first ^ second; }

  /// x becomes its image. Domain: 0 <= element < order(); dimension() numbers from x on.
  template <class Number>
  void apply(int element, Number* x) const {
    if (element == 0) return;
    if (is_dense()) {
      const Matrix& matrix = (*matrices_)[static_cast<std::size_t>(element)];
      std::vector<Number> image(dimension_, Number(0));
      for (std::size_t j = 0; j < dimension_; ++j)
        for (std::size_t i = 0; i < dimension_; ++i) image[i] += matrix(i, j) * x[j];
      std::copy(image.begin(), image.end(), x);
      return;
    }
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
  std::shared_ptr<const std::vector<Matrix>> matrices_;
};

/// x' = to x and back.
struct CoordinateChange {
  Matrix to, from;
};

/// A group G with g A_i g^-1 = A_{g(i)} for every matrix A_i of a family: images of vertices come for free. Polytopes
/// are symmetric about 0, so that elements that differ by their sign count as one.
class SymmetryGroup {
 public:
  /// An element other than the flip.
  struct Element {
    Matrix map, inverse;
    std::vector<int> letters;
  };

  /// The trivial group.
  SymmetryGroup() = default;
  /// The identity and the flip J, the reversal of the coordinates: J A_i J = A_letters[i]; without letters A_{m-1-i}
  /// for m matrices.
  static SymmetryGroup flip(std::vector<int> letters = {}) {
    SymmetryGroup result;
    result.order_ = 2;
    result.flipped_ = std::move(letters);
    return result;
  }
  /// Domain: the identity first; a finite group up to signs.
  explicit SymmetryGroup(std::vector<Element> elements)
      : order_(static_cast<int>(elements.size())), elements_(std::move(elements)) {}

  /// For the transposed matrices: by g^-T.
  SymmetryGroup transposed() const;

  int order() const { return order_; }
  /// Whether its elements are other maps than the flip. They need not keep the cone of non-negative vectors.
  bool is_dense() const { return !elements_.empty(); }
  /// g(letter).
  int letter(int element, int letter, std::size_t letter_count) const {
    if (is_dense()) return at(element).letters[static_cast<std::size_t>(letter)];
    if (element == 0) return letter;
    return flipped_.empty() ? static_cast<int>(letter_count) - 1 - letter : flipped_[static_cast<std::size_t>(letter)];
  }
  /// g(w_1) ... g(w_k).
  std::vector<int> word(int element, std::vector<int> word, std::size_t letter_count) const {
    for (int& l : word) l = letter(element, l, letter_count);
    return word;
  }
  /// On vectors in the coordinates of the family.
  GroupAction action(std::size_t dimension) const;
  /// By what rounding grows in g M g^-1, about.
  double condition(int element) const;
  /// g M g^-1.
  Matrix conjugated(int element, const Matrix& matrix) const;

  /// Coordinates in which the elements are orthogonal; those of the flip are diagonal then, with equal signs together:
  /// symmetric matrices that commute with the group fall apart into diagonal blocks of the sizes `blocks`.
  CoordinateChange adapted_coordinates(std::size_t dimension) const;
  std::vector<std::size_t> blocks(std::size_t dimension) const;
  /// The mean of g M g^T over the group. Domain: adapted coordinates, a matrix that nearly commutes with the group.
  Matrix mean(const Matrix& matrix, const CoordinateChange& adapted) const;
  /// On vectors in coordinates that differ from the adapted ones by a matrix that commutes with the group.
  GroupAction action_in(const CoordinateChange& coordinates) const;

 private:
  const Element& at(int element) const { return elements_[static_cast<std::size_t>(element)]; }

  int order_ = 1;
  std::vector<Element> elements_;  // none for the trivial group and the flip
  std::vector<int> flipped_;       // the letters of the flip
};

}  // namespace subcert::polytope
