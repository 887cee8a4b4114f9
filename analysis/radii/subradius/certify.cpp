#include "certify.hpp"

#include <subcert/analysis/radii/joint/cost.hpp>
#include <subcert/analysis/radii/polytope_proof/round_family.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace subcert::subradius {
namespace {

constexpr double shrink = 1 - 1e-11;  // of weights in double precision
constexpr int spare_bits = 64;

using IntegerVector = std::vector<Integer>;

bool is_positive(const IntegerVector& x) {
  return std::all_of(x.begin(), x.end(), [](const Integer& c) { return c > 0; });
}

/// A large integer that a number with a short numerator divides many times.
Integer divisible(const Rational& rate, int bits) {
  const Integer base = numerator(rate), longest = Integer(1) << 32;
  return (base < longest ? pow(base, static_cast<unsigned long>(bits) / 4) : Integer(1))
         << static_cast<std::size_t>(2 * bits);
}

/// Without coordinates that are 0 in the eigenvector, as far as one can see, and not longer than needed.
IntegerVector rounded(IntegerVector x, int bits) {
  const Integer largest = *std::max_element(x.begin(), x.end());
  const long excess = binary_exponent(Rational(largest)) - 2L * bits;
  for (Integer& c : x) {
    if ((c << static_cast<std::size_t>(3 * bits / 4)) < largest) c = 0;
    if (excess > 0) c >>= static_cast<std::size_t>(excess);
  }
  return x;
}

/// The proof under construction.
class Certifier {
 public:
  Certifier(const MatrixFamily& family, const AntinormCandidate& candidate, const std::vector<int>& cycle,
            const Rational& rate, int bits)
      : count_(family.count()),
        candidate_(candidate),
        cycle_(cycle),
        rate_(rate),
        denominator_(common_denominator(family)),
        program_(family.size()) {
    for (const RationalMatrix& matrix : family) {
      matrices_.push_back(integer_multiple(matrix, denominator_));
      rough_.push_back(radius::to_double(Rational(1) / rate * matrix));
    }
    proof_.weight_bits = bits + static_cast<int>(std::max(0L, -binary_exponent(rate)));
  }

  std::optional<AntinormProof> run(const IntegerVector& first, const Deadline& deadline) {
    proof_.cycle.assign(cycle_.begin(), cycle_.end());
    proof_.vertices.push_back(lengthened(first));
    for (std::size_t j = 1; j < candidate_.kept; ++j) {
      const AntinormCandidate::Vertex& vertex = candidate_.vertices[j];
      const auto parent = static_cast<std::size_t>(vertex.parent), letter = static_cast<std::size_t>(vertex.letter);
      const Rational divisor = rate_ * Rational(denominator_);
      IntegerVector next = image(parent, letter);
      for (std::size_t i = 0; i < next.size(); ++i)
        next[i] = vertex.value[i] == 0 ? Integer(0) : next[i] * denominator(divisor) / numerator(divisor);
      if (std::all_of(next.begin(), next.end(), [](const Integer& c) { return c == 0; })) return std::nullopt;
      proof_.vertices.push_back(std::move(next));
      proof_.origins.push_back({parent, letter});
      known_[{parent, letter}] = j;
    }
    known_[{cycle_.size() - 1, static_cast<std::size_t>(cycle_.back())}] = 0;
    for (const auto& [vertex, letter, target] : candidate_.coincidences)
      if (vertex < candidate_.kept && target < candidate_.kept) known_.emplace(std::pair(vertex, letter), target);
    for (std::size_t j = 0; j < candidate_.kept; ++j) program_.add(candidate_.vertices[j].value);
    std::optional<Rational> least;
    for (std::size_t j = 0; j < candidate_.kept; ++j)
      for (std::size_t t = 0; t < count_; ++t) {
        if (deadline.expired()) return std::nullopt;
        proof_.images.push_back(terms_below(j, t));
        Integer sum = 0;
        for (const AntinormProof::Term& term : proof_.images.back()) sum += term.weight;
        const Rational value = Rational(sum) * two_to(-proof_.weight_bits);
        if (!least || value < *least) least = value;
        if (*least == 0) return std::nullopt;
      }
    proof_.bound = *least;
    return std::move(proof_);
  }

