#pragma once
/// Owners for the FLINT and Arb types that the sources (never the public headers) use, and their conversions to and
/// from the numbers of the interface. Hides the difference between FLINT 2 with Arb apart and FLINT 3.

#include <subcert/analysis/symbol/support/error.hpp>
#include "numbers.hpp"

#if __has_include(<flint/arb.h>)
#include <flint/acb.h>
#include <flint/acb_calc.h>
#include <flint/arb.h>
#include <flint/arb_fmpz_poly.h>
#else
#include <acb.h>
#include <acb_calc.h>
#include <arb.h>
#include <arb_fmpz_poly.h>
#endif
#include <flint/flint.h>
#include <flint/fmpq.h>
#include <flint/fmpq_mat.h>
#include <flint/fmpq_mpoly.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly.h>

#include <cstddef>
#include <utility>

namespace subcert::flint {

inline void set(fmpz_t target, const Integer& value) { fmpz_set_mpz(target, value.get()); }

inline Integer to_integer(const fmpz_t value) {
  Integer result;
  fmpz_get_mpz(result.get(), value);
  return result;
}

inline void set(fmpq_t target, const Rational& value) { fmpq_set_mpq(target, value.get()); }

inline Rational to_rational(const fmpq_t value) {
  Rational result;
  fmpq_get_mpq(result.get(), value);
  return result;
}

class Whole {
 public:
  Whole() { fmpz_init(value_); }
  explicit Whole(const Integer& value) : Whole() { set(value_, value); }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;
  ~Whole() { fmpz_clear(value_); }
  fmpz* get() { return value_; }
  const fmpz* get() const { return value_; }

 private:
  fmpz_t value_;
};

class Quotient {
 public:
  Quotient() { fmpq_init(value_); }
  explicit Quotient(const Rational& value) : Quotient() { set(value_, value); }
  Quotient(const Quotient&) = delete;
  Quotient& operator=(const Quotient&) = delete;
  ~Quotient() { fmpq_clear(value_); }
  fmpq* get() { return value_; }

 private:
  fmpq_t value_;
};

/// Of integers, row by row.
class WholeMatrix {
 public:
  WholeMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  WholeMatrix(const WholeMatrix&) = delete;
  WholeMatrix(WholeMatrix&& other) noexcept : WholeMatrix(0, 0) { fmpz_mat_swap(value_, other.value_); }
  WholeMatrix& operator=(WholeMatrix other) noexcept {
    fmpz_mat_swap(value_, other.value_);
    return *this;
  }
  ~WholeMatrix() { fmpz_mat_clear(value_); }
  fmpz_mat_struct* get() { return value_; }
  const fmpz_mat_struct* get() const { return value_; }
  fmpz* entry(std::size_t i, std::size_t j = 0) {
    return fmpz_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

 private:
  fmpz_mat_t value_;
};

/// The exact value of a finite binary float.
Rational to_rational(const arf_t value);

}  // namespace subcert::flint
