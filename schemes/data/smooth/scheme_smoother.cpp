#include "scheme_smoother.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <tuple>
#include <type_traits>

namespace subcert::data {
namespace {

constexpr int max_shift_level = 12;
constexpr std::size_t longest_number = 40;  // in messages

/// The smallest level on whose grid x lies.
int adic_level(const Rational& x, int arity) {
  for (int level = 0; level <= max_shift_level; ++level)
    if (denominator(Rational(x * power(Rational(arity), level))) == 1) return level;
  const std::string exact = to_text(x);
  fail(ErrorKind::domain, "smoothing: the data of this scheme stand at {} from the integers, no {}-adic number",
       exact.size() <= longest_number ? exact : to_decimal(x, 9, Rounding::nearest) + "...", arity);
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

const std::optional<LocalRegression>& checked_rules(const std::optional<LocalRegression>& rules, bool first_fit) {
  static const std::optional<LocalRegression> none;
  if (first_fit && !rules)
    fail(ErrorKind::domain,
         "smoothing: prior weights, missing data and given positions need a scheme of local regressions");
  return first_fit ? rules : none;
}

bool needs_fit(const DataSites& sites) { return !sites.weights.empty() || !sites.positions.empty(); }

}  // namespace

SmoothingKernel::SmoothingKernel(const Mask& mask, const std::optional<LocalRegression>& rules,
                                 const SmoothingOptions& options, bool first_fit)
    : mask_(mask),
      rules_(checked_rules(rules, first_fit)),
      reproduction_degree_(checked_reproduction(mask).reproduction_degree),
      shift_(checked_reproduction(mask).parametrization.front()),
      phi_(checked_values(mask, shift_, options)),
      fine_(first_fit ? mask.arity() : 1),
      factor_(power(Rational(fine_), options.derivative)),
      grid_(numerator(power(Rational(mask.arity()), phi_.level)).convert_to<long>()),
      scale_(numerator(power(Rational(mask.arity()), options.level)).convert_to<std::size_t>()),
      reach_(std::numeric_limits<long>::max(), std::numeric_limits<long>::min()) {
  for (const Rational& value : phi_.values) phi_rounded_.push_back(static_cast<double>(value));
  if (!options.places.empty()) limit_.emplace(mask, options.derivative);
  for (std::size_t p = 0; p < scale_; ++p) {
    const Rational position = Rational(p) / Rational(scale_);
    const auto [first, last] = reach_of(position);
    phases_.push_back({first, last, numerator(Rational(fine_ * (position + shift_) * grid_)).convert_to<long>()});
    for (long m = first; m <= last; ++m) {
      const auto [rule, group] = rule_of(m);
      reach_.first = std::min(reach_.first, group + (rules_ ? rules_->rules[rule].first : 0));
      reach_.second = std::max(reach_.second, group + (rules_ ? rules_->rules[rule].last : 0));
    }
  }
  if (!rules_) return;
  for (const RegressionRule& rule : rules_->rules) {
    auto& nodes = nodes_.emplace_back();
    for (long k = rule.first; k <= rule.last; ++k) nodes.push_back(static_cast<double>(Rational(k - rule.position)));
  }
}

ExtensionRule SmoothingKernel::extension(Boundary kind) const {
  const long length = mask_.symbol().length();
  return {kind, static_cast<std::size_t>((length + mask_.arity() - 1) / mask_.arity()), reproduction_degree_};
}

/// The data of level 0 or 1 with a value of phi at this position.
std::pair<long, long> SmoothingKernel::reach_of(const Rational& position) const {
  const Interval range = limit_support(mask_);
  const Rational x = fine_ * (position + shift_);
  return {ceil_index(x - range.upper), floor_index(x - range.lower)};
}

/// Which rule makes the datum of level 1 with this index, and the datum from which its window counts; the datum itself
/// without a first fit.
std::pair<std::size_t, long> SmoothingKernel::rule_of(long index) const {
  if (!rules_) return {0, index};
  const long offset = index - rules_->first_output;
  return {static_cast<std::size_t>(modulo(offset, fine_)), floor_divide(offset, fine_)};
}

SchemeSmoother::SchemeSmoother(const Mask& mask, const DataSites& sites, const SmoothingOptions& options,
                               const std::optional<LocalRegression>& rules)
    : SchemeSmoother(std::make_shared<SmoothingKernel>(mask, rules, options, needs_fit(sites)), sites, options) {}

SchemeSmoother::SchemeSmoother(std::shared_ptr<const SmoothingKernel> kernel, DataSites sites,
                               const SmoothingOptions& options)
    : LinearSmoother(kernel->extension(options.boundary), std::move(sites), options, kernel->scale_, kernel->reach_),
      kernel_(std::move(kernel)) {
  require(!options.at_data || data().uniform(),
          "smoothing: data that stand on no grid are places of their own for schemes");
}

/// The place of the datum is that of its rule on uniform data; its window, as many data about the same place.
template <class Number>
SchemeSmoother::Window<Number> SchemeSmoother::window_of(long index) const {
  auto [rule, group] = kernel_->rule_of(index);
  const RegressionRule& r = kernel_->rules_->rules[rule];
  Number place;
  if constexpr (std::is_same_v<Number, double>)
    place = static_cast<double>(group + r.first) - kernel_->nodes_[rule].front();
  else
    place = group + r.position;
  if (!data().uniform())
    group = static_cast<long>(
        std::floor(data().index_at(static_cast<double>(place)) - static_cast<double>(r.position) + 0.5));
  const auto points = static_cast<std::size_t>(r.last - r.first + 1);
  Window<Number> window{rule, std::move(place), group + r.first, std::vector<Number>(points), {}};
  for (std::size_t k = 0; k < points; ++k) {
    const long datum = window.first + static_cast<long>(k);
    window.weights[k] = prior_weight<Number>(datum);
    if (!r.weights.empty()) window.weights[k] *= static_cast<Number>(r.weights[k]);
    if (window.weights[k] > 0) window.kept.push_back(k);
  }
  const std::size_t needed = std::min(points, static_cast<std::size_t>(kernel_->rules_->degree) + 1);
  if (window.kept.size() < needed)
    fail(ErrorKind::data, "smoothing: {} of the {} data around datum {} are present, a fit of degree {} needs {}",
         window.kept.size(), points, group + 1 + static_cast<long>(data().sites().before), kernel_->rules_->degree,
         needed);
  return window;
}

template <class Number>
std::vector<Number> SchemeSmoother::fit_of(const Window<Number>& window) const {
  constexpr bool rounded = std::is_same_v<Number, double>;
  std::vector<Number> nodes, positive;
  for (const std::size_t k : window.kept) {
    if (rounded && data().uniform())  // far from the first datum too
      nodes.push_back(Number(kernel_->nodes_[window.rule][k]));
    else
      nodes.push_back(Number(data().position(window.first + static_cast<long>(k))) - window.place);
    positive.push_back(window.weights[k]);
  }
  return regression_weights(nodes, positive, kernel_->rules_->degree, 0);
}

/// The datum of level 0 or, from a fit with the prior weights, 1 with this index.
template <class Number>
Combination<Number> SchemeSmoother::level_datum(long index) const {
  if (!kernel_->rules_) return data().at<Number>(index);
  const auto window = window_of<Number>(index);
  const std::vector<Number> fit = fit_of(window);
  Combination<Number> sum;
  for (std::size_t k = 0; k < fit.size(); ++k)
    sum.add(data(), window.first + static_cast<long>(window.kept[k]), fit[k]);
  return sum;
}

/// Rows for outputs that go up; keeps the data of level 0 or 1.
template <class Number>
class SchemeSmoother::Rows : public RowMaker<Number> {
 public:
  explicit Rows(const SchemeSmoother& smoother) : smoother_(smoother), kernel_(*smoother.kernel_) {}

