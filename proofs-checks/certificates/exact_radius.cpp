#include "exact_radius.hpp"

#include "group_words.hpp"

#include <subcert/analysis/symbol/balls.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert {
namespace {

constexpr slong root_bits = 1024;   // of the balls of zeros
constexpr int point_bits = 640;     // of a point near a zero
constexpr int radius_bits = 400;    // of the bounds of the radius
constexpr int most_decimals = 100;  // of the point that names a zero
constexpr std::size_t longest_cycle = 256;

Rational absolute_sum(const RationalComplex& z) { return abs(z.re) + abs(z.im); }

Rational one_norm(const ComplexVector& v) {
  Rational sum = 0;
  for (const RationalComplex& c : v) sum += absolute_sum(c);
  return sum;
}

ComplexVector difference(const ComplexVector& a, const RationalComplex& factor, const ComplexVector& b) {
  ComplexVector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - factor * b[i]);
  return result;
}

/// <v, w> / <v, v>. Domain: v not 0.
RationalComplex quotient(const ComplexVector& v, const ComplexVector& w) {
  RationalComplex sum;
  Rational size = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    sum += v[i].conjugate() * w[i];
    size += v[i].squared_modulus();
  }
  return (1 / size) * sum;
}

bool is_near(const ComplexVector& v, const RationalComplex& factor, const ComplexVector& w) {
  return one_norm(difference(w, factor, v)) < power(Rational(10), -20) * one_norm(w);
}

/// A dyadic number within 2^-bits of the value, relatively.
Rational rounded(const Rational& value, int bits, Rounding rounding) {
  if (value == 0) return value;
  const long shift = bits - binary_exponent(value);
  const Rational unit = power(Rational(2), shift);
  return Rational(to_integer(value * unit, rounding)) / unit;
}

/// The integer multiple whose entries have no common divisor, the last one positive.
std::vector<Integer> primitive(const std::vector<Rational>& values) {
  Integer common = 1, divisor = 0;
  for (const Rational& x : values) common = lcm(common, denominator(x));
  std::vector<Integer> result;
  for (const Rational& x : values) {
    result.push_back(numerator(Rational(x * common)));
    divisor = gcd(divisor, result.back());
  }
  for (Integer& x : result) x /= divisor;
  return result;
}

std::vector<Integer> coefficients(const LaurentPolynomial& p) {
  std::vector<Rational> values;
  for (long k = 0; k <= p.highest(); ++k) values.push_back(p.coefficient(k));
  return primitive(values);
}

RationalComplex value_at(const std::vector<Integer>& p, const RationalComplex& z) {
  RationalComplex value;
  for (std::size_t k = p.size(); k-- > 0;) value = value * z + RationalComplex{Rational(p[k]), 0};
  return value;
}

std::vector<Integer> derivative(const std::vector<Integer>& p) {
  std::vector<Integer> result;
  for (std::size_t k = 1; k < p.size(); ++k) result.push_back(p[k] * k);
  return result;
}

/// A zero of a polynomial: a point, how far from it the zero is at most, and a disc that holds no other zero.
struct Zero {
  std::vector<Integer> polynomial;
  RationalComplex point, centre;
  Rational error, within;
};

/// Whether the disc around the centre has at most one zero.
bool isolates(const std::vector<Integer>& p, const RationalComplex& centre, const Rational& within) {
  const Rational size = absolute_sum(centre) + within;
  Rational change = 0;
  for (std::size_t k = p.size(); k-- > 2;) change = change * size + abs(Rational(p[k] * k * (k - 1)));
  return change * change * within * within < value_at(derivative(p), centre).squared_modulus();
}

