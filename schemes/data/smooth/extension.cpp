#include "extension.hpp"

#include "rounded_regression.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace subcert::data {
void Combination::add(const Combination& other, const Rational& factor) {
  if (factor == 0) return;
  for (const auto& [index, coefficient] : other.terms) terms[index] += factor * coefficient;
  outside += factor * other.outside;
}

ExtendedData::ExtendedData(const ExtensionRule& rule, DataSites sites) : rule_(rule), sites_(std::move(sites)) {
  const auto& [count, weights, positions, before] = sites_;
  require(count != 0, "ExtendedData: need count >= 1, got 0");
  require(rule.kind != Boundary::shrink, "ExtendedData: need a boundary that continues the data, got shrink");
  if (rule.window == 0 || rule.degree < 0) fail(ErrorKind::domain, "ExtendedData: need window >= 1 and degree >= 0");
  require(positions.empty() || positions.size() == count, "ExtendedData: need as many positions as data, got {} for {}",
          positions.size(), count);
  if (!positions.empty())
    require(positions.front() == 0 && std::is_sorted(positions.begin(), positions.end(), std::less_equal<>()),
            "ExtendedData: need positions that increase from 0");
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

const Combination& ExtendedData::fitted(long index) const {
  if (const auto found = fitted_.find(index); found != fitted_.end()) return found->second;
  std::vector<Rational> nodes, weights;
  const std::vector<std::size_t> data = fitted_data(index);
  for (const std::size_t i : data) {
    nodes.emplace_back(position(static_cast<long>(i)));
    if (weighted()) weights.push_back(sites_.weights[i]);
  }
  const std::vector<Rational> coefficients = regression_weights(nodes, weights, rule_.degree,
                                                                Rational(position(index)));
  Combination& result = fitted_[index];
  for (std::size_t k = 0; k < data.size(); ++k) result.terms[data[k]] = coefficients[k];
  return result;
}

RoundedCombination rounded(const Combination& combination) {
  RoundedCombination result;
  result.outside = static_cast<double>(combination.outside);
  for (const auto& [datum, weight] : combination.terms) result.terms.emplace_back(datum, static_cast<double>(weight));
  return result;
}

void RoundedCombination::add(const ExtendedData& data, long index, double factor) {
  if (data.is_inside(index)) {
    terms.emplace_back(static_cast<std::size_t>(index), factor);
    return;
  }
  const RoundedCombination datum = data.rounded_at(index);
  outside += factor * datum.outside;
  for (const auto& [i, weight] : datum.terms) terms.emplace_back(i, factor * weight);
}

RoundedCombination ExtendedData::rounded_at(long index) const {
  if (is_inside(index)) return {{{static_cast<std::size_t>(index), 1}}};
  if ((!weighted() && uniform()) || rule_.kind != Boundary::regression) return rounded(at(index));
  std::vector<double> nodes, weights;
  const std::vector<std::size_t> data = fitted_data(index);
  for (const std::size_t i : data) {
    nodes.push_back(position(static_cast<long>(i)) - position(index));
    weights.push_back(weighted() ? static_cast<double>(sites_.weights[i]) : 1);
  }
  const std::vector<double> coefficients = rounded_regression_weights(nodes, weights, rule_.degree, 0);
  RoundedCombination result;
  for (std::size_t k = 0; k < data.size(); ++k) result.terms.emplace_back(data[k], coefficients[k]);
  return result;
}

Combination ExtendedData::at(long index) const {
  if (is_inside(index)) return {{{static_cast<std::size_t>(index), 1}}};
  if (rule_.kind == Boundary::constant) return {{}, 1};
  if (rule_.kind == Boundary::regression) return fitted(index);
  return {{{source(index), 1}}};
}

const Rational& ExtendedData::weight(long index) const {
  static const Rational one = 1;
  if (!weighted()) return one;
  if (is_inside(index)) return sites_.weights[static_cast<std::size_t>(index)];
  if (rule_.kind == Boundary::constant || rule_.kind == Boundary::regression)
    return index < 0 ? mean_before_ : mean_after_;
  return sites_.weights[source(index)];
}

}  // namespace subcert::data
