#include "contraction.hpp"

#include "cone_program.hpp"
#include "difference_forms.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace subcert::piecewise {
namespace {

constexpr double clearly = 1e-7;         // larger values of forms are no rounding
constexpr double slightly = 1e-6;        // smaller residuals are rounding
constexpr std::size_t most_asked = 500;  // known factors that are tried on a cell
constexpr std::size_t most_tried = 3;    // splits of a window of which programs are solved

/// Which data of a window have a positive, which a negative sign, in some of its pieces or of its factors.
struct SignMasks {
  std::uint64_t positive = 0, negative = 0;
};

SignMasks masks_of(const std::vector<int>& signs) {
  SignMasks masks;
  for (std::size_t r = 0; r < signs.size(); ++r) {
    if (signs[r] > 0) masks.positive |= std::uint64_t{1} << r;
    if (signs[r] < 0) masks.negative |= std::uint64_t{1} << r;
  }
  return masks;
}

std::uint8_t sign_of(const SignMasks& masks, std::size_t r) {
  if ((masks.positive >> r & 1) != 0) return ProofNode::positive;
  return (masks.negative >> r & 1) != 0 ? ProofNode::negative : ProofNode::none;
}

/// Factors with the signs that they have, so that they may serve other cells too.
struct KnownFactors {
  ResidualFactors factors;
  std::vector<SignMasks> masks;  // of each window
  std::size_t listed = 0;        // its number in the tree plus one; 0: not yet there
};

/// Pieces of a window by the sign of one of its data.
struct Split {
  std::size_t window = 0, datum = 0;
  std::uint8_t signs = 0;  // of the first child
  double rank = 0;
};

/// The tree of one start.
class TreeSearch {
 public:
  TreeSearch(const Rule& rule, const ContractionOptions& options, long start, Rational known, Aim aim = Aim::modulus)
      : rule_(rule),
        options_(options),
        plan_(dependence(rule, options.steps, options.order, start)),
        forms_(forms_for(aim, rule, plan_, options.order)),
        program_(forms_.dimension, forms_.boxed, forms_.residuals, forms_.objective),
        best_(std::move(known)),
        sides_(forms_.residuals.size(), Side::nonnegative),
        any_(plan_.windows.size()) {
    tree_.start = start;
    tree_.windows = plan_.windows;
    for (const Piece& piece : rule.pieces) piece_masks_.push_back(masks_of(piece.signs));
    std::vector<std::uint32_t> all(rule.pieces.size());
    std::iota(all.begin(), all.end(), 0);
    possible_.assign(plan_.windows.size(), all);
    for (std::size_t window = 0; window < possible_.size(); ++window) lay_out(window);
  }

  /// False where time is up or a program failed.
  bool run() {
    visit(program_.corner_of_box());
    return !stopped_;
  }

  const Rational& best() const { return best_; }
  const std::vector<Rational>& data() const { return data_; }
  ContractionTree take_tree() { return std::move(tree_); }

 private:
  using Corner = ConeProgram::Corner;
  using Pieces = std::vector<std::uint32_t>;

  double enough() const { return best_.convert_to<double>() - clearly; }
  void lay_out(std::size_t window);
  std::pair<Pieces, Pieces> parts(const Split& split) const;

  // Factors.
  bool have_signs(const KnownFactors& known) const;
  bool close_by_known();
  bool close(const Corner& corner, bool attained);
  void use(KnownFactors& known);
  void keep_data(const Corner& corner);

  // Splitting.
  double violation(const double* residuals, const SignMasks& any) const;
  double least_violation(const double* residuals, const Pieces& pieces) const;
  void rate_splits(std::size_t window, const double* residuals, std::vector<Split>& found) const;
  std::vector<Split> violated_splits(const Corner& corner) const;
  Split choose(const Corner& corner, const std::vector<Split>& splits);
  Split any_split() const;
  double gain(const Corner& corner, std::size_t window, Pieces pieces);

  void visit(Corner corner);
  void branch(const Corner& corner, Split split);

  const Rule& rule_;
  const ContractionOptions& options_;
  const Dependence plan_;
  const Forms forms_;
  const ConeProgram program_;
  Rational best_;
  std::vector<Rational> data_;
  ContractionTree tree_;
  bool stopped_ = false;

