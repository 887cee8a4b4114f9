/// Walk: forms on cells, their children, the ranges they prove (docs/limit-enclosures.md, sections 4 and 5).
///   setup   cell_setup   the scheme that contracts, phi in balls, its interpolating polynomials, the sources
///   bounds  cell_bounds  the remainders, in doubles with proved errors
///   walk    limit_cells  here

#include "limit_cells.hpp"

#include "cell_bounds.hpp"
#include "cell_setup.hpp"

#include <subcert/analysis/outward_rounding/outward.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace subcert {
namespace {

using namespace outward;
using namespace cells;

constexpr std::size_t rough_degree = 3;  // tried, too, where phi may be rough at the scale of the integers
constexpr std::size_t rough_width = 64;  // widest vectors for which it is

/// Polynomials of one degree, and what they leave out.
struct Approximation {
  Interpolation in;
  Remainder rest;
};

/// Rows of a form moved to a part of the cell, before the transition operator acts on them.
struct RecentredRows {
  std::vector<double> rows;
  std::vector<double> row_losses;  // of the steps before
  std::vector<double> losses;      // by moving them, in the maximum norm
  std::vector<double> errors;      // by all that came before, and by moving them
  std::vector<double> sizes;
};

}  // namespace

struct LimitCells::Impl {
  CellSetup setup;
  Approximation approximation;
  bool exact;  // phi is a polynomial between integers
  CellBounds bounds;
  bool slopes;
  std::string reason;  // why not C^1

  Impl(const Mask& mask, const Deadline& deadline)
      : setup(mask, deadline),
        approximation{setup.interpolation(most_nodes - 1), {}},
        exact(setup.order() == 1 && setup.is_piecewise_polynomial(approximation.in, deadline)),
        bounds(setup, exact),
        slopes(setup.order() == 2 || exact),
        reason(setup.contraction.reason) {
    if (exact)
      set_exact();
    else
      approximate();
  }

  std::size_t nodes() const { return approximation.in.nodes(); }
  std::size_t degree() const { return approximation.in.degree; }
  std::size_t length() const { return setup.rows_width(); }

  void set_exact() {
    const std::vector<double> nothing(nodes() * length(), 0.0);
    approximation.in.sources.assign(static_cast<std::size_t>(setup.arity),
                                    {nothing, std::vector<double>(nodes(), 0.0), {}});
  }

  void complete(Approximation& one) const {
    one.in.sources = setup.sources(one.in);
    one.rest = bounds.remainder(one.in.sources);
  }

  /// With polynomials of high or of low degree, whichever leave out less.
  void approximate() {
    complete(approximation);
    if (setup.width <= rough_width) {
      Approximation rough{setup.interpolation(rough_degree), {}};
      complete(rough);
      const bool rougher = setup.order() == 2 ? rough.rest.slope < approximation.rest.slope
                                              : rough.rest.value < approximation.rest.value;
      if (rougher) approximation = std::move(rough);
    }
    require(!std::isinf(approximation.rest.value), "limit cells: the difference scheme contracts too slowly");
    if (setup.order() == 2 && std::isinf(approximation.rest.slope)) {
      slopes = false;
      reason = "C^1 is proved, but the difference scheme contracts too slowly for a bound of the slope";
    }
  }

  std::pair<double, double> square_bounds(int level) const {
    return bounds.square_bounds(approximation.rest, level, slopes);
  }
  RowBounds row_bounds(const CellForm& form) const {
    return bounds.row_bounds({form.rows, form.row_losses, form.factor, form.level}, approximation.rest, slopes);
  }
  CellForm squared(std::vector<BallVector> z) const;
  void add_digits(CellForm& form) const;
  void recentre_polynomial(const CellForm& form, int digit, CellForm& result) const;
  RecentredRows recentre_rows(const CellForm& form, int digit) const;
  void add_source(const RecentredRows& moved, double scale, int digit, CellForm& result) const;
  void drop_small_rows(CellForm& form, const Spare& spare) const;
  CellParts parts(const CellForm& form) const;
};

LimitCells::LimitCells(const Mask& mask, const Deadline& deadline) : impl_(std::make_unique<Impl>(mask, deadline)) {}
LimitCells::LimitCells(LimitCells&&) noexcept = default;
LimitCells& LimitCells::operator=(LimitCells&&) noexcept = default;
LimitCells::~LimitCells() = default;

