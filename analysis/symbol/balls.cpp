#include "balls.hpp"

namespace subcert {

Enclosure Ball::enclosure(slong bits) const {
  if (!arb_is_finite(value_)) return {};
  arf_t low, high;
  arf_init(low);
  arf_init(high);
  arb_get_interval_arf(low, high, value_, bits);
  Enclosure result{flint::to_rational(low), flint::to_rational(high)};
  arf_clear(low);
  arf_clear(high);
  return result;
}

}  // namespace subcert
