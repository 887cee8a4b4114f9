#include "smoothing.hpp"

#include "rounded_regression.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/schemes/data/refine/weighted_sum.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <type_traits>

namespace subcert::data {
namespace {

constexpr int max_shift_level = 12;
constexpr std::size_t most_block_positions = 512;
constexpr std::size_t most_block_values = 8192;

/// The smallest level on whose grid x lies.
int adic_level(const Rational& x, int arity) {
  for (int level = 0; level <= max_shift_level; ++level)
    if (denominator(Rational(x * power(Rational(arity), level))) == 1) return level;
  fail(ErrorKind::domain, "smoothing: the data of this scheme stand at {} from the integers, no {}-adic number",
       to_text(x), arity);
}

PolynomialReproduction checked_reproduction(const Mask& mask) {
  PolynomialReproduction reproduction = polynomial_reproduction(mask);
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
  prior_weights_.assign(count, 1);
  if (data_.weighted())
    for (std::size_t i = 0; i < count; ++i) prior_weights_[i] = static_cast<double>(data_.weight(static_cast<long>(i)));
  prepare_rounded_rows();
}

/// What rounded_row() and interior_end() need of the exact numbers.
void LinearSmoother::prepare_rounded_rows() {
  for (const Rational& value : phi_.values) phi_rounded_.push_back(static_cast<double>(value));
  const long arity = mask_.arity();
  const Rational scale = data_.weighted() ? arity : 1, grid = power(Rational(arity), phi_.level);
  for (std::size_t p = 0; p < std::min(scale_, outputs()); ++p) {
    const auto [first, last] = reach(p, scale);
    phases_.push_back({first, last, numerator(Rational(scale * (position(p) + shift_) * grid)).convert_to<long>()});
    long low = first, high = last;
    if (data_.weighted()) {
      low = std::numeric_limits<long>::max();
      high = std::numeric_limits<long>::min();
      for (long m = first; m <= last; ++m) {
        const auto [rule, group] = rule_of(m);
        low = std::min(low, group + rules_->rules[rule].first);
        high = std::max(high, group + rules_->rules[rule].last);
      }
    }
    lowest_ = p == 0 ? low : std::min(lowest_, low);
    highest_ = p == 0 ? high : std::max(highest_, high);
  }
  if (!data_.weighted()) return;
  for (const RegressionRule& rule : rules_->rules) {
    auto& nodes = nodes_.emplace_back();
    for (long k = rule.first; k <= rule.last; ++k) nodes.push_back(static_cast<double>(Rational(k - rule.position)));
  }
  same_weight_until_.assign(data_.count(), data_.count());
  for (std::size_t i = data_.count() - 1; i-- > 0;)
    same_weight_until_[i] = prior_weights_[i] == prior_weights_[i + 1] ? same_weight_until_[i + 1] : i + 1;
}

std::size_t LinearSmoother::outputs() const { return (data_.count() - 1) * scale_ + 1; }

Rational LinearSmoother::position(std::size_t output) const { return Rational(output) / Rational(scale_); }

/// The integers j with a value of phi at scale * (position + shift) - j.
std::pair<long, long> LinearSmoother::reach(std::size_t output, const Rational& scale) const {
  const Interval range = limit_support(mask_);
  const Rational x = scale * (position(output) + shift_);
  return {ceil_index(x - range.upper), floor_index(x - range.lower)};
}

/// The first position from `whole` on whose outputs are not all composed from data inside of one weight; `whole` itself
/// where its own are not. The last position, which has one output alone, never counts as such.
std::size_t LinearSmoother::interior_end(std::size_t whole) const {
  const auto count = static_cast<long>(data_.count()), at = static_cast<long>(whole);
  if (at + lowest_ < 0 || at + highest_ >= count) return whole;
  const long end = same_weight_until_.empty()
                       ? count
                       : static_cast<long>(same_weight_until_[static_cast<std::size_t>(at + lowest_)]);
  return static_cast<std::size_t>(std::clamp(end - highest_, at, std::max(at, count - 1)));
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

/// Which rule makes the datum of level 1 with this index, and the datum from which its window counts.
std::pair<std::size_t, long> LinearSmoother::rule_of(long index) const {
  const long arity = mask_.arity();
  const long offset = index - rules_->first_output;
  return {static_cast<std::size_t>(modulo(offset, arity)), floor_divide(offset, arity)};
}

template <class Number>
LinearSmoother::Window<Number> LinearSmoother::window_of(long index) const {
  const auto [rule, group] = rule_of(index);
  const RegressionRule& r = rules_->rules[rule];
  const auto points = static_cast<std::size_t>(r.last - r.first + 1);
  Window<Number> window{rule, group + r.first, std::vector<Number>(points), {}};
  for (std::size_t k = 0; k < points; ++k) {
    const long datum = window.first + static_cast<long>(k);
    if (std::is_same_v<Number, double> && r.weights.empty() && data_.is_inside(datum))
      window.weights[k] = static_cast<Number>(prior_weights_[static_cast<std::size_t>(datum)]);
    else
      window.weights[k] = static_cast<Number>(
          Rational(data_.weight(datum) * (r.weights.empty() ? Rational(1) : r.weights[k])));
    if (window.weights[k] > 0) window.kept.push_back(k);
  }
  const std::size_t needed = std::min(points, static_cast<std::size_t>(rules_->degree) + 1);
  if (window.kept.size() < needed)
    fail(ErrorKind::data, "smoothing: {} of the {} data around datum {} are present, a fit of degree {} needs {}",
         window.kept.size(), points, group + 1, rules_->degree, needed);
  return window;
}

const std::vector<Rational>& LinearSmoother::fit_of(const Window<Rational>& window) const {
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
  const auto window = window_of<Rational>(index);
  const std::vector<Rational>& fit = fit_of(window);
  Combination sum;
  for (std::size_t k = 0; k < window.kept.size(); ++k)
    sum.add(data_.at(window.first + static_cast<long>(window.kept[k])), fit[k]);
  return sum;
}

/// refined_datum() in double precision.
RoundedCombination LinearSmoother::rounded_refined_datum(long index) const {
  const auto window = window_of<double>(index);
  std::vector<double> nodes, weights;
  for (const std::size_t k : window.kept) {
    nodes.push_back(nodes_[window.rule][k]);
    weights.push_back(window.weights[k]);
  }
  const std::vector<double> fit = rounded_regression_weights(nodes, weights, rules_->degree, 0);
  RoundedCombination sum;
  for (std::size_t k = 0; k < fit.size(); ++k) {
    const long at = window.first + static_cast<long>(window.kept[k]);
    if (data_.is_inside(at)) {
      sum.terms.emplace_back(static_cast<std::size_t>(at), fit[k]);
      continue;
    }
    const RoundedCombination datum = data_.rounded_at(at);
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

/// The data of level 0 or, with prior weights, of level 1 in double precision, for positions that go up.
class LinearSmoother::RoundedData {
 public:
  explicit RoundedData(const LinearSmoother& smoother) : smoother_(smoother) {}

  /// Makes those from first to last and forgets those before.
  void reach(long first, long last) {
    while (!data_.empty() && first_ < first) {
      data_.pop_front();
      ++first_;
    }
    if (data_.empty()) first_ = first;
    for (long j = first_ + static_cast<long>(data_.size()); j <= last; ++j)
      data_.push_back(smoother_.data_.weighted() ? smoother_.rounded_refined_datum(j) : smoother_.data_.rounded_at(j));
  }
  const RoundedCombination& operator[](long index) const { return data_[static_cast<std::size_t>(index - first_)]; }

 private:
  const LinearSmoother& smoother_;
  std::deque<RoundedCombination> data_;
  long first_ = 0;
};

/// row(), composed in double precision.
LinearSmoother::RoundedRow LinearSmoother::rounded_row(std::size_t output, RoundedData& data) const {
  const long arity = mask_.arity(), scale = data_.weighted() ? arity : 1;
  const double factor = data_.weighted() ? static_cast<double>(power(Rational(arity), options_.derivative)) : 1;
  const long grid = numerator(power(Rational(arity), phi_.level)).convert_to<long>();
  const Phase& phase = phases_[output % scale_];
  const long whole = scale * static_cast<long>(output / scale_);
  data.reach(whole + phase.first, whole + phase.last);
  std::vector<std::pair<const RoundedCombination*, double>> parts;
  std::size_t low = data_.count(), high = 0;
  for (long j = phase.first; j <= phase.last; ++j) {
    const long index = phase.base - j * grid - phi_.first_index;
    if (index < 0 || index >= static_cast<long>(phi_rounded_.size())) continue;
    const double value = phi_rounded_[static_cast<std::size_t>(index)];
    if (value == 0) continue;
    parts.emplace_back(&data[whole + j], factor * value);
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

template <class One, class Many>
void LinearSmoother::visit_rounded_rows(const One& one, const Many& many) const {
  RoundedData data(*this);
  std::vector<RoundedRow> interior;  // of one position
  std::size_t made_at = 0;
  for (std::size_t whole = 0; whole < data_.count();) {
    const std::size_t end = interior_end(whole);
    if (end == whole) {
      for (std::size_t o = whole * scale_; o < std::min((whole + 1) * scale_, outputs()); ++o)
        one(rounded_row(o, data), o);
      ++whole;
      continue;
    }
    const auto weight_at = [&](std::size_t at) {
      return prior_weights_[static_cast<std::size_t>(static_cast<long>(at) + lowest_)];
    };
    if (interior.empty() || weight_at(whole) != weight_at(made_at)) {
      interior.clear();
      made_at = whole;
      for (std::size_t p = 0; p < scale_; ++p) interior.push_back(rounded_row(whole * scale_ + p, data));
    }
    many(interior, whole - made_at, whole, end);
    whole = end;
  }
}

std::vector<LinearSmoother::RoundedRow> LinearSmoother::rounded_rows() const {
  std::vector<RoundedRow> result;
  result.reserve(outputs());
  visit_rounded_rows([&](RoundedRow row, std::size_t) { result.push_back(std::move(row)); },
                     [&](const std::vector<RoundedRow>& rows, std::size_t shift, std::size_t begin, std::size_t end) {
                       for (std::size_t whole = begin; whole < end; ++whole)
                         for (const RoundedRow& row : rows) {
                           result.push_back(row);
                           result.back().first += shift + whole - begin;
                         }
                     });
  return result;
}

/// Smoothed::path, row by row.
class LinearSmoother::PathLength {
 public:
  explicit PathLength(const std::vector<double>& prior_weights) : prior_weights_(prior_weights) {}

  void go_to(const RoundedRow& row, std::size_t shift) {
    if (row.variance == 0) return;
    if (last_.variance > 0) length_ += angle(last_, last_shift_, row, shift);
    last_ = row;
    last_shift_ = shift;
  }
  /// Through all rows, and again `times` - 1 times, each time one datum further: all of these data have one weight.
  void go_through(const std::vector<RoundedRow>& rows, std::size_t shift, std::size_t times) {
    for (const RoundedRow& row : rows) go_to(row, shift);
    if (times < 2) return;
    const auto first = std::find_if(rows.begin(), rows.end(), [](const RoundedRow& row) { return row.variance > 0; });
    if (first == rows.end()) return;
    PathLength once(prior_weights_);
    for (const RoundedRow& row : rows) once.go_to(row, shift);
    once.go_to(*first, shift + 1);
    length_ += static_cast<double>(times - 1) * once.length_;
    last_shift_ = shift + times - 1;
  }
  double length() const { return length_; }

 private:
  /// Between two rows as lines, from the distance of unit vectors, which does not cancel where they are near.
  double angle(const RoundedRow& a, std::size_t a_shift, const RoundedRow& b, std::size_t b_shift) const {
    const std::size_t low = std::min(a.first + a_shift, b.first + b_shift);
    const std::size_t high = std::max(a.first + a_shift + a.weights.size(), b.first + b_shift + b.weights.size());
    const double a_norm = 1 / std::sqrt(a.variance), b_norm = 1 / std::sqrt(b.variance);
    const auto at = [](const RoundedRow& row, std::size_t datum) {
      return datum < row.weights.size() ? row.weights[datum] : 0;  // wraps around before the row
    };
    double apart = 0, opposite = 0;
    for (std::size_t i = low; i < high; ++i) {
      const double x = at(a, i - a_shift - a.first) * a_norm, y = at(b, i - b_shift - b.first) * b_norm;
      if (x == 0 && y == 0) continue;
      apart += (x - y) * (x - y) / prior_weights_[i];
      opposite += (x + y) * (x + y) / prior_weights_[i];
    }
    return 2 * std::asin(std::min(1.0, std::sqrt(std::min(apart, opposite)) / 2));
  }

  const std::vector<double>& prior_weights_;
  double length_ = 0;
  RoundedRow last_;
  std::size_t last_shift_ = 0;
};

LinearSmoother::Smoothed LinearSmoother::apply(const std::vector<double>& data) const {
  require(data.size() == data_.count(), "smoothing: need {} data, got {}", data_.count(), data.size());
  Smoothed result{std::vector<double>(outputs()), std::vector<double>(outputs()), std::vector<double>(data.size())};
  PathLength path(prior_weights_);
  const auto leverage = [](const RoundedRow& row, std::size_t datum, std::size_t shift) {
    const std::size_t own = datum - shift - row.first;  // wraps around where the datum lies before the row
    return own < row.weights.size() ? row.weights[own] : 0;
  };
  const auto one = [&](const RoundedRow& row, std::size_t output) {
    double sum = row.outside * options_.constant;
    for (std::size_t k = 0; k < row.weights.size(); ++k)
      if (row.weights[k] != 0) sum += row.weights[k] * data[row.first + k];
    result.values[output] = sum;
    result.variances[output] = row.variance;
    path.go_to(row, 0);
    if (output % scale_ == 0) result.leverages[output / scale_] = leverage(row, output / scale_, 0);
  };
  // Positions that are computed phase by phase, so that sums and rows stay in the nearest cache.
  const std::size_t block = std::clamp<std::size_t>(most_block_values / scale_, 1, most_block_positions);
  std::vector<double> parts(scale_ <= outputs() ? scale_ * block : 0);
  const auto many = [&](const std::vector<RoundedRow>& rows, std::size_t shift, std::size_t begin, std::size_t end) {
    for (std::size_t first = begin; first < end; first += block) {
      const std::size_t size = std::min(block, end - first);
      for (std::size_t p = 0; p < scale_; ++p) {
        const RoundedRow& row = rows[p];
        double* const sums = parts.data() + p * block;
        std::fill_n(sums, size, row.outside * options_.constant);
        if (!row.weights.empty())
          weighted_sum(data.data() + row.first + shift + (first - begin), 1, row.weights.data(), row.weights.size(),
                       size, sums, true);
      }
      interleave(parts.data(), block, scale_, size, 1, result.values.data() + first * scale_);
    }
    path.go_through(rows, shift, end - begin);
    double* variance = result.variances.data() + begin * scale_;
    for (std::size_t whole = begin; whole < end; ++whole) {
      for (const RoundedRow& row : rows) *variance++ = row.variance;
      result.leverages[whole] = leverage(rows.front(), begin, shift);
    }
  };
  visit_rounded_rows(one, many);
  result.path = path.length();
  return result;
}

}  // namespace subcert::data
