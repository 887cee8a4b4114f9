#include "exact_radius.hpp"

#include <subcert/analysis/regularity/radius/subspace.hpp>
#include <subcert/analysis/regularity/subradius/attained_subradius.hpp>
#include <subcert/analysis/symbol/balls.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

namespace subcert {
namespace {

constexpr slong root_bits = 1024;   // of the balls of zeros
constexpr int point_bits = 640;     // of a point near a zero
constexpr int radius_bits = 400;    // of the bounds of the radius
constexpr int most_decimals = 100;  // of the point that names a zero, less the zeros in front
constexpr std::size_t longest_cycle = 1000;

ComplexVector difference(const ComplexVector& a, const RationalComplex& factor, const ComplexVector& b) {
  ComplexVector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - factor * b[i]);
  return result;
}

bool is_near(const ComplexVector& v, const RationalComplex& factor, const ComplexVector& w) {
  return one_norm(difference(w, factor, v)) < power(Rational(10), -20) * one_norm(w);
}

RationalComplex value_at(const LaurentPolynomial& p, const RationalComplex& z) {
  RationalComplex value;
  for (long k = p.highest(); k >= 0; --k) value = value * z + RationalComplex{p.coefficient(k), 0};
  return value;
}

/// A zero of a polynomial: a point, how far from it the zero is at most, and a disc that holds no other zero.
struct Zero {
  LaurentPolynomial polynomial;
  RationalComplex point, centre;
  Rational error, within;