std::optional<Zero> zero_near(const LaurentPolynomial& factor, const RationalComplex& approximation) {
  Zero zero{coefficients(factor), {}, {}, 0, 0};
  const std::vector<Integer>& p = zero.polynomial;
  if (p.size() == 2) {
    zero.point = {Rational(-p[0], p[1]), 0};
  } else {
    const ComplexBall near = ball_around(approximation, root_bits);
    const std::vector<ComplexBall> zeros = complex_roots(factor, root_bits);
    const auto closest = std::min_element(zeros.begin(), zeros.end(), [&](const ComplexBall& a, const ComplexBall& b) {
      return abs(a - near).is_less(abs(b - near));
    });
    const Enclosure re = closest->real().enclosure(root_bits), im = imaginary_part(*closest).enclosure(root_bits);
    if (!re.lower || !re.upper || !im.lower || !im.upper) return std::nullopt;
    zero.point = {rounded((*re.lower + *re.upper) / 2, point_bits, Rounding::down),
                  *im.lower <= 0 && 0 <= *im.upper ? Rational(0)
                                                   : rounded((*im.lower + *im.upper) / 2, point_bits, Rounding::down)};
  }
  const Rational steep = value_at(derivative(p), zero.point).squared_modulus();
  if (steep == 0) return std::nullopt;
  const Rational squared = Rational((p.size() - 1) * (p.size() - 1)) * value_at(p, zero.point).squared_modulus() /
                           steep;
  zero.error = squared == 0 ? Rational(0) : power(Rational(2), binary_exponent(squared) / 2 + 1);
  for (int decimals = 3; decimals < most_decimals; ++decimals) {
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

class Writer {
 public:
  Writer(const MatrixFamily& family, const PolytopeProof& polytope)
      : polytope_(polytope),
        origins_(polytope.origins),
        words_(polytope.group, true),
        parents_(origins_.vertices.size()) {
    for (const RationalMatrix& m : family) matrices_.push_back(polytope.transposed ? transposed(m) : m);
    for (const FamilySymmetry& element : polytope.group) maps_.push_back(element.map.matrix());
  }

  std::optional<ExactRadiusLines> run() {
    if (origins_.vertices.size() != polytope_.vertices.size()) return std::nullopt;
    std::string cycles, origins, same;
    for (std::size_t v = 0; v < parents_.size(); ++v) {
      const PolytopeOrigins::Vertex& origin = origins_.vertices[v];
      if (origin.parent >= 0)
        parents_[v] = {static_cast<std::size_t>(origin.parent), static_cast<std::size_t>(origin.letter)};
      else if (origin.cycle >= 0 && !(parents_[v] = place_before(v))) {
        const auto lines = cycle_lines(v);
        if (!lines) return std::nullopt;
        cycles += *lines;
      }
      if (parents_[v]) origins += fmt::format("origin {} {} {}\n", v, parents_[v]->first, parents_[v]->second);
    }
    if (!zero_) return std::nullopt;
    for (const PolytopeOrigins::Coincidence& image : origins_.coincidences)
      if (!is_known(image))
        same += fmt::format("same {} {} {}{}\n", image.vertex, image.letter, image.target, words_.word(image.element));
    const Zero& z = *zero_;
    const Enclosure modulus = root_enclosure(z.point.squared_modulus(), 2, radius_bits);
    const int length = static_cast<int>(length_);
    const Rational low = rounded(*root_enclosure(*modulus.lower - z.error, length, radius_bits).lower, radius_bits,
                                 Rounding::down),
                   high = rounded(*root_enclosure(*modulus.upper + z.error, length, radius_bits).upper, radius_bits,
                                  Rounding::up);
    return ExactRadiusLines{fmt::format("|[{}]@{},{},{}|^1/{}", joined(z.polynomial, ","), to_text(z.centre.re),
                                        to_text(z.centre.im), to_text(z.within), length_),
                            fmt::format("root {} {} {} {} {}\n", to_text(z.point.re), to_text(z.point.im),
                                        to_text(z.error), to_text(low), to_text(high)),
                            cycles + origins + same, low};
  }

 private:
  using Image = std::pair<std::size_t, std::size_t>;  // of a vertex under a matrix

  static std::string joined(const std::vector<Integer>& numbers, const char* separator) {
    std::string text;
    for (const Integer& x : numbers) text += (text.empty() ? "" : separator) + x.str();
    return text;
  }

  ComplexVector vertex(std::size_t index) const {
    const Integer one = Integer(1) << polytope_.vertex_bits;
    ComplexVector result;
    for (std::size_t i = 0; i < polytope_.vertices[index].size(); ++i)
      result.push_back({Rational(polytope_.vertices[index][i], one),
                        polytope_.imaginary.empty() ? Rational(0) : Rational(polytope_.imaginary[index][i], one)});
    return result;
  }

  /// The vertex on the same cycle of which this one is the image, if it comes before.
  std::optional<Image> place_before(std::size_t v) const {
    const PolytopeOrigins::Vertex& origin = origins_.vertices[v];
    const std::vector<int>& cycle = origins_.cycles[static_cast<std::size_t>(origin.cycle)];
    const int length = static_cast<int>(cycle.size()), place = (origin.place + length - 1) % length;
    const auto letter = static_cast<std::size_t>(cycle[static_cast<std::size_t>(place)]);
    const ComplexVector goal = vertex(v);
    for (std::size_t u = 0; u < v; ++u) {
      const PolytopeOrigins::Vertex& other = origins_.vertices[u];
      if (other.parent >= 0 || other.cycle != origin.cycle || other.place != place) continue;
      const ComplexVector image = matrices_[letter] * vertex(u);
      if (one_norm(image) > 0 && is_near(goal, quotient(goal, image), image)) return Image{u, letter};
    }
    return std::nullopt;
  }

  /// The lines `cycle` and `seed`: the shortest part of the cycle after which an element of the group leads back.
  std::optional<std::string> cycle_lines(std::size_t v) {
    const PolytopeOrigins::Vertex& origin = origins_.vertices[v];
    std::vector<int> letters = origins_.cycles[static_cast<std::size_t>(origin.cycle)];
    std::rotate(letters.begin(), letters.begin() + origin.place, letters.end());
    const ComplexVector start = vertex(v);
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
        const RationalComplex eigenvalue = quotient(start, image);
        if (!is_near(start, eigenvalue, image)) continue;
        const auto seed = seed_of(map * product, eigenvalue, length);
        if (!seed) return std::nullopt;
        letters.resize(length);
        cycles_.emplace_back(v, letters);
        return fmt::format("cycle {} {} {}\nseed {}\n", v, words_.word(e).empty() ? "-" : words_.word(e),
                           fmt::join(letters, " "), joined(*seed, " "));
      }
    }
    return std::nullopt;
  }

  /// A vector on which the polynomial of the zero vanishes. The zero has to be that of the other cycles, and simple.
  std::optional<std::vector<Integer>> seed_of(const RationalMatrix& product, const RationalComplex& eigenvalue,
                                              std::size_t length) {
    const LaurentPolynomial characteristic = characteristic_polynomial(product);
    const ComplexBall near = ball_around(eigenvalue, root_bits);
    std::optional<PolynomialFactor> best;
    std::optional<ComplexBall> distance;
    for (const PolynomialFactor& factor : irreducible_factors(characteristic)) {
      if (factor.polynomial.lowest() != 0) continue;
      for (const ComplexBall& zero : complex_roots(factor.polynomial, root_bits))
        if (const ComplexBall away(abs(zero - near)); !distance || abs(away).is_less(abs(*distance))) {
          distance = away;
          best = factor;
        }
    }
    if (!best || best->multiplicity != 1) return std::nullopt;
    if (!zero_) {
      zero_ = zero_near(best->polynomial, eigenvalue);
      length_ = length;
    }
    if (!zero_ || length_ != length || zero_->polynomial != coefficients(best->polynomial)) return std::nullopt;
    const LaurentPolynomial others = *characteristic.exact_quotient(best->polynomial);
    for (std::size_t i = 0; i < product.rows(); ++i) {
      std::vector<Rational> seed(product.rows());
      for (long k = others.highest(); k >= 0; --k) {
        seed = product * seed;
        seed[i] += others.coefficient(k);
      }
      if (std::any_of(seed.begin(), seed.end(), [](const Rational& x) { return x != 0; })) return primitive(seed);
    }
    return std::nullopt;
  }

  /// Whether the image is a vertex by the lines `origin` and `cycle`.
  bool is_known(const PolytopeOrigins::Coincidence& image) const {
    const Image here{image.vertex, image.letter};
    for (const auto& parent : parents_)
      if (parent == here) return true;
    for (const auto& [first, letters] : cycles_) {
      std::size_t at = first;
      for (std::size_t k = 0; k + 1 < letters.size(); ++k) {
        const Image step{at, static_cast<std::size_t>(letters[k])};
        const auto next = std::find(parents_.begin(), parents_.end(), std::optional(step));
        if (next == parents_.end()) return false;
        at = static_cast<std::size_t>(next - parents_.begin());
      }
      if (here == Image{at, static_cast<std::size_t>(letters.back())}) return true;
    }
    return false;
  }

  const PolytopeProof& polytope_;
  const PolytopeOrigins& origins_;
  GroupWords words_;
  std::vector<RationalMatrix> matrices_, maps_;
  std::vector<std::optional<Image>> parents_;
  std::vector<std::pair<std::size_t, std::vector<int>>> cycles_;  // first vertices, and letters
  std::optional<Zero> zero_;
  std::size_t length_ = 0;
};

}  // namespace

std::optional<ExactRadiusLines> exact_radius_lines(const MatrixFamily& family, const PolytopeProof& polytope) {
  return Writer(family, polytope).run();
}

}  // namespace subcert
