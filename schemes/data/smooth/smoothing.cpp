#include "smoothing.hpp"

#include "rounded_regression.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>

#include <algorithm>

namespace subcert::data {
namespace {

constexpr int max_shift_level = 12;

/// The smallest level on whose grid x lies.
int adic_level(const Rational& x, int arity) {
  for (int level = 0; level <= max_shift_level; ++level)
    if (denominator(Rational(x * power(Rational(arity), level))) == 1) return level;
  fail(ErrorKind::domain, "smoothing: the data of this scheme stand at {} from the integers, no {}-adic number",
       to_text(x), arity);
}

PolynomialReproduction checked_reproduction(const Mask& mask) {
  const PolynomialReproduction reproduction = polynomial_reproduction(mask);
  require(reproduction.reproduction_degree >= 0, "smoothing: need a scheme that reproduces constants");
  return reproduction;
}

LimitValues checked_values(const Mask& mask, const Rational& shift, const SmoothingOptions& options) {
  require(options.level >= 0, "smoothing: need level >= 0, got {}", options.level);
  return limit_values(mask, std::max(options.level, adic_level(shift, mask.arity())), options.derivative);
}

}  // namespace

void require_smoothable(std::size_t count, std::size_t scale) {
  if (count - 1 > (most_smoothed_values - 1) / scale)
    fail(ErrorKind::size, "smoothing: need at most {} outputs, got {} data with {} outputs each", most_smoothed_values,
         count, scale);
}

ExtensionRule extension_rule(const Mask& mask, Boundary kind) {
  const long length = mask.symbol().length();
  return {kind, static_cast<std::size_t>((length + mask.arity() - 1) / mask.arity()),
          std::max(0, checked_reproduction(mask).reproduction_degree)};
}

LinearSmoother::LinearSmoother(const Mask& mask, std::size_t count, const SmoothingOptions& options,
                               const std::optional<LocalRegression>& rules, std::vector<Rational> prior_weights)
    : mask_(mask),
      options_(options),
      rules_(rules),
      shift_(checked_reproduction(mask).parametrization),
      phi_(checked_values(mask, shift_, options)),
      data_(extension_rule(mask, options.boundary), count, std::move(prior_weights)),
      scale_(numerator(power(Rational(mask.arity()), options.level)).convert_to<std::size_t>()) {
  require_smoothable(count, scale_);
  if (data_.weighted() && !rules_)
    fail(ErrorKind::domain, "smoothing: prior weights and missing data need a scheme of local regressions");
  for (std::size_t i = 0; i < count; ++i)
    prior_weights_.push_back(static_cast<double>(data_.weight(static_cast<long>(i))));
}

std::size_t LinearSmoother::outputs() const { return (data_.count() - 1) * scale_ + 1; }

Rational LinearSmoother::position(std::size_t output) const { return Rational(output) / Rational(scale_); }

/// The integers j with a value of phi at scale * (position + shift) - j.
std::pair<long, long> LinearSmoother::reach(std::size_t output, const Rational& scale) const {
  const Interval range = limit_support(mask_);
  const Rational x = scale * (position(output) + shift_);
  return {ceil_index(x - range.upper), floor_index(x - range.lower)};
}

bool LinearSmoother::is_interior(std::size_t output) const {
  const auto [first, last] = reach(output, 1);
  return data_.is_inside(first) && data_.is_inside(last);
}

SmoothingRow LinearSmoother::to_row(const Combination& combination) const {
  SmoothingRow row;
  row.outside = combination.outside;
  if (combination.terms.empty()) return row;
  row.first = combination.terms.begin()->first;
  row.weights.assign(combination.terms.rbegin()->first - row.first + 1, 0);
  for (const auto& [index, weight] : combination.terms) {
    row.weights[index - row.first] = weight;
    if (weight != 0) row.variance += weight * weight / data_.weight(static_cast<long>(index));
  }
  return row;
}

SmoothingRow LinearSmoother::limit_row(std::size_t output) const {
  const Rational grid = power(Rational(mask_.arity()), phi_.level);
  const Rational x = position(output) + shift_;
  const auto [first, last] = reach(output, 1);
  Combination sum;
  for (long j = first; j <= last; ++j)
    sum.add(data_.at(j), phi_.at(numerator(Rational((x - j) * grid)).convert_to<long>()));
  return to_row(sum);
}

LinearSmoother::Window LinearSmoother::window_of(long index) const {
  const long arity = mask_.arity();
  const long offset = index - rules_->first_output;
  const long residue = modulo(offset, arity);
  const auto rule = static_cast<std::size_t>(residue);
  const RegressionRule& r = rules_->rules[rule];
  const auto points = static_cast<std::size_t>(r.last - r.first + 1);
  const long group = floor_divide(offset, arity);
  Window window{rule, group + r.first, group, std::vector<Rational>(points, 0), {}};
  for (std::size_t k = 0; k < points; ++k) {
    window.weights[k] = data_.weight(window.first + static_cast<long>(k)) *
                        (r.weights.empty() ? Rational(1) : r.weights[k]);
    if (window.weights[k] > 0) window.kept.push_back(k);
  }
  const std::size_t needed = std::min(points, static_cast<std::size_t>(rules_->degree) + 1);
  if (window.kept.size() < needed)
    fail(ErrorKind::data, "smoothing: {} of the {} data around datum {} are present, a fit of degree {} needs {}",
         window.kept.size(), points, group + 1, rules_->degree, needed);
  return window;
}

const std::vector<Rational>& LinearSmoother::fit_of(const Window& window) const {
  const auto found = fits_.find({window.rule, window.weights});
  if (found != fits_.end()) return found->second;
  const RegressionRule& r = rules_->rules[window.rule];
  std::vector<Rational> nodes, positive;
  for (const std::size_t k : window.kept) {
    nodes.emplace_back(r.first + static_cast<long>(k));
    positive.push_back(window.weights[k]);
  }
  return fits_[{window.rule, window.weights}] = regression_weights(nodes, positive, rules_->degree, r.position);
}

/// The datum of level 1 with this index, from a fit with the prior weights.
Combination LinearSmoother::refined_datum(long index) const {
  const Window window = window_of(index);
  const std::vector<Rational>& fit = fit_of(window);
  Combination sum;
  for (std::size_t k = 0; k < window.kept.size(); ++k)
    sum.add(data_.at(window.first + static_cast<long>(window.kept[k])), fit[k]);
  return sum;
}

/// refined_datum() in double precision.
RoundedCombination LinearSmoother::rounded_refined_datum(long index) const {
  const Window window = window_of(index);
  const RegressionRule& r = rules_->rules[window.rule];
  std::vector<double> nodes, weights;
  for (const std::size_t k : window.kept) {
    nodes.push_back(static_cast<double>(Rational(r.first + static_cast<long>(k) - r.position)));
    weights.push_back(static_cast<double>(window.weights[k]));
  }
  const std::vector<double> fit = rounded_regression_weights(nodes, weights, rules_->degree, 0);
  RoundedCombination sum;
  for (std::size_t k = 0; k < fit.size(); ++k) {
    const RoundedCombination datum = data_.rounded_at(window.first + static_cast<long>(window.kept[k]));
    sum.outside += fit[k] * datum.outside;
    for (const auto& [i, weight] : datum.terms) sum.terms.emplace_back(i, fit[k] * weight);
  }
  return sum;
}

SmoothingRow LinearSmoother::row(std::size_t output) const {
  if (!data_.weighted()) return limit_row(output);
  const Rational arity = mask_.arity();
  const Rational grid = power(arity, phi_.level), factor = power(arity, options_.derivative);
  const Rational x = arity * (position(output) + shift_);
  const auto [first, last] = reach(output, arity);
  Combination sum;
  for (long m = first; m <= last; ++m) {
    const Rational value = phi_.at(numerator(Rational((x - m) * grid)).convert_to<long>());
    if (value != 0) sum.add(refined_datum(m), factor * value);
  }
  return to_row(sum);
}

/// The datum of level 0 or, with prior weights, of level 1, in double precision; made once.
const RoundedCombination& LinearSmoother::rounded_datum(long index) const {
  if (const auto found = rounded_.find(index); found != rounded_.end()) return found->second;
  return rounded_[index] = data_.weighted() ? rounded_refined_datum(index) : data_.rounded_at(index);
}

/// row(), composed in double precision.
LinearSmoother::RoundedRow LinearSmoother::rounded_row(std::size_t output) const {
  const Rational scale = data_.weighted() ? mask_.arity() : 1;
  const double factor = data_.weighted() ? static_cast<double>(power(scale, options_.derivative)) : 1;
  const Rational origin = scale * (position(output) + shift_) * power(Rational(mask_.arity()), phi_.level);
  const auto [first, last] = reach(output, scale);
  const long grid = numerator(power(Rational(mask_.arity()), phi_.level)).convert_to<long>();
  const long base = numerator(origin).convert_to<long>();
  std::vector<std::pair<const RoundedCombination*, double>> parts;
  std::size_t low = data_.count(), high = 0;
  for (long j = first; j <= last; ++j) {
    const Rational value = phi_.at(base - j * grid);
    if (value == 0) continue;
    parts.emplace_back(&rounded_datum(j), factor * static_cast<double>(value));
    for (const auto& [datum, weight] : parts.back().first->terms) {
      low = std::min(low, datum);
      high = std::max(high, datum);
    }
  }
  RoundedRow row;
  row.first = low;
  if (low <= high) row.weights.assign(high - low + 1, 0);
  for (const auto& [datum, value] : parts) {
    row.outside += value * datum->outside;
    for (const auto& [index, weight] : datum->terms) row.weights[index - low] += value * weight;
  }
  for (std::size_t k = 0; k < row.weights.size(); ++k)
    if (row.weights[k] != 0) row.variance += row.weights[k] * row.weights[k] / prior_weights_[low + k];
  return row;
}

template <class Visit>
void LinearSmoother::visit_rounded_rows(const Visit& visit) const {
  std::vector<std::optional<RoundedRow>> interior(scale_);
  std::optional<std::size_t> period;  // the whole position at which the interior rows were made
  for (std::size_t o = 0; o < outputs(); ++o) {
    if (data_.weighted() || !is_interior(o)) {
      visit(rounded_row(o), o, 0);
      continue;
    }
    auto& row = interior[o % scale_];
    if (!row) {
      if (!period) period = o / scale_;
      row = rounded_row(o);
      row->first -= o / scale_ - *period;  // as if it were made at `period`
    }
    visit(*row, o, o / scale_ - *period);
  }
}

std::vector<LinearSmoother::RoundedRow> LinearSmoother::rounded_rows() const {
  std::vector<RoundedRow> result;
  result.reserve(outputs());
  visit_rounded_rows([&](const RoundedRow& row, std::size_t, std::size_t shift) {
    result.push_back(row);
    result.back().first += shift;
  });
  return result;
}

LinearSmoother::Smoothed LinearSmoother::apply(const std::vector<double>& data) const {
  require(data.size() == data_.count(), "smoothing: need {} data, got {}", data_.count(), data.size());
  Smoothed result;
  result.values.reserve(outputs());
  result.variances.reserve(outputs());
  visit_rounded_rows([&](const RoundedRow& row, std::size_t output, std::size_t shift) {
    double sum = row.outside * options_.constant;
    for (std::size_t k = 0; k < row.weights.size(); ++k)
      if (row.weights[k] != 0) sum += row.weights[k] * data[row.first + shift + k];
    result.values.push_back(sum);
    result.variances.push_back(row.variance);
    const std::size_t own = output / scale_ - shift - row.first;  // wraps around where the datum lies before the row
    if (output % scale_ == 0) result.leverages.push_back(own < row.weights.size() ? row.weights[own] : 0);
  });
  return result;
}

}  // namespace subcert::data
