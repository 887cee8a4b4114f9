#include "extension.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace subcert::data {
template <class Number>
void Combination<Number>::add(const ExtendedData& data, long index, const Number& factor) {
  if (data.is_inside(index)) {
    terms.emplace_back(static_cast<std::size_t>(index), factor);
    return;
  }
  const Combination datum = data.at<Number>(index);
  outside += factor * datum.outside;
  for (const auto& [i, weight] : datum.terms) terms.emplace_back(i, factor * weight);
}

template struct Combination<double>;
template struct Combination<Rational>;

ExtendedData::ExtendedData(const ExtensionRule& rule, DataSites sites) : rule_(rule), sites_(std::move(sites)) {
  const auto& [count, weights, positions, before, derivatives] = sites_;
  require(count != 0, "ExtendedData: need count >= 1, got 0");
  require(rule.kind != Boundary::shrink, "ExtendedData: need a boundary that continues the data, got shrink");
  if (rule.window == 0 || rule.degree < 0) fail(ErrorKind::domain, "ExtendedData: need window >= 1 and degree >= 0");
  require(positions.empty() || positions.size() == count, "ExtendedData: need as many positions as data, got {} for {}",
          positions.size(), count);
  if (!positions.empty())
    require(positions.front() == 0 && std::is_sorted(positions.begin(), positions.end()),
            "ExtendedData: need positions from 0 on, in order");
  require(derivatives >= 0 && count % kinds() == 0 && (derivatives == 0 || !positions.empty()),
          "ExtendedData: need positions, and {} data at each, got {} in all", kinds(), count);
  require(derivatives == 0 || rule.kind == Boundary::regression || rule.kind == Boundary::periodic,
          "smoothing: values with slopes need the boundary interp or wrap (regression, periodic), got {}",
          to_text(rule.kind));
  for (std::size_t i = 0; derivatives > 0 && i < count; ++i)
    require(positions[i] == positions[i - i % kinds()], "ExtendedData: need one position for a value and its slopes");
  if (weights.empty()) return;
  require(weights.size() == count, "ExtendedData: need as many weights as data, got {} for {}", weights.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    require(weights[i] >= 0, "ExtendedData: need weights >= 0");
    if (weights[i] > 0) present_.push_back(i);
  }
  require(!present_.empty(), "ExtendedData: need a positive weight");
  mean_before_ = mean_weight(-1);
  mean_after_ = mean_weight(static_cast<long>(count));
}

Rational ExtendedData::mean_weight(long index) const {
  Rational sum = 0;
  const std::vector<std::size_t> data = fitted_data(index);
  for (const std::size_t i : data) sum += sites_.weights[i];
  return sum / Rational(data.size());
}

int ExtendedData::order_of_many(long index) const {
  return static_cast<int>(modulo(index, static_cast<long>(kinds())));
}

double ExtendedData::position(long index) const {
  if (uniform()) return static_cast<double>(index);
  const auto n = static_cast<long>(count());
  const auto inside = [&](long i) { return sites_.positions[static_cast<std::size_t>(i)]; };
  if (is_inside(index)) return inside(index);
  const double length = sites_.positions.back();
  if (rule_.kind == Boundary::periodic)
    return static_cast<double>(floor_divide(index, n)) * (length + 1) + inside(modulo(index, n));
  if (rule_.kind == Boundary::reflect && n > 1) {
    const long turn = 2 * (n - 1), folded = modulo(index, turn);
    return static_cast<double>(floor_divide(index, turn)) * 2 * length +
           (folded < n ? inside(folded) : 2 * length - inside(turn - folded));
  }
  return index < 0 ? static_cast<double>(index) : length + static_cast<double>(index - n + 1);
}