  RowOf<Number> row(std::size_t output) override {
    if (kernel_.limit_) return row_at(smoother_.rounded_position(output));
    const auto& phase = kernel_.phases_[output % smoother_.scale()];
    const long whole = kernel_.fine_ * static_cast<long>(output / smoother_.scale());
    make(whole + phase.first, whole + phase.last);
    const auto factor = static_cast<Number>(kernel_.factor_);
    const auto& phi = std::get<const std::vector<Number>&>(std::tie(kernel_.phi_.values, kernel_.phi_rounded_));
    parts_.clear();
    for (long j = phase.first; j <= phase.last; ++j) {
      const long index = phase.base - j * kernel_.grid_ - kernel_.phi_.first_index;
      if (index < 0 || index >= static_cast<long>(phi.size())) continue;
      const Number& value = phi[static_cast<std::size_t>(index)];
      if (value != 0) parts_.emplace_back(&data_[static_cast<std::size_t>(whole + j - first_)], factor * value);
    }
    return smoother_.to_row(parts_);
  }

 private:
  /// At the nearest arity-adic number.
  RowOf<Number> row_at(double position) {
    const AdicLimit& limit = *kernel_.limit_;
    const double whole = std::floor(position);
    const long nearest = std::lround((position - whole) * static_cast<double>(limit.points()));
    const Rational x = kernel_.fine_ * (Rational(nearest) / Rational(limit.points()) + kernel_.shift_);
    const long index = floor_index(x * Rational(limit.points()));
    const long start = kernel_.fine_ * static_cast<long>(whole) + floor_divide(index, limit.points()) - limit.first();
    const std::vector<Number> phi = limit.values<Number>(modulo(index, limit.points()));
    std::size_t first = 0, end = phi.size();
    while (first < end && phi[first] == 0) ++first;
    while (first < end && phi[end - 1] == 0) --end;
    make(start - static_cast<long>(end) + 1, start - static_cast<long>(first));
    const auto factor = static_cast<Number>(kernel_.factor_);
    parts_.clear();
    for (std::size_t k = end; k-- > first;)
      parts_.emplace_back(&data_[static_cast<std::size_t>(start - static_cast<long>(k) - first_)], factor * phi[k]);
    return smoother_.to_row(parts_);
  }

  /// Makes the data from first to last and forgets those before.
  void make(long first, long last) {
    while (!data_.empty() && first_ < first) {
      data_.pop_front();
      ++first_;
    }
    if (data_.empty()) first_ = first;
    for (long j = first_ + static_cast<long>(data_.size()); j <= last; ++j)
      data_.push_back(smoother_.level_datum<Number>(j));
  }

  const SchemeSmoother& smoother_;
  const SmoothingKernel& kernel_;
  std::deque<Combination<Number>> data_;
  long first_ = 0;
  std::vector<std::pair<const Combination<Number>*, Number>> parts_;
};

SmoothingRow SchemeSmoother::row(std::size_t output) const { return Rows<Rational>(*this).row(output); }

std::unique_ptr<LinearSmoother::RowMaker<double>> SchemeSmoother::row_maker() const {
  return std::make_unique<Rows<double>>(*this);
}

}  // namespace subcert::data
