#include "certify.hpp"

#include <subcert/analysis/radii/joint/cost.hpp>
#include <subcert/analysis/radii/joint/subspace.hpp>
#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>
#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace subcert::subradius {
namespace {

constexpr slong eigenpair_bits = 640;
constexpr long rounded_bits = 256;  // of the factors

using IntegerVector = std::vector<Integer>;

/// No row of a zero has an entry in a column of another coordinate.
bool leaves_zeros_alone(const RationalMatrix& matrix, const IntegerVector& vector) {
  for (std::size_t i = 0; i < vector.size(); ++i)
    for (std::size_t j = 0; j < vector.size(); ++j)
      if (vector[i] == 0 && vector[j] != 0 && matrix(i, j) != 0) return false;
  return true;
}

/// A number D such that v <= alpha U <= D v for the leading eigenvector U of a matrix and some alpha, the eigenvalue,
/// and the irreducible polynomial of it. An eigenvector whose real parts are positive belongs to the spectral radius,
/// as its inner product with a left eigenvector of that is not 0; and as the eigenvalue is simple, its real parts are
/// an eigenvector.
struct NearEigenvector {
  Rational factor;
  Rational eigenvalue;  ///< a lower bound
  LaurentPolynomial polynomial;
};

std::optional<NearEigenvector> near_eigenvector(const RationalMatrix& matrix, const IntegerVector& v,
                                                const Deadline& deadline) {
  ComplexVector near;
  for (const Integer& c : v) near.push_back({Rational(c), 0});
  const auto pair = enclose_eigenpair(matrix, near, eigenpair_bits);
  if (!pair) return std::nullopt;
  std::vector<Enclosure> parts;
  for (const ComplexBall& entry : pair->vector) parts.push_back(entry.real().enclosure());
  if (*parts.front().upper < 0)
    for (Enclosure& part : parts) part = {-*part.upper, -*part.lower};
  Rational alpha = 0, most = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    if (*parts[i].lower <= 0) return std::nullopt;
    alpha = std::max(alpha, Rational(v[i]) / *parts[i].lower);
    most = std::max(most, *parts[i].upper / Rational(v[i]));
  }
  const auto characteristic = characteristic_polynomial(matrix, deadline);
  if (!characteristic || !radius::has_time_for_roots(*characteristic, deadline)) return std::nullopt;
  std::vector<LaurentPolynomial> candidates;
  for (const PolynomialFactor& factor : irreducible_factors(*characteristic))
    if (contains_zero(value_at(factor.polynomial, pair->value))) candidates.push_back(factor.polynomial);
  if (candidates.size() != 1) return std::nullopt;
  return NearEigenvector{alpha * most, *pair->value.real().enclosure().lower, candidates.front()};
}

Rational rounded_up(const Rational& x) {
  return Rational(to_integer(x * two_to(rounded_bits), Rounding::up)) * two_to(-rounded_bits);
}

class Attained {
 public:
  Attained(const MatrixFamily& family, AntinormProof& proof, const Enclosure& radius, const Deadline& deadline)
      : family_(family),
        proof_(proof),
        radius_(radius),
        deadline_(deadline),
        product_(product_of_cycle(family, proof.cycle)) {}

  Decision run() {
    if (const char* reason = first_vertex()) return {Truth::unknown, reason};
    if (const char* reason = other_vertices()) return {Truth::unknown, reason};
    const Rational least = *radius_.upper * factor_;
    for (std::size_t i = 0; i < proof_.images.size(); ++i) {
      Integer sum = 0;
      for (const AntinormProof::Term& term : proof_.images[i]) sum += term.weight;
      if (known_.contains(i) || Rational(sum) * two_to(-proof_.weight_bits) >= least) continue;
      if (deadline_.expired()) return {Truth::unknown, no_time};
      if (proof_.images[i].size() != 1 ||
          !is_same(i / family_.count(), i % family_.count(), proof_.images[i].front().vertex))
        return {Truth::unknown, "an image lies too near to the boundary"};
      proof_.coincidences.push_back({i / family_.count(), i % family_.count(), proof_.images[i].front().vertex});
    }
    return {Truth::yes, "every image is a vertex or lies inside, and the product attains the subradius"};
  }

 private:
  static constexpr const char* no_time = "no time was left to look at the vertices";

