#include "contraction.hpp"

#include "cone_program.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::piecewise {
namespace {

constexpr double clearly = 1e-7;  // larger values of forms are no rounding

/// sum += factor * row.
void add_multiple(Row& sum, const Rational& factor, const Row& row) {
  if (factor == 0) return;
  if (sum.size() < row.size()) sum.resize(row.size(), 0);
  for (std::size_t j = 0; j < row.size(); ++j)
    if (row[j] != 0) sum[j] += factor * row[j];
}

/// (-1)^(order - s) binom(order, s) for s = 0, ..., order.
Row difference_form(int order) {
  Row form{order % 2 == 0 ? 1 : -1};
  for (int s = 0; s < order; ++s) form.push_back(form.back() * Rational(s - order, s + 1));
  return form;
}

/// What a difference at the last level depends on: of each level the first index and the number of values.
struct Dependence {
  struct Level {
    long first;
    std::size_t count;
  };
  std::vector<Level> levels;  // 0, ..., steps
  std::vector<WindowPlace> windows;
};

Dependence dependence(const Rule& rule, int steps, int order, long start) {
  Dependence result;
  result.levels.resize(static_cast<std::size_t>(steps) + 1);
  long low = start, high = start + order;
  result.levels.back() = {low, static_cast<std::size_t>(order) + 1};
  for (int level = steps - 1; level >= 0; --level) {
    const long first = floor_divide(low, 2), last = floor_divide(high, 2);
    std::vector<WindowPlace> windows;
    for (long window = first; window <= last; ++window) windows.push_back({level, window});
    result.windows.insert(result.windows.begin(), windows.begin(), windows.end());
    low = first;
    high = last + static_cast<long>(rule.points) - 1;
    result.levels[static_cast<std::size_t>(level)] = {low, static_cast<std::size_t>(high - low + 1)};
  }
  return result;
}

/// Data by their differences of this order, the first `order` data being zero: row j has the coefficients of datum j.
std::vector<Row> data_by_differences(std::size_t count, std::size_t order) {
  std::vector<Row> rows(count);
  for (std::size_t j = order; j < count; ++j) {
    rows[j].assign(j - order + 1, 0);
    rows[j].back() = 1;
  }
  for (std::size_t k = 0; k < order; ++k)
    for (std::size_t j = order; j + 1 < count; ++j) add_multiple(rows[j + 1], 1, rows[j]);
  return rows;
}

/// The sum of |c_j| where form = sum of c_j * differences; nothing where it is no such sum.
std::optional<Rational> difference_norm(Row form, int order) {
  for (int k = 0; k < order; ++k) {
    for (std::size_t j = 0; j + 1 < form.size(); ++j) {
      form[j + 1] += form[j];
      form[j] = -form[j];
    }
    if (form.back() != 0) return std::nullopt;
    form.pop_back();
  }
  Rational norm = 0;
  for (const Rational& entry : form) norm += abs(entry);
  return norm;
}

/// Which data of a window have a positive, which a negative sign.
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

/// Factors with the signs that they have, so that they may serve other cells too.
struct KnownFactors {
  ResidualFactors factors;
  std::vector<SignMasks> masks;  // of each window
  std::size_t listed = 0;        // its number in the tree plus one; 0: not yet there
};

/// No piece: the two values of the fit are variables, or one where the fit is constant.
Piece free_piece(const Rule& rule) {
  Piece piece{std::vector<int>(rule.points, 0), rule.degree == 0 ? std::size_t{1} : 2, {}, {}};
  for (std::size_t phase = 0; phase < 2; ++phase) {
    Row output(rule.points + piece.own, 0);
    output[rule.points + std::min(phase, piece.own - 1)] = 1;
    piece.outputs.push_back(std::move(output));
  }
  return piece;
}

/// The tree of one start.
class TreeSearch {
 public:
  TreeSearch(const Rule& rule, const ContractionOptions& options, long start, Rational known)
      : rule_(rule),
        options_(options),
        plan_(dependence(rule, options.steps, options.order, start)),
        difference_(difference_form(options.order)),
        best_(std::move(known)),
        free_(free_piece(rule)) {
    tree_.start = start;
    tree_.windows = plan_.windows;
    const auto order = static_cast<std::size_t>(options.order);
    const std::size_t data = plan_.levels[0].count;
    boxed_ = data > order ? data - order : 0;
    for (const Dependence::Level& level : plan_.levels) values_.emplace_back(level.count);
    values_[0] = data_by_differences(data, order);
    for (const Piece& piece : rule.pieces) piece_masks_.push_back(masks_of(piece.signs));
    piece_masks_.emplace_back();
    path_.assign(plan_.windows.size(), rule.pieces.size());
  }

  /// False where time is up or a program failed.
  bool run() {
    visit();
    return !stopped_;
  }

  const Rational& best() const { return best_; }
  const std::vector<Rational>& data() const { return data_; }
  ContractionTree take_tree() { return std::move(tree_); }

