#include "certified_polytope.hpp"

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <cmath>

namespace subcert {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>, boost::multiprecision::et_off>;
using RealVector = std::vector<Real>;

constexpr int vertex_bits = 112;
constexpr int weight_bits = 112;
constexpr int refinements = 4;

struct RealMatrix {
  std::size_t size;
  std::vector<Real> entries;
  const Real& operator()(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
  Real& operator()(std::size_t i, std::size_t j) { return entries[i * size + j]; }
};

RealVector operator*(const RealMatrix& a, const RealVector& x) {
  RealVector result(a.size, 0);
  for (std::size_t i = 0; i < a.size; ++i)
    for (std::size_t j = 0; j < a.size; ++j)
      if (a(i, j) != 0) result[i] += a(i, j) * x[j];
  return result;
}

Real dot(const RealVector& x, const RealVector& y) {
  Real sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[i];
  return sum;
}

RealVector from_double(const Eigen::VectorXcd& x) {
  RealVector result;
  for (Eigen::Index i = 0; i < x.size(); ++i) result.emplace_back(x[i].real());
  return result;
}

/// x with (a - shift) x = b, by elimination with row pivots; tiny pivots are what inverse iteration wants.
RealVector solve_shifted(RealMatrix a, const Real& shift, RealVector b) {
  const std::size_t n = a.size;
  for (std::size_t i = 0; i < n; ++i) a(i, i) -= shift;
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
  Real value;
  RealVector vector;
};

/// Inverse iteration from a good start.
EigenPair refine_eigenpair(const RealMatrix& a, RealVector x) {
  const auto normalise = [](RealVector& v) {
    const Real norm = sqrt(dot(v, v));
    for (Real& c : v) c /= norm;
  };
  normalise(x);
  const Real shift = dot(x, a * x) * (1 + Real("1e-14"));
  for (int k = 0; k < 5; ++k) {
    x = solve_shifted(a, shift, x);
    normalise(x);
  }
  return {dot(x, a * x), x};
}

/// The orbit of the search once more, at the precision of Real.
class Orbit {
 public:
  Orbit(const std::vector<RationalMatrix>& matrices, const SearchResult& result) : result_(result) {
    for (const RationalMatrix& m : matrices) {
      RealMatrix real{m.rows(), std::vector<Real>(m.rows() * m.rows())};
      for (std::size_t i = 0; i < m.rows(); ++i)
        for (std::size_t j = 0; j < m.rows(); ++j) {
          const Rational& entry = result.transposed ? m(j, i) : m(i, j);
          real(i, j) = Real(numerator(entry)) / Real(denominator(entry));
        }
      matrices_.push_back(std::move(real));
    }
  }

  std::vector<RealVector> vertices() {
    std::vector<RealVector> values;
    for (const Vertex& vertex : result_.vertices) {
      RealVector value;
      if (vertex.parent >= 0) {
        value = matrices_[static_cast<std::size_t>(vertex.letter)] * values[static_cast<std::size_t>(vertex.parent)];
        for (Real& c : value) c /= scale();
      } else if (vertex.cycle >= 0) {
        value = root(vertex);
      } else {
        value = from_double(vertex.value);
      }
      values.push_back(std::move(value));
    }
    return values;
  }

 private:
  /// What images are divided by: the radius of the first product where the search used it.
  const Real& scale() {
    if (!scale_) scale_ = result_.scale == result_.radius && first_radius_ ? *first_radius_ : Real(result_.scale);
    return *scale_;
  }

