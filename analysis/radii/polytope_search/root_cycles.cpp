
#include "root_cycles.hpp"

#include "decompositions.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::polytope {
namespace {

constexpr double parallel_tolerance = 1e-10;  // eigenvectors this close to parallel are one: a Jordan block
constexpr double same_value = 1e-6;           // left and right eigenvalues come out apart by a root of the rounding
constexpr double least_pairing = 1e-9;        // of dual vectors; below, the eigenvalue is defective
constexpr double unreached_pairing = 1e-20;   // stands for the zero of a dual vector on an orbit
constexpr int orbit_generations = 14;         // of an orbit that balancing looks at: sizes have settled by then
constexpr std::size_t orbit_width = 256;
constexpr double smallest_factor = -15;  // logarithm of the smallest balancing factor

// The dual vector that belongs to v, among those of close eigenvalues the one that pairs best; none if defective.
const ComplexVector* dual_of(const ComplexVector& v, std::complex<double> value, const EigenDecomposition& left) {
  const ComplexVector* match = nullptr;
  double most = least_pairing;
  for (std::size_t l = 0; l < left.vectors.size(); ++l) {
    if (std::abs(left.values[l] - value) > same_value) continue;
    const double pairing = std::abs(inner(conjugate(left.vectors[l]), v));
    if (pairing <= most) continue;
    most = pairing;
    match = &left.vectors[l];
  }
  return match;
}

// The vectors along the cycle that begins with the eigenvector v, and their dual vectors.
void fill_cycle(RootCycle& cycle, ComplexVector v, const ComplexVector* dual, const std::vector<Matrix>& matrices,
                const Candidate& candidate) {
  for (const int letter : candidate.word) {
    cycle.right.push_back(v);
    v = matrices[static_cast<std::size_t>(letter)] * v;
    divide(v, candidate.radius);
  }
  if (dual == nullptr) return;
  // left[t] applies the rest of the word first.
  ComplexVector u = *dual;
  cycle.left.resize(candidate.word.size());
  for (std::size_t t = candidate.word.size(); t-- > 0;) {
    u = multiply_transposed(matrices[static_cast<std::size_t>(candidate.word[t])], u);
    divide(u, candidate.radius);
    cycle.left[t] = u;
    divide(cycle.left[t], inner(conjugate(u), cycle.right[t]));
  }
}

// The largest modulus on x of functionals and, where points are complex, of their conjugates.
double largest_value(const std::vector<ComplexVector>& conjugates, PolytopeKind kind, const ComplexVector& x) {
  double largest = 0;
  for (const ComplexVector& u : conjugates) {
    largest = std::max(largest, std::abs(inner(u, x)));
    if (kind == PolytopeKind::complex) largest = std::max(largest, std::abs(inner(conjugate(u), x)));
  }
  return largest;
}

// Potentials p with p_i + q_ij + t <= p_j for all i and j; false if there are none.
bool find_potentials(const Matrix& q, double t, Vector& p) {
  p.assign(q.rows(), 0.0);
  for (std::size_t round = 0; round <= p.size(); ++round) {
    bool changed = false;
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t j = 0; j < p.size(); ++j) {
        if (i == j || p[i] + q(i, j) + t <= p[j] + 1e-12) continue;
        p[j] = p[i] + q(i, j) + t;
        changed = true;
      }
    }
    if (!changed) return true;
  }
  return false;
}

}  // namespace

std::vector<ComplexVector> with_images(const std::vector<ComplexVector>& vectors, const GroupAction& action) {
  std::vector<ComplexVector> result = vectors;
  for (int g = 1; g < action.order(); ++g) {
    for (const ComplexVector& v : vectors) {
      result.push_back(v);
      action.apply(g, result.back().data());
    }
  }
  return result;
}

void balance(std::vector<RootCycle>& cycles, const std::vector<Matrix>& matrices, const GroupAction& action,
             PolytopeKind kind, const Budget& budget) {
  const std::size_t n = cycles.size();
  if (n < 2) return;
  const std::size_t point = action.dimension() * sizeof(std::complex<double>) + sizeof(ComplexVector);
  const std::size_t width = std::clamp<std::size_t>(budget.memory / (point * matrices.size()), 1, orbit_width);
  std::vector<std::vector<ComplexVector>> conjugate_duals;
  for (const RootCycle& cycle : cycles) {
    conjugate_duals.push_back(with_images(cycle.left, action));
    for (ComplexVector& u : conjugate_duals.back()) u = conjugate(std::move(u));
  }
  Matrix q(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) q(i, j) = -50;
    follow_orbit(cycles[i].right, matrices, orbit_generations, width, budget.deadline, squared_norm,
                 [&](const ComplexVector& x) {
                   for (std::size_t j = 0; j < n; ++j) {
                     if (j != i)
                       q(i, j) = std::max(q(i, j),
                                          std::log(largest_value(conjugate_duals[j], kind, x) + unreached_pairing));
                   }
                 });
  }
  Vector p, best(n, 0.0);
  double low = -20, high = 5;
  for (int k = 0; k < 40; ++k) {
    const double t = (low + high) / 2;
    if (find_potentials(q, t, p)) {
      low = t;
      best = p;
    } else {
      high = t;
    }
  }
  const double largest = *std::max_element(best.begin(), best.end());
  for (std::size_t i = 0; i < n; ++i) cycles[i].size = std::exp(std::max(best[i] - largest, smallest_factor));
}

