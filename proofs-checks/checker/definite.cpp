#include "definite.hpp"

#include <algorithm>
#include <cmath>

namespace subcert_check {
namespace {

mpz_class floor_root(const mpz_class& x) { return sqrt(x); }
double floor_root(double x) { return std::floor(std::sqrt(x)); }

/// floor(-x / by) for n numbers x.
void divide(mpz_class* row, const mpz_class& by, std::size_t n) {
  for (std::size_t j = 0; j < n; ++j) {
    row[j] = -row[j];
    mpz_fdiv_q(row[j].get_mpz_t(), row[j].get_mpz_t(), by.get_mpz_t());
  }
}
void divide(double* row, double by, std::size_t n) {
  const auto divided = [by](double x) { return std::floor(-x / by); };
  std::transform(row, row + n, row, divided);
}

}  // namespace

void add_multiples(mpz_class* sum, const mpz_class* factors, std::size_t step, const mpz_class* rows,
                   std::size_t row_step, std::size_t count, std::size_t n, Arithmetic& arithmetic) {
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t j = 0; j < n; ++j) arithmetic.add_product(sum[j], factors[k * step], rows[k * row_step + j]);
}

void add_multiples(double* sum, const double* factors, std::size_t step, const double* rows, std::size_t row_step,
                   std::size_t count, std::size_t n, Arithmetic&) {
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4) {  // four rows at once, and two of their numbers: so it takes half the time
    const double *f = factors + k * step, *r = rows + k * row_step;
    const double f0 = f[0], f1 = f[step], f2 = f[2 * step], f3 = f[3 * step];
    const double *r1 = r + row_step, *r2 = r1 + row_step, *r3 = r2 + row_step;
    for (std::size_t j = 0; j < n; ++j) sum[j] += f0 * r[j] + f1 * r1[j] + f2 * r2[j] + f3 * r3[j];
  }
  for (; k < count; ++k)
    for (std::size_t j = 0; j < n; ++j) sum[j] += factors[k * step] * rows[k * row_step + j];
}

Vector gram(const Vector& m, std::size_t n, Arithmetic& arithmetic) {
  Vector result(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i; j < n; ++j) add_multiples(&result[i * n + j], &m[i * n], 1, &m[j * n], 1, n, 1, arithmetic);
  return result;
}

// An x_jj that is not positive before it is complete is not positive afterwards. So, with doubles, the sums of the
// R_lj^2 that are used are below U_jj <= 2^48, and |x_kj| <= 2^49 by Cauchy and Schwarz. As divisors and roots are at
// most 2^24, a quotient that is no integer is farther from one than rounding leads, and so is a root. A square of some
// R_kj may be rounded, where it is above 2^53: then x_jj is negative.
template <class Number>
bool is_decomposed(Number* s, std::size_t n, Arithmetic& arithmetic) {
  for (std::size_t k = 0; k < n; ++k) {
    Number *const row = s + k * n, *const right = row + k + 1;
    add_multiples(right, s + k, n, s + k + 1, n, k, n - k - 1, arithmetic);
    if (row[k] >= 0) return false;
    divide(right, floor_root(Number(-row[k])), n - k - 1);
    for (std::size_t j = k + 1; j < n; ++j) {
      Number& diagonal = s[j * n + j];
      add_multiples(&diagonal, row + j, 1, row + j, 1, 1, 1, arithmetic);
      if (diagonal >= 0) return false;
    }
  }
  return true;
}
template bool is_decomposed(double* s, std::size_t n, Arithmetic& arithmetic);
template bool is_decomposed(mpz_class* s, std::size_t n, Arithmetic& arithmetic);

bool is_positive(Vector s, std::size_t n, Arithmetic& arithmetic) {
  constexpr std::size_t half = 128;
  mpz_class largest = 0;
  for (const mpz_class& x : s) largest = std::max(largest, mpz_class(abs(x)));
  if (largest == 0) return true;
  const std::size_t size = bits(largest);
  const mpz_class margin = (mpz_class(n) << half) + n;
  for (std::size_t i = 0; i < n * n; ++i) {
    if (size <= 2 * half)
      s[i] <<= 2 * half - size;
    else
      s[i] >>= size - 2 * half;  // towards minus infinity
    s[i] = (i % (n + 1) == 0 ? margin : mpz_class(0)) - s[i];
  }
  return is_decomposed(s.data(), n, arithmetic);
}

}  // namespace subcert_check
