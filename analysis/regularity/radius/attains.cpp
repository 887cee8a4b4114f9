#include "exact_radius.hpp"
#include <subcert/analysis/symbol/balls.hpp>

#if __has_include(<flint/acb_mat.h>)
#include <flint/acb_mat.h>
#else
#include <acb_mat.h>
#endif

#include <flint/fmpz_poly_factor.h>

#include <algorithm>

namespace subcert {
namespace {

constexpr slong precision = 320;

using RationalVector = std::vector<Rational>;

/// x + i y with rational parts; y may be empty.
struct RationalComplex {
  RationalVector x, y;
};

Rational one_norm(const RationalVector& v) {
  Rational sum = 0;
  for (const Rational& c : v) sum += abs(c);
  return sum;
}

class AcbMatrix {
 public:
  AcbMatrix(std::size_t rows, std::size_t columns) {
    acb_mat_init(value_, static_cast<slong>(rows), static_cast<slong>(columns));
  }
  AcbMatrix(const AcbMatrix&) = delete;
  AcbMatrix& operator=(const AcbMatrix&) = delete;
  ~AcbMatrix() { acb_mat_clear(value_); }
  acb_mat_struct* get() { return value_; }
  acb_ptr entry(std::size_t i, std::size_t j) {
    return acb_mat_entry(value_, static_cast<slong>(i), static_cast<slong>(j));
  }

 private:
  acb_mat_t value_;
};

/// An upper bound for |ball - value|.
Rational distance(acb_ptr ball, const Rational& re, const Rational& im) {
  Ball difference, bound;
  Rational sum = 0;
  for (const bool real : {true, false}) {
    arb_set_fmpq(difference.get(), flint::Quotient(real ? re : im).get(), precision);
    arb_sub(difference.get(), real ? acb_realref(ball) : acb_imagref(ball), difference.get(), precision);
    arb_abs(difference.get(), difference.get());
    const Enclosure enclosure = difference.enclosure(256);
    if (!enclosure.upper) return -1;
    sum += *enclosure.upper;
  }
  return sum;
}

/// Whether the ball holds exactly one zero of p, a simple one, and all others but its conjugate are smaller in modulus.
bool is_simple_and_leading(const LaurentPolynomial& p, const acb_t eigenvalue) {
  const LaurentPolynomial q = p.shifted(-p.lowest());  // the zeros at 0 do not matter
  const LaurentPolynomial repeated = gcd(q, q.derivative());
  flint::IntegerPolynomial simple(*q.exact_quotient(repeated)), multiple(repeated);
  const slong count = fmpz_poly_degree(simple.get());
  if (count < 1) return false;
  acb_ptr roots = _acb_vec_init(count);
  arb_fmpz_poly_complex_roots(roots, simple.get(), 0, precision);
  acb_t conjugate, value;
  acb_init(conjugate);
  acb_init(value);
  acb_conj(conjugate, eigenvalue);
  Ball modulus, other;
  acb_abs(modulus.get(), eigenvalue, precision);
  int held = 0;
  bool leading = true;
  for (slong i = 0; i < count; ++i) {
    if (acb_overlaps(roots + i, eigenvalue)) {
      ++held;
      continue;
    }
    if (acb_overlaps(roots + i, conjugate)) continue;
    acb_abs(other.get(), roots + i, precision);
    leading = leading && arb_lt(other.get(), modulus.get());
  }
  arb_fmpz_poly_evaluate_acb(value, multiple.get(), eigenvalue, precision);
  const bool once = !acb_contains_zero(value);
  acb_clear(conjugate);
  acb_clear(value);
  _acb_vec_clear(roots, count);
  return leading && once && held == 1;
}

class Proof {
 public:
  Proof(const std::vector<RationalMatrix>& matrices, const SearchResult& result, const CertifiedPolytope& polytope,
        const Rational& lower)
      : result_(result), polytope_(polytope), lower_(lower), count_(matrices.size()) {
    for (const RationalMatrix& m : matrices) matrices_.push_back(polytope.transposed ? transposed(m) : m);
    for (std::size_t k = 0; k < result.maximizing; ++k) cycles_.push_back({result.products[k].word, {}, {}, {}});
  }