  /// Whether a zero of the polynomial in this ball may be the same.
  bool may_be(const ComplexBall& ball) const {
    return !Ball(within, root_bits).is_less(abs(ball - ball_around(centre, root_bits)));
  }
};

/// Whether the disc around the centre has at most one zero.
bool isolates(const LaurentPolynomial& p, const RationalComplex& centre, const Rational& within) {
  const Rational size = one_norm({centre}) + within;
  Rational change = 0;
  for (long k = p.highest(); k >= 2; --k) change = change * size + abs(p.coefficient(k)) * (k * (k - 1));
  return change * change * within * within < value_at(p.derivative(), centre).squared_modulus();
}

/// A point of the ball; real where the ball has real points.
std::optional<RationalComplex> point_of(const ComplexBall& ball) {
  const Enclosure re = ball.real().enclosure(root_bits), im = imaginary_part(ball).enclosure(root_bits);
  if (!re.is_bounded() || !im.is_bounded()) return std::nullopt;
  const auto middle = [](const Enclosure& e) { return rounded((*e.lower + *e.upper) / 2, point_bits, Rounding::down); };
  return RationalComplex{middle(re), im.contains(0) ? Rational(0) : middle(im)};
}

/// Of the digits before the decimal point: a large zero is named by about as many as others. Domain: size > 0.
int digits_left_out(const Rational& size) {
  constexpr long most_digits = 16, digits_of_ten_bits = 3;
  return static_cast<int>(std::max(0L, binary_exponent(size) * digits_of_ten_bits / 10 - most_digits));
}

/// The zero of an irreducible polynomial in the ball.
std::optional<Zero> zero_in(const ComplexBall& ball, const LaurentPolynomial& p) {
  const auto rational = zero_of_linear(p);
  const auto point = rational ? std::optional(RationalComplex{*rational, 0}) : point_of(ball);
  if (!point) return std::nullopt;
  Zero zero{p, *point, {}, 0, 0};
  const Rational steep = value_at(p.derivative(), zero.point).squared_modulus();
  if (steep == 0) return std::nullopt;
  const Rational squared = p.highest() * p.highest() * value_at(p, zero.point).squared_modulus() / steep;
  zero.error = squared == 0 ? Rational(0) : power(Rational(2), binary_exponent(squared) / 2 + 1);
  const Rational size = one_norm({zero.point});
  const int first_decimals = 3 + (size == 0 ? 0 : std::max(0, decimal_places(size) - 1) - digits_left_out(size));
  for (int decimals = first_decimals; decimals < first_decimals + most_decimals; ++decimals) {
    const Rational unit = power(Rational(10), decimals);
    const auto decimal = [&](const Rational& x) { return Rational(to_integer(x * unit, Rounding::nearest)) / unit; };
    zero.centre = {decimal(zero.point.re), decimal(zero.point.im)};
    zero.within = 1 / unit;
    const Rational rest = zero.within - zero.error;
    if (rest > 0 && (zero.point - zero.centre).squared_modulus() <= rest * rest &&
        isolates(p, zero.centre, zero.within))
      return zero;
  }
  return std::nullopt;
}

/// The irreducible factor that has the zero nearest to a point, and a ball that holds this zero.
struct NearestZero {
  PolynomialFactor factor;
  ComplexBall ball;
};

/// p(2^exponent z). Domain: lowest exponent 0 or more.
LaurentPolynomial stretched(const LaurentPolynomial& p, long exponent) {
  std::vector<Rational> coefficients;
  for (long k = 0; k <= p.highest(); ++k)
    coefficients.push_back(p.coefficient(k) * power(power(Rational(2), exponent), k));
  return LaurentPolynomial(coefficients, 0);
}

std::optional<NearestZero> nearest_zero(const LaurentPolynomial& p, const RationalComplex& point) {
  const ComplexBall near = ball_around(point, root_bits);
  // Zeros that are about as large as 1 are found fast.
  const Rational size = one_norm({point});
  const long exponent = size == 0 ? 0 : binary_exponent(size);
  std::optional<NearestZero> best;
  for (const PolynomialFactor& factor : irreducible_factors(p)) {
    if (factor.polynomial.lowest() != 0) continue;
    for (const ComplexBall& stretched_zero : complex_roots(stretched(factor.polynomial, exponent), root_bits)) {
      const ComplexBall zero = stretched_zero.scaled(exponent);
      if (!best || abs(zero - near).is_less(abs(best->ball - near))) best = {factor, zero};
    }
  }
  return best;
}

std::string coefficients_text(const LaurentPolynomial& p) {
  std::string text;
  for (long k = 0; k <= p.highest(); ++k) text += (k == 0 ? "" : ",") + to_text(p.coefficient(k));
  return text;
}

/// |z|^(1/length)
ExactRadiusLines lines_of(const Zero& z, std::size_t length_of_cycles, const CycleLines& cycles) {
  const Enclosure modulus = root_enclosure(z.point.squared_modulus(), 2, radius_bits);
  const int length = static_cast<int>(length_of_cycles);
  const auto exact = z.error == 0 ? exact_root(z.point.squared_modulus(), 2 * length_of_cycles) : std::nullopt;
  const auto bound = [&](const Rational& power, std::optional<Rational> Enclosure::*end, Rounding rounding) {
    return exact ? *exact : rounded(*(root_enclosure(power, length, radius_bits).*end), radius_bits, rounding);
  };
  const Rational low = bound(*modulus.lower - z.error, &Enclosure::lower, Rounding::down),
                 high = bound(*modulus.upper + z.error, &Enclosure::upper, Rounding::up);
  return {fmt::format("|[{}]@{},{},{}|^1/{}", coefficients_text(z.polynomial), to_text(z.centre.re),
                      to_text(z.centre.im), to_text(z.within), length),
          fmt::format("root {} {} {} {} {}\n", to_text(z.point.re), to_text(z.point.im), to_text(z.error), to_text(low),
                      to_text(high)),
          cycles, low};
}

/// The zero that cycles have in common, and their seeds.
class CommonZero {
 public:
  /// A vector on which the polynomial p of the zero near an eigenvalue vanishes, so that an eigenvector of the zero is
  /// a sum of its images. The zero has to be that of the other cycles. Of several eigenvectors the one near `start` is
  /// meant; where p divides the minimal polynomial more than once it does not vanish.
  std::optional<std::vector<Integer>> seed_of(const RationalMatrix& product, const RationalComplex& eigenvalue,
                                              std::size_t length, const ComplexVector& start) {
    const LaurentPolynomial characteristic = characteristic_polynomial(product);
    const auto nearest = nearest_zero(characteristic, eigenvalue);
    if (!nearest || (nearest->factor.multiplicity != 1 && start.empty())) return std::nullopt;
    const LaurentPolynomial& p = nearest->factor.polynomial;
    if (!zero_) {
      zero_ = zero_in(nearest->ball, p);
      length_ = length;
    }
    if (!zero_ || length_ != length || zero_->polynomial != p || !zero_->may_be(nearest->ball)) return std::nullopt;
    const LaurentPolynomial others = *characteristic.exact_quotient(p.pow(nearest->factor.multiplicity));
    // The value of this polynomial at the product, times a vector.
    const auto image_of = [&](const std::vector<Rational>& vector) {
      std::vector<Rational> seed(product.rows());
      for (long k = others.highest(); k >= 0; --k) {
        seed = product * seed;
        for (std::size_t i = 0; i < seed.size(); ++i) seed[i] += others.coefficient(k) * vector[i];
      }
      return seed;
    };
    const auto is_zero = [](const std::vector<Rational>& v) {
      return std::all_of(v.begin(), v.end(), [](const Rational& x) { return x == 0; });
    };
    std::vector<Rational> vector(product.rows()), seed;
    if (nearest->factor.multiplicity > 1) {
      // Its imaginary part is one of conjugate eigenvectors, to which the sum of images gives no weight.
      std::transform(start.begin(), start.end(), vector.begin(), [](const RationalComplex& x) { return x.re; });
      seed = image_of(vector);
    } else {
      for (std::size_t i = 0; i < vector.size() && (seed.empty() || is_zero(seed)); ++i) {
        vector.assign(vector.size(), 0);
        vector[i] = 1;
        seed = image_of(vector);
      }
    }
    return is_zero(seed) ? std::nullopt : std::optional(radius::primitive(seed));
  }

