#include "closed_orbit.hpp"

#include "attains.hpp"
#include "cost.hpp"
#include "subspace.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/radii/polytope_search/incremental_simplex.hpp>
#include <subcert/analysis/radii/schedule.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

namespace subcert::radius {
namespace {

constexpr std::size_t largest_size = 12, most_products = 64, most_words = 8, longest_word = 12, most_vertices = 300;
constexpr int longest = 4;            // products of the family
constexpr long turns = 24;            // roots of unity of such orders are made 1
constexpr double rounding = 1e-9;     // of a norm
constexpr double inside = 1e-6;       // by which a norm is below 1 where images have to lie inside
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

/// A vector from which an orbit starts, and the letters that lead it back to itself, up to its sign and the power of
/// the radius; none where they are not asked for.
struct Start {
  Vector vector;
  std::vector<int> cycle;
};

/// Vertices, and where their images are. A vertex is a rational vector over a power of the radius, after so many
/// letters; what has another power is another vertex, even where that is rational.
class Orbit {
 public:
  /// `power`: the radius^length. `strict`: images lie inside, or are vertices that stem from the same start; the length
  /// is that of the cycles. Otherwise they may lie on the boundary. Domain: strict, or length = 1.
  Orbit(const MatrixFamily& family, const Rational& power, int length, bool strict, const Budget& budget)
      : family_(family),
        power_(power),
        length_(length),
        strict_(strict),
        budget_(budget),
        simplex_(PolytopeKind::real, polytope::GroupAction(family.size()), budget) {
    candidate_.scale = std::pow(power.convert_to<double>(), 1.0 / length);
    if (strict) candidate_.radius = candidate_.scale;
    candidate_.closed = true;
  }

  /// Whether it closes and spans.
  bool grow(const std::vector<Start>& starts) {
    for (const Start& start : starts) {
      if (find({start.vector, 0, 0})) continue;
      PolytopeCandidate::Vertex origin;
      if (strict_) {
        origin.cycle = static_cast<int>(candidate_.products.size());
        origin.place = 0;
        candidate_.products.push_back({start.cycle, candidate_.radius});
      }
      add({start.vector, 0, vertices_.size()}, std::move(origin));
      for (std::size_t k = 0; k + 1 < start.cycle.size() && strict_; ++k) {
        const int letter = start.cycle[k], last = static_cast<int>(vertices_.size()) - 1;
        add(image_of(vertices_.back(), static_cast<std::size_t>(letter)), {{}, last, letter});
      }
      if (strict_ && !grow()) return false;
      if (strict_ && spans()) break;
    }
    candidate_.maximizing = candidate_.products.size();
    return grow() && spans();
  }

  const PolytopeCandidate& candidate() const { return candidate_; }

 private:
  /// x over the radius^level, level < length.
  struct Vertex {
    Vector x;
    int level;
    std::size_t start;  ///< from which it stems
  };

  Vertex image_of(Vertex v, std::size_t t) const {
    v.x = family_[t] * v.x;
    if (++v.level == length_) {
      v.level = 0;
      for (Rational& c : v.x) c /= power_;
    }
    return v;
  }

  bool grow() {
    for (std::size_t next = candidate_.images.size(); next < vertices_.size() * family_.count(); ++next) {
      if (vertices_.size() > most_vertices || budget_.deadline.expired()) return false;
      if (!settle(next / family_.count(), next % family_.count())) return false;
    }
    return true;
  }

  bool spans() const {
    RationalMatrix all(family_.size(), vertices_.size());
    for (std::size_t j = 0; j < vertices_.size(); ++j)
      for (std::size_t i = 0; i < family_.size(); ++i) all(i, j) = vertices_[j].x[i];
    return !vertices_.empty() && pivot_columns(all).size() == family_.size();
  }

  std::vector<double> value(const Vertex& v) const {
    std::vector<double> result;
    for (const Rational& x : v.x) result.push_back(x.convert_to<double>() / std::pow(candidate_.scale, v.level));
    return result;
  }

  void add(Vertex v, PolytopeCandidate::Vertex origin) {
    const std::vector<double> numbers = value(v);
    simplex_.add(numbers);
    origin.value.assign(numbers.begin(), numbers.end());
    candidate_.vertices.push_back(std::move(origin));
    vertices_.push_back(std::move(v));
  }

  /// The vertex that this is, up to its sign.
  std::optional<PolytopeCandidate::Term> find(const Vertex& v) const {
    Vector negative = v.x;
    for (Rational& c : negative) c = -c;
    for (std::size_t j = 0; j < vertices_.size(); ++j)
      if (vertices_[j].level == v.level && (vertices_[j].x == v.x || vertices_[j].x == negative))
        return PolytopeCandidate::Term{static_cast<int>(j), 0, false, vertices_[j].x == v.x ? 1.0 : -1.0};
    return std::nullopt;
  }

