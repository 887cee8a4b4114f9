#include "product_tree.hpp"

#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>

#include <cmath>
#include <queue>

namespace subcert::quadratic {
namespace {

using polytope::Matrix;

constexpr int longest = 1000;  // letters of a word

double spectral_norm(const Matrix& m) {
  return std::sqrt(std::max(0.0, polytope::symmetric_eigenvalues(m.transposed() * m).back()));
}

class Tree {
 public:
  Tree(const EllipsoidalCoordinates& coordinates, const polytope::SymmetryGroup& symmetry, double limbs_per_letter)
      : matrices_(coordinates.matrices), scale_(coordinates.bound), symmetry_(symmetry), limbs_(limbs_per_letter) {
    const std::size_t n = coordinates.to.rows();
    for (Matrix& m : matrices_) m /= scale_;
    std::vector<int> all;
    for (int g = 0; g < symmetry.order(); ++g) all.push_back(g);
    nodes_.push_back({-1, -1, 0, std::numeric_limits<double>::infinity(), std::move(all), Matrix::identity(n), {}});
    split(0);
  }

  double bound() const { return nodes_[open_.top().second].bound; }
  /// Of an exact proof of the leaves.
  double work() const { return work_; }
  std::size_t leaves() const { return open_.size(); }
  std::size_t bytes() const { return nodes_.size() * sizeof(Node) + open_.size() * sizeof(double) * entries(); }

  /// Splits the worst leaf; false where its word would be too long.
  bool grow() {
    const std::size_t worst = open_.top().second;
    if (nodes_[worst].length >= longest) return false;
    open_.pop();
    work_ -= work_of(nodes_[worst].length);
    split(worst);
    return true;
  }

  /// The first nodes of each branch whose own norm is small enough.
  ProductTree cut() const {
    ProductTree result{{}, bound()};
    std::vector<int> word;
    collect(0, result, word);
    return result;
  }

 private:
  struct Node {
    int parent, letter, length;
    double bound;              // the least averaged norm of the products of its beginnings
    std::vector<int> keepers;  // elements of the symmetry that leave the word as it is
    Matrix product;            // of a leaf
    std::vector<std::size_t> children;
    double own = 0;  // averaged norm
  };

  void split(std::size_t at) {
    const Matrix product = std::move(nodes_[at].product);
    nodes_[at].product = {};
    for (int letter = 0; letter < static_cast<int>(matrices_.size()); ++letter) {
      // Of letters that the elements exchange which keep the word so far, the least.
      std::vector<int> keepers;
      bool least = true;
      for (const int g : nodes_[at].keepers) {
        const int image = symmetry_.letter(g, letter, matrices_.size());
        least = least && image >= letter;
        if (image == letter) keepers.push_back(g);
      }
      if (!least) continue;
      Node child{static_cast<int>(at),
                 letter,
                 nodes_[at].length + 1,
                 0,
                 std::move(keepers),
                 product * matrices_[static_cast<std::size_t>(letter)],
                 {}};
      child.own = scale_ * std::pow(spectral_norm(child.product), 1.0 / child.length);
      child.bound = std::min(child.own, nodes_[at].bound);
      nodes_[at].children.push_back(nodes_.size());
      open_.emplace(child.bound, nodes_.size());
      work_ += work_of(child.length);
      nodes_.push_back(std::move(child));
    }
  }

  void collect(std::size_t at, ProductTree& result, std::vector<int>& word) const {
    const Node& node = nodes_[at];
    if (at != 0 && node.own <= result.bound) {
      result.words.push_back(word);
      return;
    }
    for (const std::size_t child : node.children) {
      word.push_back(nodes_[child].letter);
      collect(child, result, word);
      word.pop_back();
    }
  }

  std::size_t entries() const { return matrices_.front().entries().size(); }
  /// Of the product and A^T P A, where P has two limbs; and what does not depend on the size.
  double work_of(int length) const {
    const double limbs = 1 + limbs_ * length;
    return 3e4 + 300.0 * length +
           std::pow(static_cast<double>(entries()), 1.5) * (60 + 3 * limbs + limbs * (limbs + 2));
  }

  std::vector<Matrix> matrices_;  // of norms up to 1
  double scale_;
  const polytope::SymmetryGroup& symmetry_;
  double limbs_;
  std::vector<Node> nodes_;
  double work_ = 0;
  std::priority_queue<std::pair<double, std::size_t>> open_;
};

}  // namespace

ProductTree product_tree(const EllipsoidalCoordinates& coordinates, const polytope::SymmetryGroup& symmetry,
                         const TreeLimits& limits) {
  Tree tree(coordinates, symmetry, limits.limbs_per_letter);
  while (tree.bound() > limits.target && tree.work() < limits.work && tree.leaves() < limits.leaves &&
         tree.bytes() < limits.budget.memory && !limits.budget.deadline.expired() && tree.grow()) {
  }
  return tree.cut();
}

}  // namespace subcert::quadratic