  bool is_known() const { return zero_.has_value(); }
  /// Domain: a known zero; the lines from `cycle` on.
  ExactRadiusLines lines(const CycleLines& cycles) const { return lines_of(*zero_, length_, cycles); }

 private:
  std::optional<Zero> zero_;
  std::size_t length_ = 0;
};

class Writer {
 public:
  Writer(const MatrixFamily& family, const PolytopeProof& polytope, bool negation)
      : polytope_(polytope), origins_(polytope.origins), words_(words_of(polytope, negation)) {
    for (const RationalMatrix& m : family) matrices_.push_back(polytope.transposed ? transposed(m) : m);
    for (const FamilySymmetry& element : polytope.group) maps_.push_back(element.map.matrix());
  }

  std::optional<ExactRadiusLines> run() {
    if (origins_.vertices.size() != polytope_.vertices.size()) return std::nullopt;
    std::string cycles, origins, same;
    for (std::size_t v = 0; v < origins_.vertices.size(); ++v) {
      const PolytopeOrigins::Vertex& origin = origins_.vertices[v];
      std::optional<Image> parent;
      if (origin.parent >= 0)
        parent = {static_cast<std::size_t>(origin.parent), static_cast<std::size_t>(origin.letter)};
      else if (origin.cycle >= 0 && !(parent = place_before(v))) {
        const auto lines = cycle_lines(v);
        if (!lines) return std::nullopt;
        cycles += *lines;
      }
      if (!parent) continue;
      children_.emplace(*parent, v);
      origins += fmt::format("origin {} {} {}\n", v, parent->first, parent->second);
    }
    if (!zero_.is_known()) return std::nullopt;
    const std::set<Image> closing = closing_images();
    for (const auto& [vertex, letter, target, element] : origins_.coincidences)
      if (const Image image{vertex, letter}; !children_.contains(image) && !closing.contains(image))
        same += fmt::format("same {} {} {}{}\n", vertex, letter, target, words_.word(element));
    return zero_.lines({cycles + origins + same, !words_.negation().empty()});
  }

