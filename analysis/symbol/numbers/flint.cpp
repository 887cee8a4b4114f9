#include "flint.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert::flint {

Rational to_rational(const arf_t value) {
  if (!arf_is_finite(value)) fail(ErrorKind::domain, "to_rational: need a finite float");
  Quotient exact;
  arf_get_fmpq(exact.get(), value);
  return to_rational(exact.get());
}

}  // namespace subcert::flint
