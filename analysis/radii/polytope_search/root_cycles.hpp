#pragma once
/// The first vertices of a polytope: the leading eigenvectors of the candidates for spectrum maximizing products.

#include "product_search.hpp"

#include <algorithm>

namespace subcert::polytope {

/// Coordinates x' = to x in which orbits are round and the symmetry acts as `action` tells. Those of non-negative
/// polytopes are the coordinates of the family.
struct Coordinates {
  CoordinateChange change;
  GroupAction action;
  std::vector<std::size_t> blocks;  ///< of coordinates on which an element of the symmetry has one sign
};

/// Domain: at least one matrix. Cost: that of orbit_shape and a symmetric eigenvalue problem.
Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind, const Deadline& deadline);

/// A product with its leading eigenvectors along the cycle, in working coordinates.
struct RootCycle {
  int product = 0;                   ///< index into the products of the run
  std::vector<ComplexVector> right;  ///< right[t] = A_{w_t} ... A_{w_1} right[0] / radius^t
  std::vector<ComplexVector> left;   ///< left[t] . right[t] = 1, or empty when the eigenvalue is defective
  std::complex<double> phase;  ///< one turn multiplies right[0] by it (times (radius of the product/scale)^length)
  double size = 1;             ///< balancing factor
};

/// Eigenvector cycles of all products, of the first ones only past the deadline.
/// `tolerance`: eigenvalues whose modulus is that near to the largest, relatively, lead as well.
std::vector<RootCycle> leading_cycles(const std::vector<Matrix>& matrices, const std::vector<Candidate>& products,
                                      double tolerance, const Deadline& deadline);

/// The vectors and their images under the symmetry.
std::vector<ComplexVector> with_images(const std::vector<ComplexVector>& vectors, const GroupAction& action);

/// Calls visit(x) for the points of the orbit of `front`, at most `width` of them, of largest `value`, per generation.
/// Point: Vector or ComplexVector.
template <class Point, class Value, class Visit>
void follow_orbit(std::vector<Point> front, const std::vector<Matrix>& matrices, int generations, std::size_t width,
                  const Deadline& deadline, Value value, Visit visit) {
  for (int generation = 0; generation < generations; ++generation) {
    std::vector<std::pair<double, Point>> next;
    next.reserve(front.size() * matrices.size());
    for (std::size_t k = 0; k < front.size(); ++k) {
      if (k % 16 == 0 && deadline.expired()) return;
      for (const Matrix& a : matrices) {
        Point x = a * front[k];
        const double size = value(x);
        next.emplace_back(size, std::move(x));
      }
    }
    if (next.size() > width) {
      std::nth_element(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(width), next.end(),
                       [](const auto& a, const auto& b) { return a.first > b.first; });
      next.resize(width);
    }
    front.clear();
    for (auto& [size, x] : next) {
      visit(x);
      front.push_back(std::move(x));
    }
  }
}

/// Sizes of the root cycles so that no orbit of one sticks out at the roots of another: with q_ij the largest value of
/// the dual vectors of j on the orbit of i, maximises t in log size_i + log q_ij + t <= log size_j. Ref: [GP16].
void balance(std::vector<RootCycle>& cycles, const std::vector<Matrix>& matrices, const GroupAction& action,
             PolytopeKind kind, const Budget& budget);

}  // namespace subcert::polytope
