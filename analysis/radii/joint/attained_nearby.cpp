#include "attained_nearby.hpp"

#include "attains.hpp"
#include "rounded_family.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>
#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace subcert::radius {
namespace {

constexpr slong inverse_precision = 512;
constexpr long inverse_accuracy = 80;  // bits of the inverse times the matrix
constexpr long most_bits = 4000;
constexpr int most_steps = 20;  // towards an eigenvector
constexpr int radius_bits = 240, guard_bits = 60;
constexpr const char* no_eigenvector =
    "the first vertex of a cycle is near no simple eigenvector of all families near by";

using Vector = std::vector<Rational>;

/// |x|_1
Rational length_of(const Vector& x) {
  Rational sum = 0;
  for (const Rational& c : x) sum += abs(c);
  return sum;
}

Rational dyadic(const Rational& x, long bits) { return to_multiple(x, power(Rational(2), -bits), Rounding::nearest); }

/// The equations for an eigenvalue and an eigenvector, one coordinate of which is kept: SPEC.md, 7.1.
class EigenvectorSystem {
 public:
  EigenvectorSystem(RationalMatrix product, Rational error, std::size_t kept)
      : product_(std::move(product)), error_(std::move(error)), kept_(kept) {}

  /// An approximate inverse of the derivative.
  bool invert(const Rational& c, const Vector& x) {
    const RationalMatrix there = derivative(c, x);
    const std::size_t size = there.rows();
    const auto columns = inverse_columns(Rational(-1) * there, {0, 0},
                                         inverse_precision + 2 * std::abs(binary_exponent(there).value_or(0)));
    if (!columns) return false;
    bits_ = std::max(0L,
                     inverse_accuracy + binary_exponent(Rational(one_norm(there) * static_cast<long>(size * size))));
    if (bits_ > most_bits) return false;
    inverse_ = RationalMatrix(size, size);
    for (std::size_t j = 0; j < size; ++j)
      for (std::size_t i = 0; i < size; ++i) inverse_(i, j) = dyadic((*columns)[j][i].re, bits_);
    return true;
  }

  /// What the distances of eigenvalue and eigenvector from these add up to at most; nothing where that is not proved.
  std::optional<Rational> distance(const Rational& c, const Vector& x) const {
    RationalMatrix unity = inverse_ * derivative(c, x);
    for (std::size_t i = 0; i < unity.rows(); ++i) unity(i, i) -= 1;
    const Rational moved = one_norm(inverse_) * error_, rest = 1 - (one_norm(unity) + moved),
                   step = length_of(step_from(c, x)) + moved * length_of(x);
    if (rest <= 0 || 6 * one_norm(inverse_) * step >= rest * rest) return std::nullopt;
    return 2 * step / rest;
  }

  /// A step of Newton's method, rounded to so many bits after the point.
  void improve(Rational& c, Vector& x, long bits) const {
    const Vector step = step_from(c, x);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (i != kept_) x[i] = dyadic(x[i] - step[i], bits);
    c = dyadic(c - step.back(), bits);
  }

  NearbyEigenvector at(const Rational& point) const {
    const Rational scale = power(Rational(2), bits_);
    NearbyEigenvector result{point, static_cast<int>(bits_), {}};
    for (std::size_t j = 0; j < inverse_.rows(); ++j) {
      std::vector<Integer>& column = result.inverse.emplace_back();
      for (std::size_t i = 0; i < inverse_.rows(); ++i) column.push_back(numerator(Rational(scale * inverse_(i, j))));
    }
    return result;
  }

 private:
  RationalMatrix derivative(const Rational& c, const Vector& x) const {
    const std::size_t n = x.size();
    RationalMatrix result(n + 1, n + 1);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) result(i, j) = product_(i, j);
      result(i, i) -= c;
      result(i, n) = -x[i];
    }
    result(n, kept_) = 1;
    return result;
  }

  Vector step_from(const Rational& c, const Vector& x) const {
    Vector rest = product_ * x;
    for (std::size_t i = 0; i < x.size(); ++i) rest[i] -= c * x[i];
    rest.emplace_back(0);
    return inverse_ * rest;
  }

  RationalMatrix product_;
  Rational error_;
  std::size_t kept_;
  RationalMatrix inverse_{0, 0};
  long bits_ = 0;  // after the point, of its entries
};

