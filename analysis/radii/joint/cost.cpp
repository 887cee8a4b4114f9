#include "cost.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace subcert::radius {
namespace {

double bits_of(const Rational& value) { return value == 0 ? 0 : std::abs(static_cast<double>(binary_exponent(value))); }

/// Of the numerator or the denominator.
double bits_of_parts(const Rational& value) {
  return value == 0 ? 0 : static_cast<double>(std::max(msb(abs(numerator(value))), msb(denominator(value))));
}

/// About the binary logarithm of the largest modulus of a zero that is not 0 over the smallest. Domain: not all zero.
double spread_of_zeros(const std::vector<Integer>& coefficients) {
  std::vector<std::pair<double, double>> logarithms;  // of those that are not 0, with their place
  for (std::size_t i = 0; i < coefficients.size(); ++i)
    if (coefficients[i] != 0) logarithms.emplace_back(i, binary_exponent(Rational(coefficients[i])));
  constexpr double none = -std::numeric_limits<double>::infinity();
  double largest = none, smallest = none;  // of a zero and of the inverse of one
  const auto [first, lowest] = logarithms.front();
  const auto [last, highest] = logarithms.back();
  for (const auto& [place, value] : logarithms) {
    if (place < last) largest = std::max(largest, (value - highest) / (last - place));
    if (place > first) smallest = std::max(smallest, (value - lowest) / (place - first));
  }
  return std::max(0.0, largest + smallest);
}

}  // namespace

bool has_long_characteristic(const RationalMatrix& matrix) {
  // Measured: size 114 with rows of 180 bits 0.75 s.
  double bits = 0;
  for (std::size_t i = 0; i < matrix.rows(); ++i) {
    double most = 0;
    for (std::size_t j = 0; j < matrix.columns(); ++j) most = std::max(most, bits_of_parts(matrix(i, j)));
    bits += most;
  }
  return bits * std::pow(static_cast<double>(matrix.rows()), 2) > 1e7;
}

bool has_time_for_eigenpair(std::size_t size, const RationalComplex& near, const Deadline& deadline) {
  // Measured: size 50 0.012 s, 100 0.09 s, 200 0.5 s, and over twice as much for numbers that are not real: 0.03, 0.2
  // and 1.3 s. It ends between two of its steps with nothing once the deadline has passed.
  return (near.im == 0 ? 9.5e-8 : 2.2e-7) * std::pow(static_cast<double>(size), 3) <= deadline.remaining();
}

bool has_time_for_roots(const LaurentPolynomial& p, const Deadline& deadline) {
  // Measured to 320 bits: degree 64 with coefficients of 700 bits 0.9 s, of 13000 bits 6 s; degree 128 with 1500 bits
  // 5.6 s, with 13000 bits 50 s. Factors and divisors took less. Small zeros that lie near each other beside large ones
  // ask for more bits: degree 15, 4000 bits, zeros from 10^-40 to 10^80 4.2 s.
  double bits = 0;
  const std::vector<Integer> numerators = p.numerators();
  for (const Integer& c : numerators) bits = std::max(bits, bits_of(Rational(c)));
  const double spread = 1 + spread_of_zeros(numerators) / 50;
  return 3e-6 * std::pow(static_cast<double>(p.length()), 3) * (1 + bits / 2000) * spread * spread <=
         deadline.remaining();
}

bool has_time_for_elimination(const RationalMatrix& matrix, const Deadline& deadline) {
  // As many primes as the numbers of the solution ask for. Measured: size 256 with entries of 10 bits 0.3 s, size 128
  // with 100 bits 0.2 s. Below size 25 FLINT eliminates without fractions: size 12 with entries of 1600 bits 0.006 s,
  // of 6400 bits 0.05 s, size 6 with 6400 bits 0.0022 s.
  constexpr std::size_t largest_without_fractions = 24;
  double bits = 10;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) bits = std::max(bits, 10 + bits_of_parts(matrix(i, j)));
  const auto size = static_cast<double>(matrix.rows());
  const double modular = 2e-11 * std::pow(size, 4) * bits;
  const double without_fractions = matrix.rows() <= largest_without_fractions
                                       ? 1e-12 * std::pow(size, 4.5) * std::pow(bits, 1.54)
                                       : 0;
  return modular + without_fractions <= deadline.remaining();
}

}  // namespace subcert::radius
