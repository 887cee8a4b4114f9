#include "field_values.hpp"

#include <utility>

namespace subcert {

FieldValues by_points(const LatticeSequence& values, std::size_t components, long root) {
  FieldValues result;
  for (const auto& [index, value] : values) {
    const LatticePoint point(index.begin(), std::prev(index.end()));
    const auto part = static_cast<std::size_t>(index.back());
    QuadraticNumber& number = result.try_emplace(point, components).first->second[part % components];
    if (value == 0) continue;
    if (part < components) {
      number.rational = value;
    } else {
      number.multiple = value;
      number.root = root;
    }
  }
  return result;
}

FieldValues limit_values(const LatticeMask& mask, const std::optional<QuadraticMask>& meant,
                         const LatticeSequence& values, int level, const LatticePoint& orders) {
  return by_points(limit_values(meant ? meant->doubled : mask, values, level, orders), mask.components(),
                   meant ? meant->root : 0);
}

LatticeSequence normalised(const LatticeSequence& values, std::size_t components, long root) {
  const FieldValues points = by_points(values, components, root);
  QuadraticNumber sum, first;
  for (const auto& [point, numbers] : points)
    for (const QuadraticNumber& number : numbers) {
      sum.rational += number.rational;
      sum.multiple += number.multiple;
      if (first.is_zero()) first = number;
    }
  sum.root = sum.multiple == 0 ? 0 : root;
  const QuadraticNumber& scale = sum.is_zero() ? first : sum;
  LatticeSequence result;
  for (const auto& [point, numbers] : points)
    for (std::size_t c = 0; c < components; ++c) {
      const QuadraticNumber number = numbers[c] / scale;
      LatticePoint index = point;
      index.push_back(static_cast<long>(c));
      if (number.rational != 0) result.emplace(index, number.rational);
      index.back() += static_cast<long>(components);
      if (number.multiple != 0) result.emplace(std::move(index), number.multiple);
    }
  return result;
}

Rational rounded(const QuadraticNumber& number, long bits) {
  if (number.multiple == 0) return number.rational;
  const Rational part = number.multiple * rounded_root(number.root, bits);
  // Where both parts cancel, by the norm: p + q r = (p^2 - q^2 D) / (p - q r).
  if ((number.rational < 0) == (number.multiple < 0) || number.rational == 0) return number.rational + part;
  const Rational norm = number.rational * number.rational - number.root * number.multiple * number.multiple;
  return norm / (number.rational - part);
}

}  // namespace subcert