  RealVector root(const Vertex& vertex) {
    const std::vector<int>& word = result_.products[static_cast<std::size_t>(vertex.cycle)].word;
    const RealVector near = from_double(vertex.value);
    for (const Turn& turn : turns_) {
      if (turn.cycle != vertex.cycle) continue;
      // Along the cycle from the first root of it that is known.
      RealVector value = turn.vector;
      for (int place = turn.place; place != vertex.place; place = (place + 1) % static_cast<int>(word.size())) {
        value = matrices_[static_cast<std::size_t>(word[static_cast<std::size_t>(place)])] * value;
        for (Real& c : value) c /= turn.radius;
      }
      const Real size = dot(value, near) / dot(value, value);
      if (abs(abs(size) - 1) > Real("1e-6")) continue;  // another eigenvector of the same product
      if (size < 0)
        for (Real& c : value) c = -c;
      return value;
    }
    RealMatrix product = matrices_[static_cast<std::size_t>(word[static_cast<std::size_t>(vertex.place)])];
    for (std::size_t k = 1; k < word.size(); ++k)
      product = times(matrices_[static_cast<std::size_t>(word[(static_cast<std::size_t>(vertex.place) + k) % word.size()])],
                      product);
    EigenPair pair = refine_eigenpair(product, near);
    const Real radius = pow(abs(pair.value), 1 / Real(word.size()));
    if (vertex.cycle == 0) first_radius_ = radius;
    const Real size = dot(pair.vector, near);
    for (Real& c : pair.vector) c *= size;
    turns_.push_back({vertex.cycle, vertex.place, radius, pair.vector});
    return pair.vector;
  }

  static RealMatrix times(const RealMatrix& a, const RealMatrix& b) {
    RealMatrix result{a.size, std::vector<Real>(a.size * a.size, 0)};
    for (std::size_t i = 0; i < a.size; ++i)
      for (std::size_t k = 0; k < a.size; ++k)
        if (a(i, k) != 0)
          for (std::size_t j = 0; j < a.size; ++j) result(i, j) += a(i, k) * b(k, j);
    return result;
  }

  struct Turn {
    int cycle;
    int place;
    Real radius;
    RealVector vector;
  };

  const SearchResult& result_;
  std::vector<RealMatrix> matrices_;
  std::vector<Turn> turns_;
  std::optional<Real> first_radius_, scale_;
};

Integer round_scaled(const Real& value, int bits) { return Integer(round(ldexp(value, bits))); }

double to_double(const Integer& value, long exponent) {
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, value.backend().data());
  return std::ldexp(mantissa, static_cast<int>(std::clamp(own + exponent, -2000L, 2000L)));
}

class Certifier {
 public:
  Certifier(const std::vector<RationalMatrix>& matrices, bool symmetric, const SearchResult& result)
      : result_(result), size_(matrices.front().rows()) {
    polytope_.kind = result.kind;
    polytope_.symmetric = symmetric;
    polytope_.transposed = result.transposed;
    polytope_.vertex_bits = vertex_bits;
    polytope_.weight_bits = weight_bits;
    for (const RationalMatrix& m : matrices)
      for (std::size_t i = 0; i < size_; ++i)
        for (std::size_t j = 0; j < size_; ++j) denominator_ = lcm(denominator_, Integer(denominator(m(i, j))));
    for (const RationalMatrix& m : matrices) {
      std::vector<Integer> entries;
      for (std::size_t i = 0; i < size_; ++i)
        for (std::size_t j = 0; j < size_; ++j) {
          const Rational& entry = result.transposed ? m(j, i) : m(i, j);
          entries.push_back(numerator(entry) * (denominator_ / denominator(entry)));
        }
      matrices_.push_back(std::move(entries));
    }
    const bool cone = result.kind == PolytopeKind::nonnegative;
    for (const RealVector& vertex : Orbit(matrices, result).vertices()) {
      std::vector<Integer> rounded;
      for (const Real& c : vertex) rounded.push_back(round_scaled(cone ? abs(c) : c, vertex_bits));
      polytope_.vertices.push_back(std::move(rounded));
    }
  }