  Decision run() {
    const auto unknown = [](const char* reason) { return Decision{Truth::unknown, reason}; };
    if (result_.status != SearchStatus::closed) return unknown("the polytope did not close");
    if (polytope_.kind == PolytopeKind::nonnegative) return unknown("polytopes of cones are only enclosed");
    for (Cycle& cycle : cycles_) cycle.mirror_shift = mirror_shift(cycle.word);
    if (!bound_vertex_errors())
      return unknown("a leading eigenvalue is not simple, or its eigenvector was not isolated");
    // kappa: norm by the true polytope / norm by the rational one.
    if (error_ >= 1) return unknown("the vertices are not known well enough");
    const Rational kappa = 1 / (1 - error_);
    for (std::size_t i = 0; i < result_.images.size(); ++i) {
      const ImageProof& image = result_.images[i];
      if (image.identity && is_same_vertex(image)) continue;
      const Rational& moduli = polytope_.moduli[i];
      const Rational rest = polytope_.residuals[i] * polytope_.unit_norm + (polytope_.bound + moduli) * error_;
      if (moduli + kappa * rest >= lower_)
        return unknown(image.identity ? "an image coincides with a vertex for no known reason"
                                      : "an image lies too near to the boundary");
    }
    return {Truth::yes, "every image is a vertex or lies inside, and the product attains the radius"};
  }

 private:
  /// A product whose leading eigenvectors are roots of the polytope.
  struct Cycle {
    std::vector<int> word;
    /// The mirror image of the word is the word shifted by so much.
    std::optional<std::size_t> mirror_shift;
    /// The root from which all others come, and the vertex it is.
    std::optional<std::size_t> base;
    /// See find_eigenspace.
    std::vector<RationalVector> eigenspace;

    int letter(std::size_t place) const { return word[place % word.size()]; }
  };

  const RationalMatrix& matrix(int letter) const { return matrices_[static_cast<std::size_t>(letter)]; }

  std::size_t place_of(std::size_t vertex) const { return static_cast<std::size_t>(result_.vertices[vertex].place); }
  const Cycle& cycle_of(std::size_t vertex) const {
    return cycles_[static_cast<std::size_t>(result_.vertices[vertex].cycle)];
  }

  /// The product that starts at this place of the word.
  RationalMatrix product_from(const Cycle& cycle, std::size_t place) const {
    RationalMatrix product = matrix(cycle.letter(place));
    for (std::size_t k = 1; k < cycle.word.size(); ++k) product = matrix(cycle.letter(place + k)) * product;
    return product;
  }

  std::optional<std::size_t> mirror_shift(const std::vector<int>& word) const {
    if (!polytope_.symmetric) return std::nullopt;
    for (std::size_t shift = 0; shift < word.size(); ++shift) {
      bool equal = true;
      for (std::size_t k = 0; k < word.size() && equal; ++k)
        equal = static_cast<int>(count_) - 1 - word[k] == word[(k + shift) % word.size()];
      if (equal) return shift;
    }
    return std::nullopt;
  }

  RationalComplex vertex(std::size_t index) const {
    const auto rational = [&](const std::vector<Integer>& integers) {
      RationalVector result;
      for (const Integer& c : integers) result.emplace_back(c, Integer(1) << polytope_.vertex_bits);
      return result;
    };
    return {rational(polytope_.vertices[index]),
            polytope_.imaginary.empty() ? RationalVector{} : rational(polytope_.imaginary[index])};
  }

  /// The norm of M ... M source / radius^steps - (+-) target, by the rational polytope. Domain: steps >= 1.
  Rational step_error(std::size_t source, const std::vector<int>& letters, std::size_t target) const {
    RationalComplex moved = vertex(source);
    const RationalComplex goal = vertex(target);
    Enclosure scale = Enclosure::exactly(1);
    for (int t : letters) {
      moved.x = matrices_[static_cast<std::size_t>(t)] * moved.x;
      if (!moved.y.empty()) moved.y = matrices_[static_cast<std::size_t>(t)] * moved.y;
      scale = {*scale.lower * lower_, *scale.upper * polytope_.bound};
    }
    Rational best = -1;
    for (int sign : {1, -1}) {
      Rational error = 0;
      for (const auto& [from, to] : {std::pair(&moved.x, &goal.x), std::pair(&moved.y, &goal.y)})
        for (std::size_t i = 0; i < from->size(); ++i) error += abs((*from)[i] - sign * *scale.lower * (*to)[i]);
      error += (*scale.upper - *scale.lower) * (one_norm(goal.x) + one_norm(goal.y));
      if (best < 0 || error < best) best = error;
    }
    return best / *scale.lower * polytope_.unit_norm;
  }

