#include "polytope_proof.hpp"

#include "orbit.hpp"

#include <subcert/analysis/radii/polytope_search/decompositions.hpp>
#include <subcert/analysis/symbol/numbers/boost_numbers.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <type_traits>
#include <utility>

namespace subcert {
namespace {

using radius::Real;
using radius::RealVector;

constexpr int least_bits = 112, most_bits = 192;  // of vertices and weights; orbits have 200
constexpr int refinements = 4;
// Cones: relatively nearer coordinates are to be met, or fewer of them where that leads further below.
constexpr int tight_bits = 20, tightest_bits = 40, tight_step = 5;

Integer round_scaled(const Real& value, int bits) {
  return from_boost(boost::multiprecision::mpz_int(round(ldexp(value, bits))));
}

/// Domain: value != 0.
long bit_size(const Integer& value) { return static_cast<long>(mpz_sizeinbase(value.get(), 2)); }

/// value * 2^exponent.
double to_double(const Integer& value, long exponent) {
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, value.get());
  return std::ldexp(mantissa, static_cast<int>(std::clamp(own + exponent, -2000L, 2000L)));
}

/// What the proof and the orbit behind it will hold, roughly.
std::size_t bytes_of_proof(const radius::PolytopeCandidate& candidate, std::size_t size) {
  constexpr std::size_t number = 64, term = 3 * number;  // an integer of 240 bits, a weighted vertex
  const std::size_t parts = candidate.kind == PolytopeKind::complex ? 2 : 1;
  std::size_t bytes = candidate.vertices.size() * size * parts * 2 * number;
  for (const auto& image : candidate.images) bytes += image.terms.size() * (term + sizeof image.terms.front());
  return bytes;
}

class Certifier {
 public:
  Certifier(const MatrixFamily& family, const radius::PolytopeCandidate& candidate)
      : candidate_(candidate), size_(family.size()) {
    polytope_.kind = candidate.kind;
    polytope_.transposed = candidate.transposed;
    polytope_.group = candidate.transposed ? transposed(family).group() : family.group();
    denominator_ = common_denominator(family);
    for (const RationalMatrix& m : family)
      matrices_.push_back(integer_multiple(candidate.transposed ? transposed(m) : m, denominator_));
    if (const auto& [to, from] = candidate.coordinates; candidate.coordinates.differ()) {
      // Polytopes are as flat as the orbits, and norms of residuals as large.
      bits_ = static_cast<int>(std::clamp<long>(
          least_bits + binary_exponent(to).value_or(0) + binary_exponent(from).value_or(0), least_bits, most_bits));
      // Of vectors that become as small as 1 over the entries of `from`, 64 bits are left.
      to_search_bits_ = 64 + std::max(0L, binary_exponent(from).value_or(0));
      for (std::size_t i = 0; i < size_; ++i)
        for (std::size_t j = 0; j < size_; ++j)
          to_search_.push_back(to_integer(to(i, j) * power(Rational(2), to_search_bits_), Rounding::down));
    }
  }

  std::optional<PolytopeProof> run(const radius::Orbit& orbit, const Deadline& deadline) {
    polytope_.vertex_bits = polytope_.weight_bits = bits_;
    take(orbit);
    const bool spans = is_complex() ? express_units<std::complex<double>>() : express_units<double>();
    if (!spans) return std::nullopt;
    Integer largest = 0;  // bound times denominator * 2^(2 * bits_)
    const Integer scale = round_scaled(scale_, bits_), clearly_below = scale - (scale >> tight_bits);
    for (const radius::PolytopeCandidate::Image& proposal : candidate_.images) {
      if (deadline.expired()) return std::nullopt;
      const Target target = image(static_cast<std::size_t>(proposal.letter), static_cast<std::size_t>(proposal.vertex));
      Combination combination = combined(target, proposal, tight_bits);
      for (int bits = tight_bits + tight_step; cone() && bits <= tightest_bits; bits += tight_step) {
        if (combination.moduli < clearly_below) break;
        if (Combination other = combined(target, proposal, bits); other.bound < combination.bound)
          combination = std::move(other);
      }
      largest = std::max(largest, combination.bound);
      polytope_.moduli.emplace_back(combination.moduli, Integer(1) << bits_);
      polytope_.residuals.emplace_back(combination.rest, denominator_ << (2 * bits_));
      polytope_.images.push_back(std::move(combination.terms));
    }
    polytope_.bound = Rational(largest, denominator_ << (2 * bits_));
    return std::move(polytope_);
  }

