#include "attains.hpp"

#include <subcert/analysis/regularity/polytope_proof/candidate.hpp>
#include "cost.hpp"

#include <subcert/analysis/symbol/ball_matrix.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <algorithm>

namespace subcert::radius {
namespace {

constexpr slong precision = 320;
constexpr const char* no_time = "no time was left to compare the images with the vertices";

using RationalVector = std::vector<Rational>;

/// |x|_1, real and imaginary parts apart.
Rational one_norm(const ComplexVector& v) {
  Rational sum = 0;
  for (const RationalComplex& c : v) sum += abs(c.re) + abs(c.im);
  return sum;
}

/// An upper bound for |ball - value|, real and imaginary parts apart; nothing where it is infinite.
std::optional<Rational> distance(const ComplexBall& ball, const RationalComplex& value) {
  const ComplexBall difference = ball - ball_around(value, precision);
  const Enclosure re = abs(difference.real()).enclosure(256), im = abs(imaginary_part(difference)).enclosure(256);
  if (!re.upper || !im.upper) return std::nullopt;
  return *re.upper + *im.upper;
}

/// Whether the ball holds exactly one zero of p, a simple one, and all others but its conjugate are smaller in modulus.
bool is_simple_and_leading(const LaurentPolynomial& p, const ComplexBall& eigenvalue) {
  const LaurentPolynomial q = p.shifted(-p.lowest());  // the zeros at 0 do not matter
  const LaurentPolynomial repeated = gcd(q, q.derivative()), simple = *q.exact_quotient(repeated);
  if (simple.length() < 2) return false;
  const ComplexBall conjugate = conj(eigenvalue);
  const Ball modulus = abs(eigenvalue);
  int held = 0;
  bool leading = true;
  for (const ComplexBall& root : complex_roots(simple, precision)) {
    if (overlap(root, eigenvalue))
      ++held;
    else if (!overlap(root, conjugate))
      leading = leading && abs(root).is_less(modulus);
  }
  return leading && held == 1 && !contains_zero(value_at(repeated, eigenvalue));
}

RationalVector negated(RationalVector v) {
  for (Rational& c : v) c = -c;
  return v;
}

class Proof {
 public:
  Proof(const MatrixFamily& family, const PolytopeCandidate& candidate, const PolytopeProof& polytope,
        const Rational& lower, const Deadline& deadline)
      : candidate_(candidate), polytope_(polytope), lower_(lower), deadline_(deadline) {
    for (const RationalMatrix& m : family) matrices_.push_back(polytope.transposed ? transposed(m) : m);
    for (std::size_t k = 0; k < candidate.maximizing; ++k) cycles_.push_back({candidate.products[k].cycle, {}, {}, {}});
  }