/// |value|^(1/length) for all numbers within `away` of the point; nothing where that may be 0.
std::optional<Enclosure> averaged_modulus(const Rational& point, const Rational& away, int length, int bits) {
  const Rational low = abs(point) - away;
  if (low <= 0) return std::nullopt;
  return Enclosure{root_enclosure(low, length, bits).lower, root_enclosure(abs(point) + away, length, bits).upper};
}

class NearbyProof {
 public:
  NearbyProof(const MatrixFamily& family, const Rational& error, const PolytopeProof& polytope, bool is_transition)
      : error_(error), polytope_(polytope), is_transition_(is_transition) {
    for (const RationalMatrix& m : family) matrices_.push_back(polytope.transposed ? transposed(m) : m);
    for (std::size_t v = 0; v < polytope.vertices.size(); ++v) {
      Vector& vertex = vertices_.emplace_back();
      for (const RationalComplex& c : polytope.vertex(v)) vertex.push_back(c.re);
    }
  }

  /// The reason why there is no proof, empty where there is one. `proof`: what find_nearby_cycles() finds.
  std::string run(AttainedProof& proof, int bits) {
    if (std::string missing = enclose_cycles(proof, bits); !missing.empty()) return missing;
    const Rational &low = *coarse_.lower, &high = *coarse_.upper, &growth = polytope_.bound;
    for (const auto& [vertex, parent, letter] : proof.origins) {
      const Rational off = distance_to_image(vertex, parent, letter, low) +
                           (high - low) * length_of(vertices_[vertex]) + error_ * length_of(vertices_[parent]);
      errors_[vertex] = (growth * errors_[parent] + off * unit_norm()) / low;
    }
    Rational most = 0;
    for (const auto& [vertex, error] : errors_) most = std::max(most, error);
    if (most >= 1) return "the vertices are not known well enough";
    std::set<std::pair<std::size_t, std::size_t>> met;
    for (const AttainedProof::Cycle& cycle : proof.cycles)
      met.emplace(cycle.last, static_cast<std::size_t>(cycle.letters.back()));
    for (const auto& [vertex, parent, letter] : proof.origins) met.emplace(parent, letter);
    std::erase_if(proof.coincidences, [&](const AttainedProof::Coincidence& image) {
      return met.contains({image.vertex, image.letter}) || !is_mirrored(proof, image);
    });
    for (const AttainedProof::Coincidence& image : proof.coincidences) met.emplace(image.vertex, image.letter);
    const std::size_t count = matrices_.size();
    for (std::size_t i = 0; i < polytope_.images.size(); ++i) {
      if (met.contains({i / count, i % count})) continue;
      const Rational rest = polytope_.residuals[i] * unit_norm() + (growth + polytope_.moduli[i]) * most;
      if (polytope_.moduli[i] + rest / (1 - most) > low) return "an image lies too near to the boundary";
    }
    return "";
  }

 private:
  Rational unit_norm() const { return Rational(polytope_.unit_norm); }

  /// Of one cycle: how far the eigenvalue is from the point, the radius as the certificate has it, and finer.
  struct CycleEnclosure {
    Rational away;
    Enclosure coarse, fine;
    NearbyEigenvector eigenvector;
  };

