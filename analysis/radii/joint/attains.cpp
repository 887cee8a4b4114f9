#include "attains.hpp"

#include "cost.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>
#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>

#include <algorithm>
#include <map>

namespace subcert::radius {
namespace {

constexpr slong least_precision = 320;  // bits of balls
constexpr slong attained_bits = 240;
constexpr const char* no_time = "no time was left to compare the images with the vertices";

using RationalVector = std::vector<Rational>;

/// An upper bound for |ball - value|, real and imaginary parts apart; nothing where it is infinite.
std::optional<Rational> distance(const ComplexBall& ball, const RationalComplex& value) {
  const ComplexBall difference = ball - ball_around(value, ball.bits());
  const Enclosure re = abs(difference.real()).enclosure(256), im = abs(imaginary_part(difference)).enclosure(256);
  if (!re.upper || !im.upper) return std::nullopt;
  return *re.upper + *im.upper;
}

/// p(matrix) v. Domain: lowest exponent 0 or more.
std::optional<ComplexVector> value_on(const LaurentPolynomial& p, const RationalMatrix& matrix, const ComplexVector& v,
                                      const Deadline& deadline) {
  ComplexVector sum(v.size(), RationalComplex{0, 0});
  for (long k = p.highest(); k >= 0; --k) {
    if (deadline.expired()) return std::nullopt;
    sum = matrix * sum;
    for (std::size_t i = 0; i < v.size(); ++i) {
      sum[i].re += p.coefficient(k) * v[i].re;
      sum[i].im += p.coefficient(k) * v[i].im;
    }
  }
  return sum;
}

RationalVector negated(RationalVector v) {
  for (Rational& c : v) c = -c;
  return v;
}

class Proof {
 public:
  Proof(const MatrixFamily& family, const PolytopeCandidate& candidate, const PolytopeProof& polytope,
        const Rational& lower, const Deadline& deadline)
      : candidate_(candidate), polytope_(polytope), lower_(lower), radius_{lower, polytope.bound}, deadline_(deadline) {
    for (const RationalMatrix& m : family) matrices_.push_back(polytope.transposed ? transposed(m) : m);
  }

  Decision run() {
    const auto unknown = [](const char* reason) { return Decision{Truth::unknown, reason}; };
    if (!candidate_.closed) return unknown("the polytope did not close");
    if (!bound_vertex_errors())
      return unknown(deadline_.expired() ? no_time : "a root of the polytope is near no leading eigenvector");
    // kappa: norm by the true polytope / norm by the rational one.
    if (error_ >= 1) return unknown("the vertices are not known well enough");
    const Rational kappa = 1 / (1 - error_);
    inside_.assign(candidate_.images.size(), false);
    for (std::size_t i = 0; i < candidate_.images.size(); ++i) {
      const PolytopeCandidate::Image& image = candidate_.images[i];
      if (deadline_.expired()) return unknown(no_time);
      if (image.identity && is_same_vertex(image)) continue;
      const Rational& moduli = polytope_.moduli[i];
      const Rational rest = polytope_.residuals[i] * polytope_.unit_norm + (polytope_.bound + moduli) * error_;
      if (moduli + kappa * rest >= lower_)
        return unknown(image.identity ? "an image coincides with a vertex for no known reason"
                                      : "an image lies too near to the boundary");
      inside_[i] = true;
    }
    return {Truth::yes, "every image is a vertex or lies inside, and the product attains the radius"};
  }

  const CycleFactors& factors() const { return factors_; }
  /// For each image, whether it was shown to lie inside, and not to be a vertex.
  const std::vector<bool>& inside() const { return inside_; }

 private:
  /// A product and one of its leading eigenvectors, of which the images along the word are roots of the polytope.
  struct Cycle {
    int product;
    std::vector<int> word;
    /// For each element of the group: the image of the word is the word shifted by so much.
    std::vector<std::optional<std::size_t>> shifts;
    std::size_t base;  ///< the vertex that is the first of these roots
    /// The rational space that the eigenvector and its algebraic conjugates span, with all others of these eigenvalues:
    /// the kernel of f(product), f irreducible. What rational linear equations hold there hold for the eigenvector.
    std::vector<RationalVector> eigenspace = {};
    bool simple = false;  ///< the eigenvalue