 private:
  struct Program {
    ConeProgram cone;
    Row form;
    std::optional<ConeBound> found;
  };

  // The path: rows of the cells of its windows, in the differences of the data and the variables of the pieces.
  void lay_out();
  Row over_path(const Row& form, const WindowPlace& place, std::size_t own_begin) const;
  Row objective() const;
  bool is_free(std::size_t window) const { return path_[window] == rule_.pieces.size(); }
  const Piece& piece(std::size_t window) const { return is_free(window) ? free_ : rule_.pieces[path_[window]]; }
  Program solve(double enough);
  std::optional<std::size_t> window_to_split(const ConeProgram& program) const;

  // Factors.
  std::optional<KnownFactors> factors_of(const ConeBound& bound) const;
  bool have_signs_of_path(const KnownFactors& known) const;
  bool close_by_known();
  bool close(const Program& program, bool last);
  void use(KnownFactors& known);

  void visit();
  void keep_data(const Program& program);

  const Rule& rule_;
  const ContractionOptions& options_;
  const Dependence plan_;
  const Row difference_;
  Rational best_;
  const Piece free_;
  std::vector<Rational> data_;
  ContractionTree tree_;
  bool stopped_ = false;

  std::vector<std::size_t> path_;  // the piece of each window, or the number of pieces: free
  std::size_t boxed_ = 0, dimension_ = 0;
  std::vector<std::vector<Row>> values_;  // [level][index]
  std::vector<Row> rows_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;  // window and row of its cell, of each row
  std::vector<std::size_t> owners_;                          // the window of each variable beyond the data
  std::vector<SignMasks> piece_masks_;
  std::vector<KnownFactors> leaves_;
};

// A form in the data of a window and its own variables, in those of the path.
Row TreeSearch::over_path(const Row& form, const WindowPlace& place, std::size_t own_begin) const {
  const auto level = static_cast<std::size_t>(place.level);
  const auto begin = static_cast<std::size_t>(place.window - plan_.levels[level].first);
  Row result;
  for (std::size_t r = 0; r < rule_.points; ++r) add_multiple(result, form[r], values_[level][begin + r]);
  if (form.size() > rule_.points) result.resize(std::max(result.size(), own_begin + form.size() - rule_.points), 0);
  for (std::size_t k = rule_.points; k < form.size(); ++k) result[own_begin + k - rule_.points] += form[k];
  return result;
}

void TreeSearch::lay_out() {
  rows_.clear();
  places_.clear();
  owners_.clear();
  for (std::size_t window = 0; window < path_.size(); ++window) {
    const WindowPlace& place = plan_.windows[window];
    const std::size_t begin = boxed_ + owners_.size();
    owners_.insert(owners_.end(), piece(window).own, window);
    for (std::size_t i = 0; i < piece(window).cell.size(); ++i) {
      rows_.push_back(over_path(piece(window).cell[i], place, begin));
      places_.emplace_back(window, i);
    }
    const auto next = static_cast<std::size_t>(place.level) + 1;
    for (long phase = 0; phase < 2; ++phase) {
      const long index = 2 * place.window + phase - plan_.levels[next].first;
      if (index >= 0 && index < static_cast<long>(plan_.levels[next].count))
        values_[next][static_cast<std::size_t>(index)] = over_path(
            piece(window).outputs[static_cast<std::size_t>(phase)], place, begin);
    }
  }
  dimension_ = boxed_ + owners_.size();
}

Row TreeSearch::objective() const {
  Row result;
  for (std::size_t s = 0; s < difference_.size(); ++s) add_multiple(result, difference_[s], values_.back()[s]);
  return result;
}

TreeSearch::Program TreeSearch::solve(double enough) {
  lay_out();
  Program program{ConeProgram(dimension_, boxed_), objective(), std::nullopt};
  for (const Row& row : rows_) program.cone.add(row);
  program.found = program.cone.bound(program.form, enough);
  return program;
}

// One whose fit is free and moves the difference, of the last level that has such.
std::optional<std::size_t> TreeSearch::window_to_split(const ConeProgram& program) const {
  if (const auto coordinate = program.unbounded_coordinate())
    if (const std::size_t window = owners_[*coordinate - boxed_]; is_free(window)) return window;
  for (std::size_t window = path_.size(); window-- > 0;)
    if (is_free(window)) return window;
  return std::nullopt;
}

// From the last level down: the form in the values of a level becomes one in the values of the level before, the
// factors of each window being the linear rule that takes its place.
std::optional<KnownFactors> TreeSearch::factors_of(const ConeBound& bound) const {
  KnownFactors result;
  result.factors.of_window.assign(path_.size(), Row(rule_.points, 0));
  result.masks.resize(path_.size());
  std::vector<Row> added(path_.size());
  for (const auto& [row, factor] : bound.multipliers) {
    const auto [window, place] = places_[row];
    add_multiple(added[window], factor, piece(window).cell[place]);
  }
  std::vector<Row> forms;
  for (const Dependence::Level& level : plan_.levels) forms.emplace_back(level.count, 0);
  forms.back() = difference_;
  for (std::size_t window = path_.size(); window-- > 0;) {
    const auto level = static_cast<std::size_t>(plan_.windows[window].level);
    Row form = added[window];
    for (long phase = 0; phase < 2; ++phase) {
      const long index = 2 * plan_.windows[window].window + phase - plan_.levels[level + 1].first;
      if (index < 0 || index >= static_cast<long>(plan_.levels[level + 1].count)) continue;
      add_multiple(form, forms[level + 1][static_cast<std::size_t>(index)],
                   piece(window).outputs[static_cast<std::size_t>(phase)]);
    }
    const auto begin = static_cast<std::size_t>(plan_.windows[window].window - plan_.levels[level].first);
    for (std::size_t r = 0; r < form.size(); ++r) {
      if (form[r] == 0) continue;
      if (r >= rule_.points) return std::nullopt;
      forms[level][begin + r] += form[r];
      result.factors.of_window[window][r] = form[r];
      (form[r] > 0 ? result.masks[window].positive : result.masks[window].negative) |= std::uint64_t{1} << r;
    }
  }
  const auto norm = difference_norm(forms[0], options_.order);
  if (!norm) return std::nullopt;
  result.factors.bound = *norm;
  return result;
}

bool TreeSearch::have_signs_of_path(const KnownFactors& known) const {
  for (std::size_t window = path_.size(); window-- > 0;) {
    const SignMasks& signs = piece_masks_[path_[window]];
    const SignMasks& own = known.masks[window];
    if ((own.positive & signs.negative) != 0 || (own.negative & signs.positive) != 0) return false;
    if (is_free(window) && (own.positive | own.negative) != 0) return false;
  }
  return true;
}

void TreeSearch::use(KnownFactors& known) {
  if (!options_.keep_trees) return;
  if (known.listed == 0) {
    tree_.leaves.push_back(known.factors);
    known.listed = tree_.leaves.size();
  }
  tree_.nodes.push_back({false, static_cast<std::uint32_t>(known.listed - 1)});
}

// What served last is asked first.
bool TreeSearch::close_by_known() {
  for (std::size_t i = leaves_.size(); i-- > 0;)
    if (have_signs_of_path(leaves_[i])) {
      std::swap(leaves_[i], leaves_.back());
      use(leaves_.back());
      return true;
    }
  return false;
}

bool TreeSearch::close(const Program& program, bool last) {
  if (!program.found || (!last && program.found->bound > best_)) return false;
  auto known = factors_of(*program.found);
  if (!known || (!last && known->factors.bound > best_)) return false;
  if (known->factors.bound > best_) {
    best_ = known->factors.bound;
    keep_data(program);
  }
  leaves_.push_back(std::move(*known));
  use(leaves_.back());
  return true;
}

void TreeSearch::keep_data(const Program& program) {
  data_.clear();
  const auto x = program.cone.maximiser();
  if (!x || value_at(program.form, *x) != best_) return;
  for (const Row& row : values_[0]) data_.push_back(value_at(row, *x));
}

void TreeSearch::visit() {
  if (stopped_ || close_by_known()) return;
  if (options_.deadline.expired()) {
    stopped_ = true;
    return;
  }
  const Program program = solve(best_.convert_to<double>() - clearly);
  const auto window = window_to_split(program.cone);
  const bool last = std::none_of(path_.begin(), path_.end(), [&](std::size_t p) { return p == rule_.pieces.size(); });
  if (close(program, last)) return;
  if (last || !window) {
    stopped_ = true;
    return;
  }
  if (options_.keep_trees) tree_.nodes.push_back({true, static_cast<std::uint32_t>(*window)});
  for (path_[*window] = 0; path_[*window] < rule_.pieces.size(); ++path_[*window]) visit();
}

}  // namespace

std::optional<Contraction> contraction(const Rule& rule, const ContractionOptions& options) {
  require(options.order >= 1 && options.order <= rule.degree + 1, "contraction: need 1 <= order <= {}, got {}",
          rule.degree + 1, options.order);
  require(options.steps >= 1 && options.steps <= 8, "contraction: need 1 <= steps <= 8, got {}", options.steps);
  require(rule.points <= 64, "contraction: need at most 64 points, got {}", rule.points);
  Contraction result{options.steps, options.order, 0, {}, {}};
  const long period = 1L << options.steps;
  for (long start = 0; start < period; ++start) {
    if (modulo(2 * static_cast<long>(rule.points) - 3 - options.order - start, period) < start) continue;
    TreeSearch search(rule, options, start, result.bound);
    if (!search.run()) return std::nullopt;
    if (search.best() > result.bound) {
      result.bound = search.best();
      result.data = search.data();
    }
    if (options.keep_trees) result.trees.push_back(search.take_tree());
  }
  return result;
}

}  // namespace subcert::piecewise