  std::optional<CertifiedPolytope> run() {
    if (result_.kind == PolytopeKind::complex || polytope_.vertices.empty() || !express_units()) return std::nullopt;
    Integer largest = 0;  // bound times denominator * 2^(vertex_bits + weight_bits)
    for (const ImageProof& proof : result_.images) {
      const std::vector<Integer> image = apply(static_cast<std::size_t>(proof.letter),
                                               polytope_.vertices[static_cast<std::size_t>(proof.vertex)]);
      std::vector<WeightedVertex> terms = express(image, start_from(proof));
      const Integer residual = residual_size(image, terms);
      Integer weight = 0;
      for (const WeightedVertex& term : terms) weight += abs(term.weight);
      largest = std::max(largest, Integer((weight * denominator_ << vertex_bits) + residual * unit_norm_));
      polytope_.images.push_back(std::move(terms));
    }
    polytope_.bound = Rational(largest, denominator_ << (vertex_bits + weight_bits));
    return std::move(polytope_);
  }

 private:
  bool cone() const { return polytope_.kind == PolytopeKind::nonnegative; }

  /// denominator_ * 2^vertex_bits times the image of a vertex.
  std::vector<Integer> apply(std::size_t letter, const std::vector<Integer>& vertex) const {
    std::vector<Integer> result(size_, 0);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j)
        mpz_addmul(result[i].backend().data(), matrices_[letter][i * size_ + j].backend().data(),
                   vertex[j].backend().data());
    return result;
  }

  const Integer& coordinate(const WeightedVertex& term, std::size_t i) const {
    return polytope_.vertices[term.vertex][term.flipped ? size_ - 1 - i : i];
  }

  /// target 2^weight_bits - denominator_ * (sum of weight * vertex), all times 2^vertex_bits.
  std::vector<Integer> residual(const std::vector<Integer>& target, const std::vector<WeightedVertex>& terms) const {
    std::vector<Integer> result(size_);
    for (std::size_t i = 0; i < size_; ++i) {
      Integer sum = 0;
      for (const WeightedVertex& term : terms)
        mpz_addmul(sum.backend().data(), term.weight.backend().data(), coordinate(term, i).backend().data());
      result[i] = (target[i] << weight_bits) - denominator_ * sum;
    }
    return result;
  }

  /// The 1-norm of the residual, of its positive part for the cone.
  Integer residual_size(const std::vector<Integer>& target, const std::vector<WeightedVertex>& terms) const {
    Integer sum = 0;
    for (const Integer& c : residual(target, terms))
      if (c > 0 || !cone()) sum += abs(c);
    return sum;
  }

  std::vector<WeightedVertex> start_from(const ImageProof& proof) const {
    std::vector<WeightedVertex> terms;
    for (const Term& term : proof.terms)
      terms.push_back({static_cast<std::size_t>(term.vertex), term.flipped,
                       round_scaled(Real(term.coefficient.real()) * Real(result_.scale), weight_bits)});
    return terms;
  }

  /// Corrects the weights until the residual is at the level of the rounding, in double precision steps against exact
  /// residuals. For the cone the weights only need to dominate, so they are kept and rounded up.
  std::vector<WeightedVertex> express(const std::vector<Integer>& target, std::vector<WeightedVertex> terms) const {
    if (terms.empty()) return terms;
    if (cone()) {
      for (WeightedVertex& term : terms) term.weight = std::max(Integer(0), term.weight);
      return terms;
    }
    Eigen::MatrixXd basis(static_cast<Eigen::Index>(size_), static_cast<Eigen::Index>(terms.size()));
    for (std::size_t k = 0; k < terms.size(); ++k)
      for (std::size_t i = 0; i < size_; ++i)
        basis(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = to_double(coordinate(terms[k], i), -vertex_bits);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(basis);
    // Residuals are denominator_ * 2^(vertex_bits + weight_bits) times their value; weights 2^weight_bits times theirs.
    const double scale = 1 / to_double(denominator_, 0);
    for (int round_of = 0; round_of < refinements; ++round_of) {
      const std::vector<Integer> rest = residual(target, terms);
      Eigen::VectorXd right(static_cast<Eigen::Index>(size_));
      long exponent = 0;  // the largest residual, so that small ones keep their digits
      for (const Integer& c : rest)
        if (c != 0) exponent = std::max(exponent, static_cast<long>(mpz_sizeinbase(c.backend().data(), 2)));
      if (exponent == 0) break;
      for (std::size_t i = 0; i < size_; ++i) right[static_cast<Eigen::Index>(i)] = to_double(rest[i], -exponent);
      const Eigen::VectorXd correction = factors.solve(right) * scale;
      const long shift = exponent - vertex_bits;  // correction * 2^shift in units of 2^-weight_bits
      bool changed = false;
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const double c = correction[static_cast<Eigen::Index>(k)];
        if (!std::isfinite(c)) return terms;
        const Integer step = round_scaled(Real(c), static_cast<int>(shift));
        changed = changed || step != 0;
        terms[k].weight += step;
      }
      if (!changed) break;
    }
    return terms;
  }

