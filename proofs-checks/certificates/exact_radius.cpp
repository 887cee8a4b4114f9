
#include "exact_radius.hpp"

#include <subcert/analysis/radii/joint/leading_factor.hpp>
#include <subcert/analysis/radii/subradius/certify.hpp>
#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace subcert {
namespace {

constexpr slong root_bits = 1024;   // of the balls of zeros
constexpr slong factor_bits = 320;  // of those that tell zeros apart
constexpr int point_bits = 640;     // of a point near a zero
constexpr int radius_bits = 400;    // of the bounds of the radius
constexpr int most_decimals = 100;  // of the point that names a zero, less the zeros in front
constexpr std::size_t longest_cycle = 1000;

/// A point, how far from it the zero of a polynomial is at most, and a disc that holds no other zero.
struct Zero {
  RationalComplex point, centre;
  Rational error, within;
};

/// Whether the disc around the centre has at most one zero.
bool isolates(const LaurentPolynomial& p, const RationalComplex& centre, const Rational& within) {
  const Rational size = one_norm({centre}) + within;
  Rational change = 0;
  for (long k = p.highest(); k >= 2; --k) change = change * size + abs(p.coefficient(k)) * (k * (k - 1));
  return change * change * within * within < value_at(p.derivative(), centre).squared_modulus();
}

/// The point, with more digits. Domain: the zero is not rational.
RationalComplex refined(const AttainedNumber& number) {
  const RationalComplex z = exact_middle(radius::refined_zero(number.polynomial, ball_around(number.point, root_bits)));
  return {rounded(z.re, point_bits, Rounding::down), rounded(z.im, point_bits, Rounding::down)};
}

/// Of the digits before the decimal point: a large zero is named by about as many as others. Domain: size > 0.
int digits_left_out(const Rational& size) {
  constexpr long most_digits = 16, digits_of_ten_bits = 3;
  return static_cast<int>(std::max(0L, binary_exponent(size) * digits_of_ten_bits / 10 - most_digits));
}

std::optional<Zero> zero_of(const AttainedNumber& number) {
  const LaurentPolynomial& p = number.polynomial;
  Zero zero{p.highest() == 1 ? number.point : refined(number), {}, 0, 0};
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

std::string coefficients_text(const LaurentPolynomial& p) {
  std::string text;
  for (long k = 0; k <= p.highest(); ++k) text += (k == 0 ? "" : ",") + to_text(p.coefficient(k));
  return text;
}

/// The image that leads a cycle back.
std::pair<std::size_t, std::size_t> closing_image(const AttainedProof::Cycle& cycle) {
  return {cycle.last, static_cast<std::size_t>(cycle.letters.back())};
}

}  // namespace

GroupWords words_of(const PolytopeProof& polytope, bool exact) {
  const GroupWords words(polytope.group, polytope.is_flip_symmetric());
  const bool negation = exact && std::ranges::any_of(polytope.attained->cycles, [&](const AttainedProof::Cycle& cycle) {
                          return cycle.sign != words.sign(cycle.element);
                        });
  return negation ? GroupWords(polytope.group, false, true) : words;
}

Rational rounded(const Rational& value, int bits, Rounding rounding) {
  if (value == 0) return value;
  const long shift = bits - binary_exponent(value);
  const Rational unit = power(Rational(2), shift);
  return Rational(to_integer(value * unit, rounding)) / unit;
}

std::optional<NumberLines> number_lines(const AttainedNumber& number) {
  const auto z = zero_of(number);
  if (!z) return std::nullopt;
  const Enclosure modulus = root_enclosure(z->point.squared_modulus(), 2, radius_bits);
  const int length = static_cast<int>(number.length);
  const auto exact = z->error == 0 ? exact_root(z->point.squared_modulus(), 2 * number.length) : std::nullopt;
  const auto bound = [&](const Rational& power, std::optional<Rational> Enclosure::*end, Rounding rounding) {
    return exact ? *exact : rounded(*(root_enclosure(power, length, radius_bits).*end), radius_bits, rounding);
  };
  const Rational low = bound(*modulus.lower - z->error, &Enclosure::lower, Rounding::down),
                 high = bound(*modulus.upper + z->error, &Enclosure::upper, Rounding::up);
  return NumberLines{fmt::format("|[{}]@{},{},{}|^1/{}", coefficients_text(number.polynomial), to_text(z->centre.re),
                                 to_text(z->centre.im), to_text(z->within), length),
                     fmt::format("root {} {} {} {} {}\n", to_text(z->point.re), to_text(z->point.im), to_text(z->error),
                                 to_text(low), to_text(high)),
                     low};
}

std::string inverse_text(int bits, const std::vector<std::vector<Integer>>& columns) {
  std::string text = fmt::format("inverse {}\n", bits);
  for (std::size_t k = 0; k < columns.size(); ++k) text += fmt::format("column {} {}\n", k, fmt::join(columns[k], " "));
  return text;
}

std::string cycle_text(const AttainedProof& proof, const GroupWords& words) {
  std::string text;
  std::set<std::pair<std::size_t, std::size_t>> closing;
  for (std::size_t k = 0; k < proof.cycles.size(); ++k) {
    const AttainedProof::Cycle& cycle = proof.cycles[k];
    const std::string word = words.word(cycle.element) +
                             (cycle.sign == words.sign(cycle.element) ? "" : words.negation());
    const NearbyEigenvector* near = proof.nearby ? &proof.nearby->eigenvectors[k] : nullptr;
    text += fmt::format("cycle {} {} {}{}\n", cycle.vertex, word.empty() ? "-" : word,
                        near ? to_text(near->eigenvalue) + " " : "", fmt::join(cycle.letters, " ")) +
            (near ? inverse_text(near->bits, near->inverse) : fmt::format("seed {}\n", fmt::join(cycle.seed, " ")));
    closing.insert(closing_image(cycle));
  }
  for (const auto& [vertex, parent, letter] : proof.origins)
    text += fmt::format("origin {} {} {}\n", vertex, parent, letter);
  for (const auto& [vertex, letter, target, element] : proof.coincidences)
    if (!closing.contains({vertex, letter}))
      text += fmt::format("same {} {} {}{}\n", vertex, letter, target, words.word(element));
  return text;
}

std::string cycle_text(const AttainedGraph& graph) {
  return fmt::format("cycle {} {} {} {}\nseed {}\n", graph.first, graph.coordinate, to_text(graph.kept),
                     to_text(graph.scale), fmt::join(graph.seed, " "));
}

std::optional<AttainedNumber> number_of(const CoefficientGrowth& growth) {
  const auto pole = radius::nearest_factor(growth.recurrence, {*growth.radius.lower, 0}, factor_bits);
  return pole ? std::optional(pole->number(1)) : std::nullopt;
}

std::optional<SubradiusLines> exact_subradius_lines(const MatrixFamily& family, const AntinormProof& proof) {
  const std::vector<Integer>& first = proof.vertices.front();
  const RationalMatrix product = subradius::product_of_cycle(proof.transposed ? transposed(family) : family,
                                                             proof.cycle),
                       inner = subradius::restricted(product, first, false),
                       rest = subradius::restricted(product, first, true);
  ComplexVector start;
  for (const Integer& c : first)
    if (c > 0) start.push_back({Rational(c), 0});
  const RationalComplex eigenvalue = rayleigh_quotient(start, inner * start);
  const auto length = static_cast<long>(proof.cycle.size());
  // Zeros that are about as large as 1 are found fast.
  const Rational unit = power(Rational(2), binary_exponent(one_norm({eigenvalue})) / length),
                 less = power(unit, -length);
  const auto factor = radius::leading_factor(less * inner, less * eigenvalue, factor_bits, {});
  const auto seed = factor ? radius::seed_of(less * inner, *factor, start) : std::nullopt;
  const auto number = seed ? number_lines(scaled(factor->number(proof.cycle.size()), unit)) : std::nullopt;
  if (!number || proof.cycle.size() > longest_cycle) return std::nullopt;
  SubradiusLines lines{*number, fmt::format("cycle 0 - {}\nseed", fmt::join(proof.cycle, " "))};
  const std::vector<Integer> weights = rest.rows() == 0
                                           ? std::vector<Integer>{}
                                           : subradius::subinvariant_vector(rest, power(number->low, length));
  if (weights.size() != rest.rows()) return std::nullopt;
  std::string others = "rest";
  for (std::size_t i = 0, inside = 0, outside = 0; i < first.size(); ++i) {
    lines.cycles += " " + (first[i] > 0 ? (*seed)[inside++] : Integer(0)).str();
    others += " " + (first[i] > 0 ? Integer(1) : weights[outside++]).str();
  }
  lines.cycles += "\n" + (weights.empty() ? "" : others + "\n");
  for (std::size_t j = 1; j < proof.vertices.size(); ++j)
    lines.cycles += fmt::format("origin {} {} {}\n", j, proof.origins[j - 1].parent, proof.origins[j - 1].letter);
  for (const auto& [vertex, letter, target] : proof.coincidences)
    lines.cycles += fmt::format("same {} {} {}\n", vertex, letter, target);
  return lines;
}

namespace {

/// The element that is the map or its negative.
std::pair<std::size_t, int> find(const std::vector<RationalMatrix>& maps, const RationalMatrix& map) {
  for (std::size_t e = 0; e < maps.size(); ++e)
    for (const int sign : {1, -1})
      if (map == Rational(sign) * maps[e]) return {e, sign};
  fail(ErrorKind::domain, "certificate: need a group of symmetries, got maps that are none");
}

}  // namespace

GroupWords::GroupWords(const std::vector<FamilySymmetry>& group, bool flip, bool negation) : words_(group.size()) {
  words_[0] = {"", 1};
  std::vector<RationalMatrix> maps;
  for (const FamilySymmetry& element : group) maps.push_back(element.map.matrix());
  if (flip) {
    words_[1] = {"f", 1};
    return;
  }
  for (std::size_t next = 1; next < group.size(); ++next) {
    if (words_[next]) continue;
    generators_.push_back(next);
    inverses_.push_back(find(maps, solve(maps[next], maps[0])).first);
    extend(maps);
  }
  if (negation) negation_ = static_cast<char>('A' + generators_.size());
}

/// Words for all products of the generators so far.
void GroupWords::extend(const std::vector<RationalMatrix>& maps) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t e = 0; e < maps.size(); ++e)
      for (std::size_t g = 0; words_[e] && g < generators_.size(); ++g) {
        const auto [product, sign] = find(maps, maps[generators_[g]] * maps[e]);
        if (words_[product]) continue;
        words_[product] = {static_cast<char>('A' + g) + words_[e]->first, sign * words_[e]->second};
        changed = true;
      }
  }
}

}  // namespace subcert
