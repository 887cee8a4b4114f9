#pragma once
/// Exact numbers as those of Boost.Multiprecision, and back: for its floats, and for programs that use it.

#include "rational.hpp"

#include <boost/multiprecision/gmp.hpp>

namespace subcert {

inline boost::multiprecision::mpz_int to_boost(const Integer& value) {
  return boost::multiprecision::mpz_int(const_cast<mpz_ptr>(value.get()));
}
inline boost::multiprecision::mpq_rational to_boost(const Rational& value) {
  return boost::multiprecision::mpq_rational(const_cast<mpq_ptr>(value.get()));
}
inline Integer from_boost(const boost::multiprecision::mpz_int& value) { return Integer(value.backend().data()); }
inline Rational from_boost(const boost::multiprecision::mpq_rational& value) {
  return Rational(value.backend().data());
}

}  // namespace subcert
