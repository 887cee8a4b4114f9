#include "flint.hpp"

#include <stdexcept>

namespace subcert::flint {

Rational to_rational(const arf_t value) {
  if (!arf_is_finite(value)) throw std::domain_error("to_rational: need a finite float");
  Quotient exact;
  arf_get_fmpq(exact.get(), value);
  return to_rational(exact.get());
}

Enclosure Ball::enclosure(slong bits) const {
  if (!arb_is_finite(value_)) return {};
  arf_t low, high;
  arf_init(low);
  arf_init(high);
  arb_get_interval_arf(low, high, value_, bits);
  Enclosure result{to_rational(low), to_rational(high)};
  arf_clear(low);
  arf_clear(high);
  return result;
}

}  // namespace subcert::flint