 private:
  using Image = std::pair<std::size_t, std::size_t>;  // of a vertex under a matrix

  /// The vertex on the same cycle of which this one is the image, if it comes before.
  std::optional<Image> place_before(std::size_t v) const {
    const PolytopeOrigins::Vertex& origin = origins_.vertices[v];
    const std::vector<int>& cycle = origins_.cycles[static_cast<std::size_t>(origin.cycle)];
    const int length = static_cast<int>(cycle.size()), place = (origin.place + length - 1) % length;
    const auto letter = static_cast<std::size_t>(cycle[static_cast<std::size_t>(place)]);
    const ComplexVector goal = polytope_.vertex(v);
    for (std::size_t u = 0; u < v; ++u) {
      const PolytopeOrigins::Vertex& other = origins_.vertices[u];
      if (other.parent >= 0 || other.cycle != origin.cycle || other.place != place) continue;
      const ComplexVector image = matrices_[letter] * polytope_.vertex(u);
      if (one_norm(image) > 0 && is_near(goal, rayleigh_quotient(goal, image), image)) return Image{u, letter};
    }
    return std::nullopt;
  }

  /// The lines `cycle` and `seed`: the shortest part of the cycle after which an element of the group leads back.
  std::optional<std::string> cycle_lines(std::size_t v) {
    const PolytopeOrigins::Vertex& origin = origins_.vertices[v];
    std::vector<int> letters = origins_.cycles[static_cast<std::size_t>(origin.cycle)];
    std::rotate(letters.begin(), letters.begin() + origin.place, letters.end());
    const ComplexVector start = polytope_.vertex(v);
    if (one_norm(start) == 0 || letters.size() > longest_cycle) return std::nullopt;
    ComplexVector moved = start;
    RationalMatrix product = RationalMatrix::identity(start.size());
    for (std::size_t length = 1; length <= letters.size(); ++length) {
      const RationalMatrix& next = matrices_[static_cast<std::size_t>(letters[length - 1])];
      moved = next * moved;
      product = next * product;
      if (letters.size() % length != 0 || one_norm(moved) == 0) continue;
      for (std::size_t e = 0; e < maps_.size(); ++e) {
        const RationalMatrix map = Rational(words_.sign(e)) * maps_[e];
        const ComplexVector image = map * moved;
        const RationalComplex eigenvalue = rayleigh_quotient(start, image);
        if (!is_near(start, eigenvalue, image)) continue;
        std::string word = words_.word(e);
        auto seed = zero_.seed_of(map * product, eigenvalue, length, start);
        if (!seed && !words_.negation().empty()) {
          seed = zero_.seed_of(Rational(-1) * map * product, {-eigenvalue.re, -eigenvalue.im}, length, start);
          word += words_.negation();
        }
        if (!seed) return std::nullopt;
        letters.resize(length);
        cycles_.emplace_back(v, letters);
        return fmt::format("cycle {} {} {}\nseed {}\n", v, word.empty() ? "-" : word, fmt::join(letters, " "),
                           fmt::join(*seed, " "));
      }
    }
    return std::nullopt;
  }

  /// The last image of each cycle, whose vertices are all known now.
  std::set<Image> closing_images() const {
    std::set<Image> images;
    for (const auto& [first, letters] : cycles_) {
      std::optional<std::size_t> at = first;
      for (std::size_t k = 0; at && k + 1 < letters.size(); ++k) {
        const auto next = children_.find({*at, static_cast<std::size_t>(letters[k])});
        at = next == children_.end() ? std::nullopt : std::optional(next->second);
      }
      if (at) images.emplace(*at, static_cast<std::size_t>(letters.back()));
    }
    return images;
  }