  /// error_ bounds, over all vertices, the norm of (rational vertex - true vertex).
  bool bound_vertex_errors() {
    std::vector<Rational> errors;
    const auto growth = [&] { return polytope_.bound / lower_; };  // of the norm of an error in one step
    for (std::size_t v = 0; v < result_.vertices.size(); ++v) {
      const Vertex& origin = result_.vertices[v];
      if (origin.parent >= 0) {
        const auto parent = static_cast<std::size_t>(origin.parent);
        errors.push_back(growth() * errors[parent] + step_error(parent, {origin.letter}, v));
      } else if (origin.cycle < 0) {
        errors.emplace_back(0);  // any vertex will do here: the true one is the rational one
      } else if (Cycle& cycle = cycles_[static_cast<std::size_t>(origin.cycle)]; !cycle.base) {
        cycle.base = v;
        const auto error = eigenvector_error(cycle);
        if (!error) return false;
        errors.push_back(*error);
      } else {
        std::vector<int> letters;
        const std::size_t end = place_of(v);
        for (std::size_t place = place_of(*cycle.base); place != end; place = (place + 1) % cycle.word.size())
          letters.push_back(cycle.word[place]);
        if (letters.empty()) return false;
        Rational carried = errors[*cycle.base];
        for (std::size_t k = 0; k < letters.size(); ++k) carried *= growth();
        errors.push_back(carried + step_error(*cycle.base, letters, v));
      }
      error_ = std::max(error_, errors.back());
    }
    return std::all_of(cycles_.begin(), cycles_.end(), [](const Cycle& cycle) { return cycle.base.has_value(); });
  }

  /// The norm of (rational base root - an exact eigenvector of the product that starts at its place), if its eigenvalue
  /// is simple and of largest modulus.
  std::optional<Rational> eigenvector_error(Cycle& cycle) {
    const RationalMatrix product = product_from(cycle, place_of(*cycle.base));
    const std::size_t n = product.rows();
    const RationalComplex v = vertex(*cycle.base);
    AcbMatrix matrix(n, n), approximate(n, 1), enclosure(n, 1), subspace(1, 1);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        acb_set_fmpq(matrix.entry(i, j), flint::Quotient(product(i, j)).get(), precision);
      arb_set_fmpq(acb_realref(approximate.entry(i, 0)), flint::Quotient(v.x[i]).get(), precision);
      if (!v.y.empty()) arb_set_fmpq(acb_imagref(approximate.entry(i, 0)), flint::Quotient(v.y[i]).get(), precision);
    }
    acb_mat_get_mid(approximate.get(), approximate.get());
    // Rayleigh quotient as the approximate eigenvalue.
    RationalVector image_x = product * v.x, image_y = v.y.empty() ? RationalVector{} : product * v.y;
    Rational square = 0, re = 0, im = 0;
    for (std::size_t i = 0; i < n; ++i) {
      square += v.x[i] * v.x[i];
      re += v.x[i] * image_x[i];
      if (v.y.empty()) continue;
      square += v.y[i] * v.y[i];
      re += v.y[i] * image_y[i];
      im += v.x[i] * image_y[i] - v.y[i] * image_x[i];
    }
    if (square == 0) return std::nullopt;
    acb_t eigenvalue, start;
    acb_init(eigenvalue);
    acb_init(start);
    arb_set_fmpq(acb_realref(start), flint::Quotient(re / square).get(), precision);
    arb_set_fmpq(acb_imagref(start), flint::Quotient(im / square).get(), precision);
    acb_get_mid(start, start);
    acb_mat_eig_enclosure_rump(eigenvalue, subspace.get(), enclosure.get(), matrix.get(), start, approximate.get(),
                               precision);
    const bool found = acb_is_finite(eigenvalue) &&
                       is_simple_and_leading(characteristic_polynomial(product), eigenvalue);
    if (found) {
      find_eigenspace(cycle, product, eigenvalue);
      Ball modulus;
      acb_abs(modulus.get(), eigenvalue, precision);
      const Enclosure enclosed = modulus.enclosure(256);
      if (enclosed.lower && *enclosed.lower > 0)
        lower_ = std::min(lower_, *root_enclosure(*enclosed.lower, static_cast<int>(cycle.word.size())).lower);
    }
    acb_clear(eigenvalue);
    acb_clear(start);
    if (!found) return std::nullopt;
    Rational sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Rational d = distance(enclosure.entry(i, 0), v.x[i], v.y.empty() ? Rational(0) : v.y[i]);
      if (d < 0) return std::nullopt;
      sum += d;
    }
    return sum * polytope_.unit_norm;
  }

