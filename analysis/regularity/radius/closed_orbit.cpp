#include "closed_orbit.hpp"

#include "subspace.hpp"

#include <subcert/analysis/regularity/polytope_proof/candidate.hpp>
#include <subcert/analysis/regularity/polytope_search/incremental_simplex.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace subcert::radius {
namespace {

constexpr std::size_t largest_size = 12, most_products = 64, most_words = 8, longest_word = 12, most_vertices = 300;
constexpr int longest = 4;            // products of the family
constexpr long turns = 24;            // roots of unity of such orders are made 1
constexpr double seconds = 1;         // for all
constexpr double share = 0.1;         // of the time
constexpr double rounding = 1e-9;     // of a norm
constexpr long longest_entry = 2000;  // bits of a vertex

long bit_size(const Vector& v) {
  long bits = 0;
  for (const Rational& x : v)
    for (const Integer& part : {numerator(x), denominator(x)})
      if (!part.is_zero()) bits = std::max(bits, static_cast<long>(msb(abs(part))));
  return bits;
}

/// The products of so many matrices; the number of a word is that in the base count.
MatrixFamily products_of(const MatrixFamily& family, int length) {
  std::vector<RationalMatrix> products = family.matrices();
  for (int k = 1; k < length; ++k) {
    std::vector<RationalMatrix> longer;
    for (const RationalMatrix& product : products)
      for (const RationalMatrix& m : family) longer.push_back(product * m);
    products = std::move(longer);
  }
  std::vector<std::size_t> letters(products.size());
  std::iota(letters.begin(), letters.end(), std::size_t{0});
  return {std::move(products), {{SparseMap::identity(family.size()), std::move(letters)}}};
}

/// Vertices, and where their images are.
class Orbit {
 public:
  Orbit(const MatrixFamily& family, const Rational& radius, const Budget& budget)
      : family_(family),
        radius_(radius),
        budget_(budget),
        simplex_(PolytopeKind::real, polytope::GroupAction(family.size()), budget) {
    candidate_.scale = radius.convert_to<double>();
    candidate_.closed = true;
  }

  /// Whether it closes and spans.
  bool grow(const Subspace& starts) {
    for (const Vector& v : starts)
      if (!find(v)) add(v, {});
    for (std::size_t v = 0; v < vertices_.size(); ++v)
      for (std::size_t t = 0; t < family_.count(); ++t) {
        if (vertices_.size() > most_vertices || budget_.deadline.expired()) return false;
        if (!settle(v, t)) return false;
      }
    RationalMatrix all(family_.size(), vertices_.size());
    for (std::size_t j = 0; j < vertices_.size(); ++j)
      for (std::size_t i = 0; i < family_.size(); ++i) all(i, j) = vertices_[j][i];
    return !vertices_.empty() && pivot_columns(all).size() == family_.size();
  }

  const PolytopeCandidate& candidate() const { return candidate_; }

 private:
  void add(const Vector& v, PolytopeCandidate::Vertex origin) {
    std::vector<double> value;
    for (const Rational& x : v) value.push_back(x.convert_to<double>());
    simplex_.add(value);
    origin.value.assign(value.begin(), value.end());
    candidate_.vertices.push_back(std::move(origin));
    vertices_.push_back(v);
  }

  /// The vertex that this is, up to its sign.
  std::optional<PolytopeCandidate::Term> find(const Vector& x) const {
    Vector negative = x;
    for (Rational& c : negative) c = -c;
    for (std::size_t j = 0; j < vertices_.size(); ++j)
      if (vertices_[j] == x || vertices_[j] == negative)
        return PolytopeCandidate::Term{static_cast<int>(j), 0, false, vertices_[j] == x ? 1.0 : -1.0};
    return std::nullopt;
  }

  /// False where a number becomes too long.
  bool settle(std::size_t v, std::size_t t) {
    Vector x = family_[t] * vertices_[v];
    for (Rational& c : x) c /= radius_;
    const int vertex = static_cast<int>(v), letter = static_cast<int>(t);
    std::vector<PolytopeCandidate::Term> terms;
    if (std::ranges::any_of(x, [](const Rational& c) { return c != 0; })) {
      if (bit_size(x) > longest_entry) return false;
      if (const auto same = find(x)) {
        terms = {*same};
      } else if (auto inside = combination(x)) {
        terms = std::move(*inside);
      } else {
        terms = {{static_cast<int>(vertices_.size()), 0, false, 1.0}};
        add(x, {{}, vertex, letter});
      }
    }
    candidate_.images.push_back({vertex, letter, false, std::move(terms)});
    return true;
  }