 private:
  /// denominator_ * 2^bits_ times a vector; `im` is empty for real ones.
  struct Target {
    std::vector<Integer> re, im;
  };

  /// An image as a combination of vertices and a residual, and what follows for its norm.
  struct Combination {
    std::vector<WeightedVertex> terms;
    Integer moduli, rest, bound;  ///< times 2^bits_, denominator_ 2^(2 bits_), and that again
  };
  Combination combined(const Target& target, const radius::PolytopeCandidate::Image& proposal, int tight) const {
    Combination result{start_from(proposal), 0, 0, 0};
    if (is_complex())
      refine<std::complex<double>>(target, result.terms, tight);
    else
      refine<double>(target, result.terms, tight);
    if (cone()) dominate(target, result.terms);
    result.moduli = finish(result.terms);
    result.rest = residual_size(target, result.terms);
    result.bound = (result.moduli * denominator_ << bits_) + result.rest * polytope_.unit_norm;
    return result;
  }

  /// The vertices, rounded.
  void take(const radius::Orbit& orbit) {
    const auto rounded = [&](const RealVector& values) {
      std::vector<Integer> integers;
      for (const Real& c : values) integers.push_back(round_scaled(cone() ? Real(abs(c)) : c, bits_));
      return integers;
    };
    for (std::size_t v = 0; v < orbit.vertices.size(); ++v) {
      const radius::OrbitPoint& vertex = orbit.vertices[v];
      polytope_.vertices.push_back(rounded(vertex.x));
      if (vertex.is_complex()) polytope_.imaginary.push_back(rounded(vertex.y));
      if (!to_search_.empty()) restore_flip(candidate_.vertices[v]);
    }
    scale_ = orbit.scale;
  }

  /// Where an extra vertex of the search is exactly even or odd under the flip, so is the last vertex taken: the way
  /// from one to the other loses that to rounding.
  void restore_flip(const radius::PolytopeCandidate::Vertex& vertex) {
    if (vertex.parent >= 0 || vertex.cycle >= 0 || !polytope_.is_flip_symmetric()) return;
    for (const int sign : {1, -1}) {
      bool kept = true;
      for (std::size_t i = 0; i < size_; ++i)
        kept = kept && vertex.value[i] == static_cast<double>(sign) * vertex.value[size_ - 1 - i];
      if (!kept) continue;
      for (auto* parts : {&polytope_.vertices, &polytope_.imaginary}) {
        if (parts->empty()) continue;
        std::vector<Integer>& x = parts->back();
        for (std::size_t i = 0; 2 * i + 1 < size_; ++i) x[size_ - 1 - i] = sign * x[i];
        if (sign < 0 && size_ % 2 == 1) x[size_ / 2] = 0;
      }
      return;
    }
  }

  bool cone() const { return polytope_.kind == PolytopeKind::nonnegative; }
  bool is_complex() const { return polytope_.kind == PolytopeKind::complex; }

  std::vector<Integer> apply(std::size_t letter, const std::vector<Integer>& vector) const {
    std::vector<Integer> result(size_, 0);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j)
        mpz_addmul(result[i].get(), matrices_[letter][i * size_ + j].get(), vector[j].get());
    return result;
  }

  Target image(std::size_t letter, std::size_t vertex) const {
    Target target{apply(letter, polytope_.vertices[vertex]), {}};
    if (is_complex()) target.im = apply(letter, polytope_.imaginary[vertex]);
    return target;
  }

  const Integer& real_part(const WeightedVertex& term, std::size_t i) const {
    return image_of(term, polytope_.vertices, images_)[i];
  }
  Integer imaginary_part(const WeightedVertex& term, std::size_t i) const {
    const Integer& part = image_of(term, polytope_.imaginary, imaginary_images_)[i];
    return term.conjugated ? Integer(-part) : part;
  }