  /// The rational space that the base eigenvector and its algebraic conjugates span: the kernel of f(product), where f
  /// is the irreducible factor of the characteristic polynomial that vanishes at the eigenvalue. Whatever rational
  /// linear equations hold on that space hold for the eigenvector.
  void find_eigenspace(Cycle& cycle, const RationalMatrix& product, const acb_t eigenvalue) {
    flint::IntegerPolynomial characteristic(characteristic_polynomial(product));
    fmpz_poly_factor_t factors;
    fmpz_poly_factor_init(factors);
    fmpz_poly_factor(factors, characteristic.get());
    acb_t value;
    acb_init(value);
    int candidates = 0;
    std::vector<Rational> factor;
    for (slong i = 0; i < factors->num; ++i) {
      arb_fmpz_poly_evaluate_acb(value, factors->p + i, eigenvalue, precision);
      if (!acb_contains_zero(value)) continue;
      ++candidates;
      factor.clear();
      for (slong k = 0; k < fmpz_poly_length(factors->p + i); ++k)
        factor.emplace_back(flint::to_integer((factors->p + i)->coeffs + k));
    }
    acb_clear(value);
    fmpz_poly_factor_clear(factors);
    if (candidates != 1) return;
    const std::size_t n = product.rows();
    RationalMatrix sum(n, n);
    for (auto c = factor.rbegin(); c != factor.rend(); ++c) {
      sum = sum * product;
      for (std::size_t i = 0; i < n; ++i) sum(i, i) += *c;
    }
    cycle.eigenspace = kernel(sum);
  }

  std::size_t root_of(std::size_t index) const {
    while (result_.vertices[index].parent >= 0) index = static_cast<std::size_t>(result_.vertices[index].parent);
    return index;
  }

  /// The letters that lead from the base root of its cycle to a true vertex.
  std::optional<std::vector<int>> path(std::size_t index) const {
    std::vector<int> letters;
    for (; result_.vertices[index].parent >= 0; index = static_cast<std::size_t>(result_.vertices[index].parent))
      letters.push_back(result_.vertices[index].letter);
    if (result_.vertices[index].cycle < 0) return std::nullopt;
    const Cycle& cycle = cycle_of(index);
    const std::size_t length = cycle.word.size();
    for (std::size_t k = place_of(index); k != place_of(*cycle.base); k = (k + length - 1) % length)
      letters.push_back(cycle.letter(k + length - 1));
    std::reverse(letters.begin(), letters.end());
    return letters;
  }

  RationalVector along(const std::vector<int>& letters, RationalVector v) const {
    for (int t : letters) v = matrix(t) * v;
    return v;
  }

  /// Turns of the cycle from its base on.
  RationalVector around(const Cycle& cycle, std::size_t turns, RationalVector v) const {
    for (std::size_t k = 0; k < turns * cycle.word.size(); ++k) v = matrix(cycle.letter(place_of(*cycle.base) + k)) * v;
    return v;
  }

  /// Whether image = +- radius * target follows from linear equations on the eigenspace. Both sides are brought to the
  /// same number of letters by turns of the cycle, which multiply the eigenvector by a number of modulus radius^length.
  bool follows_linearly(std::size_t source, int image_letter, std::size_t target, bool flipped) const {
    auto from = path(source);
    const auto to = path(target);
    if (!from || !to || result_.vertices[root_of(source)].cycle != result_.vertices[root_of(target)].cycle)
      return false;
    const Cycle& cycle = cycle_of(root_of(source));
    from->push_back(image_letter);
    const std::size_t steps = from->size(), other = to->size(), length = cycle.word.size();
    if (cycle.eigenspace.empty() || steps % length != other % length) return false;
    const std::size_t more = (std::max(steps, other) - std::min(steps, other)) / length;
    bool same = true, opposite = true;
    for (const RationalVector& v : cycle.eigenspace) {
      const RationalVector left = along(*from, around(cycle, steps < other ? more : 0, v));
      RationalVector right = along(*to, around(cycle, steps > other ? more : 0, v));
      if (flipped) std::reverse(right.begin(), right.end());
      for (std::size_t i = 0; i < left.size(); ++i) {
        same = same && left[i] == right[i];
        opposite = opposite && left[i] == -right[i];
      }
    }
    return same || opposite;
  }

  /// How a true vertex arises: a place of a cycle, then letters that leave it. The letters that follow the word only
  /// move the place, as the root there is the image of the one before.
  struct History {
    const Cycle* cycle;
    std::size_t place;
    std::vector<int> letters;
    bool operator==(const History&) const = default;
  };

