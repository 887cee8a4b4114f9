#include "balls.hpp"

#if __has_include(<flint/acb_poly.h>)
#include <flint/acb_poly.h>
#else
#include <acb_poly.h>
#endif

#include <algorithm>
#include <cstdlib>

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

RationalComplex exact_middle(const ComplexBall& a) {
  return {flint::to_rational(arb_midref(acb_realref(a.get()))), flint::to_rational(arb_midref(acb_imagref(a.get())))};
}

ComplexBall ball_around(const RationalComplex& value, slong bits) {
  ComplexBall result(bits);
  acb_set_arb_arb(result.get(), Ball(value.re, bits).get(), Ball(value.im, bits).get());
  return result;
}

}  // namespace subcert
