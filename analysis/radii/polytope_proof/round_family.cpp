#include "round_family.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>

#include <cmath>

namespace subcert::radius {
namespace {

constexpr double round_enough = 1e-7;  // ratio of the eigenvalues of the shape
constexpr int most_steps = 8;
constexpr std::size_t largest_long = 24;              // the size of matrices for which shapes of many bits are computed
constexpr int long_sums = 60, long_floor_bits = 400;  // of such a shape
constexpr double well_conditioned = 1e-3;             // the radius over the largest entry
constexpr double seconds_per_product = 1e-7;          // of numbers of that size
constexpr slong bits = 512;                           // of `from`

/// The mean of the matrix and its image under the flip.
RationalMatrix commuting_with_flip(const RationalMatrix& matrix) {
  const std::size_t n = matrix.rows();
  RationalMatrix result(n, n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) result(i, j) = (matrix(i, j) + matrix(n - 1 - i, n - 1 - j)) / 2;
  return result;
}

/// A matrix that makes orbits rounder, symmetric up to rounding; nothing where they are round.
std::optional<polytope::Matrix> rounding_step(const std::vector<polytope::Matrix>& matrices, const Deadline& deadline) {
  const polytope::OrbitShape orbit = polytope::orbit_shape(matrices, deadline);
  const polytope::SymmetricDecomposition shape = polytope::symmetric_decomposition(orbit.shape);
  if (!(orbit.radius_bound > 0) || !(shape.values.back() > 0) ||
      shape.values.front() > round_enough * shape.values.back())
    return std::nullopt;
  polytope::Vector factors;
  const double largest = shape.values.back();
  const double least = polytope::resolved_share * largest / static_cast<double>(shape.values.size());
  for (const double value : shape.values) factors.push_back(std::sqrt(largest / std::max(value, least)));
  return polytope::composed(shape.vectors, factors);
}

Rational rounded(const Rational& value) {
  if (value == 0) return value;
  return to_multiple(value, power(Rational(2), binary_exponent(value) - bits), Rounding::nearest);
}

/// The fixed point of G = sum of A G A^T up to its size, with many bits; nothing where all long products vanish.
std::optional<RationalMatrix> long_shape(const MatrixFamily& family, const Deadline& deadline) {
  const std::size_t n = family.size();
  const Rational least = power(Rational(2), -long_floor_bits);
  RationalMatrix shape = RationalMatrix::identity(n);
  for (int k = 0; k < long_sums; ++k) {
    RationalMatrix sum(n, n);
    for (const RationalMatrix& a : family) {
      if (deadline.expired()) return std::nullopt;
      const RationalMatrix image = a * shape * transposed(a);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) sum(i, j) += image(i, j);
    }
    const auto exponent = binary_exponent(sum);
    if (!exponent) return std::nullopt;
    const Rational unit = power(Rational(2), -*exponent);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) shape(i, j) = rounded(unit * sum(i, j));
    for (std::size_t i = 0; i < n; ++i) shape(i, i) += least;
  }
  return shape;
}

/// Nearly; nothing where balls do not resolve it.
std::optional<RationalMatrix> inverse(const RationalMatrix& matrix) {
  const auto columns = inverse_columns(matrix, {0, 0}, bits);
  if (!columns) return std::nullopt;
  RationalMatrix result(matrix.rows(), matrix.rows());
  for (std::size_t j = 0; j < columns->size(); ++j)
    for (std::size_t i = 0; i < columns->size(); ++i) result(i, j) = -(*columns)[j][i].re;
  return result;
}

/// False, with nothing changed, where balls do not resolve the way back or doubles do not hold the family there.
bool set_coordinates(RoundFamily& round, const MatrixFamily& family, const RationalMatrix& to) {
  const auto from = inverse(to);
  if (!from) return false;
  polytope::SearchFamily moved{{}, round.family.symmetry};
  for (const RationalMatrix& m : family) moved.matrices.push_back(to_double(to * m * *from));
  if (!polytope::is_finite(moved) || !polytope::has_symmetry(moved)) return false;
  round = {std::move(moved), {to, *from}};
  return true;
}

}  // namespace