  /// A combination of vertices whose weights have moduli of sum at most 1, exactly.
  std::optional<std::vector<PolytopeCandidate::Term>> combination(const Vector& x) {
    std::vector<double> point;
    for (const Rational& c : x) point.push_back(c.convert_to<double>());
    const polytope::Membership found = simplex_.solve(point, 1 + rounding, 1 + rounding);
    if (!found.combined || found.upper > 1 + 2 * rounding) return std::nullopt;
    std::vector<polytope::CombinationTerm> terms = simplex_.combination();
    std::erase_if(terms, [](const auto& term) { return std::abs(term.coefficient) < rounding; });
    const std::size_t n = x.size(), k = terms.size();
    RationalMatrix system(n, k + 1);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < k; ++j) system(i, j) = vertices_[static_cast<std::size_t>(terms[j].vertex)][i];
      system(i, k) = x[i];
    }
    const auto solutions = kernel(system);
    if (solutions.size() != 1 || solutions.front()[k] == 0) return std::nullopt;
    Rational sum = 0;
    std::vector<PolytopeCandidate::Term> result;
    for (std::size_t j = 0; j < k; ++j) {
      const Rational weight = -solutions.front()[j] / solutions.front()[k];
      sum += abs(weight);
      result.push_back({terms[j].vertex, 0, false, weight.convert_to<double>()});
    }
    return sum <= 1 ? std::optional(std::move(result)) : std::nullopt;
  }

  const MatrixFamily& family_;
  const Rational& radius_;
  Budget budget_;
  polytope::IncrementalSimplex simplex_;
  std::vector<Vector> vertices_;
  PolytopeCandidate candidate_;
};

/// The vectors that some power of a product multiplies by that power of the radius: those of all products that arise
/// from the word by cyclic shifts.
Subspace leading_vectors(const MatrixFamily& family, std::vector<int> word, int length, const Rational& radius) {
  const long letters = std::lcm(static_cast<long>(word.size()), static_cast<long>(length)) * turns,
             repeated = letters / static_cast<long>(word.size());
  const Rational value = power(radius, letters / length);
  Subspace result;
  for (std::size_t shift = 0; shift < word.size(); ++shift) {
    RationalMatrix difference = power(family.product(word), repeated);
    for (std::size_t i = 0; i < family.size(); ++i) difference(i, i) -= value;
    const Subspace own = kernel(difference);
    if (!own.empty()) std::ranges::move(with_short_vectors(own), std::back_inserter(result));
    std::rotate(word.begin(), word.begin() + 1, word.end());
  }
  return result;
}

/// radius^length, where the product attains the radius and that is a rational number.
std::optional<Rational> rational_power(const MatrixFamily& products, std::size_t count, const std::vector<int>& word,
                                       int length, const Deadline& deadline) {
  std::vector<int> in_products;
  const std::size_t letters = std::lcm(word.size(), static_cast<std::size_t>(length));
  for (std::size_t begin = 0; begin < letters; begin += static_cast<std::size_t>(length)) {
    std::size_t number = 0;
    for (std::size_t k = begin; k < begin + static_cast<std::size_t>(length); ++k)
      number = number * count + static_cast<std::size_t>(word[k % word.size()]);
    in_products.push_back(static_cast<int>(number));
  }
  return prove_product(products, in_products, deadline).exact;
}

}  // namespace

std::optional<ClosedOrbit> closed_orbit(const MatrixFamily& family, const std::vector<std::vector<int>>& words,
                                        const Budget& budget) {
  if (family.size() > largest_size || words.empty() || words.front().size() > longest_word) return std::nullopt;
  const Budget its{budget.deadline.after(share).at_most(seconds), budget.memory};
  std::size_t count = family.count();
  for (int length = 1; length <= longest && count <= most_products; ++length, count *= family.count()) {
    const MatrixFamily products = products_of(family, length);
    const auto radius = rational_power(products, family.count(), words.front(), length, its.deadline);
    if (!radius || *radius <= 0) continue;
    Subspace all;
    for (std::size_t k = 0; k < std::min(words.size(), most_words) && !its.deadline.expired(); ++k) {
      if (words[k].size() > longest_word) continue;
      const Subspace own = leading_vectors(family, words[k], length, *radius);
      all.insert(all.end(), own.begin(), own.end());
      for (const bool alone : {true, false}) {
        if (!alone && all.size() == own.size()) continue;
        Orbit orbit(products, *radius, its);
        if (!orbit.grow(alone ? own : all)) continue;
        ClosedOrbit result{*radius, length, std::nullopt};
        if (length == 1) result.proof = certify_polytope(products, orbit.candidate(), its);
        return result;
      }
    }
  }
  return std::nullopt;
}

}  // namespace subcert::radius