  /// Combinations of the unit vectors, and the bound unit_norm_ for their norms that follows. False where the vertices
  /// do not span.
  bool express_units() {
    std::vector<WeightedVertex> all;
    for (std::size_t v = 0; v < polytope_.vertices.size(); ++v) {
      all.push_back({v, false, 0});
      if (polytope_.symmetric) all.push_back({v, true, 0});
    }
    const std::size_t count = polytope_.symmetric ? (size_ + 1) / 2 : size_;
    std::vector<WeightedVertex> basis;
    if (!cone()) {
      Eigen::MatrixXd columns(static_cast<Eigen::Index>(size_), static_cast<Eigen::Index>(all.size()));
      for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t i = 0; i < size_; ++i)
          columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = to_double(coordinate(all[k], i), -vertex_bits);
      const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> factors(columns);
      if (factors.rank() < static_cast<Eigen::Index>(size_)) return false;
      for (std::size_t k = 0; k < size_; ++k)
        basis.push_back(all[static_cast<std::size_t>(factors.colsPermutation().indices()[static_cast<Eigen::Index>(k)])]);
    }
    Integer most = 0, largest_residual = 0;
    for (std::size_t k = 0; k < count; ++k) {
      std::vector<Integer> target(size_, 0);
      target[k] = denominator_ << vertex_bits;
      std::vector<WeightedVertex> terms = basis;
      if (cone()) {
        const auto best = std::max_element(all.begin(), all.end(), [&](const WeightedVertex& a, const WeightedVertex& b) {
          return coordinate(a, k) < coordinate(b, k);
        });
        if (coordinate(*best, k) <= 0) return false;
        terms = {*best};
        terms.front().weight = ((Integer(1) << (vertex_bits + weight_bits)) / coordinate(*best, k)) + 1;
      } else {
        terms = express(target, terms);
      }
      Integer weight = 0;
      for (const WeightedVertex& term : terms) weight += abs(term.weight);
      most = std::max(most, weight);
      largest_residual = std::max(largest_residual, residual_size(target, terms));
      polytope_.units.push_back(std::move(terms));
    }
    const Integer one = denominator_ << (vertex_bits + weight_bits);
    if (largest_residual >= one) return false;
    // E = S / (1 - R), rounded up to an integer.
    const Rational norm = Rational(most, Integer(1) << weight_bits) / (1 - Rational(largest_residual, one));
    unit_norm_ = numerator(norm) / denominator(norm) + 1;
    return true;
  }

  const SearchResult& result_;
  std::size_t size_;
  Integer denominator_ = 1;
  std::vector<std::vector<Integer>> matrices_;  // denominator_ times the matrices, transposed where the search was
  Integer unit_norm_ = 0;
  CertifiedPolytope polytope_{};
};

}  // namespace

std::optional<CertifiedPolytope> certify_polytope(const std::vector<RationalMatrix>& matrices, bool symmetric,
                                                  const SearchResult& result) {
  if (result.kind == PolytopeKind::complex || result.vertices.empty()) return std::nullopt;
  return Certifier(matrices, symmetric, result).run();
}

}  // namespace subcert
