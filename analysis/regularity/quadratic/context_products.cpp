#include "context_products.hpp"

#include "product_tree.hpp"

#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace subcert::quadratic {
namespace {

using polytope::Matrix;

constexpr double contexts_share = 0.5;                   // of the time
constexpr double excesses[] = {3e-3, 1e-3, 3e-4, 1e-4};  // over the radius, of words that are followed
constexpr long most_words = 400000;                      // that are looked at for one excess
constexpr std::size_t longest = 400;                     // letters of such a word
constexpr std::size_t kept = 6;                          // words that cycles are sought in
constexpr std::size_t longest_cycle = 150, cycle_starts = 150;
constexpr double better = 1e-9;  // relatively, for another look
constexpr double near = 2e-3;    // products so far below the best are reported

/// Follows words depth first, from every state, as long as they are no contractions.
class Words {
 public:
  Words(const StateForms& forms, const polytope::SymmetryGroup& symmetry)
      : forms_(forms), symmetry_(symmetry), letters_(forms.steps.size() / forms.states()) {}

  /// The longest ones, for norms that are divided by bound^letters; and whether all were followed to their ends.
  std::pair<std::vector<std::vector<int>>, bool> longest_words(double bound, const Deadline& deadline) {
    bound_ = bound;
    left_ = most_words;
    found_.clear();
    std::vector<int> word;
    for (std::size_t state = 0; state < forms_.states(); ++state)
      follow(Matrix::identity(forms_.to.front().rows()), state, 0, word, deadline);
    return {found_, left_ > 0};
  }

 private:
  void follow(const Matrix& product, std::size_t state, int element, std::vector<int>& word, const Deadline& deadline) {
    for (std::size_t read = 0; read < letters_; ++read) {
      if (--left_ <= 0 || deadline.expired()) {
        left_ = 0;
        return;
      }
      const Step& step = forms_.steps[state * letters_ + read];
      Matrix next = polytope::fast_product(product, step.matrix);
      next /= bound_;
      if (is_contraction(next)) continue;
      word.push_back(symmetry_.letter(element, static_cast<int>(read), letters_));
      if (word.size() < longest) follow(next, step.to, element ^ step.element, word, deadline);
      remember(word);
      word.pop_back();
    }
  }

  void remember(const std::vector<int>& word) {
    if (found_.size() == kept && word.size() <= found_.back().size()) return;
    // The beginning of a word that is known says nothing new.
    for (const std::vector<int>& other : found_)
      if (word.size() <= other.size() && std::equal(word.begin(), word.end(), other.begin())) return;
    found_.push_back(word);
    std::ranges::stable_sort(found_, std::ranges::greater{}, &std::vector<int>::size);
    if (found_.size() > kept) found_.pop_back();
  }

  const StateForms& forms_;
  const polytope::SymmetryGroup& symmetry_;
  std::size_t letters_;
  double bound_ = 1;
  long left_ = 0;
  std::vector<std::vector<int>> found_;
};

/// Products of parts of words.
class Cycles {
 public:
  Cycles(const polytope::SearchFamily& family, const EllipsoidalCoordinates& for_letters, double radius)
      : family_(family), matrices_(for_letters.matrices), best_(radius) {}

  void look_into(const std::vector<int>& word, const Deadline& deadline) {
    // What comes first and last in a word is on its way to its cycle or from it.
    const std::size_t first = word.size() / 4, end = std::min(word.size(), first + cycle_starts);
    for (std::size_t begin = first; begin < end && !deadline.expired(); ++begin) {
      Matrix product = Matrix::identity(matrices_.front().rows());
      for (std::size_t k = begin; k < std::min(word.size(), begin + longest_cycle); ++k) {
        product = polytope::fast_product(product, matrices_[static_cast<std::size_t>(word[k])]);
        product /= best_;
        double trace = 0;
        for (std::size_t j = 0; j < product.columns(); ++j)
          for (std::size_t i = 0; i < product.rows(); ++i) trace += product(i, j) * product(j, i);
        const double length = static_cast<double>(k + 1 - begin);
        if (std::pow(std::abs(trace), 0.5 / length) < 1 - near) continue;
        // The letter that is applied first comes first in a candidate.
        std::vector<int> letters(word.begin() + static_cast<std::ptrdiff_t>(begin),
                                 word.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        std::ranges::reverse(letters);
        letters = polytope::canonical_word(std::move(letters), family_.matrices.size(), family_.symmetry);
        if (known_.contains(letters)) continue;
        known_.emplace(std::move(letters), best_ * std::pow(polytope::spectral_radius(product), 1 / length));
      }
    }
  }

  /// The largest radius so far.
  double best() {
    for (const auto& [word, radius] : known_) best_ = std::max(best_, radius);
    return best_;
  }
  std::vector<polytope::Candidate> near_best() {
    std::vector<polytope::Candidate> result;
    for (const auto& [word, radius] : known_)
      if (radius >= best() * (1 - near)) result.push_back({word, radius});
    return result;
  }

 private:
  const polytope::SearchFamily& family_;
  std::vector<Matrix> matrices_;
  double best_;
  std::map<std::vector<int>, double> known_;
};

}  // namespace

std::vector<polytope::Candidate> context_products(const polytope::SearchFamily& family, double radius,
                                                  const Budget& budget, std::optional<ContextForms>& contexts) {
  const Deadline &deadline = budget.deadline, contexts_end = deadline.after(contexts_share);
  const EllipsoidalCoordinates for_letters = ellipsoidal_coordinates(family, radius, contexts_end);
  contexts.emplace(family, for_letters);
  while (contexts->forms().bound > radius && contexts->grow({contexts_end, budget.memory})) {
  }
  Cycles cycles(family, for_letters, radius);
  Words words(contexts->forms(), contexts->symmetry());
  for (const double excess : excesses) {
    bool all = false;
    for (double before = 0; cycles.best() > before * (1 + better) && !deadline.expired();) {
      before = cycles.best();
      std::vector<std::vector<int>> found;
      std::tie(found, all) = words.longest_words(before * (1 + excess), deadline);
      for (const std::vector<int>& word : found) cycles.look_into(word, deadline);
    }
    if (!all || deadline.expired()) break;
  }
  return cycles.near_best();
}

}  // namespace subcert::quadratic
