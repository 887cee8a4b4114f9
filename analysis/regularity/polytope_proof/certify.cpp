#include "certified_polytope.hpp"

#include <boost/multiprecision/mpfr.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <type_traits>
#include <utility>

namespace subcert {
namespace {

using Real =
    boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>, boost::multiprecision::et_off>;
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

/// x + i y; y is empty for real vectors.
struct Vector {
  RealVector x, y;
  bool is_complex() const { return !y.empty(); }
};

RealVector operator*(const RealMatrix& a, const RealVector& x) {
  RealVector result(x.empty() ? 0 : a.size, 0);
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < a.size; ++j)
      if (a(i, j) != 0) result[i] += a(i, j) * x[j];
  return result;
}

Vector operator*(const RealMatrix& a, const Vector& v) { return {a * v.x, a * v.y}; }

Real dot(const RealVector& x, const RealVector& y) {
  Real sum = 0;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) sum += x[i] * y[i];
  return sum;
}

Real squared_norm(const Vector& v) { return dot(v.x, v.x) + dot(v.y, v.y); }

/// The real and imaginary parts of conj(a) . b.
std::pair<Real, Real> inner(const Vector& a, const Vector& b) {
  return {dot(a.x, b.x) + dot(a.y, b.y), dot(a.x, b.y) - dot(a.y, b.x)};
}

/// v times re + i im; im = 0 for real vectors.
Vector scaled(Vector v, const Real& re, const Real& im) {
  for (std::size_t i = 0; i < v.x.size(); ++i) {
    const Real x = v.x[i];
    v.x[i] = v.is_complex() ? Real(re * x - im * v.y[i]) : Real(re * x);
    if (v.is_complex()) v.y[i] = re * v.y[i] + im * x;
  }
  return v;
}

Vector from_double(const Eigen::VectorXcd& v, bool is_complex) {
  Vector result;
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    result.x.emplace_back(v[i].real());
    if (is_complex) result.y.emplace_back(v[i].imag());
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
  Vector vector;
};

