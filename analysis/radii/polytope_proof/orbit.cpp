#include "orbit.hpp"

#include <subcert/analysis/symbol/numbers/boost_numbers.hpp>

#include <utility>

namespace subcert::radius {
namespace {

struct RealMatrix {
  std::size_t size;
  std::vector<Real> entries;
  const Real& operator()(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
  Real& operator()(std::size_t i, std::size_t j) { return entries[i * size + j]; }
};

RealMatrix operator*(const RealMatrix& a, const RealMatrix& b) {
  RealMatrix result{a.size, std::vector<Real>(a.size * a.size, 0)};
  for (std::size_t i = 0; i < a.size; ++i)
    for (std::size_t k = 0; k < a.size; ++k)
      if (a(i, k) != 0)
        for (std::size_t j = 0; j < a.size; ++j) result(i, j) += a(i, k) * b(k, j);
  return result;
}

RealVector operator*(const RealMatrix& a, const RealVector& x) {
  RealVector result(x.empty() ? 0 : a.size, 0);
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < a.size; ++j)
      if (a(i, j) != 0) result[i] += a(i, j) * x[j];
  return result;
}

RealMatrix to_real(const RationalMatrix& m) {
  RealMatrix result{m.rows(), std::vector<Real>(m.rows() * m.rows())};
  for (std::size_t i = 0; i < m.rows(); ++i)
    for (std::size_t j = 0; j < m.rows(); ++j) result(i, j) = Real(to_boost(m(i, j)));
  return result;
}

OrbitPoint operator*(const RealMatrix& a, const OrbitPoint& v) { return {a * v.x, a * v.y}; }

Real dot(const RealVector& x, const RealVector& y) {
  Real sum = 0;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) sum += x[i] * y[i];
  return sum;
}

Real squared_norm(const OrbitPoint& v) { return dot(v.x, v.x) + dot(v.y, v.y); }

bool is_finite(const OrbitPoint& v) { return isfinite(squared_norm(v)); }

/// The real and imaginary parts of conj(a) . b.
std::pair<Real, Real> inner(const OrbitPoint& a, const OrbitPoint& b) {
  return {dot(a.x, b.x) + dot(a.y, b.y), dot(a.x, b.y) - dot(a.y, b.x)};
}

/// v times re + i im; im = 0 for real vectors.
OrbitPoint scaled(OrbitPoint v, const Real& re, const Real& im) {
  for (std::size_t i = 0; i < v.x.size(); ++i) {
    const Real x = v.x[i];
    v.x[i] = v.is_complex() ? Real(re * x - im * v.y[i]) : Real(re * x);
    if (v.is_complex()) v.y[i] = re * v.y[i] + im * x;
  }
  return v;
}

OrbitPoint from_double(const std::vector<std::complex<double>>& v, bool is_complex) {
  OrbitPoint result;
  for (const std::complex<double>& c : v) {
    result.x.emplace_back(c.real());
    if (is_complex) result.y.emplace_back(c.imag());
  }
  return result;
}

/// x with a x = b, by elimination with row pivots; tiny pivots are what inverse iteration wants.
RealVector solve(RealMatrix a, RealVector b) {
  const std::size_t n = a.size;
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (abs(a(i, k)) > abs(a(pivot, k))) pivot = i;
    if (pivot != k) {
      for (std::size_t j = k; j < n; ++j) std::swap(a(pivot, j), a(k, j));
      std::swap(b[pivot], b[k]);
    }
    if (a(k, k) == 0) a(k, k) = Real("1e-58");
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = a(i, k) / a(k, k);
      if (factor == 0) continue;
      for (std::size_t j = k; j < n; ++j) a(i, j) -= factor * a(k, j);
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a(k, j) * b[j];
    b[k] /= a(k, k);
  }
  return b;
}

struct EigenPair {
  Real modulus;
  OrbitPoint vector;
};

/// (a - shift_re - i shift_im)^-1 v, a complex system as a real one of twice the size.
OrbitPoint solve_shifted(const RealMatrix& a, const Real& shift_re, const Real& shift_im, const OrbitPoint& v) {
  const std::size_t n = a.size, size = v.is_complex() ? 2 * n : n;
  RealMatrix system{size, std::vector<Real>(size * size, 0)};
  for (std::size_t block = 0; block < size; block += n)
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) system(block + i, block + j) = a(i, j);
      system(block + i, block + i) -= shift_re;
      if (v.is_complex()) system(block + i, n - block + i) = block == 0 ? shift_im : Real(-shift_im);
    }
  RealVector right = v.x;
  right.insert(right.end(), v.y.begin(), v.y.end());
  const RealVector solution = solve(std::move(system), std::move(right));
  const auto middle = solution.begin() + static_cast<std::ptrdiff_t>(n);
  return {RealVector(solution.begin(), middle), RealVector(middle, solution.end())};
}

