#include "product_tree.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/symbol/parallel.hpp>

#include <atomic>
#include <cmath>
#include <string_view>

namespace subcert::quadratic {
namespace {

using polytope::fast_product;
using polytope::Matrix;

constexpr std::size_t longest = 1000;  // letters of a word
constexpr double most_growth = 3;      // of the norms of its steps, multiplied
constexpr double node_work = 3000;     // besides multiplications of matrices
constexpr std::string_view end_characters = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";

class Tree {
 public:
  /// Fails past the deadline.
  Tree(const StateForms& forms, double bound, const TreeLimits& limits)
      : steps_(forms.steps), ends_(forms.ends), letters_(steps_.size() / forms.states()), limits_(limits) {
    if (limits.keep) {
      kept_.assign(forms.first_of_product(), -1);
      kept_.insert(kept_.end(), forms.product.begin(), forms.product.end());
    }
    for (Step& step : steps_) {
      if ((failed_ = limits_.deadline.expired())) return;
      step.matrix /= bound;
      norms_.push_back(polytope::spectral_norm(step.matrix));
    }
    for (std::vector<Step>& ends : ends_) {
      if (ends.size() >= end_characters.size()) ends.resize(end_characters.size() - 1);
      for (Step& step : ends) step.matrix /= bound;
    }
    const auto size = static_cast<double>(forms.to.front().rows());
    product_work_ = std::pow(size, 3);
  }

  /// False where a limit is reached.
  bool follow(std::size_t state, const Matrix& product, double growth, std::size_t length, std::string& ends) {
    if (length >= longest || growth > most_growth || failed_ || limits_.deadline.expired()) return !(failed_ = true);
    for (std::size_t letter = 0; letter < letters_; ++letter) {
      if (length == 0 && !kept_.empty() && kept_[state] == static_cast<int>(letter)) {
        ends += kept_character;
        continue;
      }
      const std::size_t on = state * letters_ + letter;
      const Matrix next = fast_product(product, steps_[on].matrix);
      std::size_t end = 0;
      bool is_end = is_contraction(next);
      for (; !is_end && end < ends_[on].size(); ++end)
        is_end = is_contraction(fast_product(product, ends_[on][end].matrix));
      ends += is_end ? end_character(end) : '+';
      if (!is_end && !follow(steps_[on].to, next, growth * norms_[on], length + 1, ends)) return false;
      // A contraction is a third of a decomposition and half a product.
      if ((work_ += (is_end ? 5.0 / 3 : 1) * product_work_ + node_work) > limits_.work) return !(failed_ = true);
    }
    return true;
  }

  double work() const { return work_; }

 private:
  std::vector<Step> steps_;  // divided by the bound
  std::vector<double> norms_;
  std::vector<std::vector<Step>> ends_;
  std::size_t letters_;
  TreeLimits limits_;
  std::vector<int> kept_;  // the letters, of each state
  double product_work_ = 0;
  std::atomic<double> work_ = 0;
  std::atomic<bool> failed_ = false;
};

}  // namespace

bool is_contraction(const Matrix& m) {
  const std::size_t n = m.rows();
  Matrix rest = fast_product(m.transposed(), m);
  rest /= -1;
  for (std::size_t k = 0; k < n; ++k) rest(k, k) += 1;
  for (std::size_t k = 0; k < n; ++k) {
    double* column = &rest(0, k);
    if (!(column[k] > 0)) return false;
    const double pivot = std::sqrt(column[k]);
    for (std::size_t i = k; i < n; ++i) column[i] /= pivot;
    for (std::size_t j = k + 1; j < n; ++j) {
      double* other = &rest(0, j);
      const double factor = column[j];
      for (std::size_t i = j; i < n; ++i) other[i] -= column[i] * factor;
    }
  }
  return true;
}

char end_character(std::size_t k) { return end_characters.at(k); }

std::size_t end_number(char character) { return end_characters.find(character); }

std::optional<ProductTree> product_tree(const StateForms& forms, double bound, const TreeLimits& limits) {
  Tree tree(forms, bound, limits);
  ProductTree result{std::vector<std::string>(forms.states()), bound, 0};
  const Matrix identity = Matrix::identity(forms.to.front().rows());
  std::atomic<bool> complete = true;
  parallel_for_each(forms.states(), all_cores(), [&](std::size_t state) {
    if (complete && !tree.follow(state, identity, 1, 0, result.ends[state])) complete = false;
  });
  if (!complete) return std::nullopt;
  result.work = tree.work();
  return result;
}

}  // namespace subcert::quadratic
