#include "level_norms.hpp"

#include "difference.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace subcert {
namespace {

constexpr double unit = std::numeric_limits<double>::epsilon();  // twice the unit roundoff
constexpr double tiny = 1e-280;                                  // covers whatever underflow loses
constexpr std::size_t work_in_any_time = 200'000;                // of exact sums: so that more time never tells less

double round_up(const Rational& value) {
  const double nearest = value.convert_to<double>();
  return nearest + std::abs(nearest) * 2 * unit + tiny;
}

/// The symbols b(z) b(z^a) ... of the powers, read as a tree: the node for the residue r modulo a^k holds the vector
/// v_j = coefficient of z^(r + a^k j); its child for the digit t is T_t v. In floating point and, times the common
/// denominator at each step, in integers.
class PowerTree {
 public:
  explicit PowerTree(const Mask& mask)
      : palindromic_(symmetry(mask).kind != Symmetry::none),
        denominator_(mask.symbol().denominator()),
        rounded_(rounded(mask), mask.arity()),
        exact_(mask.symbol().numerators(), mask.arity()) {}

  int arity() const { return static_cast<int>(rounded_.window().arity); }
  long degree() const { return rounded_.window().degree; }
  std::size_t width() const { return rounded_.width(); }
  bool palindromic() const { return palindromic_; }
  const Integer& denominator() const { return denominator_; }

  void step(const std::vector<double>& parent, int t, std::vector<double>& child) const {
    rounded_.apply(t, parent.data(), child.data());
  }
  void step(const std::vector<Integer>& parent, int t, std::vector<Integer>& child) const {
    exact_.apply(t, parent.data(), child.data());
  }

 private:
  static std::vector<double> rounded(const Mask& mask) {
    std::vector<double> result;
    for (const Rational& c : mask.symbol().coefficients()) result.push_back(c.convert_to<double>());
    return result;
  }

  bool palindromic_;
  Integer denominator_;
  Transition<double> rounded_;
  Transition<Integer> exact_;
};

/// Exact sums of |coefficients| over cosets, with the prefixes common to successive ones kept.
class ExactSums {
 public:
  ExactSums(const PowerTree& tree, int levels)
      : tree_(tree), path_(static_cast<std::size_t>(levels) + 1, std::vector<Integer>(tree.width(), 0)) {
    path_.front().front() = 1;
  }

  /// Nothing once the deadline has passed, but for the first few: no later sum is right.
  std::optional<Rational> sum(const std::vector<int>& digits, const Deadline& deadline) {
    std::size_t common = 0;
    while (common < last_.size() && last_[common] == digits[common]) ++common;
    for (std::size_t k = common; k < digits.size(); ++k) {
      work_ += tree_.width() * tree_.width();
      if (work_ > work_in_any_time && deadline.expired()) return std::nullopt;
      tree_.step(path_[k], digits[k], path_[k + 1]);
    }
    last_ = digits;
    Integer total = 0;
    for (const Integer& c : path_[digits.size()]) total += abs(c);
    return Rational(total, pow(tree_.denominator(), static_cast<unsigned>(digits.size())));
  }

 private:
  const PowerTree& tree_;
  std::vector<std::vector<Integer>> path_;
  std::vector<int> last_;
  std::size_t work_ = 0;  // products of coefficients
};

/// The norm of one level: the largest sum over a coset modulo arity^levels.
class Search {
 public:
  Search(const PowerTree& tree, int levels, const std::vector<double>& known, LevelNorms& counters,
         const Deadline& deadline)
      : tree_(tree),
        levels_(levels),
        known_(known),
        counters_(counters),
        deadline_(deadline),
        growth_(static_cast<double>(tree.width() + 2) * unit),
        vectors_(static_cast<std::size_t>(levels) * static_cast<std::size_t>(tree.arity()) + 1,
                 std::vector<double>(tree.width(), 0.0)),
        digits_(static_cast<std::size_t>(levels), 0),
        losses_(static_cast<std::size_t>(levels) + 1, 0.0),
        exact_(tree, levels) {
    vectors_.front().front() = 1.0;
    // Mirror of the residue r modulo a^L is D_L - r with D_L = degree * (a^L - 1) / (a - 1); by digits from below.
    if (tree.palindromic()) {
      Integer total = 0;
      for (int k = 0; k < levels; ++k) total = total * tree.arity() + tree.degree();
      for (int k = 0; k < levels; ++k) {
        mirror_digits_.push_back(Integer(total % tree.arity()).convert_to<int>());
        total /= tree.arity();
      }
    }
  }

  /// The exact maximum, or nothing where the time ran out.
  std::optional<Rational> run() {
    visit(0, 0, 1.0, tree_.palindromic() ? 0 : -1);
    sum_candidates();
    if (expired_) return std::nullopt;
    return best_;
  }

 private:
  struct Candidate {
    std::vector<int> digits;
    double upper;
  };

  double bound_of_powers(int level) const { return level == 0 ? 1.0 : known_[static_cast<std::size_t>(level) - 1]; }