/// (a - shift_re - i shift_im)^-1 v, a complex system as a real one of twice the size.
Vector solve_shifted(const RealMatrix& a, const Real& shift_re, const Real& shift_im, const Vector& v) {
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

/// Inverse iteration from a good start.
EigenPair refine_eigenpair(const RealMatrix& a, Vector v) {
  const auto normalised = [](const Vector& w) { return scaled(w, 1 / sqrt(squared_norm(w)), 0); };
  v = normalised(v);
  const auto [re, im] = inner(v, a * v);
  const Real off = 1 + Real("1e-14");
  for (int k = 0; k < 5; ++k) v = normalised(solve_shifted(a, re * off, im * off, v));
  const auto [value_re, value_im] = inner(v, a * v);
  return {sqrt(value_re * value_re + value_im * value_im), v};
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

  std::vector<Vector> vertices() {
    std::vector<Vector> values;
    for (const Vertex& vertex : result_.vertices) {
      if (vertex.parent >= 0)
        values.push_back(
            scaled(matrices_[static_cast<std::size_t>(vertex.letter)] * values[static_cast<std::size_t>(vertex.parent)],
                   1 / scale(), 0));
      else if (vertex.cycle >= 0)
        values.push_back(root(vertex));
      else
        values.push_back(from_double(vertex.value, is_complex()));
    }
    return values;
  }

  /// What images are divided by: the radius of the first product where the search used it.
  const Real& scale() {
    if (!scale_) scale_ = result_.scale == result_.radius && first_radius_ ? *first_radius_ : Real(result_.scale);
    return *scale_;
  }

 private:
  bool is_complex() const { return result_.kind == PolytopeKind::complex; }

  Vector root(const Vertex& vertex) {
    const std::vector<int>& word = result_.products[static_cast<std::size_t>(vertex.cycle)].word;
    const Vector near = from_double(vertex.value, is_complex());
    for (const Turn& turn : turns_) {
      if (turn.cycle != vertex.cycle) continue;
      // Along the cycle from the first root of it that is known.
      Vector value = turn.vector;
      for (int place = turn.place; place != vertex.place; place = (place + 1) % static_cast<int>(word.size()))
        value = scaled(matrices_[static_cast<std::size_t>(word[static_cast<std::size_t>(place)])] * value,
                       1 / turn.radius, 0);
      const auto [re, im] = inner(value, near);
      const Real size = squared_norm(value);
      // The search turns real eigenvectors as it likes; anything else is another eigenvector of the same product.
      const Real turned = is_complex() ? Real(re / size) : Real(abs(re / size));
      if (abs(turned - 1) > Real("1e-6") || abs(im / size) > Real("1e-6")) continue;
      return re < 0 ? scaled(value, -1, 0) : value;
    }
    RealMatrix product = matrices_[static_cast<std::size_t>(word[static_cast<std::size_t>(vertex.place)])];
    for (std::size_t k = 1; k < word.size(); ++k)
      product = times(
          matrices_[static_cast<std::size_t>(word[(static_cast<std::size_t>(vertex.place) + k) % word.size()])],
          product);
    const EigenPair pair = refine_eigenpair(product, near);
    const Real radius = pow(pair.modulus, 1 / Real(word.size()));
    if (vertex.cycle == 0) first_radius_ = radius;
    const auto [re, im] = inner(pair.vector, near);
    const Vector vector = scaled(pair.vector, re, im);
    turns_.push_back({vertex.cycle, vertex.place, radius, vector});
    return vector;
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
    Vector vector;
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
    const auto rounded = [&](const RealVector& values) {
      std::vector<Integer> integers;
      for (const Real& c : values) integers.push_back(round_scaled(cone() ? Real(abs(c)) : c, vertex_bits));
      return integers;
    };
    Orbit orbit(matrices, result);
    for (const Vector& vertex : orbit.vertices()) {
      polytope_.vertices.push_back(rounded(vertex.x));
      if (vertex.is_complex()) polytope_.imaginary.push_back(rounded(vertex.y));
    }
    scale_ = orbit.scale();
  }

  std::optional<CertifiedPolytope> run() {
    const bool spans = is_complex() ? express_units<std::complex<double>>() : express_units<double>();
    if (!spans) return std::nullopt;
    Integer largest = 0;  // bound times denominator * 2^(vertex_bits + weight_bits)
    for (const ImageProof& proof : result_.images) {
      const Target target = image(static_cast<std::size_t>(proof.letter), static_cast<std::size_t>(proof.vertex));
      std::vector<WeightedVertex> terms = start_from(proof);
      if (is_complex())
        refine<std::complex<double>>(target, terms);
      else
        refine<double>(target, terms);
      const Integer moduli = finish(terms), rest = residual_size(target, terms);
      largest = std::max(largest, Integer((moduli * denominator_ << vertex_bits) + rest * unit_norm_));
      polytope_.moduli.emplace_back(moduli, Integer(1) << weight_bits);
      polytope_.residuals.emplace_back(rest, denominator_ << (vertex_bits + weight_bits));
      polytope_.images.push_back(std::move(terms));
    }
    polytope_.unit_norm = unit_norm_;
    polytope_.bound = Rational(largest, denominator_ << (vertex_bits + weight_bits));
    return std::move(polytope_);
  }

 private:
  /// denominator_ * 2^vertex_bits times a vector; `im` is empty for real ones.
  struct Target {
    std::vector<Integer> re, im;
  };

  bool cone() const { return polytope_.kind == PolytopeKind::nonnegative; }
  bool is_complex() const { return polytope_.kind == PolytopeKind::complex; }

  std::vector<Integer> apply(std::size_t letter, const std::vector<Integer>& vector) const {
    std::vector<Integer> result(size_, 0);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j)
        mpz_addmul(result[i].backend().data(), matrices_[letter][i * size_ + j].backend().data(),
                   vector[j].backend().data());
    return result;
  }

  Target image(std::size_t letter, std::size_t vertex) const {
    Target target{apply(letter, polytope_.vertices[vertex]), {}};
    if (is_complex()) target.im = apply(letter, polytope_.imaginary[vertex]);
    return target;
  }

  std::size_t place(const WeightedVertex& term, std::size_t i) const { return term.flipped ? size_ - 1 - i : i; }
  const Integer& real_part(const WeightedVertex& term, std::size_t i) const {
    return polytope_.vertices[term.vertex][place(term, i)];
  }
  Integer imaginary_part(const WeightedVertex& term, std::size_t i) const {
    const Integer& part = polytope_.imaginary[term.vertex][place(term, i)];
    return term.conjugated ? Integer(-part) : part;
  }

  template <class Scalar>
  Scalar entry(const WeightedVertex& term, std::size_t i) const {
    if constexpr (std::is_same_v<Scalar, double>)
      return to_double(real_part(term, i), -vertex_bits);
    else
      return {to_double(real_part(term, i), -vertex_bits), to_double(imaginary_part(term, i), -vertex_bits)};
  }

  /// target 2^weight_bits - denominator_ * (sum of weight * vertex), all times 2^vertex_bits.
  Target residual(const Target& target, const std::vector<WeightedVertex>& terms) const {
    Target result = target;
    for (std::size_t i = 0; i < size_; ++i) {
      Integer re = 0, im = 0;
      for (const WeightedVertex& term : terms) {
        mpz_addmul(re.backend().data(), term.weight.backend().data(), real_part(term, i).backend().data());
        if (!is_complex()) continue;
        const Integer part = imaginary_part(term, i);
        re -= term.imaginary * part;
        im += term.weight * part + term.imaginary * real_part(term, i);
      }
      result.re[i] = (target.re[i] << weight_bits) - denominator_ * re;
      if (is_complex()) result.im[i] = (target.im[i] << weight_bits) - denominator_ * im;
    }
    return result;
  }

  /// The 1-norm of the residual, real and imaginary parts apart; of its positive part for the cone.
  Integer residual_size(const Target& target, const std::vector<WeightedVertex>& terms) const {
    const Target rest = residual(target, terms);
    Integer sum = 0;
    for (const Integer& c : rest.re)
      if (c > 0 || !cone()) sum += abs(c);
    for (const Integer& c : rest.im) sum += abs(c);
    return sum;
  }

  /// Sets the moduli, drops what is zero, and returns the sum of the moduli.
  Integer finish(std::vector<WeightedVertex>& terms) const {
    Integer sum = 0;
    for (WeightedVertex& term : terms) {
      term.modulus = abs(term.weight);
      if (term.imaginary != 0) {
        const Integer square = term.weight * term.weight + term.imaginary * term.imaginary;
        term.modulus = sqrt(square) + 1;
      }
      sum += term.modulus;
    }
    std::erase_if(terms, [](const WeightedVertex& term) { return term.modulus == 0; });
    return sum;
  }

  /// The combination that the search found; several phases of one vertex are one term.
  std::vector<WeightedVertex> start_from(const ImageProof& proof) const {
    std::vector<WeightedVertex> terms;
    for (const Term& term : proof.terms) {
      const auto weight = [&](double part) { return round_scaled(Real(part) * scale_, weight_bits); };
      WeightedVertex next{static_cast<std::size_t>(term.vertex),
                          term.flipped,
                          term.conjugated && is_complex(),
                          weight(term.coefficient.real()),
                          is_complex() ? weight(term.coefficient.imag()) : Integer(0),
                          0};
      const auto same = std::find_if(terms.begin(), terms.end(), [&](const WeightedVertex& t) {
        return t.vertex == next.vertex && t.flipped == next.flipped && t.conjugated == next.conjugated;
      });
      if (same == terms.end()) {
        terms.push_back(std::move(next));
      } else {
        same->weight += next.weight;
        same->imaginary += next.imaginary;
      }
    }
    return terms;
  }

  /// Corrects the weights until the residual is at the level of the rounding, in double precision steps against exact
  /// residuals. For the cone the weights only need to dominate and are kept.
  template <class Scalar>
  void refine(const Target& target, std::vector<WeightedVertex>& terms) const {
    if (terms.empty()) return;
    if (cone()) {
      for (WeightedVertex& term : terms) term.weight = std::max(Integer(0), term.weight);
      return;
    }
    using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
    Matrix basis(static_cast<Eigen::Index>(size_), static_cast<Eigen::Index>(terms.size()));
    for (std::size_t k = 0; k < terms.size(); ++k)
      for (std::size_t i = 0; i < size_; ++i)
        basis(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = entry<Scalar>(terms[k], i);
    const Eigen::ColPivHouseholderQR<Matrix> factors(basis);
    // Residuals are denominator_ * 2^(vertex_bits + weight_bits) times their value; weights 2^weight_bits times theirs.
    const double scale = 1 / to_double(denominator_, 0);
    for (int round_of = 0; round_of < refinements; ++round_of) {
      const Target rest = residual(target, terms);
      long exponent = 0;  // of the largest part, so that small residuals keep their digits
      for (const auto* parts : {&rest.re, &rest.im})
        for (const Integer& c : *parts)
          if (c != 0) exponent = std::max(exponent, static_cast<long>(mpz_sizeinbase(c.backend().data(), 2)));
      if (exponent == 0) return;
      Column right(static_cast<Eigen::Index>(size_));
      for (std::size_t i = 0; i < size_; ++i) {
        if constexpr (std::is_same_v<Scalar, double>)
          right[static_cast<Eigen::Index>(i)] = to_double(rest.re[i], -exponent);
        else
          right[static_cast<Eigen::Index>(i)] = {to_double(rest.re[i], -exponent), to_double(rest.im[i], -exponent)};
      }
      const Column correction = factors.solve(right) * scale;
      if (!correction.allFinite()) return;
      const int shift = static_cast<int>(exponent - vertex_bits);  // correction * 2^shift in units of 2^-weight_bits
      bool changed = false;
      const auto add = [&](Integer& weight, double c) {
        const Integer step = round_scaled(Real(c), shift);
        changed = changed || step != 0;
        weight += step;
      };
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const Scalar c = correction[static_cast<Eigen::Index>(k)];
        if constexpr (std::is_same_v<Scalar, double>) {
          add(terms[k].weight, c);
        } else {
          add(terms[k].weight, c.real());
          add(terms[k].imaginary, c.imag());
        }
      }
      if (!changed) return;
    }
  }

  /// Combinations of the unit vectors, and the bound unit_norm_ for their norms that follows. False where the vertices
  /// do not span.
  template <class Scalar>
  bool express_units() {
    std::vector<WeightedVertex> all;
    for (std::size_t v = 0; v < polytope_.vertices.size(); ++v)
      for (int variant = 0; variant < 4; ++variant)
        if ((variant % 2 == 0 || polytope_.symmetric) && (variant < 2 || is_complex()))
          all.push_back({v, variant % 2 == 1, variant >= 2, 0, 0, 0});
    std::vector<WeightedVertex> basis;
    if (!cone()) {
      Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> columns(static_cast<Eigen::Index>(size_),
                                                                    static_cast<Eigen::Index>(all.size()));
      for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t i = 0; i < size_; ++i)
          columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = entry<Scalar>(all[k], i);
      const Eigen::ColPivHouseholderQR<decltype(columns)> factors(columns);
      if (factors.rank() < static_cast<Eigen::Index>(size_)) return false;
      for (std::size_t k = 0; k < size_; ++k)
        basis.push_back(
            all[static_cast<std::size_t>(factors.colsPermutation().indices()[static_cast<Eigen::Index>(k)])]);
    }
    Integer most = 0, largest_residual = 0;
    for (std::size_t k = 0; k < (polytope_.symmetric ? (size_ + 1) / 2 : size_); ++k) {
      Target target{std::vector<Integer>(size_, 0), std::vector<Integer>(is_complex() ? size_ : 0, 0)};
      target.re[k] = denominator_ << vertex_bits;
      std::vector<WeightedVertex> terms = basis;
      if (cone()) {
        const auto best = std::max_element(
            all.begin(), all.end(),
            [&](const WeightedVertex& a, const WeightedVertex& b) { return real_part(a, k) < real_part(b, k); });
        if (real_part(*best, k) <= 0) return false;
        terms = {*best};
        terms.front().weight = ((Integer(1) << (vertex_bits + weight_bits)) / real_part(*best, k)) + 1;
      } else {
        refine<Scalar>(target, terms);
      }
      most = std::max(most, finish(terms));
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
  Real scale_ = 1;
  Integer unit_norm_ = 0;
  CertifiedPolytope polytope_{};
};

}  // namespace

std::optional<CertifiedPolytope> certify_polytope(const std::vector<RationalMatrix>& matrices, bool symmetric,
                                                  const SearchResult& result) {
  if (result.vertices.empty()) return std::nullopt;
  return Certifier(matrices, symmetric, result).run();
}

}  // namespace subcert