int LimitCells::arity() const { return impl_->setup.arity; }
bool LimitCells::has_slopes() const { return impl_->slopes; }
const std::string& LimitCells::slope_reason() const { return impl_->reason; }
bool LimitCells::is_mirrored() const { return impl_->setup.mirrored; }
long LimitCells::first_integer() const { return impl_->setup.window.first; }
long LimitCells::last_integer() const { return first_integer() + static_cast<long>(impl_->setup.width); }

int LimitCells::deepest_level() const {
  int level = 0;
  for (long cells = (1L << 61) - 1; cells >= arity(); cells /= arity()) ++level;
  return level;
}

// ---- The first forms

CellForm LimitCells::limit_form(long k) const {
  const Impl& m = *impl_;
  const long place = k - first_integer();
  CellForm form;
  form.index = k;
  form.middle.assign(1, 0.0);
  form.radius.assign(1, 0.0);
  form.rows.assign(m.length(), 0.0);
  form.row_losses.assign(1, 0.0);
  if (place < 0 || place >= static_cast<long>(m.setup.width)) return form;
  form.middle.assign(m.nodes(), 0.0);
  form.radius.assign(m.nodes(), 0.0);
  const Interpolation& in = m.approximation.in;
  const slong bits = m.setup.bits;
  for (std::size_t j = 0; j < m.nodes(); ++j) {
    Ball sum(bits);
    for (std::size_t s = 0; s < m.nodes(); ++s)
      sum.add_product(in.lagrange[s].at(j, bits), in.at_nodes[s].at(static_cast<std::size_t>(place), bits));
    form.middle[j] = cells::to_double(sum, form.radius[j]);
  }
  std::vector<double> unit(m.setup.width, 0.0);
  unit[static_cast<std::size_t>(place)] = 1;
  for (int i = 0; i < m.setup.order(); ++i) {
    for (std::size_t j = 0; j + 1 < unit.size(); ++j) unit[j] -= unit[j + 1];
    unit.pop_back();
  }
  form.rows = std::move(unit);
  return form;
}

CellForm LimitCells::variance_form(std::int64_t index, int level) const {
  const Impl& m = *impl_;
  const int deepest = deepest_level() - m.setup.node_level;
  require(level >= 0 && level <= deepest && index >= 0 && index < int_power(arity(), level),
          "variance_form: need 0 <= level <= {} and 0 <= index < arity^level, got level {}", deepest, level);
  std::vector<BallVector> at;
  for (const std::int64_t node : m.approximation.in.node)
    at.push_back(m.setup.values(index * int_power(arity(), m.setup.node_level) + node, level + m.setup.node_level));
  CellForm form = m.squared(m.approximation.in.polynomial(at, m.setup.bits));
  form.level = level;
  form.index = index;
  form.factor = 2;
  m.add_digits(form);
  std::tie(form.square, form.square_slope) = m.square_bounds(level);
  return form;
}

/// |Z|^2 for the polynomial Z with these coefficients, and the rows of its m-th differences.
CellForm LimitCells::Impl::squared(std::vector<BallVector> z) const {
  CellForm form;
  form.middle.assign(2 * degree() + 1, 0.0);
  form.radius.assign(2 * degree() + 1, 0.0);
  for (std::size_t i = 0; i <= 2 * degree(); ++i) {
    Ball sum(setup.bits);
    for (std::size_t j = i > degree() ? i - degree() : 0; 2 * j <= i; ++j) {
      const Ball product = dot(z[j], z[i - j], setup.bits);
      sum += product;
      if (2 * j < i) sum += product;
    }
    form.middle[i] = cells::to_double(sum, form.radius[i]);
  }
  form.rows.assign(nodes() * length(), 0.0);
  for (std::size_t j = 0; j < nodes(); ++j) {
    for (int i = 0; i < setup.order(); ++i) z[j].take_differences(setup.bits);
    double error = 0;
    for (std::size_t k = 0; k < length(); ++k) {
      double entry_error = 0;
      form.rows[j * length() + k] = cells::to_double(z[j].at(k, setup.bits), entry_error);
      error = std::max(error, entry_error);
    }
    form.row_losses.push_back(error);
  }
  return form;
}

/// Takes the rows from [0, 1] to the cell of the form.
void LimitCells::Impl::add_digits(CellForm& form) const {
  std::vector<int> digits;
  for (std::int64_t rest = form.index; static_cast<int>(digits.size()) < form.level; rest /= setup.arity)
    digits.push_back(static_cast<int>(rest % setup.arity));
  std::vector<double> image(length());
  for (std::size_t d = digits.size(); d-- > 0;)
    for (std::size_t j = 0; j < nodes(); ++j) {
      double* row = &form.rows[j * length()];
      const double size = largest(row, length());
      bounds.transition().apply_transposed(digits[d], row, image.data());
      std::copy(image.begin(), image.end(), row);
      form.row_losses.push_back(up(bounds.norm_of_step() * gamma(length()) * size));
    }
}