    int letter(std::size_t place) const { return word[place % word.size()]; }
  };

  const RationalMatrix& matrix(int letter) const { return matrices_[static_cast<std::size_t>(letter)]; }

  std::size_t place_of(std::size_t vertex) const { return static_cast<std::size_t>(candidate_.vertices[vertex].place); }
  /// Domain: a root that is no extra vertex.
  const Cycle& cycle_of(std::size_t vertex) const { return cycles_[cycle_of_root_.at(vertex)]; }

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

  /// The norm of M ... M source / radius^steps - (+-) target, by the rational polytope.
  Rational step_error(std::size_t source, const std::vector<int>& letters, std::size_t target) const {
    ComplexVector moved = polytope_.vertex(source);
    const ComplexVector goal = polytope_.vertex(target);
    Enclosure scale = Enclosure::exactly(1);
    for (int t : letters) {
      moved = matrix(t) * moved;
      scale = {*scale.lower * *radius_.lower, *scale.upper * *radius_.upper};
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
      } else if (const auto carried = error_along_cycle(v, errors)) {
        errors.push_back(*carried);
      } else {
        const auto error = start_cycle(v);
        if (!error) return false;
        errors.push_back(*error);
      }
      error_ = std::max(error_, errors.back());
    }
    return true;
  }

  /// The error of a root that is the image of the first root of a cycle; nothing where it is that of none.
  std::optional<Rational> error_along_cycle(std::size_t root, const std::vector<Rational>& errors) {
    const Rational near = power(Rational(10), -6);
    for (std::size_t k = 0; k < cycles_.size(); ++k) {
      const Cycle& cycle = cycles_[k];
      if (cycle.product != candidate_.vertices[root].cycle) continue;
      std::vector<int> letters;
      for (std::size_t place = place_of(cycle.base); place % cycle.word.size() != place_of(root); ++place)
        letters.push_back(cycle.letter(place));
      const Rational step = step_error(cycle.base, letters, root);
      if (step >= near * polytope_.unit_norm) continue;
      cycle_of_root_.emplace(root, k);
      Rational carried = errors[cycle.base];
      for (std::size_t t = 0; t < letters.size(); ++t) carried *= polytope_.bound / lower_;
      return carried + step;
    }
    return std::nullopt;
  }

  /// The norm of (rational root - an exact eigenvector of the product that starts at its place): the projection of the
  /// root to the eigenvectors of the eigenvalue. It has to be semisimple. That it leads need not be shown: the polytope
  /// proves that no radius is above that of its largest cycle.
  std::optional<Rational> start_cycle(std::size_t root) {
    const int index = candidate_.vertices[root].cycle;
    Cycle cycle{index, candidate_.products[static_cast<std::size_t>(index)].word, {}, root};
    for (const FamilySymmetry& element : polytope_.group) cycle.shifts.push_back(shift_of(cycle.word, element));
    const RationalMatrix product = product_from(cycle, place_of(root));
    const ComplexVector v = polytope_.vertex(root);
    if (one_norm(v) == 0) return std::nullopt;
    // The powers of the product lose so many digits to each other in the projection.
    const slong precision = least_precision +
                            static_cast<slong>(v.size()) * std::max(0L, binary_exponent(product).value_or(0));
    auto own = leading_factor(product, rayleigh_quotient(v, product * v), precision, deadline_);
    if (!own) return std::nullopt;
    const auto& [f, others, multiplicity, eigenvalue, zeros] = *own;
    cycle.simple = multiplicity == 1;
    if (polytope_.kind == PolytopeKind::nonnegative && !is_perron_root(eigenvalue, zeros)) return std::nullopt;
    const std::optional<RationalMatrix> on_product = value_at(f, product, deadline_);
    if (!on_product || !has_time_for_elimination(*on_product, deadline_)) return std::nullopt;
    cycle.eigenspace = kernel(*on_product);
    if (static_cast<long>(cycle.eigenspace.size()) != f.highest() * multiplicity) return std::nullopt;
    const Enclosure modulus = abs(eigenvalue).enclosure(256);
    if (!modulus.lower || *modulus.lower <= 0) return std::nullopt;
    const int length = static_cast<int>(cycle.word.size());
    const Enclosure radius{root_enclosure(*modulus.lower, length, attained_bits).lower,
                           root_enclosure(*modulus.upper, length, attained_bits).upper};
    lower_ = std::min(lower_, *radius.lower);
    if (cycles_.empty())
      radius_ = radius;
    else
      radius_ = {std::min(*radius_.lower, *radius.lower), std::max(*radius_.upper, *radius.upper)};
    const auto error = distance_to_eigenvector(product, v, f, others, eigenvalue);
    if (!error) return std::nullopt;
    cycle_of_root_.emplace(root, cycles_.size());
    cycles_.push_back(std::move(cycle));
    factors_.emplace(root, std::move(*own));
    return *error * polytope_.unit_norm;
  }