  /// What is missing, or null.
  const char* first_vertex() {
    const IntegerVector& first = proof_.vertices.front();
    if (!leaves_zeros_alone(product_, first)) return "the first vertex has zeros that the eigenvector has not";
    IntegerVector positive;
    std::ranges::copy_if(first, std::back_inserter(positive), [](const Integer& c) { return c > 0; });
    const RationalMatrix inner = restricted(product_, first, false), rest = restricted(product_, first, true);
    const auto near = near_eigenvector(inner, positive, deadline_);
    if (!near) return "the first vertex is near no positive eigenvector of a simple eigenvalue";
    // A rational eigenvalue that is the spectral radius of the whole product is that of the eigenvector if it is its.
    const Rational lower = power(*radius_.lower, static_cast<long>(proof_.cycle.size()));
    const auto rational = zero_of_linear(near->polynomial);
    const Rational least = rational ? *rational : std::min(near->eigenvalue, lower);
    const bool leads = rational && radius_.is_exact() && *rational == lower;
    if (!leads && rest.rows() > 0 && (least <= 0 || subinvariant_vector(rest, least).empty()))
      return "the product may have another leading eigenvalue";
    factors_.push_back(near->factor);
    conjugates_of(value_at(near->polynomial, inner), inner);
    return nullptr;
  }

  /// The kernel of a polynomial of the product, in all coordinates, and how the product acts on it.
  void conjugates_of(const RationalMatrix& polynomial, const RationalMatrix& inner) {
    const auto basis = kernel(polynomial);
    const std::vector<std::size_t> free = free_columns(basis);
    const std::size_t n = basis.size();
    action_ = RationalMatrix(n, n);
    RationalMatrix padded(product_.rows(), n);
    for (std::size_t k = 0; k < n; ++k) {
      const std::vector<Rational> image = inner * basis[k];
      for (std::size_t l = 0; l < n; ++l) action_(l, k) = image[free[l]];
      for (std::size_t i = 0, at = 0; i < product_.rows(); ++i)
        if (proof_.vertices.front()[i] > 0) padded(i, k) = basis[k][at++];
    }
    led_.emplace(0, std::move(padded));
  }

  const char* other_vertices() {
    factor_ = factors_.front();
    steps_.push_back(0);
    cut_.push_back(false);
    std::vector<std::size_t> followed{0};  // the vertices of the cycle
    for (std::size_t j = 1; j < proof_.vertices.size(); ++j) {
      if (deadline_.expired()) return no_time;
      const auto& [parent, letter] = proof_.origins[j - 1];
      const std::vector<Rational> image = image_of(parent, letter);
      Rational most = 0;
      bool cut = cut_[parent];
      for (std::size_t i = 0; i < image.size(); ++i) {
        const Rational coordinate(proof_.vertices[j][i]);
        if (*radius_.upper * coordinate > image[i]) return "a vertex is not below the image that it stems from";
        cut = cut || (coordinate == 0 && image[i] > 0);
        if (coordinate > 0) most = std::max(most, image[i] / (*radius_.lower * coordinate));
      }
      factors_.push_back(rounded_up(factors_[parent] * most));
      factor_ = std::max(factor_, factors_.back());
      steps_.push_back(steps_[parent] + 1);
      cut_.push_back(cut);
      known_.insert(AntinormProof::image_index(parent, letter, family_.count()));
      const std::size_t step = followed.size() - 1;
      if (step + 1 < proof_.cycle.size() && parent == followed.back() && letter == proof_.cycle[step])
        followed.push_back(j);
    }
    if (followed.size() != proof_.cycle.size() || cut_[followed.back()]) return "a vertex of the cycle is missing";
    known_.insert(AntinormProof::image_index(followed.back(), proof_.cycle.back(), family_.count()));
    return nullptr;
  }

  std::vector<Rational> image_of(std::size_t vertex, std::size_t letter) const {
    std::vector<Rational> x;
    for (const Integer& c : proof_.vertices[vertex]) x.emplace_back(c);
    return family_[letter] * x;
  }

  /// What the letters that lead to a vertex make of the basis.
  const RationalMatrix& led(std::size_t vertex) {
    const auto at = led_.find(vertex);
    if (at != led_.end()) return at->second;
    const auto& [parent, letter] = proof_.origins[vertex - 1];
    RationalMatrix result = family_[letter] * led(parent);
    return led_.emplace(vertex, std::move(result)).first->second;
  }

