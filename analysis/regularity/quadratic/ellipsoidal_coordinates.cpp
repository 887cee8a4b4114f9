#include "ellipsoidal_coordinates.hpp"

#include <subcert/analysis/regularity/polytope_search/decompositions.hpp>

#include <algorithm>
#include <cmath>
#include <deque>

namespace subcert::quadratic {
namespace {

using polytope::composed;
using polytope::Matrix;
using polytope::norm;
using polytope::SymmetricDecomposition;
using polytope::Vector;

constexpr double largest_power = 512;   // q: sums of such powers tell the largest term to a thousandth
constexpr double power_for_words = 16;  // where it begins for words: the form for letters is near
constexpr int steps_per_power = 200;
constexpr std::size_t remembered = 20;  // steps of L-BFGS
constexpr double settled = 1e-12;       // of the logarithm of the sum
constexpr int most_halvings = 20;       // of a step
constexpr double longest_step = 2;      // in the norm of the logarithm of the form
constexpr double largest_condition = 1e13;

double inner(const Matrix& a, const Matrix& b) { return polytope::inner(a.entries(), b.entries()); }

/// a += factor * b
void add(Matrix& a, double factor, const Matrix& b) {
  for (std::size_t j = 0; j < a.columns(); ++j)
    for (std::size_t i = 0; i < a.rows(); ++i) a(i, j) += factor * b(i, j);
}

Matrix scaled(double factor, const Matrix& a) {
  Matrix result(a.rows(), a.columns());
  add(result, factor, a);
  return result;
}

/// exp(factor X). Domain: symmetric.
Matrix exponential(const SymmetricDecomposition& x, double factor) {
  Vector values = x.values;
  for (double& value : values) value = std::exp(factor * value);
  return composed(x.vectors, values);
}

/// Of the words of products; 0: the matrix is only carried along.
using Lengths = std::vector<int>;

/// A group and coordinates in which its elements are orthogonal; steps along means over the group keep them so.
struct Symmetry {
  const polytope::SymmetryGroup& group;
  polytope::CoordinateChange adapted;
};

/// log(sum_t trace (B_t^T B_t)^(q/l_t)) / (2 q), its gradient with respect to X where B_t becomes e^(X/2) B_t e^(-X/2),
/// and the largest |B_t|^(1/l_t). Matrices with l_t = 0 do not count.
struct Value {
  double smooth = 0, bound = 0;
  Matrix gradient;
};
Value value_of(const std::vector<Matrix>& matrices, const Lengths& lengths, double q, const Symmetry& symmetry) {
  const std::size_t n = matrices.front().rows();
  std::vector<SymmetricDecomposition> squares(matrices.size());
  double largest = 0;
  for (std::size_t t = 0; t < matrices.size(); ++t) {
    if (lengths[t] == 0) continue;
    squares[t] = polytope::symmetric_decomposition(matrices[t].transposed() * matrices[t]);
    largest = std::max(largest, std::pow(std::max(squares[t].values.back(), 0.0), 1.0 / lengths[t]));
  }
  Value result{0, std::sqrt(largest), Matrix(n, n)};
  double sum = 0;
  for (std::size_t t = 0; t < matrices.size(); ++t) {
    if (lengths[t] == 0) continue;
    Vector powers, less;
    for (const double value : squares[t].values) {
      powers.push_back(value > 0 ? std::pow(std::pow(value, 1.0 / lengths[t]) / largest, q) : 0);
      less.push_back(value > 0 ? powers.back() / value : 0);
      sum += powers.back();
    }
    add(result.gradient, 1.0 / lengths[t], composed(matrices[t] * squares[t].vectors, less));
    add(result.gradient, -1.0 / lengths[t], composed(squares[t].vectors, powers));
  }
  result.gradient /= 2 * sum;
  result.gradient = symmetry.group.mean(result.gradient, symmetry.adapted);
  result.smooth = std::log(largest) / 2 + std::log(sum) / (2 * q);
  return result;
}

/// The last steps and what they changed in the gradient.
class Memory {
 public:
  void clear() { steps_.clear(); }
  void remember(Matrix step, Matrix change) {
    const double product = inner(step, change);
    if (!(product > 1e-14 * norm(step.entries()) * norm(change.entries()))) return;
    steps_.push_back({std::move(step), std::move(change), product});
    if (steps_.size() > remembered) steps_.pop_front();
  }
  /// Where to go from here.
  Matrix direction(const Matrix& gradient, double q) const {
    Matrix result = scaled(-1, gradient);
    std::vector<double> shares(steps_.size());
    for (std::size_t i = steps_.size(); i-- > 0;) {
      shares[i] = inner(steps_[i].step, result) / steps_[i].product;
      add(result, -shares[i], steps_[i].change);
    }
    const double length = norm(gradient.entries());
    const double first = steps_.empty() ? 0.1 / (q * std::max(length, 1e-300))
                                        : steps_.back().product / inner(steps_.back().change, steps_.back().change);
    result = scaled(first, result);
    for (std::size_t i = 0; i < steps_.size(); ++i)
      add(result, shares[i] - inner(steps_[i].change, result) / steps_[i].product, steps_[i].step);
    return result;
  }