// ---- Their children

CellForm LimitCells::variance_child(const CellForm& form, const CellRange& range, int digit, const Spare& spare) const {
  const CellSetup& setup = impl_->setup;
  // Where cells are few: what is spare leaves no room for the square.
  const double cost = real_power(arity(), form.level + 1) * static_cast<double>(setup.width * setup.width);
  const bool early = (cost < 1e5 || form.level < 4) &&
                     (form.square > 5 * spare.value || form.square_slope > 5 * spare.slope);
  if ((range.square_share > 0.1 || early) && form.level + setup.node_level < deepest_level()) {
    const auto [value, slope] = impl_->square_bounds(form.level + 1);
    if (value < form.square / 2 || slope < form.square_slope / 2)
      return variance_form(form.index * arity() + digit, form.level + 1);
  }
  return child(form, digit, spare);
}

/// eta((t + y) / a) = a^-m T eta(y) + k_t(y): the second part goes to the polynomial, the first makes the new rows.
CellForm LimitCells::child(const CellForm& form, int digit, const Spare& spare) const {
  const Impl& m = *impl_;
  const std::size_t length = m.length(), count = form.rows.size() / length;
  CellForm result;
  result.level = form.level + 1;
  result.index = form.index * arity() + digit;
  result.factor = form.factor;
  result.value_slack = form.value_slack;
  result.slope_slack = form.slope_slack;
  result.square = form.square;
  result.square_slope = form.square_slope;
  m.recentre_polynomial(form, digit, result);
  RecentredRows moved = m.recentre_rows(form, digit);
  m.add_source(moved, form.factor / real_power(arity(), m.setup.order() * form.level), digit, result);
  result.rows.assign(count * length, 0.0);
  result.row_losses = std::move(moved.row_losses);
  for (std::size_t i = 0; i < count; ++i) {
    m.bounds.transition().apply_transposed(digit, &moved.rows[i * length], &result.rows[i * length]);
    result.row_losses.push_back(up(m.bounds.norm_of_step() * (moved.losses[i] + gamma(length) * moved.sizes[i])));
  }
  m.drop_small_rows(result, spare);
  return result;
}

void LimitCells::Impl::recentre_polynomial(const CellForm& form, int digit, CellForm& result) const {
  const Recentring& matrix = bounds.recentring(digit);
  const std::size_t size = std::max(form.middle.size(), form.rows.size() / length() + degree());
  result.middle.assign(size, 0.0);
  result.radius.assign(size, 0.0);
  for (std::size_t i = 0; i < form.middle.size(); ++i) {
    for (std::size_t j = i; j < form.middle.size(); ++j) {
      const double factor = matrix(i, j);
      result.middle[i] += factor * form.middle[j];
      result.radius[i] += std::abs(factor) * (form.radius[j] + gamma(form.middle.size()) * std::abs(form.middle[j]));
    }
    result.radius[i] = up(result.radius[i]);
  }
}

RecentredRows LimitCells::Impl::recentre_rows(const CellForm& form, int digit) const {
  const Recentring& matrix = bounds.recentring(digit);
  const std::size_t width = length(), count = form.rows.size() / width;
  RecentredRows result{std::vector<double>(count * width, 0.0), std::vector<double>(form.row_losses.size(), 0.0),
                       std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
                       std::vector<double>(count, 0.0)};
  for (std::size_t j = 0; j < count; ++j) {
    const double row_size = largest(&form.rows[j * width], width);
    for (std::size_t i = 0; i <= j; ++i) {
      const double factor = matrix(i, j);
      for (std::size_t k = 0; k < width; ++k) result.rows[i * width + k] += factor * form.rows[j * width + k];
      result.losses[i] += std::abs(factor) * gamma(count) * row_size;
    }
  }
  for (std::size_t k = 0; k < form.row_losses.size(); k += count)
    for (std::size_t j = 0; j < count; ++j)
      for (std::size_t i = 0; i <= j; ++i)
        result.row_losses[k + i] = up(result.row_losses[k + i] + std::abs(matrix(i, j)) * form.row_losses[k + j]);
  const std::vector<double> carried = bounds.row_errors(result.row_losses, count);
  for (std::size_t i = 0; i < count; ++i) {
    result.errors[i] = up(carried[i] + result.losses[i]);
    result.sizes[i] = up(largest(&result.rows[i * width], width) + result.errors[i]);
  }
  return result;
}