  std::vector<SignMasks> piece_masks_;
  std::vector<Pieces> possible_;  // of each window
  std::vector<Side> sides_;       // of each residual: what all possible pieces say of it
  std::vector<SignMasks> any_;    // of each window: the signs that some possible piece has
  std::vector<KnownFactors> leaves_;
};

void TreeSearch::lay_out(std::size_t window) {
  SignMasks& any = any_[window] = {};
  for (const std::uint32_t piece : possible_[window]) {
    any.positive |= piece_masks_[piece].positive;
    any.negative |= piece_masks_[piece].negative;
  }
  for (std::size_t r = 0; r < rule_.points; ++r)
    sides_[window * rule_.points + r] = static_cast<Side>(((any.negative >> r & 1) != 0 ? 0U : 1U) +
                                                          ((any.positive >> r & 1) != 0 ? 0U : 2U));
}

std::pair<TreeSearch::Pieces, TreeSearch::Pieces> TreeSearch::parts(const Split& split) const {
  std::pair<Pieces, Pieces> result;
  for (const std::uint32_t piece : possible_[split.window])
    ((sign_of(piece_masks_[piece], split.datum) & split.signs) != 0 ? result.first : result.second).push_back(piece);
  return result;
}

bool TreeSearch::have_signs(const KnownFactors& known) const {
  for (std::size_t window = 0; window < any_.size(); ++window) {
    const SignMasks &own = known.masks[window], &any = any_[window];
    if (((own.positive & any.negative) | (own.negative & any.positive)) != 0) return false;
  }
  return true;
}

void TreeSearch::use(KnownFactors& known) {
  if (!options_.keep_trees) return;
  if (known.listed == 0) {
    tree_.leaves.push_back(known.factors);
    known.listed = tree_.leaves.size();
  }
  tree_.nodes.push_back({false, 0, 0, static_cast<std::uint32_t>(known.listed - 1)});
}

// What served last is asked first.
bool TreeSearch::close_by_known() {
  const std::size_t asked = std::min(leaves_.size(), most_asked);
  for (std::size_t i = leaves_.size(); i-- > leaves_.size() - asked;)
    if (have_signs(leaves_[i])) {
      std::swap(leaves_[i], leaves_.back());
      use(leaves_.back());
      return true;
    }
  return false;
}

// Where the corner is attained by fits, its bound is the least one there.
bool TreeSearch::close(const Corner& corner, bool attained) {
  auto found = program_.bound(corner, sides_);
  if (!found || (!attained && found->bound > best_)) return false;
  KnownFactors known{{std::move(found->multipliers), found->bound}, std::vector<SignMasks>(any_.size()), 0};
  for (const auto& [place, factor] : known.factors.factors) {
    if (place / rule_.points >= any_.size()) break;  // of a difference of the data
    SignMasks& masks = known.masks[place / rule_.points];
    (factor > 0 ? masks.positive : masks.negative) |= std::uint64_t{1} << place % rule_.points;
  }
  if (found->bound > best_) {
    best_ = found->bound;
    keep_data(corner);
  }
  leaves_.push_back(std::move(known));
  use(leaves_.back());
  return true;
}

void TreeSearch::keep_data(const Corner& corner) {
  data_.clear();
  const auto x = program_.point(corner, sides_);
  if (!x || value_at(forms_.objective, *x) != best_) return;
  for (std::size_t window = 0; window < possible_.size(); ++window) {
    std::vector<int> signs;
    for (std::size_t r = 0; r < rule_.points; ++r)
      signs.push_back(value_at(forms_.residuals[window * rule_.points + r], *x).sign());
    const SignMasks own = masks_of(signs);
    const auto agrees = [&](const SignMasks& piece) {
      const std::uint64_t zero = ~(piece.positive | piece.negative);
      return ((own.positive & (piece.negative | zero)) | (own.negative & (piece.positive | zero))) == 0;
    };
    if (std::none_of(piece_masks_.begin(), piece_masks_.end(), agrees)) return;
  }
  for (const Row& row : forms_.data) data_.push_back(value_at(row, *x));
}

/// By how much residuals miss the signs that all pieces with these signs share.
double TreeSearch::violation(const double* residuals, const SignMasks& any) const {
  double sum = 0;
  for (std::size_t r = 0; r < rule_.points; ++r) {
    const bool positive = (any.positive >> r & 1) != 0, negative = (any.negative >> r & 1) != 0;
    if (!positive) sum += std::max(0.0, residuals[r]);
    if (!negative) sum += std::max(0.0, -residuals[r]);
  }
  return sum;
}

double TreeSearch::least_violation(const double* residuals, const Pieces& pieces) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t piece : pieces) least = std::min(least, violation(residuals, piece_masks_[piece]));
  return least;
}