 private:
  struct Step {
    Matrix step, change;
    double product;
  };
  std::deque<Step> steps_;
};

bool is_well_conditioned(const Matrix& to) {
  const Vector values = polytope::symmetric_decomposition(to.transposed() * to).values;
  return values.front() > values.back() / largest_condition;
}

/// Follows the gradient for one q, as far as the form stays well conditioned.
void descend(EllipsoidalCoordinates& at, const Lengths& lengths, double q, const Symmetry& symmetry,
             const Deadline& deadline) {
  Memory memory;
  Value here = value_of(at.matrices, lengths, q, symmetry);
  for (int k = 0; k < steps_per_power && !deadline.expired(); ++k) {
    Matrix direction = memory.direction(here.gradient, q);
    double slope = inner(here.gradient, direction);
    if (slope >= 0) {
      memory.clear();
      direction = memory.direction(here.gradient, q);
      slope = inner(here.gradient, direction);
    }
    if (!(slope < 0)) return;
    const SymmetricDecomposition decomposed = polytope::symmetric_decomposition(direction);
    double share = std::min(1.0, longest_step / norm(direction.entries()));
    Value there;
    EllipsoidalCoordinates next;
    for (int halvings = 0;; share /= 2) {
      const Matrix map = exponential(decomposed, share / 2), back = exponential(decomposed, -share / 2);
      next = {map * at.to, {}, 0, at.ended_flat};
      for (const Matrix& b : at.matrices) next.matrices.push_back(map * b * back);
      there = value_of(next.matrices, lengths, q, symmetry);
      if (there.smooth <= here.smooth + 1e-4 * share * slope) break;
      if (++halvings == most_halvings) return;
    }
    if (!is_well_conditioned(next.to)) {
      at.ended_flat = true;
      return;
    }
    Matrix change = there.gradient;
    add(change, -1, here.gradient);
    memory.remember(scaled(share, direction), std::move(change));
    const double gain = here.smooth - there.smooth;
    at = std::move(next);
    at.bound = there.bound;
    here = std::move(there);
    if (gain < settled) return;
  }
}

/// The best of the descents for growing q.
EllipsoidalCoordinates least(EllipsoidalCoordinates at, const Lengths& lengths, double q, double target,
                             const Symmetry& symmetry, const Deadline& deadline) {
  at.bound = value_of(at.matrices, lengths, q, symmetry).bound;
  EllipsoidalCoordinates best = at;
  for (; q <= largest_power && best.bound > target && !deadline.expired(); q *= 2) {
    descend(at, lengths, q, symmetry, deadline);
    if (at.bound < best.bound) best = at;
  }
  best.ended_flat = at.ended_flat;
  return best;
}

Symmetry symmetry_of(const polytope::SearchFamily& family) {
  return {family.symmetry, family.symmetry.adapted_coordinates(family.matrices.front().rows())};
}

}  // namespace

EllipsoidalCoordinates ellipsoidal_coordinates(const polytope::SearchFamily& family, double target,
                                               const Deadline& deadline) {
  const Symmetry symmetry = symmetry_of(family);
  EllipsoidalCoordinates start{symmetry.adapted.to, {}};
  for (const Matrix& a : family.matrices) start.matrices.push_back(symmetry.adapted.to * a * symmetry.adapted.from);
  return least(std::move(start), Lengths(family.matrices.size(), 1), 1, target, symmetry, deadline);
}

EllipsoidalCoordinates coordinates_for_words(const EllipsoidalCoordinates& start, const polytope::SearchFamily& family,
                                             const std::vector<std::vector<int>>& words, double target,
                                             const Deadline& deadline) {
  const std::size_t letters = start.matrices.size();
  EllipsoidalCoordinates at = start;
  Lengths lengths(letters, 0);
  for (const std::vector<int>& word : words) {
    Matrix product = Matrix::identity(start.to.rows());
    for (const int letter : word) product = product * start.matrices[static_cast<std::size_t>(letter)];
    at.matrices.push_back(std::move(product));
    lengths.push_back(static_cast<int>(word.size()));
  }
  at.ended_flat = false;
  at = least(std::move(at), lengths, power_for_words, target, symmetry_of(family), deadline);
  at.matrices.resize(letters, Matrix(0, 0));
  return at;
}

}  // namespace subcert::quadratic