  /// Whether the zero is real and no other real one is as large: then it is the spectral radius of a non-negative
  /// matrix, and the projection to its eigenvectors keeps vectors non-negative (docs/joint-spectral-radius.md).
  static bool is_perron_root(const ComplexBall& zero, const std::vector<ComplexBall>& zeros) {
    const auto is_real = [](const ComplexBall& z) {
      const Enclosure im = imaginary_part(z).enclosure(256);
      return im.is_exact() && *im.lower == 0;
    };
    const Ball nothing(0L, zero.bits());
    int equal = 0;  // the zero itself
    for (const ComplexBall& other : zeros) {
      if (!nothing.is_less(abs(zero - other)))
        ++equal;
      else if (is_real(other) && !other.real().is_less(zero.real()))
        return false;
    }
    return equal == 1 && is_real(zero) && nothing.is_less(zero.real());
  }

  /// |v - q(product) v / q(z)|_1 for q(x) = others(x) f(x) / (x - z). Domain: f(z) = 0, f others vanishes at the
  /// product.
  std::optional<Rational> distance_to_eigenvector(const RationalMatrix& product, const ComplexVector& v,
                                                  const LaurentPolynomial& f, const LaurentPolynomial& others,
                                                  const ComplexBall& z) const {
    const slong precision = z.bits();
    std::vector<ComplexBall> projection(v.size(), ball_around({0, 0}, precision));
    std::optional<ComplexVector> moved = value_on(others, product, v, deadline_);
    if (!moved) return std::nullopt;
    // f(x) / (x - z) has the coefficients b_k = f_{k+1} + z b_{k+1}.
    std::vector<ComplexBall> coefficients{ball_around({f.coefficient(f.highest()), 0}, precision)};
    for (long k = f.highest() - 1; k >= 1; --k)
      coefficients.push_back(ball_around({f.coefficient(k), 0}, precision) + z * coefficients.back());
    for (std::size_t k = coefficients.size(); k-- > 0; moved = product * *moved) {
      if (deadline_.expired()) return std::nullopt;
      for (std::size_t i = 0; i < v.size(); ++i) projection[i] += coefficients[k] * ball_around((*moved)[i], precision);
    }
    const ComplexBall value = value_at(others, z) * value_at(f.derivative(), z);
    Rational sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const auto d = distance(projection[i] / value, v[i]);
      if (!d) return std::nullopt;
      sum += *d;
    }
    return sum;
  }

  /// The root or extra vertex that a vertex stems from, and the letters in between.
  struct Descent {
    std::size_t first;
    std::vector<int> letters;
  };
  Descent descent(std::size_t index) const {
    std::vector<int> letters;
    for (; candidate_.vertices[index].parent >= 0; index = static_cast<std::size_t>(candidate_.vertices[index].parent))
      letters.push_back(candidate_.vertices[index].letter);
    std::reverse(letters.begin(), letters.end());
    return {index, std::move(letters)};
  }
  bool is_extra(std::size_t first) const { return candidate_.vertices[first].cycle < 0; }

  /// How a true vertex arises from a root.
  struct Origin {
    const Cycle* cycle;
    std::size_t place;         ///< of the root
    std::vector<int> letters;  ///< that lead from it to the vertex
    bool operator==(const Origin&) const = default;
  };
  std::optional<Origin> origin_of(std::size_t index) const {
    Descent from = descent(index);
    if (is_extra(from.first)) return std::nullopt;
    return Origin{&cycle_of(from.first), place_of(from.first), std::move(from.letters)};
  }

  /// The letters that lead from the base root of the cycle to that at a place.
  std::vector<int> turning_to(const Cycle& cycle, std::size_t place) const {
    std::vector<int> letters;
    for (std::size_t k = place_of(cycle.base); k % cycle.word.size() != place; ++k) letters.push_back(cycle.letter(k));
    return letters;
  }