  /// `point`: near the eigenvalue; nothing: by the vertex.
  std::optional<CycleEnclosure> enclose(const AttainedProof::Cycle& cycle, const std::optional<Rational>& point,
                                        int bits) const {
    RationalMatrix product = polytope_.group[cycle.element].map.matrix();
    Rational norm = 0;
    for (const RationalMatrix& m : matrices_) norm = std::max(norm, one_norm(m));
    for (auto letter = cycle.letters.rbegin(); letter != cycle.letters.rend(); ++letter)
      product = product * matrices_[static_cast<std::size_t>(*letter)];
    const int length = static_cast<int>(cycle.letters.size());
    Vector x = vertices_[cycle.vertex];
    std::size_t kept = 0;
    for (std::size_t i = 1; i < x.size(); ++i)
      if (abs(x[i]) > abs(x[kept])) kept = i;
    EigenvectorSystem system(product, change_of_product(norm, error_, length), kept);
    Rational c = point ? *point
                       : rayleigh_quotient(polytope_.vertex(cycle.vertex), product * polytope_.vertex(cycle.vertex)).re;
    if (!point && c != 0) c = dyadic(c, polytope_.vertex_bits - binary_exponent(c));
    const auto away = system.invert(c, x) ? system.distance(c, x) : std::nullopt;
    // Checkers round up.
    const auto coarse = away ? averaged_modulus(c, *away * (1 + power(Rational(2), -guard_bits)), length, radius_bits)
                             : std::nullopt;
    if (!coarse) return std::nullopt;
    CycleEnclosure result{*away, *coarse, *coarse, system.at(c)};
    for (int step = 0; step < most_steps; ++step) {
      system.improve(c, x, 2 * bits + 64);
      const auto nearer = system.distance(c, x);
      const auto finer = nearer ? averaged_modulus(c, *nearer, length, bits + 8) : std::nullopt;
      Enclosure& fine = result.fine;
      if (!finer || 2 * (*finer->upper - *finer->lower) > *fine.upper - *fine.lower) break;
      fine = *finer;
      if (*fine.upper - *fine.lower <= *fine.lower * power(Rational(2), -bits)) break;
    }
    return result;
  }

  std::string enclose_cycles(AttainedProof& proof, int bits) {
    const auto found = enclose(proof.cycles.front(), {}, bits);
    if (!found) return no_eigenvector;
    Enclosure bounds = found->coarse;
    errors_[proof.cycles.front().vertex] = found->away * unit_norm();
    const Rational point = found->eigenvector.eigenvalue;
    proof.nearby = NearbyCycles{{found->eigenvector}, {}, found->fine, product_of(proof.cycles.front())};
    if (proof.cycles.size() > 1) {
      const auto other = is_pair(proof) ? enclose(proof.cycles.back(), point, bits) : std::nullopt;
      if (!other || may_be_corner(point, std::max(found->away, other->away) + error_))
        return "several products seem to attain the radius, and nothing says so of all families near by";
      bounds = {std::min(*bounds.lower, *other->coarse.lower), std::max(*bounds.upper, *other->coarse.upper)};
      errors_[proof.cycles.back().vertex] = other->away * unit_norm();
      proof.nearby->eigenvectors.push_back(other->eigenvector);
    }
    coarse_ = {dyadic_end(*bounds.lower, Rounding::down), dyadic_end(*bounds.upper, Rounding::up)};
    proof.nearby->bounds = coarse_;
    return "";
  }

  /// Whether the cycles are those of the first and of the last matrix: but for one corner of each they have the same
  /// eigenvalues.
  bool is_pair(const AttainedProof& proof) const {
    const int last = static_cast<int>(matrices_.size()) - 1;
    const auto is_letter = [](const AttainedProof::Cycle& cycle, int letter) {
      return cycle.element == 0 && cycle.letters == std::vector{letter};
    };
    const AttainedProof::Cycle &first = proof.cycles.front(), &second = proof.cycles.back();
    return is_transition_ && proof.cycles.size() == 2 && !polytope_.is_flip_symmetric() &&
           ((is_letter(first, 0) && is_letter(second, last)) || (is_letter(first, last) && is_letter(second, 0)));
  }
  bool may_be_corner(const Rational& point, const Rational& error) const {
    const std::size_t end = matrices_.front().rows() - 1;
    return abs(matrices_.front()(0, 0) - point) <= error || abs(matrices_.back()(end, end) - point) <= error;
  }