  /// False where a number becomes too long, or nothing says why an image is a vertex.
  bool settle(std::size_t v, std::size_t t) {
    Vertex image = image_of(vertices_[v], t);
    const int vertex = static_cast<int>(v), letter = static_cast<int>(t);
    std::vector<PolytopeCandidate::Term> terms;
    bool is_vertex = false;
    if (std::ranges::any_of(image.x, [](const Rational& c) { return c != 0; })) {
      if (bit_size(image.x) > longest_entry) return false;
      if (const auto same = find(image)) {
        is_vertex = strict_;
        if (strict_ && vertices_[static_cast<std::size_t>(same->vertex)].start != image.start) return false;
        terms = {*same};
      } else if (auto inner = combination(image)) {
        terms = std::move(*inner);
      } else {
        is_vertex = strict_;
        terms = {{static_cast<int>(vertices_.size()), 0, false, 1.0}};
        add(std::move(image), {{}, vertex, letter});
      }
    }
    candidate_.images.push_back({vertex, letter, is_vertex, std::move(terms)});
    return true;
  }

  /// A combination of vertices whose weights have moduli of sum clearly below 1, or at most 1, exactly.
  std::optional<std::vector<PolytopeCandidate::Term>> combination(const Vertex& image) {
    const double most = strict_ ? 1 - inside : 1 + rounding;
    const polytope::Membership found = simplex_.solve(value(image), most, most);
    if (!found.combined || found.upper > most + rounding) return std::nullopt;
    std::vector<polytope::CombinationTerm> terms = simplex_.combination();
    std::erase_if(terms, [](const auto& term) { return std::abs(term.coefficient) < rounding; });
    return strict_ ? proposed(terms) : exactly(image.x, terms);
  }

  static std::vector<PolytopeCandidate::Term> proposed(const std::vector<polytope::CombinationTerm>& terms) {
    std::vector<PolytopeCandidate::Term> result;
    for (const auto& term : terms) result.push_back({term.vertex, 0, false, term.coefficient});
    return result;
  }

