// Vertices beside the orbits of the roots: for a round polytope, and for one that spans.
#include "decompositions.hpp"
#include "polytope_run.hpp"

#include <algorithm>
#include <cmath>

namespace subcert::polytope {

namespace {

constexpr double longest_extra = 1e6;  // relative to the roots: rounding of longer ones would move the faces there
constexpr int orbit_generations = 20;  // of such an orbit; it reaches farthest in the first few
constexpr std::size_t orbit_width = 16;
constexpr double nearly_kept = 0.999;      // cosine between a unit vector and its image
constexpr double covered_rest = 0.1;       // of a unit vector that images of others nearly span
constexpr double spanning_size = 0.02;     // of vertices added only to span, relative to the largest vertex
constexpr double flat_eigenvalue = 1e-16;  // relative eigenvalue, per coordinate, of a direction that no vertex reaches

// The largest modulus of complex functionals on real points.
class LargestValue {
 public:
  explicit LargestValue(const std::vector<ComplexVector>& functionals) {
    for (const ComplexVector& u : functionals) {
      Vector re, im;
      for (const auto& entry : u) {
        re.push_back(entry.real());
        im.push_back(entry.imag());
      }
      if (std::all_of(im.begin(), im.end(), [](double y) { return y == 0; })) im.clear();
      parts_.emplace_back(std::move(re), std::move(im));
    }
  }

  double operator()(const Vector& x) const {
    double largest = 0;
    for (const auto& [re, im] : parts_) {
      const double value = inner(re, x);
      largest = std::max(largest, im.empty() ? std::abs(value) : std::hypot(value, inner(im, x)));
    }
    return largest;
  }

 private:
  std::vector<std::pair<Vector, Vector>> parts_;  // real and imaginary, the latter empty if zero
};

// The part of a unit vector that is kept, up to signs, by the elements that nearly keep it.
Vector kept_by_stabiliser(const Vector& x, const GroupAction& action) {
  Vector sum(x.size(), 0.0);
  for (int g = 0; g < action.order(); ++g) {
    Vector image = x;
    action.apply(g, image.data());
    const double cosine = inner(x, image);
    if (std::abs(cosine) < nearly_kept) continue;
    for (std::size_t i = 0; i < x.size(); ++i) sum[i] += cosine > 0 ? image[i] : -image[i];
  }
  const double size = norm(sum);
  for (double& entry : sum) entry /= size;
  return sum;
}

class OrthonormalVectors {
 public:
  /// x without its part in the span.
  Vector rest(Vector x) const {
    for (const Vector& q : vectors_) {
      const double part = inner(q, x);
      for (std::size_t i = 0; i < x.size(); ++i) x[i] -= part * q[i];
    }
    return x;
  }
  void add(const Vector& x) {
    Vector q = rest(x);
    const double size = norm(q);
    if (size < covered_rest * norm(x)) return;
    for (double& entry : q) entry /= size;
    vectors_.push_back(std::move(q));
  }

 private:
  std::vector<Vector> vectors_;
};

}  // namespace

// One vertex in each of a set of orthogonal directions, as long as its orbit allows: it must stay well behind the faces
// u.x = 1 at the roots, u their dual vectors. The hull of the roots' orbit alone is flat where the matrices nearly
// share an eigenvector, and then takes many vertices that differ little. Ref: [GP16] (balancing), [Mej20] (extra
// vertices).
void PolytopeRun::add_extra_vertices() {
  if (kind_ == PolytopeKind::nonnegative) return;
  std::vector<ComplexVector> duals;
  for (const RootCycle& cycle : cycles_) {
    for (const ComplexVector& u : cycle.left) {
      duals.push_back(u);
      divide(duals.back(), cycle.size);
    }
  }
  if (duals.empty()) return;
  duals = with_images(duals, coordinates_.action);
  Matrix gram(dimension_, dimension_);
  for (const ComplexVector& u : duals) {
    for (std::size_t j = 0; j < dimension_; ++j)
      for (std::size_t i = 0; i < dimension_; ++i) gram(i, j) += (u[i] * std::conj(u[j])).real();
  }
  const LargestValue largest(duals);
  double length = 0;
  for (const Node& root : vertices_) length = std::max(length, norm(root.value));
  OrthonormalVectors covered;  // by the images of the extra vertices under a dense group
  std::size_t begin = 0;
  for (const std::size_t size : coordinates_.blocks) {
    if (size == 0) continue;
    const SymmetricDecomposition eigen = symmetric_decomposition(gram.diagonal_block(begin, size));
    for (std::size_t k = 0; k < size && !options_.budget.deadline.expired() && !full(); ++k) {
      Vector x(dimension_, 0.0);
      std::copy_n(eigen.vectors.column(k), size, x.begin() + static_cast<std::ptrdiff_t>(begin));
      if (coordinates_.action.is_dense()) {
        x = kept_by_stabiliser(x, coordinates_.action);
        if (norm(covered.rest(x)) < covered_rest) continue;
        for (int g = 0; g < coordinates_.action.order(); ++g) covered.add(acted_on(g, x));
      }
      double reach = largest(x);
      follow_orbit<Vector>({x}, matrices_, orbit_generations, orbit_width, options_.budget.deadline, largest,
                           [&](const Vector& y) { reach = std::max(reach, largest(y)); });
      if (!(reach > 0)) continue;
      const double factor = std::min(extra_reach_ / reach, longest_extra * length);
      Vector vertex(simplex_.dimension(), 0.0);
      for (std::size_t i = 0; i < dimension_; ++i) vertex[i] = factor * x[i];
      add({std::move(vertex)});
    }
    begin += size;
  }
}

// The sum of v v^T over the vertices and their images, real and imaginary parts apart; `size` becomes the largest norm.
Matrix PolytopeRun::gram_of_vertices(double& size) const {
  Matrix gram(dimension_, dimension_);
  size = 0;
  for (const Node& node : vertices_) {
    for (std::size_t h = 0; h < node.value.size(); h += dimension_) {
      for (int g = 0; g < coordinates_.action.order(); ++g) {
        const auto part = node.value.begin() + static_cast<std::ptrdiff_t>(h);
        Vector v(part, part + static_cast<std::ptrdiff_t>(dimension_));
        coordinates_.action.apply(g, v.data());
        size = std::max(size, norm(v));
        for (std::size_t j = 0; j < dimension_; ++j)
          for (std::size_t i = 0; i < dimension_; ++i) gram(i, j) += v[i] * v[j];
      }
    }
  }
  return gram;
}

// Small vertices in the directions no vertex reaches.
void PolytopeRun::add_spanning_vertices() {
  double size = 0;
  const Matrix gram = gram_of_vertices(size);
  Vector vertex(simplex_.dimension(), 0.0);
  if (kind_ == PolytopeKind::nonnegative) {
    // The cone hull has inner points once every coordinate is reached.
    for (std::size_t k = 0; k < dimension_; ++k) {
      if (gram(k, k) > 0) continue;
      vertex[k] = spanning_size * size;
      add({vertex});
      vertex[k] = 0;
    }
    return;
  }
  const SymmetricDecomposition eigen = symmetric_decomposition(gram);
  const double flat = flat_eigenvalue * *std::max_element(eigen.values.begin(), eigen.values.end()) *
                      static_cast<double>(dimension_);
  for (std::size_t k = 0; k < dimension_; ++k) {
    if (eigen.values[k] > flat) continue;
    for (std::size_t i = 0; i < dimension_; ++i) vertex[i] = eigen.vectors(i, k) * (spanning_size * size);
    add({vertex});
  }
}

}  // namespace subcert::polytope
