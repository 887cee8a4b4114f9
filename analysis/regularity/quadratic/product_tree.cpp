#include "product_tree.hpp"

#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>

#include <cmath>
#include <queue>

namespace subcert::quadratic {
namespace {

using polytope::Matrix;

constexpr int longest = 1000;  // letters of a word

double spectral_norm(const Matrix& m) {
  return std::sqrt(std::max(0.0, polytope::symmetric_eigenvalues(polytope::fast_product(m.transposed(), m)).back()));
}

class Tree {
 public:
  Tree(const StateForms& forms, const polytope::SymmetryGroup& symmetry, double limbs_per_letter)
      : steps_(forms.steps),
        endings_(forms.endings),
        states_(forms.states()),
        letters_(steps_.size() / states_),
        scale_(forms.bound),
        symmetry_(symmetry),
        limbs_(limbs_per_letter) {
    const std::size_t n = forms.to.front().rows();
    for (Step& step : steps_) step.matrix /= scale_;
    std::vector<int> keepers;  // of a context: but the identity none that is known
    for (int g = 0; g < (states_ == 1 ? symmetry.order() : 1); ++g) keepers.push_back(g);
    for (std::size_t state = 0; state < states_; ++state)
      nodes_.push_back(
          {-1, -1, 0, state, 0, std::numeric_limits<double>::infinity(), keepers, Matrix::identity(n), {}});
    for (std::size_t state = 0; state < states_; ++state) split(state);
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
    for (std::size_t state = 0; state < states_; ++state) {
      TreeWord word{state, 0, 0, {}};
      collect(state, result, word);
    }
    return result;
  }

 private:
  struct Node {
    int parent, letter, length;
    std::size_t state;  // that it has come to, moved by the element
    int element;
    double bound;              // the least averaged norm of the products of its beginnings
    std::vector<int> keepers;  // elements of the symmetry that leave the word as it is
    Matrix product;            // of a leaf
    std::vector<std::size_t> children;
    double own = 0;       // averaged norm, in the state of its end
    std::size_t end = 0;  // that state, moved by an element
    int end_element = 0;
  };

  void split(std::size_t at) {
    const Matrix product = std::move(nodes_[at].product);
    nodes_[at].product = {};
    for (int letter = 0; letter < static_cast<int>(letters_); ++letter) {
      // Of letters that the elements exchange which keep the word so far, the least.
      std::vector<int> keepers;
      bool least = true;
      for (const int g : nodes_[at].keepers) {
        const int image = symmetry_.letter(g, letter, letters_);
        least = least && image >= letter;
        if (image == letter) keepers.push_back(g);
      }
      if (!least) continue;
      // What the moved state reads as this letter.
      const Node& node = nodes_[at];
      const Step& step =
          steps_[node.state * letters_ + static_cast<std::size_t>(symmetry_.letter(node.element, letter, letters_))];
      Node child{static_cast<int>(at),
                 letter,
                 node.length + 1,
                 step.to,
                 node.element ^ step.element,  // of the flip
                 0,
                 std::move(keepers),
                 polytope::fast_product(product, step.matrix),
                 {}};
      set_end(child);
      child.bound = std::min(child.own, nodes_[at].bound);
      nodes_[at].children.push_back(nodes_.size());
      open_.emplace(child.bound, nodes_.size());
      work_ += work_of(child.length);
      nodes_.push_back(std::move(child));
    }
  }

  /// Where the word has its least norm.
  void set_end(Node& node) const {
    node.end = node.state;
    node.end_element = node.element;
    double least = spectral_norm(node.product);
    for (const Ending& ending : endings_[node.state]) {
      const double norm = spectral_norm(polytope::fast_product(node.product, ending.matrix));
      if (norm >= least) continue;
      least = norm;
      node.end = ending.to;
      node.end_element = node.element ^ ending.element;
    }
    node.own = scale_ * std::pow(least, 1.0 / node.length);
  }

  void collect(std::size_t at, ProductTree& result, TreeWord& word) const {
    const Node& node = nodes_[at];
    if (node.length > 0 && node.own <= result.bound) {
      result.words.push_back(word);
      result.words.back().to = node.end;
      result.words.back().element = node.end_element;
      return;
    }
    for (const std::size_t child : node.children) {
      word.letters.push_back(nodes_[child].letter);
      collect(child, result, word);
      word.letters.pop_back();
    }
  }

  std::size_t entries() const { return steps_.front().matrix.entries().size(); }
  /// Of the product and A^T P A, where P has two limbs; and what does not depend on the size.
  double work_of(int length) const {
    const double limbs = 1 + limbs_ * length;
    return 3e4 + 300.0 * length +
           std::pow(static_cast<double>(entries()), 1.5) * (60 + 3 * limbs + limbs * (limbs + 2));
  }

  std::vector<Step> steps_;  // divided by the scale
  std::vector<std::vector<Ending>> endings_;
  std::size_t states_, letters_;
  double scale_;
  const polytope::SymmetryGroup& symmetry_;
  double limbs_;
  std::vector<Node> nodes_;
  double work_ = 0;
  std::priority_queue<std::pair<double, std::size_t>> open_;
};

}  // namespace

ProductTree product_tree(const StateForms& forms, const polytope::SymmetryGroup& symmetry, const TreeLimits& limits) {
  Tree tree(forms, symmetry, limits.limbs_per_letter);
  while (tree.bound() > limits.target && tree.work() < limits.work && tree.leaves() < limits.leaves &&
         tree.bytes() < limits.budget.memory && !limits.budget.deadline.expired() && tree.grow()) {
  }
  return tree.cut();
}

}  // namespace subcert::quadratic
