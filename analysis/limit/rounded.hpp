#pragma once
/// Double precision with proved error bounds, for vectors and polynomials on cells (docs/limit-enclosures.md, section
/// 6).

#include <subcert/analysis/symbol/numbers.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace subcert::rounded {

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

/// The operator of a mask whose coefficients start at index 0, on vectors of its width, in double precision.
class Transition {
 public:
  Transition(const std::vector<Rational>& coefficients, int arity)
      : arity_(arity),
        top_(static_cast<long>(coefficients.size()) - 1),
        width_(std::max(1L, (top_ + arity - 2) / (arity - 1))),
        cosets_(static_cast<std::size_t>(arity)) {
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
      reversed_.push_back(to_double(coefficients[coefficients.size() - 1 - i]));
      cosets_[i % cosets_.size()].push_back(to_double(coefficients[i]));
    }
  }

  std::size_t width() const { return static_cast<std::size_t>(width_); }

  /// out = T_t in, (T_t)_{ji} = b_{arity j + t - i}.
  void apply(const double* in, long t, double* __restrict out) const {
    std::fill(out, out + width_, 0.0);
    for (long i = 0; i < width_; ++i) {
      const long residue = (((t - i) % arity_) + arity_) % arity_, offset = (t - i - residue) / arity_;
      const std::vector<double>& coset = cosets_[static_cast<std::size_t>(residue)];
      const long first = std::max(0L, -offset), last = std::min(width_, static_cast<long>(coset.size()) - offset);
      const double factor = in[i];
      const double* entries = coset.data();
      for (long j = first; j < last; ++j) out[j] += factor * entries[j + offset];
    }
  }

  /// out = transposed T_t in.
  void apply_transposed(const double* in, long t, double* __restrict out) const {
    std::fill(out, out + width_, 0.0);
    for (long j = 0; j < width_; ++j) {
      const long shift = top_ - (arity_ * j + t);  // b_{arity j + t - i} = reversed_[shift + i]
      const long first = std::max(0L, -shift), last = std::min(width_, top_ + 1 - shift);
      const double factor = in[j];
      const double* entries = reversed_.data();
      for (long i = first; i < last; ++i) out[i] += factor * entries[i + shift];
    }
  }

 private:
  long arity_;
  long top_;
  long width_;
  std::vector<double> reversed_;
  std::vector<std::vector<double>> cosets_;
};

}  // namespace subcert::rounded