  static Rational dyadic_end(const Rational& x, Rounding rounding) {
    return to_multiple(x, power(Rational(2), binary_exponent(x) - radius_bits), rounding);
  }

  /// From left to right, of matrices that are not transposed.
  std::vector<int> product_of(const AttainedProof::Cycle& cycle) const {
    std::vector<int> word = cycle.letters;
    if (cycle.element > 0)
      for (const int letter : cycle.letters) word.push_back(static_cast<int>(matrices_.size()) - 1 - letter);
    if (!polytope_.transposed) std::reverse(word.begin(), word.end());
    return word;
  }

  /// |M parent - (+-) low vertex|
  Rational distance_to_image(std::size_t vertex, std::size_t parent, std::size_t letter, const Rational& low) const {
    const Vector image = matrices_[letter] * vertices_[parent], &goal = vertices_[vertex];
    std::optional<Rational> least;
    for (const Rational& factor : {low, Rational(-low)}) {
      Rational away = 0;
      for (std::size_t i = 0; i < goal.size(); ++i) away += abs(image[i] - factor * goal[i]);
      if (!least || away < *least) least = away;
    }
    return *least;
  }

  /// Whether image and vertex stem from one vertex that is its own flip, up to its sign, by mirrored letters.
  bool is_mirrored(const AttainedProof& proof, const AttainedProof::Coincidence& image) const {
    if (image.element == 0) return false;
    const AttainedProof::Cycle& cycle = proof.cycles.front();
    const auto way = [&](std::size_t vertex) {
      std::vector<std::size_t> letters;
      for (bool found = true; found;) {
        const auto at = std::ranges::find(proof.origins, vertex, &AttainedProof::Origin::vertex);
        if ((found = at != proof.origins.end())) letters.push_back(at->letter), vertex = at->parent;
      }
      return std::pair(vertex, letters);
    };
    const auto mirrored = [&](std::size_t letter) { return matrices_.size() - 1 - letter; };
    auto [from, left] = way(image.vertex);
    auto [to, right] = way(image.target);
    left.insert(left.begin(), image.letter);
    std::ranges::transform(right, right.begin(), mirrored);
    if (from != to || left != right) return false;
    if (from == cycle.vertex)
      return std::ranges::all_of(
          cycle.letters, [&](int t) { return mirrored(static_cast<std::size_t>(t)) == static_cast<std::size_t>(t); });
    const Vector &vertex = vertices_[from], reversed(vertex.rbegin(), vertex.rend());
    return vertex == reversed ||
           std::ranges::equal(vertex, reversed, [](const Rational& a, const Rational& b) { return a == -b; });
  }

  const Rational& error_;
  const PolytopeProof& polytope_;
  bool is_transition_;
  std::vector<RationalMatrix> matrices_;
  std::vector<Vector> vertices_;
  Enclosure coarse_ = Enclosure::at_least(0);  // of the radius, as the certificate has it
  std::map<std::size_t, Rational> errors_;
};

}  // namespace

Decision product_attains_nearby(const MatrixFamily& family, const Rational& error, const PolytopeCandidate& candidate,
                                PolytopeProof& polytope, bool is_transition, int bits) {
  const auto unknown = [](std::string reason) { return Decision{Truth::unknown, std::move(reason)}; };
  polytope.attained.reset();
  if (!candidate.closed) return unknown("the polytope did not close");
  if (polytope.kind != PolytopeKind::real) return unknown("the leading eigenvalue is not real");
  find_nearby_cycles(family, candidate, polytope);
  if (!polytope.attained) return unknown(polytope.not_attained);
  polytope.not_attained = NearbyProof(family, error, polytope, is_transition).run(*polytope.attained, bits);
  if (polytope.not_attained.empty())
    return {Truth::yes,
            "in all families near by every image is a vertex or lies inside, and the product attains the radius"};
  polytope.attained.reset();
  return unknown(polytope.not_attained);
}

}  // namespace subcert::radius