polytope::Matrix to_double(const RationalMatrix& m) {
  polytope::Matrix result(m.rows(), m.columns());
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j) result(i, j) = m(i, j).convert_to<double>();
  return result;
}

std::optional<RationalMatrix> to_rational(const polytope::Matrix& m) {
  if (!polytope::is_finite(m)) return std::nullopt;
  RationalMatrix result(m.rows(), m.columns());
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.columns(); ++j) result(i, j) = Rational(m(i, j));
  return result;
}

polytope::SearchFamily to_search_family(const MatrixFamily& family) {
  polytope::SearchFamily result;
  for (const RationalMatrix& m : family) result.matrices.push_back(to_double(m));
  if (family.is_flip_symmetric()) {
    result.symmetry = polytope::SymmetryGroup::flip(
        {family.group()[1].letters.begin(), family.group()[1].letters.end()});
  } else if (family.group().size() > 1) {
    std::vector<polytope::SymmetryGroup::Element> elements;
    for (const FamilySymmetry& element : family.group())
      elements.push_back({to_double(element.map.matrix()), to_double(element.map.inverse().matrix()),
                          std::vector<int>(element.letters.begin(), element.letters.end())});
    result.symmetry = polytope::SymmetryGroup(std::move(elements));
  }
  return result;
}

bool change_coordinates(RoundFamily& round, const MatrixFamily& family, const polytope::Matrix& step) {
  const auto exact = to_rational(step);
  if (!exact) return false;
  const RationalMatrix kept = family.is_flip_symmetric() ? commuting_with_flip(*exact) : *exact;
  return set_coordinates(round, family, round.coordinates.differ() ? kept * round.coordinates.to : kept);
}

std::optional<RationalMatrix> long_rounding(const MatrixFamily& family, const Deadline& deadline) {
  const std::size_t n = family.size();
  const auto shape = long_shape(family, deadline);
  if (!shape) return std::nullopt;
  RationalMatrix root = RationalMatrix::identity(n);  // shape = root diagonal root^T
  std::vector<Rational> diagonal;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k; i < n; ++i) {
      Rational rest = (*shape)(i, k);
      for (std::size_t j = 0; j < k; ++j) rest -= root(i, j) * root(k, j) * diagonal[j];
      if (i == k) {
        if (rest <= 0) return std::nullopt;
        diagonal.push_back(rounded(rest));
      } else {
        root(i, k) = rounded(rest / diagonal[k]);
      }
    }
  }
  RationalMatrix to = solve(root, RationalMatrix::identity(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      to(i, j) = rounded(to(i, j) * power(Rational(2), -binary_exponent(diagonal[i]) / 2));
  return to;
}

bool has_hidden_products(const MatrixFamily& family, const Deadline& deadline) {
  if (family.size() > largest_long) return false;
  std::vector<polytope::Matrix> matrices;
  double largest = 0;
  for (const RationalMatrix& m : family) {
    matrices.push_back(to_double(m));
    largest = std::max(largest, matrices.back().largest_modulus());
  }
  const polytope::OrbitShape orbit = polytope::orbit_shape(matrices, deadline);
  return orbit.lost || !(orbit.radius_bound >= well_conditioned * largest);
}

RoundFamily round_family(const MatrixFamily& family, const Deadline& deadline) {
  RoundFamily given{to_search_family(family)};
  if (family.group().size() > 1 && !family.is_flip_symmetric()) return given;
  if (!family.is_flip_symmetric() && has_hidden_products(family, deadline)) {
    RoundFamily seen = given;
    const auto to = long_rounding(family, deadline);
    if (to && set_coordinates(seen, family, *to)) given = std::move(seen);
  }
  RoundFamily result = given;
  const auto d = static_cast<double>(family.size()), products = 2.0 * static_cast<double>(family.count() + 1);
  const double seconds = seconds_per_product * products * d * d * d;
  for (int k = 0; k < most_steps; ++k) {
    const auto step = rounding_step(result.family.matrices, deadline);
    if (!step || seconds >= deadline.remaining()) return result;
    if (!change_coordinates(result, family, *step)) break;
  }
  // What stays flat lies in a subspace in the end, as the powers of one matrix do.
  return given;
}

}  // namespace subcert::radius
