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

Rational value_at(const Row& form, const std::vector<Rational>& x) {
  Rational sum = 0;
  for (std::size_t j = 0; j < form.size(); ++j) sum += form[j] * x[j];
  return sum;
}

bool is_zero(const Row& row) {
  return std::all_of(row.begin(), row.end(), [](const Rational& entry) { return entry == 0; });
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
  std::size_t windows = 0;       // the others have factors 0
  std::size_t listed = 0;        // its number in the tree plus one; 0: not yet there
};

/// The tree of one start.
class TreeSearch {
 public:
  TreeSearch(const Rule& rule, const ContractionOptions& options, long start, Rational known)
      : rule_(rule),
        options_(options),
        function_(rule.is_function()),
        plan_(dependence(rule, options.steps, options.order, start)),
        difference_(difference_form(options.order)),
        best_(std::move(known)) {
    tree_.start = start;
    tree_.windows = plan_.windows;
    const auto order = static_cast<std::size_t>(options.order);
    const std::size_t data = plan_.levels[0].count;
    boxed_ = dimension_ = data > order ? data - order : 0;
    for (const Dependence::Level& level : plan_.levels) values_.emplace_back(level.count);
    values_[0] = data_by_differences(data, order);
    for (const Piece& piece : rule.pieces) piece_masks_.push_back(masks_of(piece.signs));
    path_.resize(plan_.windows.size());
  }

  /// False where time is up or a program failed.
  bool run() {
    visit(0, {});
    return !stopped_;
  }

  const Rational& best() const { return best_; }
  const std::vector<Rational>& data() const { return data_; }
  ContractionTree take_tree() { return std::move(tree_); }

 private:
  struct Mark {
    std::size_t dimension, rows;
  };
  using RowFactors = std::vector<std::pair<std::size_t, Rational>>;

  // The path: rows of the cells of its windows, in the differences of the data and the variables of their own.
  Mark push(std::size_t depth);
  void pop(const Mark& mark) {
    dimension_ = mark.dimension;
    rows_.resize(mark.rows);
    places_.resize(mark.rows);
  }
  Row over_path(const Row& form, const WindowPlace& place, std::size_t own_begin) const;
  Row objective() const;
  const Piece& piece(std::size_t window) const { return rule_.pieces[path_[window]]; }
  int level(std::size_t window) const { return plan_.windows[window].level; }

  // Factors.
  std::optional<KnownFactors> factors_of(const RowFactors& rows, bool of_difference) const;
  bool have_signs_of_path(const KnownFactors& known, std::size_t depth) const;
  bool may_witness(std::size_t window) const { return level(window) == 0 || piece(window).own == 0; }
  bool has_witness(const KnownFactors& known, std::size_t depth) const;
  KnownFactors* first_that_fits(std::vector<KnownFactors>& pool, std::size_t depth, bool thin);
  void use(KnownFactors& known, ProofNode::Kind kind);

  // The tree.
  void visit(std::size_t depth, const std::vector<double>& point);
  void visit_child(std::size_t depth, const std::vector<double>& point);
  void close_leaf(std::size_t depth);
  bool close_thin(std::size_t depth, std::vector<double>& point);
  bool lies_inside(const std::vector<double>& point, std::size_t from) const;
  void keep_data(const Row& form, const ConeProgram& program);

  const Rule& rule_;
  const ContractionOptions& options_;
  const bool function_;
  const Dependence plan_;
  const Row difference_;
  Rational best_;
  std::vector<Rational> data_;
  ContractionTree tree_;
  bool stopped_ = false;