  using Images = std::map<std::pair<std::size_t, std::size_t>, std::vector<Integer>>;
  /// The part of the vertex, after the element; each image is computed once.
  const std::vector<Integer>& image_of(const WeightedVertex& term, const std::vector<std::vector<Integer>>& parts,
                                       Images& images) const {
    if (term.element == 0) return parts[term.vertex];
    const auto [at, missing] = images.try_emplace({term.vertex, term.element});
    if (missing) at->second = polytope_.group[term.element].map(parts[term.vertex]);
    return at->second;
  }

  /// Whether combinations of so many terms are solved for in the coordinates of the search. Of fewer terms the residual
  /// is to be small in those of the family, whose rounding the others enlarge.
  bool solves_in_search(std::size_t terms) const { return !to_search_.empty() && terms >= size_; }

  template <class Scalar>
  Scalar entry(const WeightedVertex& term, std::size_t i, bool in_search) const {
    if (in_search) {  // where the flip is the reversal, too
      const auto& value = candidate_.vertices[term.vertex].value;
      const std::complex<double> c = value[term.element == 0 ? i : size_ - 1 - i];
      if constexpr (std::is_same_v<Scalar, double>)
        return c.real();
      else
        return term.conjugated ? std::conj(c) : c;
    }
    if constexpr (std::is_same_v<Scalar, double>)
      return to_double(real_part(term, i), -bits_);
    else
      return {to_double(real_part(term, i), -bits_), to_double(imaginary_part(term, i), -bits_)};
  }