void TreeSearch::rate_splits(std::size_t window, const double* residuals, std::vector<Split>& found) const {
  for (std::size_t datum = 0; datum < rule_.points; ++datum)
    for (const std::uint8_t sign : {ProofNode::positive, ProofNode::negative, ProofNode::none}) {
      SignMasks any[2];
      bool occupied[2] = {false, false};
      for (const std::uint32_t piece : possible_[window]) {
        const int side = sign_of(piece_masks_[piece], datum) == sign ? 0 : 1;
        occupied[side] = true;
        any[side].positive |= piece_masks_[piece].positive;
        any[side].negative |= piece_masks_[piece].negative;
      }
      if (!occupied[0] || !occupied[1]) continue;
      const double first = violation(residuals, any[0]), second = violation(residuals, any[1]);
      if (const double rank = 10 * std::min(first, second) + std::max(first, second); rank > 0)
        found.push_back({window, datum, sign, rank});
    }
}

// Of windows whose fits at the corner are no fits, the splits that move the corner most.
std::vector<Split> TreeSearch::violated_splits(const Corner& corner) const {
  const std::vector<double> residuals = program_.row_values(corner);
  std::vector<Split> result;
  for (std::size_t window = 0; window < possible_.size(); ++window) {
    const double* own = &residuals[window * rule_.points];
    if (possible_[window].size() < 2 || least_violation(own, possible_[window]) < slightly) continue;
    std::vector<Split> found;
    rate_splits(window, own, found);
    const std::size_t kept = std::min(found.size(), most_tried);
    std::partial_sort(found.begin(), found.begin() + static_cast<long>(kept), found.end(),
                      [](const Split& a, const Split& b) { return a.rank > b.rank; });
    result.insert(result.end(), found.begin(), found.begin() + static_cast<long>(kept));
  }
  std::stable_sort(result.begin(), result.end(), [](const Split& a, const Split& b) { return a.rank > b.rank; });
  return result;
}

/// How much of what is above the best bound goes, 0 to 1, if the window has these pieces only.
double TreeSearch::gain(const Corner& corner, std::size_t window, Pieces pieces) {
  std::swap(possible_[window], pieces);
  lay_out(window);
  Corner next = corner;
  const double above = program_.value(corner) - enough();
  const bool found = program_.improve(next, sides_, enough());
  std::swap(possible_[window], pieces);
  lay_out(window);
  return found ? std::min(1.0, (program_.value(corner) - program_.value(next)) / above) : 0;
}

Split TreeSearch::choose(const Corner& corner, const std::vector<Split>& splits) {
  if (splits.size() == 1) return splits[0];
  Split best = splits[0];
  double most = -1;
  for (const Split& split : splits) {
    auto [first, second] = parts(split);
    const double one = gain(corner, split.window, std::move(first));
    const double other = gain(corner, split.window, std::move(second));
    if (const double product = (one + 1e-4) * (other + 1e-4); product > most) {
      most = product;
      best = split;
    }
    if (one == 1 && other == 1) break;
  }
  return best;
}

// Of the last level that has one.
Split TreeSearch::any_split() const {
  for (std::size_t window = possible_.size(); window-- > 0;)
    for (std::size_t datum = 0; datum < rule_.points; ++datum)
      for (const std::uint8_t sign : {ProofNode::positive, ProofNode::negative}) {
        const auto has = [&](std::uint32_t piece) { return sign_of(piece_masks_[piece], datum) == sign; };
        const auto count = std::count_if(possible_[window].begin(), possible_[window].end(), has);
        if (count > 0 && count < static_cast<long>(possible_[window].size())) return {window, datum, sign, 0};
      }
  return {};
}