  std::size_t boxed_ = 0, dimension_ = 0;
  std::vector<std::vector<Row>> values_;  // [level][index]
  std::vector<Row> rows_;
  std::vector<std::pair<std::size_t, std::size_t>> places_;  // window and row of its cell, of each row
  std::vector<std::size_t> path_;                            // pieces
  std::vector<SignMasks> piece_masks_;
  std::vector<KnownFactors> leaves_, thin_;
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

TreeSearch::Mark TreeSearch::push(std::size_t depth) {
  const Mark mark{dimension_, rows_.size()};
  const WindowPlace& place = plan_.windows[depth];
  dimension_ += piece(depth).own;
  for (std::size_t i = 0; i < piece(depth).cell.size(); ++i) {
    rows_.push_back(over_path(piece(depth).cell[i], place, mark.dimension));
    places_.emplace_back(depth, i);
  }
  const auto next = static_cast<std::size_t>(place.level) + 1;
  for (long phase = 0; phase < 2; ++phase) {
    const long index = 2 * place.window + phase - plan_.levels[next].first;
    if (index >= 0 && index < static_cast<long>(plan_.levels[next].count))
      values_[next][static_cast<std::size_t>(index)] = over_path(piece(depth).outputs[static_cast<std::size_t>(phase)],
                                                                 place, mark.dimension);
  }
  return mark;
}

Row TreeSearch::objective() const {
  Row result;
  for (std::size_t s = 0; s < difference_.size(); ++s) add_multiple(result, difference_[s], values_.back()[s]);
  return result;
}

// From the last level down: the form in the values of a level becomes one in the values of the level before, the
// factors of each window being the linear rule that takes its place.
std::optional<KnownFactors> TreeSearch::factors_of(const RowFactors& rows, bool of_difference) const {
  KnownFactors result;
  result.factors.of_window.assign(plan_.windows.size(), Row(rule_.points, 0));
  result.masks.resize(plan_.windows.size());
  std::vector<Row> added(plan_.windows.size());
  for (const auto& [row, factor] : rows) {
    const auto [window, place] = places_[row];
    add_multiple(added[window], factor, piece(window).cell[place]);
  }
  std::vector<Row> forms;
  for (const Dependence::Level& level : plan_.levels) forms.emplace_back(level.count, 0);
  if (of_difference) forms.back() = difference_;
  for (std::size_t window = plan_.windows.size(); window-- > 0;) {
    const auto level = static_cast<std::size_t>(plan_.windows[window].level);
    Row form = added[window];
    for (long phase = 0; phase < 2; ++phase) {
      const long index = 2 * plan_.windows[window].window + phase - plan_.levels[level + 1].first;
      if (index < 0 || index >= static_cast<long>(plan_.levels[level + 1].count)) continue;
      const Rational& factor = forms[level + 1][static_cast<std::size_t>(index)];
      if (factor != 0) add_multiple(form, factor, piece(window).outputs[static_cast<std::size_t>(phase)]);
    }
    form.resize(std::max(form.size(), rule_.points), 0);
    const auto begin = static_cast<std::size_t>(plan_.windows[window].window - plan_.levels[level].first);
    for (std::size_t r = 0; r < form.size(); ++r) {
      if (form[r] == 0) continue;
      if (r >= rule_.points) return std::nullopt;
      forms[level][begin + r] += form[r];
      result.factors.of_window[window][r] = form[r];
      (form[r] > 0 ? result.masks[window].positive : result.masks[window].negative) |= std::uint64_t{1} << r;
      result.windows = std::max(result.windows, window + 1);
    }
  }
  const auto norm = difference_norm(forms[0], options_.order);
  if (!norm || (!of_difference && !is_zero(forms[0]))) return std::nullopt;
  result.factors.bound = *norm;
  return result;
}

bool TreeSearch::have_signs_of_path(const KnownFactors& known, std::size_t depth) const {
  if (known.windows > depth + 1) return false;
  for (std::size_t window = known.windows; window-- > 0;) {
    const SignMasks& signs = piece_masks_[path_[window]];
    if ((known.masks[window].positive & signs.negative) != 0 || (known.masks[window].negative & signs.positive) != 0)
      return false;
  }
  return true;
}

// A residual with a factor that vanishes on the cell though it does not do so where the cell's equations hold.
bool TreeSearch::has_witness(const KnownFactors& known, std::size_t depth) const {
  for (std::size_t window = 0; window <= depth; ++window) {
    if (!may_witness(window)) continue;
    const SignMasks& signs = piece_masks_[path_[window]];
    const std::uint64_t places = (known.masks[window].positive | known.masks[window].negative) &
                                 (signs.positive | signs.negative);
    if (places == 0) continue;
    if (level(window) == 0) return true;
    std::size_t row = 0;
    for (std::size_t r = 0; r < rule_.points; ++r) {
      if (piece(window).signs[r] == 0) continue;
      if ((places >> r & 1) != 0 && !is_zero(over_path(piece(window).cell[row], plan_.windows[window], 0))) return true;
      ++row;
    }
  }
  return false;
}

// What served last is asked first.
KnownFactors* TreeSearch::first_that_fits(std::vector<KnownFactors>& pool, std::size_t depth, bool thin) {
  for (std::size_t i = pool.size(); i-- > 0;)
    if (have_signs_of_path(pool[i], depth) && (!thin || has_witness(pool[i], depth))) return &pool[i];
  return nullptr;
}

void TreeSearch::use(KnownFactors& known, ProofNode::Kind kind) {
  if (!options_.keep_trees) return;
  std::vector<ResidualFactors>& list = kind == ProofNode::Kind::leaf ? tree_.leaves : tree_.thin;
  if (known.listed == 0) {
    list.push_back(known.factors);
    known.listed = list.size();
  }
  tree_.nodes.push_back({kind, known.listed - 1});
}

bool TreeSearch::lies_inside(const std::vector<double>& point, std::size_t from) const {
  if (point.size() < dimension_) return false;
  for (std::size_t i = from; i < rows_.size(); ++i) {
    double value = 0;
    for (std::size_t j = 0; j < rows_[i].size(); ++j) value += rows_[i][j].convert_to<double>() * point[j];
    if (value < clearly) return false;
  }
  return true;
}

void TreeSearch::visit(std::size_t depth, const std::vector<double>& point) {
  if (options_.keep_trees) tree_.nodes.push_back({ProofNode::Kind::split, depth});
  for (std::size_t index = 0; index < rule_.pieces.size() && !stopped_; ++index) {
    path_[depth] = index;
    visit_child(depth, point);
  }
}

void TreeSearch::visit_child(std::size_t depth, const std::vector<double>& point) {
  const bool leaf = depth + 1 == plan_.windows.size();
  if (KnownFactors* known = first_that_fits(leaf ? leaves_ : thin_, depth, !leaf))
    return use(*known, leaf ? ProofNode::Kind::leaf : ProofNode::Kind::thin);
  if (options_.deadline.expired()) {
    stopped_ = true;
    return;
  }
  const Mark mark = push(depth);
  if (leaf) {
    close_leaf(depth);
  } else {
    std::vector<double> inside = point;
    if (lies_inside(point, mark.rows) || !close_thin(depth, inside)) visit(depth + 1, inside);
  }
  pop(mark);
}

void TreeSearch::close_leaf(std::size_t) {
  ConeProgram program(dimension_, boxed_);
  for (const Row& row : rows_) program.add(row);
  const Row form = objective();
  const auto found = program.bound(form, best_.convert_to<double>() - clearly);
  std::optional<KnownFactors> known;
  if (found) known = factors_of(found->multipliers, true);
  if (!known) {
    stopped_ = true;
    return;
  }
  if (known->factors.bound > best_) {
    best_ = known->factors.bound;
    keep_data(form, program);
  }
  leaves_.push_back(std::move(*known));
  use(leaves_.back(), ProofNode::Kind::leaf);
}

void TreeSearch::keep_data(const Row& form, const ConeProgram& program) {
  data_.clear();
  const auto x = program.maximiser();
  if (!x || value_at(form, *x) != best_) return;
  for (const Row& row : values_[0]) data_.push_back(value_at(row, *x));
}

// Where a rule is no function, levels beyond the second are left out: the theorem does not speak of them.
bool TreeSearch::close_thin(std::size_t depth, std::vector<double>& point) {
  if (!function_ && level(depth) > 1) return false;
  ConeProgram program(dimension_, boxed_, true);
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const std::size_t window = places_[i].first;
    program.add(rows_[i], may_witness(window) && !is_zero(rows_[i]));
  }
  const auto found = program.largest_margin();
  point = program.point();
  if (!found || found->bound != 0) return false;
  auto known = factors_of(found->multipliers, false);
  if (!known || !has_witness(*known, depth)) return false;
  thin_.push_back(std::move(*known));
  use(thin_.back(), ProofNode::Kind::thin);
  return true;
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