std::vector<RootCycle> leading_cycles(const std::vector<Matrix>& matrices, const std::vector<Candidate>& products,
                                      double tolerance, const Deadline& deadline) {
  std::vector<RootCycle> cycles;
  for (std::size_t index = 0; index < products.size() && !deadline.expired(); ++index) {
    const Candidate& candidate = products[index];
    Matrix product = Matrix::identity(matrices.front().rows());
    for (const int letter : candidate.word) {
      product = matrices[static_cast<std::size_t>(letter)] * product;
      product /= candidate.radius;
    }
    const EigenDecomposition right = eigen_decomposition(product), left = eigen_decomposition(product.transposed());
    double largest = 0;
    for (const auto& value : right.values) largest = std::max(largest, std::abs(value));
    for (std::size_t k = 0; k < right.values.size(); ++k) {
      const std::complex<double> value = right.values[k];
      if (std::abs(value) < (1 - tolerance) * largest || value.imag() < 0) continue;
      ComplexVector v = right.vectors[k];
      normalise(v);
      // A Jordan block shows as parallel eigenvectors: one root only, and no polytope will close.
      const bool repeated = std::any_of(cycles.begin(), cycles.end(), [&](const RootCycle& c) {
        return c.product == static_cast<int>(index) && std::abs(inner(c.right.front(), v)) > 1 - parallel_tolerance;
      });
      if (repeated) continue;
      RootCycle cycle;
      cycle.product = static_cast<int>(index);
      cycle.phase = value / std::abs(value);
      fill_cycle(cycle, v, dual_of(v, value, left), matrices, candidate);
      cycles.push_back(std::move(cycle));
    }
  }
  return cycles;
}

namespace {

constexpr double flattest = 1e-12;  // directions in which orbits are flatter than that are stretched no further
constexpr int longest_word = 40;    // of the products whose sum tells how large coordinates are

/// Of non-negative matrices: coordinates in which the points of orbits have entries of like size. Powers of two, so
/// that nothing is rounded.
CoordinateChange balanced_coordinates(const SearchFamily& family, const GroupAction& action) {
  const std::size_t d = family.matrices.front().rows();
  Vector size(d, 1.0);
  for (int k = 0; k < longest_word; ++k) {
    Vector sum(d, 0.0);
    for (const Matrix& a : family.matrices) add_product(a, size.data(), sum.data());
    const double largest = *std::max_element(sum.begin(), sum.end());
    if (!(largest > 0)) break;
    for (std::size_t i = 0; i < d; ++i) size[i] = std::max(sum[i] / largest, flattest);
  }
  for (int g = 1; g < action.order(); ++g) {
    Vector image = size;
    action.apply(g, image.data());
    for (std::size_t i = 0; i < d; ++i) size[i] = std::max(size[i], image[i]);
  }
  CoordinateChange change{Matrix(d, d), Matrix(d, d)};
  for (std::size_t i = 0; i < d; ++i) {
    change.from(i, i) = std::exp2(std::round(std::log2(size[i])));
    change.to(i, i) = 1 / change.from(i, i);
  }
  return change;
}

}  // namespace

Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind, const Deadline& deadline) {
  const std::size_t d = family.matrices.front().rows();
  const SymmetryGroup& symmetry = family.symmetry;
  if (kind == PolytopeKind::nonnegative) {
    GroupAction action = symmetry.action(d);
    return {balanced_coordinates(family, action), std::move(action), {d}};
  }
  const CoordinateChange adapted = symmetry.adapted_coordinates(d);
  std::vector<Matrix> matrices;
  for (const Matrix& a : family.matrices) matrices.push_back(adapted.to * a * adapted.from);
  const Matrix shape = symmetry.mean(orbit_shape(matrices, deadline).shape, adapted);
  CoordinateChange change{Matrix(d, d), Matrix(d, d)};
  std::vector<std::size_t> blocks = symmetry.blocks(d);
  std::size_t begin = 0;
  for (const std::size_t size : blocks) {
    if (size == 0) continue;
    const Whitening block = whitening(shape.diagonal_block(begin, size), flattest);
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t i = 0; i < size; ++i) {
        change.to(begin + i, begin + j) = block.to(i, j);
        change.from(begin + i, begin + j) = block.from(i, j);
      }
    }
    begin += size;
  }
  change = {change.to * adapted.to, adapted.from * change.from};
  GroupAction action = symmetry.action_in(change);
  return {std::move(change), std::move(action), std::move(blocks)};
}

}  // namespace subcert::polytope
