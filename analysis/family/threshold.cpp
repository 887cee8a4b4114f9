#include "threshold.hpp"

#include <cmath>

namespace subcert::family {

Threshold::Threshold(const RangeProperty& property, int arity, int rules) : arity_(arity), exponent_(rules) {
  if (property.kind == RangeProperty::Kind::smooth || property.kind == RangeProperty::Kind::holder)
    exponent_ -= property.order;
}

double Threshold::value() const { return std::pow(arity_, exponent_.convert_to<double>()); }

Enclosure Threshold::raised(long length) const {
  const Rational exponent = exponent_ * Rational(length);
  const long top = numerator(exponent).convert_to<long>(), root = denominator(exponent).convert_to<long>();
  if (root == 1) return Enclosure::exactly(power(Rational(arity_), top));
  Enclosure modulus = root_enclosure(power(Rational(arity_), std::abs(top)), static_cast<int>(root));
  if (top >= 0) return modulus;
  return {1 / *modulus.upper, 1 / *modulus.lower};
}

}  // namespace subcert::family
