#include "cost.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::radius {
namespace {

double bits_of(const Rational& value) { return value == 0 ? 0 : std::abs(static_cast<double>(binary_exponent(value))); }

}  // namespace

bool has_time_for_roots(const LaurentPolynomial& p, const Deadline& deadline) {
  // Measured to 320 bits: degree 64 with coefficients of 700 bits 0.9 s, of 13000 bits 6 s; degree 128 with 1500 bits
  // 5.6 s, with 13000 bits 50 s. Factors and divisors took less.
  double bits = 0;
  for (const Integer& c : p.numerators()) bits = std::max(bits, bits_of(Rational(c)));
  return 3e-6 * std::pow(static_cast<double>(p.length()), 3) * (1 + bits / 2000) <= deadline.remaining();
}

bool has_time_for_elimination(const RationalMatrix& matrix, const Deadline& deadline) {
  // As many primes as the numbers of the solution ask for. Measured: size 256 with entries of 10 bits 0.3 s, size 128
  // with 100 bits 0.2 s.
  double bits = 10;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) bits = std::max(bits, 10 + bits_of(matrix(i, j)));
  return 2e-11 * std::pow(static_cast<double>(matrix.rows()), 4) * bits <= deadline.remaining();
}

}  // namespace subcert::radius
