
#include "product_tree.hpp"

#include "ellipsoidal_coordinates.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <map>
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

namespace {

using polytope::Matrix;

constexpr std::size_t contexts[] = {256, 1024, 4096};  // of last letters, for a look each
constexpr std::size_t images_per_context = 4;          // that go on
constexpr std::size_t path_length = 600, starts = 100, longest_run = 400;
constexpr std::ptrdiff_t longest_product = 200;
constexpr double near = 2e-3;     // products so far below the best are reported
constexpr double better = 1e-9;   // relatively, for a wider look
constexpr double hopeless = 0.1;  // the norm of a product over the power of the best radius: the word is left there
constexpr double least_radius = 0.7071;  // that is estimated of a product, likewise

/// Images of one vector by words of growing length.
class Beam {
 public:
  /// The longest images in each of that many contexts, or of as many as the memory holds.
  Beam(const std::vector<Matrix>& matrices, std::size_t most_contexts, std::size_t memory)
      : matrices_(matrices), directions_(matrices.front().rows(), 1), log_lengths_{0}, context_of_{0} {
    const std::size_t size = matrices.front().rows(), letters = matrices.size();
    const std::size_t bytes = path_length * sizeof(std::uint32_t) + (letters + 1) * size * sizeof(double);
    most_images_ = std::max<std::size_t>(memory / bytes, 1);
    most_contexts = std::min(most_contexts, most_images_ / images_per_context);
    for (contexts_ = letters; letters > 1 && contexts_ * letters <= most_contexts;) contexts_ *= letters;
    for (std::size_t i = 0; i < size; ++i) directions_(i, 0) = std::cos(static_cast<double>(i * i + 1));
  }

  /// The letters on the way to the longest image, the letter applied first first. Fewer past the deadline or where all
  /// images are 0.
  std::vector<int> longest_path(const Deadline& deadline) {
    while (origins_.size() < path_length && !deadline.expired() && advance()) {
    }
    std::vector<int> path(origins_.size());
    std::size_t image = 0;
    for (std::size_t k = path.size(); k-- > 0; image = origins_[k][image] / matrices_.size())
      path[k] = static_cast<int>(origins_[k][image] % matrices_.size());
    return path;
  }

 private:
  /// By one letter; the longest image comes first. False where all are 0.
  bool advance() {
    const std::size_t letters = matrices_.size(), size = directions_.rows(), count = directions_.columns();
    std::vector<Matrix> images;
    for (const Matrix& m : matrices_) images.push_back(polytope::fast_product(m, directions_));
    std::vector<double> lengths, logarithms;  // of image and letter, in the order of `origins_`
    std::vector<std::uint32_t> order;
    for (std::size_t k = 0; k < count * letters; ++k) {
      lengths.push_back(polytope::norm({images[k % letters].column(k / letters), size}));
      logarithms.push_back(log_lengths_[k / letters] + std::log(lengths.back()));
      if (lengths.back() > 0) order.push_back(static_cast<std::uint32_t>(k));
    }
    std::ranges::sort(order, std::ranges::greater{}, [&](std::uint32_t k) { return logarithms[k]; });
    std::vector<std::size_t> held(contexts_), context_of;
    std::erase_if(order, [&](std::uint32_t k) {
      const std::size_t context = (context_of_[k / letters] * letters + k % letters) % contexts_;
      if (++held[context] > images_per_context || context_of.size() == most_images_) return true;
      context_of.push_back(context);
      return false;
    });
    if (order.empty()) return false;
    directions_ = Matrix(size, order.size());
    log_lengths_.clear();
    for (std::size_t j = 0; j < order.size(); ++j) {
      const std::uint32_t k = order[j];
      for (std::size_t i = 0; i < size; ++i) directions_(i, j) = images[k % letters](i, k / letters) / lengths[k];
      log_lengths_.push_back(logarithms[k]);
    }
    context_of_ = std::move(context_of);
    origins_.push_back(std::move(order));
    return true;
  }

  const std::vector<Matrix>& matrices_;
  std::size_t most_images_ = 1, contexts_ = 1;
  Matrix directions_;
  std::vector<double> log_lengths_;
  std::vector<std::size_t> context_of_;              // a number whose digits are the last letters
  std::vector<std::vector<std::uint32_t>> origins_;  // of each image after each letter: image before, letters + letter
};

/// Products of parts of words.
class Cycles {
 public:
  Cycles(const polytope::SearchFamily& family, const std::vector<Matrix>& matrices, double radius)
      : family_(family), matrices_(matrices), best_(radius) {}

  void look_into(const std::vector<int>& word, const Deadline& deadline) {
    // What comes first and last in a word is on its way to its cycle or from it.
    const std::size_t first = word.size() / 8, part = word.size() / 2;
    for (std::size_t start = 0; start < std::min(starts, part) && !deadline.expired(); ++start) {
      const auto begin = word.begin() + static_cast<std::ptrdiff_t>(first + start * part / starts);
      try_beginnings({begin, begin + std::min(longest_product, word.end() - begin)});
    }
  }

  /// Of a letter that is followed by another one again and again.
  void look_at_runs(const Deadline& deadline) {
    const int letters = static_cast<int>(matrices_.size());
    for (int once = 0; once < letters; ++once)
      for (int again = 0; again < letters && !deadline.expired(); ++again) {
        if (again == once) continue;
        std::vector<int> word(longest_run, again);
        word.front() = once;
        try_beginnings(word);
      }
  }

  /// The largest radius so far.
  double best() {
    for (const auto& [word, radius] : known_) best_ = std::max(best_, radius);
    return best_;
  }
  std::vector<polytope::Candidate> near_best() {
    const double least = best() * (1 - near);
    std::vector<polytope::Candidate> result;
    for (const auto& [word, radius] : known_)
      if (radius >= least) result.push_back({word, radius});
    polytope::sort_candidates(result);
    return result;
  }

 private:
  void try_beginnings(const std::vector<int>& word) {
    Matrix product = Matrix::identity(matrices_.front().rows());
    std::vector<int> letters;
    for (const int letter : word) {
      letters.push_back(letter);
      product = polytope::fast_product(matrices_[static_cast<std::size_t>(letter)], product);
      product /= best_;
      if (polytope::norm(product.entries()) < hopeless) return;
      const auto length = static_cast<double>(letters.size());
      if (polytope::estimated_radius(product) < std::max(least_radius, std::pow(1 - near, length))) continue;
      auto canonical = polytope::canonical_word(letters, family_.matrices.size(), family_.symmetry);
      if (known_.contains(canonical)) continue;
      known_.emplace(std::move(canonical), best_ * std::pow(polytope::spectral_radius(product), 1 / length));
    }
  }

  const polytope::SearchFamily& family_;
  const std::vector<Matrix>& matrices_;
  double best_;
  std::map<std::vector<int>, double> known_;
};

}  // namespace

std::vector<polytope::Candidate> long_products(const polytope::SearchFamily& family, double radius,
                                               const Budget& budget) {
  const std::vector<Matrix> matrices =
      ellipsoidal_coordinates(family, radius, budget.deadline.after(schedule::products::coordinates)).matrices;
  Cycles cycles(family, matrices, radius);
  cycles.look_at_runs(budget.deadline.after(schedule::products::runs));
  for (const std::size_t count : contexts) {
    const double before = cycles.best();
    cycles.look_into(Beam(matrices, count, budget.memory).longest_path(budget.deadline), budget.deadline);
    if (cycles.best() <= before * (1 + better) && count > contexts[0]) break;
  }
  return cycles.near_best();
}

}  // namespace subcert::quadratic
