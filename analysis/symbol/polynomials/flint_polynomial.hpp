#pragma once
/// Owners for FLINT's polynomials. Inner header.

#include "laurent_polynomial.hpp"

#include <subcert/analysis/symbol/numbers/flint.hpp>

namespace subcert::flint {

/// The numerators of a Laurent polynomial, from its lowest exponent on: an integer polynomial with the same zeros but
/// 0.
class IntegerPolynomial {
 public:
  explicit IntegerPolynomial(const LaurentPolynomial& p) {
    fmpz_poly_init(value_);
    slong index = 0;
    for (const Integer& c : p.numerators()) fmpz_poly_set_coeff_fmpz(value_, index++, Whole(c).get());
  }
  IntegerPolynomial() { fmpz_poly_init(value_); }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  ~IntegerPolynomial() { fmpz_poly_clear(value_); }
  fmpz_poly_struct* get() { return value_; }
  const fmpz_poly_struct* get() const { return value_; }

 private:
  fmpz_poly_t value_;
};

}  // namespace subcert::flint