  /// Sums the cosets that were kept, as far as they can hold the maximum, and keeps none of them.
  void sum_candidates() {
    for (const Candidate& candidate : candidates_) {
      if (candidate.upper < best_lower_) continue;
      const auto sum = expired_ ? std::nullopt : exact_.sum(candidate.digits, deadline_);
      expired_ = !sum;
      if (expired_) break;
      ++counters_.exact;
      best_ = std::max(best_, *sum);
    }
    candidates_.clear();
  }

  /// An upper bound for the 1-norm of the error of the vector at this depth: what each step lost, carried on by the
  /// steps after it.
  double error_bound(int depth) const {
    double error = 0;
    for (int k = 1; k <= depth; ++k) error += losses_[static_cast<std::size_t>(k)] * bound_of_powers(depth - k);
    return error * (1 + growth_ + 64 * unit);
  }

  /// `norm` is the 1-norm of the vector as computed. `borrow` is the borrow of the mirrored subtraction while prefix
  /// and mirror agree so far, -1 once the prefix is known to be the one to keep.
  void visit(int depth, std::size_t slot, double norm, int borrow) {
    ++counters_.visited;
    work_ += tree_.width() * tree_.width() + 100;
    if (work_ > 2'000'000) {
      work_ = 0;
      expired_ = deadline_.expired();
    }
    if (expired_) return;
    if (depth == levels_) {
      const double error = error_bound(depth);
      const double upper = (norm + error) * (1 + growth_), lower = (norm - error) * (1 - growth_);
      if (upper < best_lower_) return;
      if (std::isfinite(upper)) best_lower_ = std::max(best_lower_, lower);  // overflow decides nothing
      candidates_.push_back({digits_, upper});
      counters_.held = std::max<std::uint64_t>(counters_.held, candidates_.size());
      if (candidates_.size() == LevelNorms::most_held) sum_candidates();
      return;
    }
    struct Child {
      int digit;
      double norm;
      int borrow;
    };
    std::vector<Child> children;
    for (int t = 0; t < tree_.arity(); ++t) {
      int next_borrow = -1;
      if (borrow >= 0) {
        const int difference = mirror_digits_[static_cast<std::size_t>(depth)] - t - borrow;
        const int mirrored = difference < 0 ? difference + tree_.arity() : difference;
        if (mirrored < t) continue;
        if (mirrored == t) next_borrow = difference < 0 ? 1 : 0;
      }
      std::vector<double>& child = vectors_[child_slot(depth, t)];
      tree_.step(vectors_[slot], t, child);
      double child_norm = 0;
      for (double x : child) child_norm += std::abs(x);
      children.push_back({t, child_norm, next_borrow});
    }
    std::sort(children.begin(), children.end(), [](const Child& a, const Child& b) { return a.norm > b.norm; });
    losses_[static_cast<std::size_t>(depth) + 1] = growth_ * known_[0] * norm * (1 + 4 * unit) + tiny;
    const double error = error_bound(depth + 1);
    for (const Child& child : children) {
      const double bound = (child.norm + error) * (1 + growth_) * bound_of_powers(levels_ - depth - 1) * (1 + 4 * unit);
      if (bound < best_lower_) continue;
      digits_[static_cast<std::size_t>(depth)] = child.digit;
      visit(depth + 1, child_slot(depth, child.digit), child.norm, child.borrow);
    }
  }

  std::size_t child_slot(int depth, int digit) const {
    return static_cast<std::size_t>(depth) * static_cast<std::size_t>(tree_.arity()) + static_cast<std::size_t>(digit) +
           1;
  }

  const PowerTree& tree_;
  int levels_;
  const std::vector<double>& known_;  // upper bounds for the norms of the lower levels; known_[0] for one level
  LevelNorms& counters_;
  Deadline deadline_;
  double growth_;  // relative error of a sum of width + 1 products, rounded up
  std::vector<std::vector<double>> vectors_;
  std::vector<int> digits_;
  std::vector<double> losses_;  // rounding errors of the step to each depth on the path, in the 1-norm
  std::vector<int> mirror_digits_;
  std::vector<Candidate> candidates_;  // their sums are not known exactly yet; at most most_held
  ExactSums exact_;
  Rational best_ = 0;  // of the sums known exactly
  double best_lower_ = 0;
  std::uint64_t work_ = 0;  // since the clock was last read
  bool expired_ = false;
};

}  // namespace

LevelNorms level_norms(const Mask& mask, int levels, const Deadline& deadline) {
  require(levels >= 1, "level_norms: need levels >= 1, got {}", levels);
  const PowerTree tree(mask);
  // Filled from below: the search for one level prunes with the norms of all lower ones. The norm of a single level
  // is needed for the error bound of every search.
  LevelNorms result;
  result.norms.push_back(operator_norm(mask));
  std::vector<double> known{round_up(result.norms.front())};
  for (int level = 2; level <= levels; ++level) {
    const auto norm = Search(tree, level, known, result, deadline).run();
    if (!norm) break;
    result.norms.push_back(*norm);
    known.push_back(round_up(*norm));
  }
  return result;
}

}  // namespace subcert
