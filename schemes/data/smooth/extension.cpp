#include "extension.hpp"

#include "rounded_regression.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <algorithm>

namespace subcert::data {
void Combination::add(const Combination& other, const Rational& factor) {
  if (factor == 0) return;
  for (const auto& [index, coefficient] : other.terms) terms[index] += factor * coefficient;
  outside += factor * other.outside;
}

ExtendedData::ExtendedData(const ExtensionRule& rule, std::size_t count, std::vector<Rational> weights)
    : rule_(rule), count_(count), weights_(std::move(weights)) {
  require(count != 0, "ExtendedData: need count >= 1, got 0");
  require(rule.kind != Boundary::shrink, "ExtendedData: need a boundary that continues the data, got shrink");
  if (rule.window == 0 || rule.degree < 0) fail(ErrorKind::domain, "ExtendedData: need window >= 1 and degree >= 0");
  if (weights_.empty()) return;
  require(weights_.size() == count, "ExtendedData: need as many weights as data, got {} for {}", weights_.size(),
          count);
  Rational sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    require(weights_[i] >= 0, "ExtendedData: need weights >= 0");
    if (weights_[i] > 0) present_.push_back(i);
    sum += weights_[i];
  }
  require(!present_.empty(), "ExtendedData: need a positive weight");
  mean_weight_ = sum / Rational(present_.size());
}

std::size_t ExtendedData::source(long index) const {
  const auto n = static_cast<long>(count_);
  if (rule_.kind == Boundary::periodic) return static_cast<std::size_t>(modulo(index, n));
  if (rule_.kind == Boundary::reflect) {
    if (n == 1) return 0;
    const long folded = modulo(index, 2 * (n - 1));
    return static_cast<std::size_t>(std::min(folded, 2 * (n - 1) - folded));
  }
  if (present_.empty()) return index < 0 ? 0 : count_ - 1;
  return index < 0 ? present_.front() : present_.back();
}

std::vector<std::size_t> ExtendedData::fitted_data(long index) const {
  const std::size_t available = present_.empty() ? count_ : present_.size();
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
    nodes.emplace_back(i);
    if (weighted()) weights.push_back(weights_[i]);
  }
  const std::vector<Rational> coefficients = regression_weights(nodes, weights, rule_.degree, Rational(index));
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

RoundedCombination ExtendedData::rounded_at(long index) const {
  if (is_inside(index)) return {{{static_cast<std::size_t>(index), 1}}};
  if (!weighted() || rule_.kind != Boundary::regression) return rounded(at(index));
  std::vector<double> nodes, weights;
  const std::vector<std::size_t> data = fitted_data(index);
  for (const std::size_t i : data) {
    nodes.push_back(static_cast<double>(static_cast<long>(i) - index));
    weights.push_back(static_cast<double>(weights_[i]));
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

Rational ExtendedData::weight(long index) const {
  if (!weighted()) return 1;
  if (is_inside(index)) return weights_[static_cast<std::size_t>(index)];
  if (rule_.kind == Boundary::constant || rule_.kind == Boundary::regression) return mean_weight_;
  return weights_[source(index)];
}

}  // namespace subcert::data