/// Inverse iteration from a good start and a number near the eigenvalue.
EigenPair refine_eigenpair(const RealMatrix& a, OrbitPoint v, const std::pair<Real, Real>& near) {
  const auto normalised = [](const OrbitPoint& w) { return scaled(w, 1 / sqrt(squared_norm(w)), 0); };
  const Real off = 1 + Real("1e-14");
  for (int k = 0; k < 5; ++k) v = normalised(solve_shifted(a, near.first * off, near.second * off, v));
  const auto [value_re, value_im] = inner(v, a * v);
  return {sqrt(value_re * value_re + value_im * value_im), v};
}

class OrbitWalk {
 public:
  OrbitWalk(const MatrixFamily& family, const PolytopeCandidate& candidate)
      : candidate_(candidate),
        to_search_(to_real(candidate.coordinates.to)),
        from_search_(to_real(candidate.coordinates.from)) {
    for (const RationalMatrix& m : family) matrices_.push_back(to_real(candidate.transposed ? transposed(m) : m));
  }

  std::optional<Orbit> run(const Deadline& deadline) {
    std::vector<OrbitPoint> values;
    for (const PolytopeCandidate::Vertex& vertex : candidate_.vertices) {
      if (deadline.expired()) return std::nullopt;
      if (vertex.parent >= 0)
        values.push_back(
            scaled(matrix(vertex.letter) * values[static_cast<std::size_t>(vertex.parent)], 1 / scale(), 0));
      else if (vertex.cycle >= 0)
        values.push_back(root(vertex));
      else
        values.push_back(from_search(from_double(vertex.value, is_complex())));
      if (!is_finite(values.back()) || !isfinite(scale())) return std::nullopt;
    }
    return Orbit{std::move(values), scale()};
  }

 private:
  /// A root that is known.
  struct Root {
    int cycle;
    int place;
    Real radius;
    OrbitPoint vector;
  };

  bool is_complex() const { return candidate_.kind == PolytopeKind::complex; }
  const RealMatrix& matrix(int letter) const { return matrices_[static_cast<std::size_t>(letter)]; }

  OrbitPoint in_search(const OrbitPoint& v) const { return to_search_.size == 0 ? v : to_search_ * v; }
  OrbitPoint from_search(const OrbitPoint& v) const { return from_search_.size == 0 ? v : from_search_ * v; }

  const Real& scale() {
    if (!scale_) scale_ = candidate_.scale_is_radius() && first_radius_ ? *first_radius_ : Real(candidate_.scale);
    return *scale_;
  }

  OrbitPoint root(const PolytopeCandidate::Vertex& vertex) {
    const std::vector<int>& cycle = candidate_.products[static_cast<std::size_t>(vertex.cycle)].word;
    const auto letter = [&cycle](int place) { return cycle[static_cast<std::size_t>(place) % cycle.size()]; };
    const int length = static_cast<int>(cycle.size());
    const OrbitPoint near = from_double(vertex.value, is_complex());
    // w over v, in the coordinates of the search, where both are known well.
    const auto ratio = [&](const OrbitPoint& v, const OrbitPoint& w) {
      const auto [re, im] = inner(v, w);
      const Real size = squared_norm(v);
      return std::pair{Real(re / size), Real(im / size)};
    };
    for (const Root& known : roots_) {
      if (known.cycle != vertex.cycle) continue;
      // Along the cycle from the first root of it that is known.
      OrbitPoint value = known.vector;
      for (int place = known.place; place != vertex.place; place = (place + 1) % length)
        value = scaled(matrix(letter(place)) * value, 1 / known.radius, 0);
      const auto [re, im] = ratio(in_search(value), near);
      // The search turns real eigenvectors as it likes; anything else is another eigenvector of the same product.
      const Real turned = is_complex() ? re : Real(abs(re));
      if (abs(turned - 1) > Real("1e-6") || abs(im) > Real("1e-6")) continue;
      return re < 0 ? scaled(value, -1, 0) : value;
    }
    RealMatrix product = matrix(letter(vertex.place));
    for (int k = 1; k < length; ++k) product = matrix(letter(vertex.place + k)) * product;
    const OrbitPoint start = from_search(near);
    const EigenPair pair = refine_eigenpair(product, start, ratio(near, in_search(product * start)));
    const Real radius = pow(pair.modulus, 1 / Real(length));
    if (vertex.cycle == 0) first_radius_ = radius;
    const auto [re, im] = ratio(in_search(pair.vector), near);
    roots_.push_back({vertex.cycle, vertex.place, radius, scaled(pair.vector, re, im)});
    return roots_.back().vector;
  }

  const PolytopeCandidate& candidate_;
  RealMatrix to_search_, from_search_;  // empty where both coordinates are the same
  std::vector<RealMatrix> matrices_;
  std::vector<Root> roots_;
  std::optional<Real> first_radius_, scale_;
};

}  // namespace

std::optional<Orbit> recomputed_orbit(const MatrixFamily& family, const PolytopeCandidate& candidate,
                                      const Deadline& deadline) {
  return OrbitWalk(family, candidate).run(deadline);
}

}  // namespace subcert::radius