void TreeSearch::visit(Corner corner) {
  if (stopped_ || close_by_known()) return;
  if (options_.deadline.expired()) {
    stopped_ = true;
    return;
  }
  std::vector<Split> splits;
  for (const bool anew : {false, true}) {
    if (anew) corner = program_.corner_of_box();  // rounding errors add up
    const bool found = program_.improve(corner, sides_, enough());
    if (found && program_.value(corner) <= best_.convert_to<double>() + clearly && close(corner, false)) return;
    splits = violated_splits(corner);
    if (!splits.empty()) break;
    if (found && close(corner, true)) return;
  }
  const Split split = splits.empty() ? any_split() : choose(corner, splits);
  if (split.signs == 0) {
    stopped_ = true;
    return;
  }
  branch(corner, split);
}

// The part with the larger bound first: data with large differences are found early.
void TreeSearch::branch(const Corner& corner, Split split) {
  auto [first, second] = parts(split);
  if (gain(corner, split.window, first) > gain(corner, split.window, second)) {
    std::swap(first, second);
    split.signs = static_cast<std::uint8_t>(7 - split.signs);
  }
  if (options_.keep_trees)
    tree_.nodes.push_back(
        {true, split.signs, static_cast<std::uint16_t>(split.datum), static_cast<std::uint32_t>(split.window)});
  Pieces all = std::move(possible_[split.window]);
  for (Pieces* part : {&first, &second}) {
    possible_[split.window] = std::move(*part);
    lay_out(split.window);
    visit(corner);
  }
  possible_[split.window] = std::move(all);
  lay_out(split.window);
}

}  // namespace

SignOfDifferences keeps_sign(const Rule& rule, int order, const Deadline& deadline) {
  require(order >= 1 && order <= rule.degree + 1, "sign of differences: need 1 <= order <= {}, got {}", rule.degree + 1,
          order);
  require(rule.points >= 2 && rule.points <= 64, "sign of differences: need 2 to 64 points, got {}", rule.points);
  const ContractionOptions options{1, order, 0, deadline, false};
  for (long start = 0; start < rule.arity(); ++start) {
    TreeSearch search(rule, options, start, 0, Aim::sign);
    if (!search.run()) return {{Truth::unknown, "the programs were not finished"}, {}};
    if (search.best() == 0) continue;
    if (search.data().empty()) return {{Truth::unknown, "no data were found that show it"}, {}};
    return {{Truth::no, "some data show it"}, search.data()};
  }
  return {{Truth::yes, "by the pieces"}, {}};
}

int most_steps(long arity) {
  int steps = 0;
  for (long period = arity; period <= 256; period *= arity) ++steps;
  return steps;
}

ContractionSearch contraction(const Rule& rule, const ContractionOptions& options) {
  require(options.order >= 1 && options.order <= rule.degree + 1, "contraction: need 1 <= order <= {}, got {}",
          rule.degree + 1, options.order);
  require(options.steps >= 1 && options.steps <= most_steps(rule.arity()), "contraction: need 1 <= steps <= {}, got {}",
          most_steps(rule.arity()), options.steps);
  require(rule.points >= 2 && rule.points <= 64, "contraction: need 2 to 64 points, got {}", rule.points);
  require(options.enough >= 0, "contraction: need enough >= 0, got {}", options.enough);
  Contraction result{options.steps, options.order, options.enough, {}, {}};
  ContractionSearch answer;
  long period = 1, levels = 0;  // a^steps, and 1 + a + ... + a^(steps - 1)
  for (int step = 0; step < options.steps; ++step) {
    levels += period;
    period *= rule.arity();
  }
  // Data in the order turned have the values in the order turned, moved by so much.
  const long moved = (rule.arity() - 1 - rule.arity() * (static_cast<long>(rule.points) - 1)) * levels;
  bool going_on = true;
  for (long start = 0; start < period; ++start) {
    if (modulo(moved - options.order - start, period) < start) continue;
    ++answer.starts;
    if (!going_on) continue;
    TreeSearch search(rule, options, start, result.bound);
    going_on = search.run();
    answer.finished += going_on ? 1 : 0;
    if (search.best() > result.bound) {
      result.bound = search.best();
      result.data = search.data();
      if (!result.data.empty()) {
        answer.attained = result.bound;
        answer.data = result.data;
      }
    }
    if (options.keep_trees) result.trees.push_back(search.take_tree());
  }
  if (going_on) answer.proved = std::move(result);
  return answer;
}

}  // namespace subcert::piecewise