void LimitCells::Impl::add_source(const RecentredRows& moved, double scale, int digit, CellForm& result) const {
  const VectorPolynomial& source = approximation.in.sources[static_cast<std::size_t>(digit)];
  const std::size_t width = length();
  for (std::size_t l = 0; l < nodes(); ++l) {
    const double* k = &source.coefficients[l * width];
    const double norm = one_norm(k, width);
    if (norm + source.errors[l] == 0) continue;
    for (std::size_t i = 0; i < moved.errors.size(); ++i) {
      result.middle[i + l] += scale * dot(&moved.rows[i * width], k, width);
      const double error = moved.errors[i] * norm + moved.sizes[i] * source.errors[l] +
                           gamma(width) * moved.sizes[i] * norm;
      result.radius[i + l] = up(result.radius[i + l] + scale * error + gamma(4) * std::abs(result.middle[i + l]));
    }
  }
}

/// Rows of high degree matter less at each level; those that matter less than what is spare are replaced by bounds.
void LimitCells::Impl::drop_small_rows(CellForm& form, const Spare& spare) const {
  if (form.rows.size() == length()) return;
  const RowBounds rest = row_bounds(form);
  const std::size_t count = form.rows.size() / length(), steps = form.row_losses.size() / count;
  std::size_t keep = count;
  while (keep > 1 && rest.value[keep - 1] <= spare.value && rest.slope[keep - 1] <= spare.slope) {
    --keep;
    form.value_slack = up(form.value_slack + rest.value[keep]);
    form.slope_slack = up(form.slope_slack + rest.slope[keep]);
  }
  for (std::size_t k = 1; k < steps; ++k)
    for (std::size_t j = 0; j < keep; ++j) form.row_losses[k * keep + j] = form.row_losses[k * count + j];
  form.row_losses.resize(steps * keep);
  form.rows.resize(keep * length());
}

// ---- What forms say

CellParts LimitCells::Impl::parts(const CellForm& form) const {
  const RowBounds rest = row_bounds(form);
  CellParts parts{.middle = form.middle,
                  .radius = form.radius,
                  .speed = real_power(setup.arity, form.level),
                  .value_rest = form.value_slack,
                  .slope_rest = form.slope_slack,
                  .value_slack = form.value_slack,
                  .slope_slack = form.slope_slack,
                  .square_below = 0,
                  .square_above = form.square,
                  .square_slope = form.square_slope,
                  .slopes = slopes};
  for (std::size_t j = 0; j < most_nodes; ++j) {
    parts.value_rest += rest.value[j];
    parts.slope_rest += rest.slope[j];
  }
  parts.value_rest = up(parts.value_rest);
  parts.slope_rest = up(parts.slope_rest);
  return parts;
}

CellRange LimitCells::range(const CellForm& form) const { return range_of(impl_->parts(form)); }

CellRange LimitCells::difference(const LimitCells& first, const CellForm& form, const LimitCells& second,
                                 const CellForm& other) {
  require(first.arity() == second.arity() && form.level == other.level && form.index == other.index,
          "difference: need forms on one cell, got {} and {} on levels {} and {}", form.index, other.index, form.level,
          other.level);
  CellParts parts = first.impl_->parts(form);
  const CellParts less = second.impl_->parts(other);
  parts.middle.resize(std::max(parts.middle.size(), less.middle.size()), 0.0);
  parts.radius.resize(parts.middle.size(), 0.0);
  for (std::size_t j = 0; j < less.middle.size(); ++j) {
    parts.middle[j] -= less.middle[j];
    parts.radius[j] = up(parts.radius[j] + less.radius[j] + std::abs(parts.middle[j]) * 0x1p-50);
  }
  parts.value_rest = up(parts.value_rest + less.value_rest);
  parts.slope_rest = up(parts.slope_rest + less.slope_rest);
  parts.value_slack = up(parts.value_slack + less.value_slack);
  parts.slope_slack = up(parts.slope_slack + less.slope_slack);
  parts.square_below = less.square_above;
  parts.square_slope = up(parts.square_slope + less.square_slope);
  parts.slopes = parts.slopes && less.slopes;
  return range_of(parts);
}