  std::optional<std::vector<PolytopeCandidate::Term>> exactly(
      const Vector& x, const std::vector<polytope::CombinationTerm>& terms) const {
    const std::size_t n = x.size(), k = terms.size();
    RationalMatrix system(n, k + 1);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < k; ++j) system(i, j) = vertices_[static_cast<std::size_t>(terms[j].vertex)].x[i];
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
  const Rational& power_;
  int length_;
  bool strict_;
  Budget budget_;
  polytope::IncrementalSimplex simplex_;
  std::vector<Vertex> vertices_;
  PolytopeCandidate candidate_;
};

/// The shortest power of the word, from left to right, that multiplies the vector by the power of the radius or its
/// negative, as letters of a cycle. Domain: some power does, within the turns.
std::vector<int> shortest_cycle(const MatrixFamily& family, const std::vector<int>& word, int length,
                                const Rational& radius, const Vector& v) {
  const std::size_t least = std::lcm(word.size(), static_cast<std::size_t>(length));
  const RationalMatrix product = power(family.product(word), static_cast<long>(least / word.size()));
  const Rational factor = power(radius, static_cast<long>(least) / length);
  std::vector<int> cycle;
  Vector moved = v, negative = v;
  for (Rational& c : negative) c = -c;
  do {
    moved = product * moved;
    for (Rational& c : moved) c /= factor;
    for (std::size_t k = 0; k < least / word.size(); ++k) cycle.insert(cycle.end(), word.rbegin(), word.rend());
  } while (moved != v && moved != negative);
  return cycle;
}

/// The vectors that some power of a product multiplies by that power of the radius: those of all products that arise
/// from the word by cyclic shifts, as far as there is time.
std::vector<Start> leading_vectors(const MatrixFamily& family, std::vector<int> word, int length,
                                   const Rational& radius, const Deadline& deadline) {
  const long letters = std::lcm(static_cast<long>(word.size()), static_cast<long>(length)) * turns,
             repeated = letters / static_cast<long>(word.size());
  const Rational value = power(radius, letters / length);
  std::vector<Start> result;
  for (std::size_t shift = 0; shift < word.size(); ++shift) {
    RationalMatrix difference = power(family.product(word), repeated);
    for (std::size_t i = 0; i < family.size(); ++i) difference(i, i) -= value;
    if (!has_time_for_elimination(difference, deadline)) return {};
    const Subspace own = kernel(difference);
    if (!own.empty())
      for (Vector& v : with_short_vectors(own)) {
        std::vector<int> cycle = shortest_cycle(family, word, length, radius, v);
        result.push_back({std::move(v), std::move(cycle)});
      }
    std::rotate(word.begin(), word.begin() + 1, word.end());
  }
  return result;
}

/// From which orbits may close: the leading vectors of each word, those of the fewest first, as any basis of many is a
/// guess; then all together, beginning with these.
std::vector<std::vector<Start>> all_starts(const MatrixFamily& family, const std::vector<std::vector<int>>& words,
                                           int length, const Rational& radius, const Deadline& deadline) {
  std::map<std::size_t, std::vector<std::vector<Start>>> by_dimension;
  for (const std::vector<int>& word : words) {
    std::vector<Start> own = leading_vectors(family, word, length, radius, deadline);
    by_dimension[own.size() / word.size()].push_back(std::move(own));
  }
  by_dimension.erase(0);
  std::vector<std::vector<Start>> result;
  std::vector<Start> all;
  for (auto& [dimension, several] : by_dimension)
    for (std::vector<Start>& starts : several) {
      all.insert(all.end(), starts.begin(), starts.end());
      result.push_back(std::move(starts));
    }
  if (result.size() > 1) result.push_back(std::move(all));
  return result;
}

/// A polytope of the family itself, for a certificate. The starts are made ever smaller, so that images of one which
/// look like those of another lie inside.
std::optional<PolytopeProof> strict_proof(const MatrixFamily& family, std::vector<Start> starts, int length,
                                          const Rational& radius, const Budget& budget) {
  std::ranges::stable_sort(starts, {}, [](const Start& start) { return start.cycle.size(); });
  std::erase_if(starts, [&](const Start& start) { return start.cycle.size() != starts.front().cycle.size(); });
  for (std::size_t k = 0; k < starts.size(); ++k)
    for (Rational& c : starts[k].vector) c /= power(Rational(2), static_cast<long>(k));
  const int letters = static_cast<int>(starts.front().cycle.size());
  const Rational power_of_radius = power(radius, letters / length);
  Orbit orbit(family, power_of_radius, letters, true, budget);
  if (!orbit.grow(starts)) return std::nullopt;
  auto proof = certify_polytope(family, orbit.candidate(), budget);
  if (proof) find_cycles(family, orbit.candidate(), *proof, {}, {}, budget.deadline);
  return proof;
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

/// Of the first of these starts whose orbit closes, with a proof for certificates by these or others.
std::optional<ClosedOrbit> first_closed(const MatrixFamily& family, const MatrixFamily& products,
                                        const std::vector<std::vector<Start>>& all, int length, const Rational& radius,
                                        const Budget& budget) {
  std::optional<ClosedOrbit> result;
  for (const std::vector<Start>& starts : all) {
    if (budget.deadline.expired()) break;
    if (!result) {
      Orbit orbit(products, radius, 1, false, budget);
      if (!orbit.grow(starts)) continue;
      result = {radius, length, {}, std::nullopt};
      if (length == 1) result->proof = certify_polytope(products, orbit.candidate(), budget);
    }
    if (auto proof = strict_proof(family, starts, length, radius, budget)) {
      result->proof = std::move(proof);
      break;
    }
  }
  return result;
}

}  // namespace

std::optional<ClosedOrbit> closed_orbit(const MatrixFamily& family, const std::vector<std::vector<int>>& words,
                                        const Budget& budget) {
  std::vector<std::vector<int>> short_words;
  for (const std::vector<int>& word : words)
    if (word.size() <= longest_word && short_words.size() < most_words) short_words.push_back(word);
  if (family.size() > largest_size) return std::nullopt;
  const Budget its{budget.deadline.after(schedule::orbit::all).at_most(schedule::orbit::seconds), budget.memory};
  std::set<int> tried;
  for (const std::vector<int>& word : short_words) {
    std::size_t count = family.count();
    for (int length = 1; length <= longest && count <= most_products; ++length, count *= family.count()) {
      if (tried.contains(length) || its.deadline.expired()) continue;
      const MatrixFamily products = products_of(family, length);
      const auto radius = rational_power(products, family.count(), word, length, its.deadline);
      if (!radius || *radius <= 0) continue;
      tried.insert(length);
      if (auto orbit = first_closed(family, products, all_starts(family, short_words, length, *radius, its.deadline),
                                    length, *radius, its)) {
        orbit->word = word;
        return orbit;
      }
    }
  }
  return std::nullopt;
}

}  // namespace subcert::radius