  RationalVector along(const std::vector<int>& letters, RationalVector v) const {
    for (int t : letters) v = matrix(t) * v;
    return v;
  }

  /// Turns of the cycle from its base on.
  RationalVector around(const Cycle& cycle, std::size_t turns, RationalVector v) const {
    for (std::size_t k = 0; k < turns * cycle.word.size(); ++k) v = matrix(cycle.letter(place_of(cycle.base) + k)) * v;
    return v;
  }

  /// Vectors, as many as the eigenspace has, that are rational combinations of the true image and of radius * the true
  /// target with the same coefficients, up to one factor for all. Both sides are brought to the same number of letters
  /// by turns of the cycle, which multiply the eigenvector by a number of modulus radius^length.
  struct Sides {
    RationalVector left, right;
  };
  /// `other`: of the group; the root of the target is replaced by the one that this element takes it to.
  std::vector<Sides> sides(const Origin& from, const Origin& to, std::size_t element, std::size_t other) const {
    const Cycle& cycle = *from.cycle;
    const std::size_t length = cycle.word.size();
    const auto shift = other == 0 ? std::optional<std::size_t>(0) : cycle.shifts[other];
    if (to.cycle != from.cycle || !shift || (other > 0 && !cycle.simple)) return {};
    const std::vector<int> turning_from = turning_to(cycle, from.place),
                           turning_back = turning_to(cycle, (to.place + *shift) % length);
    const std::size_t left = turning_from.size() + from.letters.size(), right = turning_back.size() + to.letters.size();
    if (left % length != right % length) return {};
    const std::size_t more = (std::max(left, right) - std::min(left, right)) / length;
    const SparseMap back = polytope_.group[other].map.inverse();
    std::vector<Sides> result;
    for (const RationalVector& v : cycle.eigenspace)
      result.push_back({along(from.letters, along(turning_from, around(cycle, left < right ? more : 0, v))),
                        polytope_.group[element].map(
                            along(to.letters, back(along(turning_back, around(cycle, left > right ? more : 0, v)))))});
    return result;
  }

  /// By whichever element of the group brings both sides to the same number of letters.
  std::vector<Sides> sides(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    auto from = origin_of(source);
    const auto to = origin_of(target);
    if (!from || !to) return {};
    from->letters.push_back(image_letter);
    for (std::size_t other = 0; other < polytope_.group.size(); ++other)
      if (std::vector<Sides> result = sides(*from, *to, element, other); !result.empty()) return result;
    return {};
  }

  /// Whether image = +- radius * target follows from linear equations on the eigenspace.
  bool follows_linearly(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    const std::vector<Sides> all = sides(source, image_letter, target, element);
    const auto every = [&](auto holds) { return !all.empty() && std::all_of(all.begin(), all.end(), holds); };
    return every([](const Sides& s) { return s.left == s.right; }) ||
           every([](const Sides& s) { return s.left == negated(s.right); });
  }

  /// Cones: whether image <= radius * target, coordinate by coordinate: equal by linear equations, or clearly less.
  bool lies_below(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    const std::vector<Sides> all = sides(source, image_letter, target, element);
    const auto real_part = [](const ComplexVector& v) {
      RationalVector result;
      for (const RationalComplex& c : v) result.push_back(c.re);
      return result;
    };
    const RationalVector image = matrix(image_letter) * real_part(polytope_.vertex(source)),
                         goal = polytope_.group[element].map(real_part(polytope_.vertex(target)));
    // A norm of at most error_ says that no coordinate is larger than error_ times the largest of all vertices.
    const Rational off = error_ * Rational(largest_coordinate(), Integer(1) << polytope_.vertex_bits);
    for (std::size_t i = 0; i < image.size(); ++i) {
      if (!all.empty() && std::all_of(all.begin(), all.end(), [=](const Sides& s) { return s.left[i] == s.right[i]; }))
        continue;
      Rational row_sum = 0;
      for (std::size_t k = 0; k < image.size(); ++k) row_sum += matrix(image_letter)(i, k);
      if (!(image[i] + row_sum * off < lower_ * (goal[i] - off))) return false;
    }
    return true;
  }