 private:
  using Terms = std::vector<AntinormProof::Term>;

  /// So long that the smallest coordinate of a vertex has some digits.
  IntegerVector lengthened(IntegerVector first) const {
    double largest = 0, least = 1;
    for (const double c : candidate_.vertices.front().value) largest = std::max(largest, c);
    for (std::size_t j = 0; j < candidate_.kept; ++j)
      for (const double c : candidate_.vertices[j].value)
        if (c > 0) least = std::min(least, c);
    const long length = proof_.weight_bits + spare_bits + std::ilogb(largest) - std::ilogb(least);
    const long missing = length - binary_exponent(Rational(*std::max_element(first.begin(), first.end())));
    for (Integer& c : first) c <<= static_cast<std::size_t>(std::max(0L, missing));
    return first;
  }

  /// The image of a vertex, times the denominator of the matrices.
  IntegerVector image(std::size_t vertex, std::size_t letter) const {
    const IntegerVector &x = proof_.vertices[vertex], &matrix = matrices_[letter];
    const std::size_t n = x.size();
    IntegerVector result(n, 0);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) add_product(result[i], matrix[i * n + k], x[k]);
    return result;
  }

  Terms terms_below(std::size_t vertex, std::size_t letter) const {
    const IntegerVector point = image(vertex, letter);
    if (const auto known = known_.find({vertex, letter}); known != known_.end())
      return multiple_below(point, known->second);
    const Combination combination = program_.below(rough_[letter] * candidate_.vertices[vertex].value,
                                                   1 + clearly_above);
    Terms terms;
    if (combination.value < 1 + clearly_above && combination.rows.size() == combination.terms.size())
      terms = solved(point, combination);
    if (terms.empty())
      for (const Combination::Term& term : combination.terms)
        add(terms, term.vertex, Rational(term.weight * shrink) * rate_);
    return shrunk(point, std::move(terms));
  }

  /// The largest multiple of a vertex.
  Terms multiple_below(const IntegerVector& point, std::size_t vertex) const {
    Terms terms;
    add(terms, vertex, 2 * rate_);
    return shrunk(point, std::move(terms));
  }

  void add(Terms& terms, std::size_t vertex, const Rational& weight) const {
    const Integer rounded = to_integer(weight * two_to(proof_.weight_bits), Rounding::down);
    if (rounded > 0) terms.push_back({vertex, rounded});
  }

  /// The weights with which the basis is equal to the point where it is to be.
  Terms solved(const IntegerVector& point, const Combination& combination) const {
    const std::size_t n = combination.rows.size();
    RationalMatrix columns(n, n), right(n, 1);
    for (std::size_t i = 0; i < n; ++i) {
      right(i, 0) = Rational(point[combination.rows[i]], denominator_);
      for (std::size_t k = 0; k < n; ++k)
        columns(i, k) = Rational(proof_.vertices[combination.terms[k].vertex][combination.rows[i]]);
    }
    Terms terms;
    if (n == 0 || determinant(columns) == 0) return terms;
    const RationalMatrix weights = solve(columns, right);
    for (std::size_t k = 0; k < n; ++k) add(terms, combination.terms[k].vertex, weights(k, 0));
    return terms;
  }

  /// Weights that are at most as large, so that the combination is below the point.
  Terms shrunk(const IntegerVector& point, Terms terms) const {
    const std::size_t n = point.size();
    std::erase_if(terms, [&](const AntinormProof::Term& term) {
      for (std::size_t i = 0; i < n; ++i)
        if (point[i] == 0 && proof_.vertices[term.vertex][i] > 0) return true;
      return false;
    });
    Rational factor = 1;
    for (std::size_t i = 0; i < n; ++i) {
      Integer sum = 0;
      for (const AntinormProof::Term& term : terms) add_product(sum, term.weight, proof_.vertices[term.vertex][i]);
      const Integer above = point[i] << static_cast<std::size_t>(proof_.weight_bits), below = sum * denominator_;
      if (factor * Rational(below) > Rational(above)) factor = Rational(above, below);
    }
    if (factor < 1)
      for (AntinormProof::Term& term : terms) term.weight = to_integer(Rational(term.weight) * factor, Rounding::down);
    std::erase_if(terms, [](const AntinormProof::Term& term) { return term.weight == 0; });
    return terms;
  }