  const PolytopeProof& polytope_;
  const PolytopeOrigins& origins_;
  GroupWords words_;
  std::vector<RationalMatrix> matrices_, maps_;
  std::map<Image, std::size_t> children_;                         // vertices that are images
  std::vector<std::pair<std::size_t, std::vector<int>>> cycles_;  // first vertices, and letters
  CommonZero zero_;
};

}  // namespace

GroupWords words_of(const PolytopeProof& polytope, bool negation) {
  return GroupWords(polytope.group, !negation, negation);
}

Rational rounded(const Rational& value, int bits, Rounding rounding) {
  if (value == 0) return value;
  const long shift = bits - binary_exponent(value);
  const Rational unit = power(Rational(2), shift);
  return Rational(to_integer(value * unit, rounding)) / unit;
}

std::optional<ExactRadiusLines> exact_radius_lines(const MatrixFamily& family, const PolytopeProof& polytope) {
  auto lines = Writer(family, polytope, false).run();
  return lines || polytope.kind == PolytopeKind::nonnegative ? lines : Writer(family, polytope, true).run();
}

std::optional<ExactRadiusLines> exact_radius_lines(const MatrixFamily& family, const AttainedGraph& graph) {
  CommonZero zero;
  const auto seed = zero.seed_of(transposed(family.product(graph.product)), graph.eigenvalue, graph.product.size(), {});
  if (!seed) return std::nullopt;
  return zero.lines({fmt::format("cycle {} {} {} {}\nseed {}\n", graph.first, graph.coordinate, to_text(graph.kept),
                                 to_text(graph.scale), fmt::join(*seed, " "))});
}

std::optional<ExactRadiusLines> exact_subradius_lines(const MatrixFamily& family, const AntinormProof& proof) {
  const std::vector<Integer>& first = proof.vertices.front();
  const RationalMatrix product = subradius::product_of_cycle(proof.transposed ? transposed(family) : family,
                                                             proof.cycle),
                       inner = subradius::restricted(product, first, false),
                       rest = subradius::restricted(product, first, true);
  ComplexVector start;
  for (const Integer& c : first)
    if (c > 0) start.push_back({Rational(c), 0});
  CommonZero zero;
  const auto seed = zero.seed_of(inner, rayleigh_quotient(start, inner * start), proof.cycle.size(), start);
  if (!seed || proof.cycle.size() > longest_cycle) return std::nullopt;
  ExactRadiusLines lines = zero.lines({fmt::format("cycle 0 - {}\nseed", fmt::join(proof.cycle, " "))});
  const std::vector<Integer> weights = rest.rows() == 0
                                           ? std::vector<Integer>{}
                                           : subradius::subinvariant_vector(
                                                 rest, power(lines.low, static_cast<long>(proof.cycle.size())));
  if (weights.size() != rest.rows()) return std::nullopt;
  std::string others = "rest";
  for (std::size_t i = 0, inside = 0, outside = 0; i < first.size(); ++i) {
    lines.cycles.text += " " + (first[i] > 0 ? (*seed)[inside++] : Integer(0)).str();
    others += " " + (first[i] > 0 ? Integer(1) : weights[outside++]).str();
  }
  lines.cycles.text += "\n" + (weights.empty() ? "" : others + "\n");
  for (std::size_t j = 1; j < proof.vertices.size(); ++j)
    lines.cycles.text += fmt::format("origin {} {} {}\n", j, proof.origins[j - 1].parent, proof.origins[j - 1].letter);
  for (const auto& [vertex, letter, target] : proof.coincidences)
    lines.cycles.text += fmt::format("same {} {} {}\n", vertex, letter, target);
  return lines;
}

std::optional<ExactRadiusLines> exact_radius_lines(const CoefficientGrowth& growth) {
  const auto nearest = nearest_zero(growth.recurrence, {*growth.radius.lower, 0});
  const auto zero = nearest ? zero_in(nearest->ball, nearest->factor.polynomial) : std::nullopt;
  if (!zero) return std::nullopt;
  return lines_of(*zero, 1, {});
}

}  // namespace subcert