  Integer largest_coordinate() const {
    Integer largest = 0;
    for (const auto& v : polytope_.vertices)
      for (const Integer& c : v) largest = std::max(largest, c);
    return largest;
  }

  /// The letters that follow the word only move the place, as the root there is the image of the one before.
  static Origin normalised(Origin h) {
    std::size_t used = 0;
    while (used < h.letters.size() && h.letters[used] == h.cycle->letter(h.place)) {
      h.place = (h.place + 1) % h.cycle->word.size();
      ++used;
    }
    h.letters.erase(h.letters.begin(), h.letters.begin() + static_cast<std::ptrdiff_t>(used));
    return h;
  }

  /// Whether the true image is radius * (a number of modulus 1) * (the true vertex, moved by the element or conjugated
  /// as said), or, in a cone, below it.
  bool is_same_vertex(const PolytopeCandidate::Image& image) const {
    const auto source = static_cast<std::size_t>(image.vertex),
               target = static_cast<std::size_t>(image.terms.front().vertex);
    const PolytopeCandidate::Vertex& aim = candidate_.vertices[target];
    const auto element = static_cast<std::size_t>(image.terms.front().element);
    const bool conjugated = image.terms.front().conjugated;
    if (element == 0 && !conjugated && aim.parent == image.vertex && aim.letter == image.letter) return true;
    if (follows_from_extra_vertex(source, image.letter, target, element)) return true;
    if (conjugated) return false;
    if (polytope_.kind == PolytopeKind::nonnegative && lies_below(source, image.letter, target, element)) return true;
    return follows_from_cycle(source, image.letter, target, element) ||
           follows_linearly(source, image.letter, target, element);
  }

  /// Whether image = +- radius * target because the rational extra vertices behind both are led to the same point, up
  /// to its sign, by equally many letters. Real extra vertices only, for which conjugation changes nothing.
  bool follows_from_extra_vertex(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    Descent from = descent(source);
    const Descent to = descent(target);
    if (!is_extra(from.first) || !is_extra(to.first) || from.letters.size() + 1 != to.letters.size()) return false;
    from.letters.push_back(image_letter);
    RationalVector left, right;
    for (const auto& [origin, parts] : {std::pair(from.first, &left), std::pair(to.first, &right)})
      for (const RationalComplex& c : polytope_.vertex(origin)) {
        if (c.im != 0) return false;
        parts->push_back(c.re);
      }
    left = along(from.letters, left);
    right = along(to.letters, right);
    right = polytope_.group[element].map(right);
    return left == right || left == negated(right);
  }

  bool follows_from_cycle(std::size_t source, int image_letter, std::size_t target, std::size_t element) const {
    auto from = origin_of(source), to = origin_of(target);
    if (!from || !to) return false;
    from->letters.push_back(image_letter);
    to = normalised(std::move(*to));
    const Origin moved = normalised(*from);
    const std::optional<std::size_t> shift = to->cycle->shifts[element];
    if (!shift || !to->cycle->simple) return false;
    // The image of the eigenvector at a place is, up to a number of modulus 1, the one a shift further on.
    to->place = (to->place + *shift) % to->cycle->word.size();
    for (int& t : to->letters) t = image_of(t, polytope_.group[element]);
    return moved == normalised(*to);
  }

  const PolytopeCandidate& candidate_;
  const PolytopeProof& polytope_;
  Rational lower_;    // a lower bound for the radius of the product, by the very eigenvalue whose vector is used
  Enclosure radius_;  // of the true vertices, each of which is an image over it; narrow once there is a cycle
  Deadline deadline_;
  std::vector<RationalMatrix> matrices_;
  std::vector<Cycle> cycles_;
  std::map<std::size_t, std::size_t> cycle_of_root_;
  CycleFactors factors_;
  std::vector<bool> inside_;
  Rational error_ = 0;
};

}  // namespace

Decision product_attains_radius(const MatrixFamily& family, const PolytopeCandidate& candidate, PolytopeProof& polytope,
                                const Rational& lower, const Deadline& deadline) {
  Proof proof(family, candidate, polytope, lower, deadline);
  Decision decision = proof.run();
  if (candidate.closed) find_cycles(family, candidate, polytope, proof.factors(), proof.inside(), deadline);
  return decision;
}

}  // namespace subcert::radius
