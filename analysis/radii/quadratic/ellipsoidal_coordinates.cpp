#include "ellipsoidal_coordinates.hpp"

#include "limited_memory.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::quadratic {
namespace {

using polytope::composed;
using polytope::Matrix;
using polytope::SymmetricDecomposition;
using polytope::Vector;

constexpr int power_count = 10;  // q = 1, 2, ..., 512: sums of such powers tell the largest term to a thousandth
constexpr int steps_per_power = 200;
constexpr double settled = 1e-12;   // of the logarithm of the sum
constexpr int most_halvings = 20;   // of a step
constexpr double longest_step = 2;  // in the norm of the logarithm of the form
constexpr double largest_condition = 1e13;

/// a += factor * b
void add(Matrix& a, double factor, const Matrix& b) {
  for (std::size_t j = 0; j < a.columns(); ++j)
    for (std::size_t i = 0; i < a.rows(); ++i) a(i, j) += factor * b(i, j);
}

/// exp(factor X). Domain: symmetric.
Matrix exponential(const SymmetricDecomposition& x, double factor) {
  Vector values = x.values;
  for (double& value : values) value = std::exp(factor * value);
  return composed(x.vectors, values);
}

/// A group and coordinates in which its elements are orthogonal; steps along means over the group keep them so.
struct Symmetry {
  const polytope::SymmetryGroup& group;
  polytope::CoordinateChange adapted;
};

/// log(sum_t trace (B_t^T B_t)^q) / (2 q), its gradient with respect to X where B_t becomes e^(X/2) B_t e^(-X/2), and
/// the largest norm.
struct Value {
  double smooth = 0, bound = 0;
  Matrix gradient;
};
Value value_of(const std::vector<Matrix>& matrices, double q, const Symmetry& symmetry) {
  const std::size_t n = matrices.front().rows();
  std::vector<SymmetricDecomposition> squares;
  double largest = 0;
  for (const Matrix& b : matrices) {
    squares.push_back(polytope::symmetric_decomposition(b.transposed() * b));
    largest = std::max(largest, squares.back().values.back());
  }
  Value result{0, std::sqrt(largest), Matrix(n, n)};
  double sum = 0;
  for (std::size_t t = 0; t < matrices.size(); ++t) {
    Vector powers, less;
    for (const double value : squares[t].values) {
      powers.push_back(value > 0 ? std::pow(value / largest, q) : 0);
      less.push_back(value > 0 ? powers.back() / value : 0);
      sum += powers.back();
    }
    add(result.gradient, 1, composed(matrices[t] * squares[t].vectors, less));
    add(result.gradient, -1, composed(squares[t].vectors, powers));
  }
  result.gradient /= 2 * sum;
  result.gradient = symmetry.group.mean(result.gradient, symmetry.adapted);
  result.smooth = std::log(largest) / 2 + std::log(sum) / (2 * q);
  return result;
}

bool is_well_conditioned(const Matrix& to) {
  const Vector values = polytope::symmetric_decomposition(to.transposed() * to).values;
  return values.front() > values.back() / largest_condition;
}

/// Follows the gradient for one q, as far as the form stays well conditioned.
void descend(EllipsoidalCoordinates& at, double q, const Symmetry& symmetry, const Deadline& deadline) {
  const std::size_t n = at.to.rows();
  LimitedMemory memory(0.1 / q);
  Value here = value_of(at.matrices, q, symmetry);
  for (int k = 0; k < steps_per_power && !deadline.expired(); ++k) {
    const std::optional<Vector> way = memory.direction(here.gradient.entries());
    if (!way) return;
    const double slope = polytope::inner(here.gradient.entries(), *way);
    const SymmetricDecomposition decomposed = polytope::symmetric_decomposition(Matrix(n, n, *way));
    double share = std::min(1.0, longest_step / polytope::norm(*way));
    Value there;
    EllipsoidalCoordinates next;
    for (int halvings = 0;; share /= 2) {
      const Matrix map = exponential(decomposed, share / 2), back = exponential(decomposed, -share / 2);
      next = {map * at.to, at.from * back, {}, 0, at.ended_flat};
      for (const Matrix& b : at.matrices) next.matrices.push_back(map * b * back);
      there = value_of(next.matrices, q, symmetry);
      if (there.smooth <= here.smooth + 1e-4 * share * slope) break;
      if (++halvings == most_halvings) return;
    }
    if (!is_well_conditioned(next.to)) {
      at.ended_flat = true;
      return;
    }
    memory.remember(share, *way, here.gradient.entries(), there.gradient.entries());
    const double gain = here.smooth - there.smooth;
    at = std::move(next);
    at.bound = there.bound;
    here = std::move(there);
    if (gain < settled) return;
  }
}

Symmetry symmetry_of(const polytope::SearchFamily& family) {
  return {family.symmetry, family.symmetry.adapted_coordinates(family.matrices.front().rows())};
}

}  // namespace

EllipsoidalCoordinates ellipsoidal_coordinates(const polytope::SearchFamily& family, double target,
                                               const Deadline& deadline) {
  const Symmetry symmetry = symmetry_of(family);
  const auto& [to, from] = symmetry.adapted;
  EllipsoidalCoordinates at{to, from, {}};
  for (const Matrix& a : family.matrices) at.matrices.push_back(to * a * from);
  at.bound = value_of(at.matrices, 1, symmetry).bound;
  EllipsoidalCoordinates best = at;
  for (int k = 0; k < power_count && best.bound > target && !deadline.expired(); ++k) {
    descend(at, std::ldexp(1.0, k), symmetry, deadline);
    if (at.bound < best.bound) best = at;
  }
  best.ended_flat = at.ended_flat;
  return best;
}

}  // namespace subcert::quadratic