double ExtendedData::index_at(double position) const {
  if (uniform()) return position;
  const auto last = static_cast<double>(count() - 1);
  const std::vector<double>& at = sites_.positions;
  const double length = at.back();
  const auto inside = [&](double x) {
    const auto next = std::upper_bound(at.begin(), at.end(), x);
    if (next == at.end()) return last + x - length;
    const auto i = static_cast<std::size_t>(next - at.begin()) - 1;
    return static_cast<double>(i) + (x - at[i]) / (at[i + 1] - at[i]);
  };
  if (position >= 0 && position <= length) return inside(position);
  if (rule_.kind == Boundary::periodic) {
    const double turn = std::floor(position / (length + 1));
    return turn * (last + 1) + inside(std::max(0.0, position - turn * (length + 1)));
  }
  if (rule_.kind == Boundary::reflect && last > 0) {
    const double turn = std::floor(position / (2 * length)), folded = std::max(0.0, position - turn * 2 * length);
    return turn * 2 * last +
           (folded <= length ? inside(folded) : 2 * last - inside(std::max(0.0, 2 * length - folded)));
  }
  return position < 0 ? position : last + position - length;
}

std::size_t ExtendedData::source(long index) const {
  const auto n = static_cast<long>(count());
  if (rule_.kind == Boundary::periodic) return static_cast<std::size_t>(modulo(index, n));
  if (rule_.kind == Boundary::reflect) {
    if (n == 1) return 0;
    const long folded = modulo(index, 2 * (n - 1));
    return static_cast<std::size_t>(std::min(folded, 2 * (n - 1) - folded));
  }
  if (present_.empty()) return index < 0 ? 0 : count() - 1;
  return index < 0 ? present_.front() : present_.back();
}

std::vector<std::size_t> ExtendedData::fitted_data(long index) const {
  const std::size_t available = present_.empty() ? count() : present_.size();
  const std::size_t used = std::min(rule_.window, available);
  std::vector<std::size_t> data;
  for (std::size_t k = 0; k < used; ++k) {
    const std::size_t rank = index < 0 ? k : available - used + k;
    data.push_back(present_.empty() ? rank : present_[rank]);
  }
  return data;
}

template <class Number>
Combination<Number> ExtendedData::fitted(long index) const {
  const std::vector<std::size_t> data = fitted_data(index);
  std::vector<Number> nodes, weights, fit;
  for (const std::size_t i : data) {
    nodes.push_back(Number(position(static_cast<long>(i))) - Number(position(index)));
    weights.push_back(weighted() ? static_cast<Number>(sites_.weights[i]) : Number(1));
  }
  if constexpr (std::is_same_v<Number, Rational>) {
    const auto [known, is_new] = fits_.try_emplace(index);
    if (is_new) known->second = regression_weights(nodes, weights, rule_.degree, 0);
    fit = known->second;
  } else {
    fit = regression_weights(nodes, weights, rule_.degree, 0);
  }
  Combination<Number> result;
  for (std::size_t k = 0; k < data.size(); ++k) result.terms.emplace_back(data[k], fit[k]);
  return result;
}

template <class Number>
Combination<Number> ExtendedData::at(long index) const {
  if (is_inside(index)) return {{{static_cast<std::size_t>(index), 1}}};
  if (rule_.kind == Boundary::constant) return {{}, 1};
  if (rule_.kind != Boundary::regression) return {{{source(index), 1}}};
  if (std::is_same_v<Number, Rational> || weighted() || !uniform()) return fitted<Number>(index);
  Combination<Number> rounded;
  for (const auto& [datum, weight] : fitted<Rational>(index).terms)
    rounded.terms.emplace_back(datum, static_cast<Number>(weight));
  return rounded;
}

template Combination<double> ExtendedData::at<double>(long) const;
template Combination<Rational> ExtendedData::at<Rational>(long) const;

const Rational& ExtendedData::weight(long index) const {
  static const Rational one = 1;
  if (!weighted()) return one;
  if (is_inside(index)) return sites_.weights[static_cast<std::size_t>(index)];
  if (rule_.kind == Boundary::constant || rule_.kind == Boundary::regression)
    return index < 0 ? mean_before_ : mean_after_;
  return sites_.weights[source(index)];
}

}  // namespace subcert::data