  std::size_t count_;
  const AntinormCandidate& candidate_;
  const std::vector<int>& cycle_;
  Rational rate_;
  Integer denominator_;
  AntinormProgram program_;
  std::vector<IntegerVector> matrices_;                               // times the denominator
  std::vector<polytope::Matrix> rough_;                               // over the rate
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> known_;  // images that are vertices
  AntinormProof proof_;
};

/// A vertex that a polytope begins with, and a proof that the spectral radius is at most the shift.
struct Start {
  IntegerVector vertex, weights;
  Rational shift;
};

/// `modulus`: of the largest eigenvalue; `factor`: of the vertex where that is rational.
std::optional<Start> start_of(const RationalMatrix& matrix, const Enclosure& modulus, const Integer& factor, int bits) {
  IntegerVector vertex;
  if (modulus.is_exact()) {
    const IntegerVector weights = eigenvector_of(matrix, *modulus.upper);
    for (const Integer& c : weights) vertex.push_back(c * factor);
    if (!weights.empty() && is_positive(weights)) return Start{vertex, weights, *modulus.upper};
  }
  const Rational shift = *modulus.upper * (1 + two_to(-bits));
  const IntegerVector longer = subinvariant_vector(matrix, shift, bits);
  if (longer.empty()) return std::nullopt;
  IntegerVector weights;
  for (const Integer& c : longer) weights.push_back(-(-c >> static_cast<std::size_t>(bits)));  // rounded up
  return Start{vertex.empty() ? rounded(longer, bits) : vertex, weights, shift};
}

}  // namespace

std::optional<LeadingVector> leading_vector(const MatrixFamily& family, const std::vector<int>& word, int bits,
                                            const Deadline& deadline) {
  const RationalMatrix matrix = family.product(word);
  const auto characteristic = characteristic_polynomial(matrix, deadline);
  if (!characteristic || !radius::has_time_for_roots(*characteristic, deadline)) return std::nullopt;
  const Enclosure modulus = largest_root_modulus(*characteristic, bits + spare_bits).largest;
  if (*modulus.upper == 0) {
    std::vector<int> repeated;
    for (std::size_t k = 0; k < family.size(); ++k) repeated.insert(repeated.end(), word.begin(), word.end());
    return LeadingVector{{repeated, 0, IntegerVector(family.size(), 1)}, Enclosure::exactly(0), 0, {}, {}};
  }
  if (!radius::has_time_for_elimination(matrix, deadline)) return std::nullopt;
  const auto root_of = [&](const Rational& value) {
    const auto root = exact_root(value, word.size());
    return root ? Enclosure::exactly(*root) : root_enclosure(value, static_cast<int>(word.size()), bits + spare_bits);
  };
  const Enclosure radius{root_of(*modulus.lower).lower, root_of(*modulus.upper).upper};
  const Integer factor = divisible(*radius.upper * Rational(common_denominator(family)), bits);
  const auto right = start_of(matrix, modulus, factor, bits),
             left = start_of(transposed(matrix), modulus, factor, bits);
  if (!right) return std::nullopt;
  return LeadingVector{{word, right->shift, right->weights},
                       radius,
                       *root_of(right->shift).upper,
                       right->vertex,
                       left ? left->vertex : IntegerVector{}};
}

std::optional<AntinormProof> certify_antinorm(const MatrixFamily& family, const AntinormCandidate& candidate,
                                              const std::vector<int>& cycle, const std::vector<Integer>& first,
                                              const Rational& rate, int bits, const Deadline& deadline) {
  if (candidate.kept == 0) return std::nullopt;
  return Certifier(family, candidate, cycle, rate, bits).run(first, deadline);
}

}  // namespace subcert::subradius
