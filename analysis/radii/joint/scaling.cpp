#include "scaling.hpp"

#include <subcert/analysis/radii/polytope_proof/round_family.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::radius {
namespace {

constexpr long near_enough = 16;        // bits: families of ordinary numbers are left alone
constexpr long short_denominator = 64;  // bits: those of ordinary decimals and masks
constexpr double ordinary_span = 60;    // bits between the largest and the smallest entry that doubles stand
constexpr int sweeps = 200;
constexpr long lattice_bits = 400;  // of the longest vector of a lattice before it is reduced

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

/// D = diag(2^e_i) for which D^-1 A D has rows and columns of equal size, the diagonal apart: one coordinate after the
/// other, until nothing changes. Nothing where the entries differ little. Ref: [Osb60].
std::optional<RationalMatrix> equal_lengths(const MatrixFamily& family) {
  const auto sizes = entry_sizes(family);
  if (span_of(sizes) <= ordinary_span) return std::nullopt;
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
  RationalMatrix result(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    // The flip has to stay a symmetry; the mean of two balanced scalings is one.
    const double mean = family.is_flip_symmetric() ? (e[i] + e[n - 1 - i]) / 2 : e[i];
    result(i, i) = power(Rational(2), std::lround(mean - e[0]));
  }
  return result;
}

MatrixFamily in_basis(const MatrixFamily& family, const RationalMatrix& basis) {
  std::vector<RationalMatrix> matrices;
  for (const RationalMatrix& m : family) matrices.push_back(solve(basis, m * basis));
  return matrices;
}

/// The size of the largest entry, in bits; nothing where all are 0.
std::optional<long> largest_exponent(const MatrixFamily& family) {
  std::optional<long> largest;
  for (const RationalMatrix& m : family)
    if (const auto e = binary_exponent(m)) largest = std::max(largest.value_or(*e), *e);
  return largest;
}

/// A reduced basis of the integer vectors, where lengths are measured in coordinates in which orbits are round, with
/// the lengths made equal by powers of two: in it matrices are hardly larger than their products. Nothing where they
/// are not much larger anyway, or the basis does not make them smaller.
std::optional<RationalMatrix> short_basis(const MatrixFamily& family, const Deadline& deadline) {
  if (family.is_flip_symmetric() || !has_hidden_products(family, deadline)) return std::nullopt;
  const auto round = long_rounding(family, deadline);
  if (!round) return std::nullopt;
  const std::size_t n = family.size();
  std::vector<std::vector<Integer>> images(n);  // of the unit vectors
  RationalMatrix given(n, n), reduced(n, n);    // columns
  const Rational unit = power(Rational(2), lattice_bits - binary_exponent(*round).value_or(0));
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      images[j].push_back(to_integer((*round)(i, j) * unit, Rounding::nearest));
      given(i, j) = images[j].back();
    }
  if (!kernel(given).empty()) return std::nullopt;
  const auto shortest = reduced_lattice(images);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) reduced(i, j) = shortest[j][i];
  RationalMatrix basis = solve(given, reduced);
  for (std::size_t j = 0; j < n; ++j) {
    Integer length = 0;
    for (const Integer& c : shortest[j]) length = std::max(length, abs(c));
    const Rational factor = power(Rational(2), lattice_bits - static_cast<long>(msb(length)));
    for (std::size_t i = 0; i < n; ++i) basis(i, j) *= factor;
  }
  const bool shorter = largest_exponent(in_basis(family, basis)) < largest_exponent(family);
  return shorter ? std::optional(std::move(basis)) : std::nullopt;
}

/// The basis in which the entries of a block are of like sizes, and not much larger than those of products; nothing
/// where it is the given one.
std::optional<RationalMatrix> balancing(const MatrixFamily& family, const Deadline& deadline) {
  const auto lengths = equal_lengths(family);
  const auto shorter = short_basis(lengths ? in_basis(family, *lengths) : family, deadline);
  return lengths && shorter ? *lengths * *shorter : shorter ? shorter : lengths;
}

}  // namespace

long scaling_exponent(const MatrixFamily& family) {
  const auto largest = largest_exponent(family);
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

BlockTriangular in_basis(BlockTriangular triangular, const RationalMatrix& change) {
  triangular.basis = triangular.basis * change;
  for (RationalMatrix& matrix : triangular.triangular) matrix = solve(change, matrix * change);
  return triangular;
}

BlockTriangular balanced(BlockTriangular triangular, const Deadline& deadline) {
  RationalMatrix change(0, 0);
  std::size_t start = 0;
  for (std::size_t k = 0; k < triangular.sizes.size(); start += triangular.sizes[k++]) {
    const auto own = triangular.sizes[k] == 1 ? std::nullopt : balancing(triangular.block(k), deadline);
    if (!own) continue;
    if (change.rows() == 0) change = RationalMatrix::identity(triangular.basis.rows());
    for (std::size_t i = 0; i < own->rows(); ++i)
      for (std::size_t j = 0; j < own->rows(); ++j) change(start + i, start + j) = (*own)(i, j);
  }
  return change.rows() == 0 ? triangular : in_basis(std::move(triangular), change);
}

}  // namespace subcert::radius