  /// 2^to_search_bits_ times the vector in the coordinates of the search.
  std::vector<Integer> in_search_coordinates(const std::vector<Integer>& x) const {
    if (x.empty()) return x;
    std::vector<Integer> result(size_, 0);
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t j = 0; j < size_; ++j) mpz_addmul(result[i].get(), to_search_[i * size_ + j].get(), x[j].get());
    return result;
  }

  /// target 2^bits_ - denominator_ * (sum of weight * vertex), all times 2^bits_.
  Target residual(const Target& target, const std::vector<WeightedVertex>& terms) const {
    Target result = target;
    for (std::size_t i = 0; i < size_; ++i) {
      Integer re = 0, im = 0;
      for (const WeightedVertex& term : terms) {
        mpz_addmul(re.get(), term.weight.get(), real_part(term, i).get());
        if (!is_complex()) continue;
        const Integer part = imaginary_part(term, i);
        re -= term.imaginary * part;
        im += term.weight * part + term.imaginary * real_part(term, i);
      }
      result.re[i] = (target.re[i] << bits_) - denominator_ * re;
      if (is_complex()) result.im[i] = (target.im[i] << bits_) - denominator_ * im;
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
  std::vector<WeightedVertex> start_from(const radius::PolytopeCandidate::Image& proposal) const {
    std::vector<WeightedVertex> terms;
    for (const auto& term : proposal.terms) {
      const auto weight = [&](double part) { return round_scaled(Real(part) * scale_, bits_); };
      WeightedVertex next{static_cast<std::size_t>(term.vertex),
                          static_cast<std::size_t>(term.element),
                          term.conjugated && is_complex(),
                          weight(term.coefficient.real()),
                          is_complex() ? weight(term.coefficient.imag()) : Integer(0),
                          0};
      const auto same = std::find_if(terms.begin(), terms.end(), [&](const WeightedVertex& t) {
        return t.vertex == next.vertex && t.element == next.element && t.conjugated == next.conjugated;
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

  /// A coordinate that the combination is to meet, and what it is multiplied by.
  struct Row {
    std::size_t index;
    double factor;
  };

  /// All coordinates; for the cone those that the combination meets up to rounding, relatively to their size, which
  /// may be tiny.
  std::vector<Row> rows_to_meet(const Target& target, const std::vector<WeightedVertex>& terms, int tight) const {
    std::vector<Row> rows;
    const Target rest = cone() ? residual(target, terms) : Target{};
    for (std::size_t i = 0; i < size_; ++i) {
      if (!cone()) {
        rows.push_back({i, 1});
      } else if (target.re[i] != 0) {
        const Integer size = target.re[i] << bits_;
        if (abs(rest.re[i]) << tight > size) continue;
        rows.push_back({i, std::ldexp(1 / to_double(target.re[i], -bit_size(target.re[i])),
                                      static_cast<int>(bit_size(denominator_) + bits_ - bit_size(target.re[i])))});
      }
    }
    return rows;
  }

  /// Cones: the least multiple of the weights that is above the target in all coordinates.
  void dominate(const Target& target, std::vector<WeightedVertex>& terms) const {
    for (WeightedVertex& term : terms) term.weight = std::max(Integer(0), term.weight);
    const Target rest = residual(target, terms);
    Rational factor = 1;
    for (std::size_t i = 0; i < size_; ++i) {
      const Integer goal = target.re[i] << bits_, reached = goal - rest.re[i];
      if (rest.re[i] <= 0) continue;
      // A coordinate that no term has is left to the residual, and so is one that would cost more.
      if (reached > 0 && (rest.re[i] << tight_bits) < reached) factor = std::max(factor, Rational(goal, reached));
    }
    if (factor == 1) return;
    for (WeightedVertex& term : terms) term.weight = (term.weight * numerator(factor)) / denominator(factor) + 1;
  }

  /// The columns of a system for weights, one after the other.
  template <class Scalar>
  std::vector<Scalar> columns_of(const std::vector<WeightedVertex>& terms, const std::vector<Row>& rows,
                                 bool in_search) const {
    std::vector<Scalar> columns;
    for (const WeightedVertex& term : terms)
      for (const Row& row : rows) columns.push_back(row.factor * entry<Scalar>(term, row.index, in_search));
    return columns;
  }

  /// Brings columns to length 1 or 0, and returns their lengths.
  template <class Scalar>
  static std::vector<double> normalise(std::vector<Scalar>& columns, std::size_t rows) {
    std::vector<double> lengths;
    for (std::size_t begin = 0; begin < columns.size(); begin += rows) {
      double square = 0;
      for (std::size_t k = begin; k < begin + rows; ++k) square += std::norm(columns[k]);
      lengths.push_back(square > 0 ? std::sqrt(square) : 1);
      for (std::size_t k = begin; k < begin + rows; ++k) columns[k] /= lengths.back();
    }
    return lengths;
  }

  /// Corrects the weights until the residual is at the level of the rounding, in double precision steps against exact
  /// residuals.
  template <class Scalar>
  void refine(const Target& target, std::vector<WeightedVertex>& terms, int tight) const {
    if (terms.empty()) return;
    const std::vector<Row> rows = rows_to_meet(target, terms, tight);
    if (rows.size() < terms.size()) return;
    const bool in_search = solves_in_search(terms.size());
    std::vector<Scalar> basis = columns_of<Scalar>(terms, rows, in_search);
    // There vertices differ in length by many powers of ten.
    const std::vector<double> lengths = in_search ? normalise(basis, rows.size())
                                                  : std::vector<double>(terms.size(), 1);
    const polytope::PivotedQr<Scalar> factors(basis, rows.size(), terms.size());
    // Residuals are denominator_ * 2^(2 * bits_) times their value; weights 2^bits_ times theirs.
    const long size = bit_size(denominator_);
    const double scale = 1 / to_double(denominator_, -size);
    for (int round_of = 0; round_of < refinements; ++round_of) {
      Target rest = residual(target, terms);
      if (in_search) rest = {in_search_coordinates(rest.re), in_search_coordinates(rest.im)};
      long exponent = 0;  // of the largest part, so that small residuals keep their digits
      for (const auto* parts : {&rest.re, &rest.im})
        for (const Integer& c : *parts)
          if (c != 0) exponent = std::max(exponent, bit_size(c));
      if (exponent == 0) return;
      std::vector<Scalar> right;
      for (const auto& [i, factor] : rows) {
        if constexpr (std::is_same_v<Scalar, double>)
          right.push_back(factor * to_double(rest.re[i], -exponent));
        else
          right.emplace_back(factor * to_double(rest.re[i], -exponent), factor * to_double(rest.im[i], -exponent));
      }
      std::vector<Scalar> correction = factors.solve(right);
      for (std::size_t k = 0; k < correction.size(); ++k) correction[k] *= scale / lengths[k];
      if (!std::all_of(correction.begin(), correction.end(), [](Scalar c) { return std::isfinite(std::abs(c)); }))
        return;
      // correction * 2^shift in units of 2^-bits_
      const int shift = static_cast<int>(exponent - bits_ - size - (in_search ? to_search_bits_ : 0));
      bool changed = false;
      const auto add = [&](Integer& weight, double c) {
        const Integer step = round_scaled(Real(c), shift);
        changed = changed || step != 0;
        weight += step;
      };
      for (std::size_t k = 0; k < terms.size(); ++k) {
        const Scalar c = correction[k];
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

  /// Combinations of the unit vectors, and the bound for their norms that follows. False where the vertices
  /// do not span.
  template <class Scalar>
  bool express_units() {
    std::vector<WeightedVertex> all;
    for (std::size_t v = 0; v < polytope_.vertices.size(); ++v)
      for (const bool conjugated : {false, true})
        for (std::size_t element = 0; element < polytope_.group.size() && (!conjugated || is_complex()); ++element)
          all.push_back({v, element, conjugated, 0, 0, 0});
    std::vector<WeightedVertex> basis;
    if (!cone()) {
      const auto columns = columns_of<Scalar>(all, rows_to_meet({}, {}, tight_bits), solves_in_search(all.size()));
      const polytope::PivotedQr<Scalar> factors(columns, size_, all.size());
      if (factors.rank() < size_) return false;
      const std::vector<std::size_t> pivots = factors.pivots();
      for (std::size_t k = 0; k < size_; ++k) basis.push_back(all[pivots[k]]);
    }
    Integer most = 0, largest_residual = 0;
    for (std::size_t k = 0; k < (polytope_.is_flip_symmetric() ? (size_ + 1) / 2 : size_); ++k) {
      Target target{std::vector<Integer>(size_, 0), std::vector<Integer>(is_complex() ? size_ : 0, 0)};
      target.re[k] = denominator_ << bits_;
      std::vector<WeightedVertex> terms = basis;
      if (cone()) {
        const auto best = std::max_element(
            all.begin(), all.end(),
            [&](const WeightedVertex& a, const WeightedVertex& b) { return real_part(a, k) < real_part(b, k); });
        if (real_part(*best, k) <= 0) return false;
        terms = {*best};
        terms.front().weight = ((Integer(1) << (2 * bits_)) / real_part(*best, k)) + 1;
      } else {
        refine<Scalar>(target, terms, tight_bits);
      }
      most = std::max(most, finish(terms));
      largest_residual = std::max(largest_residual, residual_size(target, terms));
      polytope_.units.push_back(std::move(terms));
    }
    const Integer one = denominator_ << (2 * bits_);
    if (largest_residual >= one) return false;
    // E = S / (1 - R), rounded up to an integer.
    const Rational norm = Rational(most, Integer(1) << bits_) / (1 - Rational(largest_residual, one));
    polytope_.unit_norm = numerator(norm) / denominator(norm) + 1;
    return true;
  }

  const radius::PolytopeCandidate& candidate_;
  std::size_t size_;
  std::vector<Integer> to_search_;  // 2^to_search_bits_ times the matrix, row by row; empty where it is the identity
  long to_search_bits_ = 0;
  int bits_ = least_bits;  // of vertices and weights
  Integer denominator_ = 1;
  std::vector<std::vector<Integer>> matrices_;  // denominator_ times the matrices, transposed where the search was
  Real scale_ = 1;
  PolytopeProof polytope_{};
  mutable Images images_, imaginary_images_;  // of vertices under elements other than the identity
};

}  // namespace

std::optional<PolytopeProof> certify_polytope(const MatrixFamily& family, const radius::PolytopeCandidate& candidate,
                                              const Budget& budget) {
  if (candidate.vertices.empty() || bytes_of_proof(candidate, family.size()) > budget.memory) return std::nullopt;
  if (candidate.kind == PolytopeKind::nonnegative && !is_nonnegative(family)) return std::nullopt;
  const auto orbit = radius::recomputed_orbit(family, candidate, budget.deadline);
  return orbit ? Certifier(family, candidate).run(*orbit, budget.deadline) : std::nullopt;
}

}  // namespace subcert
