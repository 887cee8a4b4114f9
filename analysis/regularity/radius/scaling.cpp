#include "scaling.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::radius {
namespace {

constexpr long near_enough = 16;        // bits: families of ordinary numbers are left alone
constexpr long short_denominator = 64;  // bits: those of ordinary decimals and masks
constexpr double ordinary_span = 60;    // bits between the largest and the smallest entry that doubles stand
constexpr int sweeps = 200;

constexpr double none = -std::numeric_limits<double>::infinity();

/// The logarithms to base 2 of the largest entries at each place, over all matrices; -infinity for zeros.
std::vector<std::vector<double>> entry_sizes(const MatrixFamily& family) {
  const std::size_t n = family.size();
  std::vector<std::vector<double>> result(n, std::vector<double>(n, none));
  for (const RationalMatrix& m : family)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (m(i, j) != 0) result[i][j] = std::max(result[i][j], static_cast<double>(binary_exponent(m(i, j))));
  return result;
}

double span_of(const std::vector<std::vector<double>>& sizes) {
  double low = -none, high = none;
  for (const auto& row : sizes)
    for (const double size : row)
      if (size > none) {
        low = std::min(low, size);
        high = std::max(high, size);
      }
  return high > none ? high - low : 0;
}

/// The e_i for which D^-1 A D, D = diag(2^e_i), has rows and columns of equal size, the diagonal apart: one coordinate
/// after the other, until nothing changes. Empty where the entries differ little. Ref: [Osb60].
std::vector<long> balancing_exponents(const MatrixFamily& family) {
  const auto sizes = entry_sizes(family);
  if (span_of(sizes) <= ordinary_span) return {};
  const std::size_t n = family.size();
  std::vector<double> e(n, 0);
  bool changed = true;
  for (int sweep = 0; changed && sweep < sweeps; ++sweep) {
    changed = false;
    for (std::size_t i = 0; i < n; ++i) {
      double row = none, column = none;
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i) continue;
        row = std::max(row, sizes[i][j] + e[j] - e[i]);
        column = std::max(column, sizes[j][i] + e[i] - e[j]);
      }
      const double step = row > none && column > none ? (row - column) / 2 : 0;
      e[i] += step;
      changed = changed || std::abs(step) > 0.5;
    }
  }
  std::vector<long> result;
  for (std::size_t i = 0; i < n; ++i) {
    // The flip has to stay a symmetry; the mean of two balanced scalings is one.
    const double mean = family.is_flip_symmetric() ? (e[i] + e[n - 1 - i]) / 2 : e[i];
    result.push_back(std::lround(mean - e[0]));
  }
  return result;
}

}  // namespace

long scaling_exponent(const MatrixFamily& family) {
  std::optional<long> largest;
  for (const RationalMatrix& m : family)
    if (const auto e = binary_exponent(m)) largest = std::max(largest.value_or(*e), *e);
  return largest && std::abs(*largest) > near_enough ? *largest : 0;
}

Rational unit_of(const MatrixFamily& family) {
  Integer numerators = 0, denominators = 1;
  for (const RationalMatrix& m : family)
    for (std::size_t i = 0; i < m.rows(); ++i)
      for (std::size_t j = 0; j < m.columns(); ++j) {
        numerators = gcd(numerators, numerator(m(i, j)));
        denominators = lcm(denominators, denominator(m(i, j)));
      }
  if (numerators == 0) return 1;
  const Rational content(numerators, denominators);
  const auto bits = [](const Integer& x) { return static_cast<long>(msb(x)); };
  const bool is_short = bits(numerators) <= near_enough && bits(denominators) <= short_denominator;
  const long exponent = scaling_exponent(family);
  if (is_short && exponent == 0) return 1;
  long largest = 0, longest = 0;  // of the integers that are left; of the numbers as they are
  for (const RationalMatrix& m : family) {
    if (const auto e = binary_exponent(m)) largest = std::max(largest, *e - binary_exponent(content));
    for (std::size_t i = 0; i < m.rows(); ++i)
      for (std::size_t j = 0; j < m.columns(); ++j)
        if (m(i, j) != 0) longest = std::max(longest, bits(abs(numerator(m(i, j)))) + bits(denominator(m(i, j))));
  }
  if (is_short || 2 * largest > longest) return power(Rational(2), exponent);
  return content * power(Rational(2), largest);
}

BlockTriangular balanced(BlockTriangular triangular) {
  const std::size_t n = triangular.basis.rows();
  std::vector<long> exponents;
  for (std::size_t k = 0; k < triangular.sizes.size(); ++k) {
    std::vector<long> own;
    if (triangular.sizes[k] > 1) own = balancing_exponents(triangular.block(k));
    own.resize(triangular.sizes[k], 0);
    exponents.insert(exponents.end(), own.begin(), own.end());
  }
  if (std::all_of(exponents.begin(), exponents.end(), [](long e) { return e == 0; })) return triangular;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      triangular.basis(i, j) *= power(Rational(2), exponents[j]);
      for (RationalMatrix& m : triangular.triangular) m(i, j) *= power(Rational(2), exponents[j] - exponents[i]);
    }
  return triangular;
}

}  // namespace subcert::radius