namespace {

using namespace outward;

struct Span {
  double lower, upper;
};

/// Values on |u| <= 1/2 of sum of (c[j] +- r[j]) u^j.
Span polynomial_span(const std::vector<double>& c, const std::vector<double>& r) {
  double low = 0, high = 0, error = 0;
  for (std::size_t j = c.size(); j-- > 1;) {
    const double term = std::ldexp(std::abs(c[j]), -static_cast<int>(j));
    if (j % 2 == 1 || c[j] < 0) low += term;
    if (j % 2 == 1 || c[j] > 0) high += term;
    error += std::ldexp(r[j], -static_cast<int>(j));
  }
  const double centre_error = up(r.empty() ? 0 : r[0]) + (c.empty() ? 0 : std::abs(c[0]) * 0x1p-50);
  const double centre = c.empty() ? 0 : c[0];
  return {centre - up(up(low) + up(error) + centre_error), centre + up(up(high) + up(error) + centre_error)};
}

}  // namespace

CellRange range_of(const CellParts& parts) {
  const std::vector<double>&c = parts.middle, &r = parts.radius;
  CellRange range{};
  range.remainder = up(parts.value_rest + std::max(parts.square_below, parts.square_above));
  const Span value = polynomial_span(c, r);
  const auto outward = [](double low, double high, double margin) {
    const double room = up(margin + (std::abs(low) + std::abs(high)) * 0x1p-50);
    return Span{low - room, high + room};
  };
  const Span all = outward(value.lower - parts.square_below, value.upper + parts.square_above, parts.value_rest);
  range.value_lower = all.lower;
  range.value_upper = all.upper;
  double value_error = 0, slope_error = 0;
  for (std::size_t j = r.size(); j-- > 0;) {
    value_error += half_power(j) * r[j];
    slope_error += 2 * static_cast<double>(j) * half_power(j) * r[j];
  }
  range.value_rounding = 2 * value_error / (range.value_upper - range.value_lower);
  double odd = 0, odd_error = 0, even = 0, even_error = 0, sizes = 0;
  for (std::size_t j = c.size(); j-- > 0;) {
    const double term = std::ldexp(c[j], -static_cast<int>(j)), error = std::ldexp(r[j], -static_cast<int>(j));
    (j % 2 == 1 ? odd : even) += term;
    (j % 2 == 1 ? odd_error : even_error) += up(error + gamma(c.size()) * std::abs(term));
    sizes += std::abs(term);
  }
  const double end_error = up(odd_error + even_error + parts.value_slack + gamma(4) * sizes);
  const Span left = outward(even - odd - parts.square_below, even - odd + parts.square_above, end_error);
  const Span right = outward(even + odd - parts.square_below, even + odd + parts.square_above, end_error);
  range.left_lower = left.lower;
  range.left_upper = left.upper;
  range.right_lower = right.lower;
  range.right_upper = right.upper;
  // What slack and square do to the mean slope over the cell is bounded by their slopes, too.
  double loose = up(up(2 * parts.value_slack + parts.square_below + parts.square_above) * parts.speed);
  if (parts.slopes) loose = std::min(loose, up(parts.slope_slack + parts.square_slope));
  const double rise = up(2 * odd_error) < 2 * std::abs(odd)
                          ? down((2 * std::abs(odd) - up(2 * odd_error)) * parts.speed) - loose
                          : 0;
  range.steepness = std::max(0.0, down(rise));
  if (parts.slopes) {
    std::vector<double> d, e;
    for (std::size_t j = 1; j < c.size(); ++j) {
      const auto factor = static_cast<double>(j);
      d.push_back(factor * c[j]);
      e.push_back(up(factor * r[j] + std::abs(factor * c[j]) * 0x1p-50));
    }
    const Span slope = polynomial_span(d, e);
    const Span moved = outward(slope.lower * parts.speed, slope.upper * parts.speed,
                               parts.slope_rest + parts.square_slope);
    range.slope_lower = moved.lower;
    range.slope_upper = moved.upper;
    range.steepness = std::max({range.steepness, range.slope_lower, -range.slope_upper});
    range.slope_rounding = 2 * slope_error * parts.speed / (range.slope_upper - range.slope_lower);
    range.square_share = parts.square_slope == 0 ? 0 : 2 * parts.square_slope / (range.slope_upper - range.slope_lower);
  } else {
    range.slope_lower = -infinite;
    range.slope_upper = infinite;
  }
  const double square = parts.square_below + parts.square_above;
  if (square > 0) range.square_share = std::max(range.square_share, square / (range.value_upper - range.value_lower));
  return range;
}

}  // namespace subcert