  /// Whether each coordinate of an image is that of a vertex times the radius, for the true vertices, or clearly more.
  bool is_same(std::size_t vertex, std::size_t letter, std::size_t target) {
    const std::size_t left = steps_[vertex] + 1, right = steps_[target], length = proof_.cycle.size();
    const bool comparable = !cut_[vertex] && !cut_[target] &&
                            (std::max(left, right) - std::min(left, right)) % length == 0;
    const RationalMatrix turns = power(
        action_, comparable ? static_cast<long>((std::max(left, right) - std::min(left, right)) / length) : 0);
    RationalMatrix of_image = family_[letter] * led(vertex), of_vertex = led(target);
    (left < right ? of_image : of_vertex) = (left < right ? of_image : of_vertex) * turns;
    const std::vector<Rational> image = image_of(vertex, letter);
    for (std::size_t i = 0; i < image.size(); ++i) {
      bool equal = comparable;
      for (std::size_t k = 0; k < action_.rows() && equal; ++k) equal = of_image(i, k) == of_vertex(i, k);
      if (!equal && image[i] < *radius_.upper * factor_ * Rational(proof_.vertices[target][i])) return false;
    }
    return true;
  }

  const MatrixFamily& family_;
  AntinormProof& proof_;
  const Enclosure& radius_;
  const Deadline& deadline_;
  RationalMatrix product_;
  std::vector<Rational> factors_;   // D_j of the theorem
  Rational factor_;                 // the largest one
  std::vector<std::size_t> steps_;  // letters that lead to a vertex
  std::vector<bool> cut_;           // a coordinate of the vertex, or of one that it stems from, was dropped
  std::set<std::size_t> known_;     // images that are vertices by construction
  RationalMatrix action_{0, 0};
  std::map<std::size_t, RationalMatrix> led_;
};

}  // namespace

IntegerVector eigenvector_of(const RationalMatrix& matrix, const Rational& eigenvalue) {
  RationalMatrix shifted = matrix;
  for (std::size_t i = 0; i < matrix.rows(); ++i) shifted(i, i) -= eigenvalue;
  const auto basis = kernel(shifted);
  if (basis.size() != 1) return {};
  IntegerVector x = radius::primitive(basis[0]);
  if (std::all_of(x.begin(), x.end(), [](const Integer& c) { return c <= 0; }))
    for (Integer& c : x) c = -c;
  return std::all_of(x.begin(), x.end(), [](const Integer& c) { return c >= 0; }) ? x : IntegerVector{};
}

RationalMatrix restricted(const RationalMatrix& matrix, const IntegerVector& vector, bool to_zeros) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < vector.size(); ++i)
    if ((vector[i] == 0) == to_zeros) kept.push_back(i);
  RationalMatrix result(kept.size(), kept.size());
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (std::size_t j = 0; j < kept.size(); ++j) result(i, j) = matrix(kept[i], kept[j]);
  return result;
}

IntegerVector subinvariant_vector(const RationalMatrix& matrix, const Rational& shift, int bits) {
  const std::size_t n = matrix.rows();
  RationalMatrix shifted = Rational(-1) * matrix, ones(n, 1);
  Rational most = 1;
  for (std::size_t i = 0; i < n; ++i) {
    Rational row = 0;
    for (std::size_t j = 0; j < n; ++j) row += matrix(i, j);
    most = std::max(most, row);
    shifted(i, i) += shift;
    ones(i, 0) = 1;
  }
  if (determinant(shifted) == 0) {
    IntegerVector x = eigenvector_of(matrix, shift);
    return std::ranges::count(x, Integer(0)) == 0 ? x : IntegerVector{};
  }
  // (shift - matrix) y = 1, and rounding most * y up adds at most `most` to matrix y.
  const RationalMatrix y = solve(shifted, ones);
  most *= two_to(bits);
  IntegerVector x;
  for (std::size_t i = 0; i < n; ++i) x.push_back(to_integer(most * y(i, 0), Rounding::up));
  if (std::ranges::any_of(x, [](const Integer& c) { return c <= 0; })) return {};
  for (std::size_t i = 0; i < n; ++i) {
    Rational image = 0;
    for (std::size_t j = 0; j < n; ++j) image += matrix(i, j) * Rational(x[j]);
    if (image > shift * Rational(x[i])) return {};
  }
  return x;
}

RationalMatrix product_of_cycle(const MatrixFamily& family, const std::vector<std::size_t>& cycle) {
  return family.product({cycle.rbegin(), cycle.rend()});
}

Decision product_attains_subradius(const MatrixFamily& family, AntinormProof& proof, const Enclosure& radius,
                                   const Deadline& deadline) {
  return Attained(family, proof, radius, deadline).run();
}

}  // namespace subcert::subradius