  Decision run() {
    const auto unknown = [](const char* reason) { return Decision{Truth::unknown, reason}; };
    if (!candidate_.closed) return unknown("the polytope did not close");
    if (polytope_.kind == PolytopeKind::nonnegative) return unknown("polytopes of cones are only enclosed");
    for (Cycle& cycle : cycles_)
      for (const FamilySymmetry& element : polytope_.group) cycle.shifts.push_back(shift_of(cycle.word, element));
    if (!bound_vertex_errors())
      return unknown(deadline_.expired() ? no_time
                                         : "a leading eigenvalue is not simple, or its eigenvector was not isolated");
    // kappa: norm by the true polytope / norm by the rational one.
    if (error_ >= 1) return unknown("the vertices are not known well enough");
    const Rational kappa = 1 / (1 - error_);
    for (std::size_t i = 0; i < candidate_.images.size(); ++i) {
      const PolytopeCandidate::Image& image = candidate_.images[i];
      if (deadline_.expired()) return unknown(no_time);
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
    /// For each element of the group: the image of the word is the word shifted by so much.
    std::vector<std::optional<std::size_t>> shifts;
    /// The root from which all others come, and the vertex it is.
    std::optional<std::size_t> base;
    /// See find_eigenspace.
    std::vector<RationalVector> eigenspace;

    int letter(std::size_t place) const { return word[place % word.size()]; }
  };

  const RationalMatrix& matrix(int letter) const { return matrices_[static_cast<std::size_t>(letter)]; }

  std::size_t place_of(std::size_t vertex) const { return static_cast<std::size_t>(candidate_.vertices[vertex].place); }
  const Cycle& cycle_of(std::size_t vertex) const {
    return cycles_[static_cast<std::size_t>(candidate_.vertices[vertex].cycle)];
  }

  /// The product that starts at this place of the word.
  RationalMatrix product_from(const Cycle& cycle, std::size_t place) const {
    RationalMatrix product = matrix(cycle.letter(place));
    for (std::size_t k = 1; k < cycle.word.size(); ++k) product = matrix(cycle.letter(place + k)) * product;
    return product;
  }

  static int image_of(int letter, const FamilySymmetry& element) {
    return static_cast<int>(element.letters[static_cast<std::size_t>(letter)]);
  }

  static std::optional<std::size_t> shift_of(const std::vector<int>& word, const FamilySymmetry& element) {
    for (std::size_t shift = 0; shift < word.size(); ++shift) {
      bool equal = true;
      for (std::size_t k = 0; k < word.size() && equal; ++k)
        equal = image_of(word[k], element) == word[(k + shift) % word.size()];
      if (equal) return shift;
    }
    return std::nullopt;
  }

  ComplexVector vertex(std::size_t index) const {
    const Integer one = Integer(1) << polytope_.vertex_bits;
    ComplexVector result;
    for (std::size_t i = 0; i < polytope_.vertices[index].size(); ++i)
      result.push_back({Rational(polytope_.vertices[index][i], one),
                        polytope_.imaginary.empty() ? Rational(0) : Rational(polytope_.imaginary[index][i], one)});
    return result;
  }

  /// The norm of M ... M source / radius^steps - (+-) target, by the rational polytope. Domain: steps >= 1.
  Rational step_error(std::size_t source, const std::vector<int>& letters, std::size_t target) const {
    ComplexVector moved = vertex(source);
    const ComplexVector goal = vertex(target);
    Enclosure scale = Enclosure::exactly(1);
    for (int t : letters) {
      moved = matrix(t) * moved;
      scale = {*scale.lower * lower_, *scale.upper * polytope_.bound};
    }
    std::optional<Rational> best;
    for (int sign : {1, -1}) {
      const Rational factor = sign * *scale.lower;
      Rational size = 0;
      for (std::size_t i = 0; i < goal.size(); ++i) {
        size += abs(moved[i].re - factor * goal[i].re);
        if (!polytope_.imaginary.empty()) size += abs(moved[i].im - factor * goal[i].im);
      }
      if (!best || size < *best) best = size;
    }
    return (*best + (*scale.upper - *scale.lower) * one_norm(goal)) / *scale.lower * polytope_.unit_norm;
  }

  /// error_ bounds, over all vertices, the norm of (rational vertex - true vertex).
  bool bound_vertex_errors() {
    std::vector<Rational> errors;
    const auto growth = [&] { return polytope_.bound / lower_; };  // of the norm of an error in one step
    for (std::size_t v = 0; v < candidate_.vertices.size(); ++v) {
      if (deadline_.expired()) return false;
      const PolytopeCandidate::Vertex& origin = candidate_.vertices[v];
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
    const ComplexVector v = vertex(*cycle.base);
    if (one_norm(v) == 0) return std::nullopt;
    const auto pair = enclose_eigenpair(product, v, precision);
    const auto characteristic = characteristic_polynomial(product, deadline_);
    if (!pair || !characteristic || !has_time_for_roots(*characteristic, deadline_) ||
        !is_simple_and_leading(*characteristic, pair->value))
      return std::nullopt;
    find_eigenspace(cycle, product, *characteristic, pair->value);
    const Enclosure modulus = abs(pair->value).enclosure(256);
    if (modulus.lower && *modulus.lower > 0)
      lower_ = std::min(lower_, *root_enclosure(*modulus.lower, static_cast<int>(cycle.word.size())).lower);
    Rational sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const auto d = distance(pair->vector[i], v[i]);
      if (!d) return std::nullopt;
      sum += *d;
    }
    return sum * polytope_.unit_norm;
  }

  /// The rational space that the base eigenvector and its algebraic conjugates span: the kernel of f(product), where f
  /// is the irreducible factor of the characteristic polynomial that vanishes at the eigenvalue. Whatever rational
  /// linear equations hold on that space hold for the eigenvector.
  static void find_eigenspace(Cycle& cycle, const RationalMatrix& product, const LaurentPolynomial& characteristic,
                              const ComplexBall& eigenvalue) {
    std::vector<LaurentPolynomial> vanishing;
    for (const PolynomialFactor& factor : irreducible_factors(characteristic))
      if (factor.polynomial.lowest() == 0 && contains_zero(value_at(factor.polynomial, eigenvalue)))
        vanishing.push_back(factor.polynomial);
    if (vanishing.size() == 1) cycle.eigenspace = kernel(value_at(vanishing.front(), product));
  }

  std::size_t root_of(std::size_t index) const {
    while (candidate_.vertices[index].parent >= 0) index = static_cast<std::size_t>(candidate_.vertices[index].parent);
    return index;
  }

  /// The letters that lead from the base root of its cycle to a true vertex.
  std::optional<std::vector<int>> path(std::size_t index) const {
    std::vector<int> letters;
    for (; candidate_.vertices[index].parent >= 0; index = static_cast<std::size_t>(candidate_.vertices[index].parent))
      letters.push_back(candidate_.vertices[index].letter);
    if (candidate_.vertices[index].cycle < 0) return std::nullopt;
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
  bool follows_linearly(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    auto from = path(source);
    const auto to = path(target);
    if (!from || !to || candidate_.vertices[root_of(source)].cycle != candidate_.vertices[root_of(target)].cycle)
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
      right = polytope_.group[element].map(right);
      same = same && left == right;
      opposite = opposite && left == negated(right);
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
    while (candidate_.vertices[index].parent >= 0) {
      letters.push_back(candidate_.vertices[index].letter);
      index = static_cast<std::size_t>(candidate_.vertices[index].parent);
    }
    if (candidate_.vertices[index].cycle < 0) return std::nullopt;
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

  /// Whether the true image is radius * (a number of modulus 1) * (the true vertex, moved by the element or conjugated
  /// as said).
  bool is_same_vertex(const PolytopeCandidate::Image& image) const {
    const auto source = static_cast<std::size_t>(image.vertex),
               target = static_cast<std::size_t>(image.terms.front().vertex);
    const PolytopeCandidate::Vertex& aim = candidate_.vertices[target];
    const std::size_t element = image.terms.front().element;
    const bool conjugated = image.terms.front().conjugated;
    if (element == 0 && !conjugated && aim.parent == image.vertex && aim.letter == image.letter) return true;
    if (follows_from_extra_vertex(source, image.letter, target, element)) return true;
    if (conjugated) return false;
    return follows_from_cycle(source, image.letter, target, element) ||
           follows_linearly(source, image.letter, target, element);
  }

  /// The extra vertex that a true vertex stems from, and the letters in between.
  std::optional<std::pair<std::size_t, std::vector<int>>> extra_origin(std::size_t index) const {
    std::vector<int> letters;
    for (; candidate_.vertices[index].parent >= 0; index = static_cast<std::size_t>(candidate_.vertices[index].parent))
      letters.push_back(candidate_.vertices[index].letter);
    if (candidate_.vertices[index].cycle >= 0) return std::nullopt;
    std::reverse(letters.begin(), letters.end());
    return std::pair(index, letters);
  }

  /// Whether image = +- radius * target because the rational extra vertices behind both are led to the same point, up
  /// to its sign, by equally many letters. Real extra vertices only, for which conjugation changes nothing.
  bool follows_from_extra_vertex(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    auto from = extra_origin(source);
    const auto to = extra_origin(target);
    if (!from || !to || from->second.size() + 1 != to->second.size()) return false;
    from->second.push_back(image_letter);
    RationalVector left, right;
    for (const auto& [origin, parts] : {std::pair(from->first, &left), std::pair(to->first, &right)})
      for (const RationalComplex& c : vertex(origin)) {
        if (c.im != 0) return false;
        parts->push_back(c.re);
      }
    left = along(from->second, left);
    right = along(to->second, right);
    right = polytope_.group[element].map(right);
    return left == right || left == negated(right);
  }

  bool follows_from_cycle(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    auto from = history(source);
    auto to = history(target);
    if (!from || !to) return false;
    from->letters.push_back(image_letter);
    const History moved = normalised(*from);
    const std::optional<std::size_t> shift = to->cycle->shifts[element];
    if (!shift) return false;
    // The image of the eigenvector at a place is, up to a number of modulus 1, the one a shift further on.
    to->place = (to->place + *shift) % to->cycle->word.size();
    for (int& t : to->letters) t = image_of(t, polytope_.group[element]);
    return moved == normalised(*to);
  }

  const PolytopeCandidate& candidate_;
  const PolytopeProof& polytope_;
  Rational lower_;  // a lower bound for the radius of the product, by the very eigenvalue whose vector is used
  Deadline deadline_;
  std::vector<RationalMatrix> matrices_;
  std::vector<Cycle> cycles_;
  Rational error_ = 0;
};

}  // namespace

Decision product_attains_radius(const MatrixFamily& family, const PolytopeCandidate& candidate,
                                const PolytopeProof& polytope, const Rational& lower, const Deadline& deadline) {
  return Proof(family, candidate, polytope, lower, deadline).run();
}

}  // namespace subcert::radius
