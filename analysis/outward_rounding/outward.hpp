#pragma once
/// Where bounds are rounded outward: double precision with proved error bounds, for numbers, vectors and polynomials on
/// cells (docs/limit-enclosures.md, section 6).

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace subcert::outward {

/// Above the exact value of a sum of at most 2^12 products of non-negative numbers that was rounded to nearest.
inline double up(double x) { return x * (1 + 0x1p-40) + 0x1p-1000; }
inline double down(double x) { return x - std::abs(x) * 0x1p-40 - 0x1p-1000; }

/// Relative error of sums of n products whose factors took part in at most 28 roundings more.
inline double gamma(std::size_t n) { return static_cast<double>(n + 32) * 0x1p-53; }

inline double to_double(const Rational& value) { return value.convert_to<double>(); }
inline double to_double_above(const Rational& value) { return up(std::abs(to_double(value))); }

inline double dot(const double* x, const double* y, std::size_t n) {
  double sums[4] = {0, 0, 0, 0};
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (std::size_t j = 0; j < 4; ++j) sums[j] += x[i + j] * y[i + j];
  for (; i < n; ++i) sums[0] += x[i] * y[i];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

inline double largest(const double* x, std::size_t n) {
  double result = 0;
  for (std::size_t i = 0; i < n; ++i) result = std::max(result, std::abs(x[i]));
  return result;
}

inline double one_norm(const double* x, std::size_t n) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += std::abs(x[i]);
  return up(sum);
}

inline std::int64_t int_power(int base, int exponent) {
  std::int64_t result = 1;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

inline double half_power(std::size_t j) { return std::ldexp(1.0, -static_cast<int>(j)); }

inline double real_power(int base, int exponent) { return std::pow(static_cast<double>(base), exponent); }

/// A polynomial in u with vectors for coefficients, one after the other, and bounds for the 1-norms of their errors.
struct VectorPolynomial {
  std::vector<double> coefficients;
  std::vector<double> errors;
  std::vector<double> norms;  // above the 1-norms of the coefficients, where they are needed
};

/// p((u + delta) / arity) for polynomials p in u: matrix of the coefficients, row i holds what enters u^i.
class Recentring {
 public:
  Recentring(int arity, int digit, std::size_t size) : size_(size), entries_(size * size, 0.0) {
    const Rational delta = Rational(2 * digit + 1 - arity) / 2;
    for (std::size_t j = 0; j < size; ++j) {
      Rational term = power(Rational(arity), -static_cast<long>(j));  // binomial(j, i) delta^(j-i) / arity^j
      for (std::size_t i = j;; --i) {
        entries_[i * size + j] = to_double(term);
        if (i == 0) break;
        term *= delta * Rational(static_cast<long>(i)) / Rational(static_cast<long>(j - i + 1));
      }
    }
  }
  double operator()(std::size_t i, std::size_t j) const { return entries_[i * size_ + j]; }

 private:
  std::size_t size_;
  std::vector<double> entries_;
};

}  // namespace subcert::outward