  std::optional<History> history(std::size_t index) const {
    std::vector<int> letters;
    while (result_.vertices[index].parent >= 0) {
      letters.push_back(result_.vertices[index].letter);
      index = static_cast<std::size_t>(result_.vertices[index].parent);
    }
    if (result_.vertices[index].cycle < 0) return std::nullopt;
    std::reverse(letters.begin(), letters.end());
    return normalised({&cycle_of(index), place_of(index), letters});
  }

  static History normalised(History h) {
    std::size_t used = 0;
    while (used < h.letters.size() && h.letters[used] == h.cycle->letter(h.place)) {
      h.place = (h.place + 1) % h.cycle->word.size();
      ++used;
    }
    h.letters.erase(h.letters.begin(), h.letters.begin() + static_cast<std::ptrdiff_t>(used));
    return h;
  }

  /// Whether the true image is radius * (a number of modulus 1) * (the true vertex, mirrored or conjugated as said).
  bool is_same_vertex(const ImageProof& image) const {
    const auto source = static_cast<std::size_t>(image.vertex),
               target = static_cast<std::size_t>(image.terms.front().vertex);
    const Vertex& aim = result_.vertices[target];
    const bool plain = !image.terms.front().flipped && !image.terms.front().conjugated;
    if (plain && aim.parent == image.vertex && aim.letter == image.letter) return true;
    if (follows_from_extra_vertex(source, image.letter, target, image.terms.front().flipped)) return true;
    if (image.terms.front().conjugated) return false;
    if (follows_from_cycle(source, image.letter, target, plain)) return true;
    return follows_linearly(source, image.letter, target, !plain);
  }

  /// The extra vertex that a true vertex stems from, and the letters in between.
  std::optional<std::pair<std::size_t, std::vector<int>>> extra_origin(std::size_t index) const {
    std::vector<int> letters;
    for (; result_.vertices[index].parent >= 0; index = static_cast<std::size_t>(result_.vertices[index].parent))
      letters.push_back(result_.vertices[index].letter);
    if (result_.vertices[index].cycle >= 0) return std::nullopt;
    std::reverse(letters.begin(), letters.end());
    return std::pair(index, letters);
  }

  /// Whether image = +- radius * target because the rational extra vertices behind both are led to the same point, up
  /// to its sign, by equally many letters. Real extra vertices only, for which conjugation changes nothing.
  bool follows_from_extra_vertex(std::size_t source, int image_letter, std::size_t target, bool flipped) const {
    auto from = extra_origin(source);
    const auto to = extra_origin(target);
    if (!from || !to || from->second.size() + 1 != to->second.size()) return false;
    from->second.push_back(image_letter);
    RationalComplex left = vertex(from->first), right = vertex(to->first);
    for (const RationalVector* y : {&left.y, &right.y})
      if (std::any_of(y->begin(), y->end(), [](const Rational& c) { return c != 0; })) return false;
    left.x = along(from->second, left.x);
    right.x = along(to->second, right.x);
    if (flipped) std::reverse(right.x.begin(), right.x.end());
    bool same = true, opposite = true;
    for (std::size_t i = 0; i < left.x.size(); ++i) {
      same = same && left.x[i] == right.x[i];
      opposite = opposite && left.x[i] == -right.x[i];
    }
    return same || opposite;
  }

  bool follows_from_cycle(std::size_t source, int image_letter, std::size_t target, bool plain) const {
    auto from = history(source);
    auto to = history(target);
    if (!from || !to) return false;
    from->letters.push_back(image_letter);
    const History moved = normalised(*from);
    if (plain) return moved == *to;
    const std::optional<std::size_t> shift = to->cycle->mirror_shift;
    if (!shift) return false;
    // The mirror image of the eigenvector at a place is, up to a number of modulus 1, the one a shift further on.
    to->place = (to->place + *shift) % to->cycle->word.size();
    for (int& t : to->letters) t = static_cast<int>(count_) - 1 - t;
    return moved == normalised(*to);
  }

  const SearchResult& result_;
  const CertifiedPolytope& polytope_;
  Rational lower_;  // a lower bound for the radius of the product, by the very eigenvalue whose vector is used
  std::size_t count_;
  std::vector<RationalMatrix> matrices_;
  std::vector<Cycle> cycles_;
  Rational error_ = 0;
};

}  // namespace

Decision product_attains_radius(const std::vector<RationalMatrix>& matrices, const SearchResult& result,
                                const CertifiedPolytope& polytope, const Rational& lower) {
  return Proof(matrices, result, polytope, lower).run();
}

}  // namespace subcert
