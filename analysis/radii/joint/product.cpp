#include "product.hpp"

#include "cost.hpp"
#include "leading_factor.hpp"
#include "rounded_family.hpp"

#include <subcert/analysis/radii/polytope_proof/candidate.hpp>
#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>
#include <subcert/analysis/symbol/polynomials/complex_roots.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace subcert {
namespace {

constexpr slong precision = 320;
constexpr int dyadic_bits = 200;
constexpr long resolved_bits = 20;     // that an eigenvalue may be smaller than the entries
constexpr int smallest_exponent = 40;  // smaller eigenvalues than 2^-40 get as many bits more
constexpr long evidence_bits = 150;    // of evidence by balls, relatively
constexpr double nearly_real = 1e-12, nearly_real_if_multiple = 1e-6,
                 nearly_double = 1e-7;                              // in doubles, relatively
constexpr std::size_t longest_common_power = 64, most_paired = 12;  // letters, and the size of matrices
// Of approximate inverses, in bits.
constexpr long inverse_distance = 72, inverse_accuracy = 60, longest_entry = 4000;

/// The largest number of which all entries are integer multiples. Domain: not the zero matrix.
Rational content(const RationalMatrix& matrix) {
  Integer numerators = 0;
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) numerators = gcd(numerators, numerator(matrix(i, j)));
  return Rational(numerators, common_denominator(matrix));
}

/// Bits that tell which integer multiple of the content a number of that size is.
slong bits_to_tell(const RationalMatrix& matrix, const radius::FloatingEigenvalue& size) {
  const long exponent = std::ilogb(std::abs(size.value)) + size.exponent;
  return precision + std::max(0L, exponent - static_cast<long>(binary_exponent(content(matrix))));
}

/// A rational zero of the characteristic polynomial p next to a number: an integer multiple of the content, as matrices
/// of integers have algebraic integers as eigenvalues.
std::optional<Rational> rational_eigenvalue(const RationalMatrix& matrix, const LaurentPolynomial& p,
                                            const Rational& near) {
  const Rational unit = content(matrix), value = to_multiple(near, unit, Rounding::nearest);
  return value != 0 && p(value) == 0 ? std::optional(value) : std::nullopt;
}

/// Whether all zeros of p but root and -root are smaller in modulus.
bool is_largest_root(const LaurentPolynomial& p, const Rational& root, const Deadline& deadline) {
  LaurentPolynomial rest = p;
  for (const Rational& r : {root, Rational(-root)})
    while (rest.length() > 1 && rest(r) == 0) rest = *rest.exact_quotient(LaurentPolynomial({-r, 1}, 0));
  return radius::has_time_for_roots(rest, deadline) && *largest_root_modulus(rest).largest.upper < abs(root);
}

/// Next to a zero of largest modulus. Domain: a zero that is not 0, and time for the zeros.
RationalComplex largest_zero(const LaurentPolynomial& simple) {
  const std::vector<ComplexBall> zeros = complex_roots(simple.shifted(-simple.lowest()), precision);
  const ComplexBall& largest = *std::ranges::max_element(
      zeros, [](const ComplexBall& a, const ComplexBall& b) { return abs(a).is_less(abs(b)); });
  RationalComplex z = exact_middle(largest);
  if (imaginary_part(largest).enclosure().contains(0)) z.im = 0;
  return z;
}

/// From doubles; where it is so much smaller than the entries that these may not tell it, from the polynomial.
radius::FloatingEigenvalue leading_eigenvalue(const radius::FloatingEigenvalue& found, const RationalMatrix& product,
                                              const LaurentPolynomial& simple, const Deadline& deadline) {
  const auto size = binary_exponent(product);
  const LaurentPolynomial p = simple.shifted(-simple.lowest());
  const double modulus = std::abs(found.value);
  if (!size || p.length() == 1 || (modulus > 0 && std::ilogb(modulus) + found.exponent > *size - resolved_bits) ||
      !radius::has_time_for_roots(p, deadline))
    return found;
  const RationalComplex z = largest_zero(p);
  const long exponent = binary_exponent(one_norm({z}));
  const RationalComplex near = power(Rational(2), -exponent) * z;
  return {{near.re.convert_to<double>(), near.im.convert_to<double>()}, exponent};
}

/// In the upper half plane; real, where its imaginary part is small.
RationalComplex as_found(const radius::FloatingEigenvalue& start, double tolerance) {
  const double imaginary = std::abs(start.value.imag());
  const bool real = imaginary <= tolerance * std::abs(start.value);
  return power(Rational(2), start.exponent) *
         RationalComplex{Rational(start.value.real()), real ? Rational(0) : Rational(imaginary)};
}

/// How many bits after the binary point a number next to it gets. Domain: not 0.
int bits_after_point(const radius::FloatingEigenvalue& start) {
  const int exponent = std::ilogb(std::abs(start.value)) + static_cast<int>(start.exponent);
  return dyadic_bits + std::max(0, -exponent - smallest_exponent);
}

RationalComplex rounded(const RationalComplex& z, int bits) {
  const Rational unit = power(Rational(2), -bits);
  return {to_multiple(z.re, unit, Rounding::nearest), to_multiple(z.im, unit, Rounding::nearest)};
}

/// The centre c of the evidence: rational, near the leading eigenvalue.
struct Centre {
  RationalComplex point;
  std::optional<Rational> rational;  ///< the point, where it is an eigenvalue
  int bits;                          ///< after the binary point
};

/// Nothing where there is no eigenvalue but 0. `simple`: the squarefree part of p.
std::optional<Centre> centre_of(const RationalMatrix& product, const radius::FloatingEigenvalue& floating,
                                const LaurentPolynomial& p, const LaurentPolynomial& simple, const Deadline& deadline) {
  const radius::FloatingEigenvalue start = leading_eigenvalue(floating, product, simple, deadline);
  const double modulus = std::abs(start.value);
  if (modulus == 0 || simple.length() == 1) return std::nullopt;
  // A multiple real eigenvalue may come out as a pair that is off by the root of the rounding.
  const RationalComplex near = as_found(start, simple.length() < p.length() ? nearly_real_if_multiple : nearly_real);
  RationalComplex z = exact_middle(radius::refined_zero(simple, ball_around(near, bits_to_tell(product, start))));
  const int bits = bits_after_point(start);
  // Zeros that are one in doubles may have a derivative of 0 between them, where Newton's steps end.
  const RationalComplex there = rounded(z, bits);
  if (value_at(simple, there).squared_modulus() * power(Rational(2), bits) >
          value_at(simple.derivative(), there).squared_modulus() * there.squared_modulus() &&
      radius::has_time_for_roots(simple, deadline))
    z = largest_zero(simple);
  if (near.im == 0)
    if (const auto exact = rational_eigenvalue(product, p, z.re)) return Centre{{*exact, 0}, exact, bits};
  return Centre{rounded(z, bits), std::nullopt, bits};
}

/// A number c with few bits next to a simple eigenvalue, and how far that one is away at most, by balls. Nothing where
/// it is not isolated as well as by the polynomial, or may be rational.
struct NearbyEigenvalue {
  RationalComplex point;
  Rational away;
};

std::optional<NearbyEigenvalue> nearby_eigenvalue(const RationalMatrix& product,
                                                  const radius::FloatingEigenvalue& start, const Deadline& deadline) {
  if (start.value == 0.0 || start.distance < nearly_double) return std::nullopt;
  const Rational unit = content(product);
  const auto nearest = [&](const Rational& x) { return to_multiple(x, unit, Rounding::nearest); };
  const RationalComplex near = as_found(start, nearly_real);
  if (!radius::has_time_for_eigenpair(product.rows(), near, deadline)) return std::nullopt;
  const Rational size = abs(near.re), rest = abs(nearest(near.re) - near.re);
  // A rational number, most likely, where few numbers of that size may be rational eigenvalues.
  if (near.im == 0 && unit > Rational(nearly_real_if_multiple) * size && rest < Rational(nearly_real) * size)
    return std::nullopt;
  const auto pair = enclose_eigenpair(product, near, bits_to_tell(product, start), deadline);
  if (!pair) return std::nullopt;
  const RationalComplex middle = exact_middle(pair->value), point = rounded(middle, bits_after_point(start));
  if (middle.im == 0 && overlap(pair->value, ball_around({nearest(middle.re), 0}, pair->value.bits())))
    return std::nullopt;
  const Rational away = *abs(pair->value - ball_around(point, precision)).enclosure().upper;
  if (away * power(Rational(2), evidence_bits) > *root_enclosure(point.squared_modulus(), 2).lower) return std::nullopt;
  return NearbyEigenvalue{point, away};
}

/// q without its zeros that are zeros of p, and 0.
LaurentPolynomial without_zeros_of(const LaurentPolynomial& p, const LaurentPolynomial& q) {
  LaurentPolynomial rest = q.shifted(-q.lowest());
  for (;;) {
    const LaurentPolynomial shared = gcd(rest, p);
    if (shared.length() == 1) return rest;
    rest = *rest.exact_quotient(shared);
  }
}

/// Its zeros are the products of any two eigenvalues, also of one with itself. Nothing once the deadline passes.
std::optional<LaurentPolynomial> polynomial_of_pairs(const RationalMatrix& matrix, const Deadline& deadline) {
  auto squares = characteristic_polynomial(matrix * matrix, deadline);
  if (!squares || matrix.rows() == 1) return squares;
  const auto others = characteristic_polynomial(second_compound(matrix), deadline);
  return others ? std::optional(*squares * *others) : std::nullopt;
}

}  // namespace

std::string word_text(const std::vector<int>& word) {
  std::string text;
  for (int letter : word) text += (letter > 9 && !text.empty() ? "," : "") + std::to_string(letter);
  return text;
}

namespace {

/// Of a product with an eigenvalue within `away` of c.
void set_eigenvalue(ProductEvidence& evidence, const RationalComplex& c, const Rational& away) {
  const int length = static_cast<int>(evidence.word.size());
  evidence.eigenvalue = c;
  const Enclosure modulus = root_enclosure(c.squared_modulus(), 2);
  const Rational low = *modulus.lower - away;
  if (low > 0)
    evidence.radius = {root_enclosure(low, length).lower, root_enclosure(*modulus.upper + away, length).upper};
}

std::optional<ProductEvidence> proved_by_balls(const RationalMatrix& product, const std::vector<int>& word,
                                               const radius::FloatingEigenvalue& start, const Deadline& deadline) {
  const auto nearby = nearby_eigenvalue(product, start, deadline);
  if (!nearby) return std::nullopt;
  ProductEvidence evidence{word, {}, Enclosure::at_least(0), std::nullopt};
  set_eigenvalue(evidence, nearby->point, nearby->away);
  return evidence;
}

}  // namespace

std::optional<ProductEvidence> radius::prove_long_product(const MatrixFamily& family, const std::vector<int>& word,
                                                          const Deadline& deadline) {
  if (deadline.expired()) return std::nullopt;
  const auto product = family.product(word, deadline);
  if (!product || !has_long_characteristic(*product)) return std::nullopt;
  return proved_by_balls(*product, word, leading_eigenvalue(*product), deadline);
}

ProductEvidence prove_product(const MatrixFamily& family, const std::vector<int>& word, const Deadline& deadline,
                              const Rational& distance) {
  ProductEvidence evidence{word, {}, Enclosure::at_least(0), std::nullopt};
  if (deadline.expired()) return evidence;
  const auto in_time = family.product(word, deadline);
  if (!in_time) return evidence;
  const RationalMatrix& product = *in_time;
  const radius::FloatingEigenvalue floating = radius::leading_eigenvalue(product);
  if (distance == 0 && radius::has_long_characteristic(product))
    if (auto found = proved_by_balls(product, word, floating, deadline)) return *std::move(found);
  const int length = static_cast<int>(word.size());
  const auto characteristic = characteristic_polynomial(product, deadline);
  if (!characteristic) return evidence;
  const LaurentPolynomial &p = *characteristic, simple = squarefree_part(p), derivative = p.derivative();
  // Multiple eigenvalues are found as simple zeros of the squarefree part.
  auto centre = centre_of(product, floating, p, simple, deadline);
  if (!centre) return evidence;
  RationalComplex& c = centre->point;
  Rational slope = value_at(derivative, c).squared_modulus();
  if (slope == 0) {
    c.re += power(Rational(2), -centre->bits);
    slope = value_at(derivative, c).squared_modulus();
  }
  evidence.eigenvalue = c;
  if (slope == 0) return evidence;
  const auto n = static_cast<long>(family.size());
  const Rational squared_value = value_at(p, c).squared_modulus();
  Rational away = n * *root_enclosure(squared_value / slope, 2).upper;
  if (distance > 0) {
    // The characteristic polynomials of all products, and their derivatives.
    const Rational error = radius::RoundedFamily(family, distance).change_of_products(length),
                   column = *root_enclosure(c.squared_modulus(), 2).upper + one_norm(product);
    const Rational value = *root_enclosure(squared_value, 2).upper + radius::change_of_product(column, error, n),
                   steep = *root_enclosure(slope, 2).lower - n * radius::change_of_product(column, error, n - 1);
    if (steep <= 0) return evidence;
    away = n * value / steep;
  }
  set_eigenvalue(evidence, c, away);
  if (centre->rational && distance == 0) {
    const Enclosure exact = root_enclosure(abs(*centre->rational), length);
    if (exact.is_exact() && is_largest_root(p, *centre->rational, deadline)) evidence.exact = exact.lower;
  }
  return evidence;
}

std::optional<ApproximateInverse> approximate_inverse(const MatrixFamily& family, const ProductEvidence& evidence) {
  const RationalMatrix product = family.product(evidence.word);
  const auto n = static_cast<long>(product.rows());
  const RationalComplex& near = evidence.eigenvalue;
  if (near.squared_modulus() == 0) return std::nullopt;
  const long place = (binary_exponent(near.squared_modulus()) + 1) / 2 - inverse_distance;
  const Rational unit = power(Rational(2), place);
  const auto rounded = [&](const Rational& x) { return to_multiple(x, unit, Rounding::nearest); };
  ApproximateInverse result{{rounded(near.re) + unit, rounded(near.im)}, 0, {}};
  const Rational column = one_norm(product) + abs(near.re) + abs(near.im);
  const long bits = std::max(inverse_accuracy + binary_exponent(Rational(column * n * n)), 0L);
  if (bits + std::abs(place) > longest_entry) return std::nullopt;
  result.bits = static_cast<int>(bits);
  // Matrices whose powers grow long before they decay take more bits than their entries say: one column tells.
  const auto is_inverse = [&](const std::vector<ComplexVector>& columns) {
    ComplexVector rest = product * columns.front();
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = rest[i] - result.point * columns.front()[i];
    rest.front().re += 1;
    return one_norm(rest) < power(Rational(2), -inverse_accuracy);
  };
  std::optional<std::vector<ComplexVector>> columns;
  for (const slong more : {precision / 2, 2 * precision}) {
    columns = inverse_columns(product, result.point, bits + std::abs(place) + more);
    if (columns && is_inverse(*columns)) break;
  }
  if (!columns) return std::nullopt;
  const Rational scale = power(Rational(2), bits);
  for (const ComplexVector& exact : *columns) {
    std::vector<Integer>& numbers = result.columns.emplace_back();
    for (const RationalComplex& entry : exact) numbers.push_back(to_integer(scale * entry.re, Rounding::nearest));
    for (std::size_t i = 0; result.point.im != 0 && i < exact.size(); ++i)
      numbers.push_back(to_integer(scale * exact[i].im, Rounding::nearest));
  }
  return result;
}

namespace radius {

ProductEvidence scaled(ProductEvidence evidence, const Rational& factor) {
  evidence.eigenvalue = power(factor, static_cast<long>(evidence.word.size())) * evidence.eigenvalue;
  evidence.radius.lower = *evidence.radius.lower * factor;
  if (evidence.radius.upper) evidence.radius.upper = *evidence.radius.upper * factor;
  if (evidence.exact) evidence.exact = *evidence.exact * factor;
  return evidence;
}

bool is_dominated(const MatrixFamily& first, const ProductEvidence& above, const MatrixFamily& second,
                  const ProductEvidence& below, const Deadline& deadline) {
  const std::size_t common = std::lcm(above.word.size(), below.word.size());
  if (2 * common > longest_common_power) return false;
  const Rational largest = power(*above.radius.lower, static_cast<long>(2 * common));
  const auto repeated = [&](const MatrixFamily& family, const std::vector<int>& word) {
    return power(family.product(word), static_cast<long>(common / word.size()));
  };
  const RationalMatrix a = repeated(first, above.word), b = repeated(second, below.word);
  // Whether all zeros of the one but common ones are small enough.
  const auto covered = [&](const auto& polynomial_of, const auto& are_small) {
    const auto p = polynomial_of(a, deadline), q = polynomial_of(b, deadline);
    return p && q && are_small(without_zeros_of(*p, *q));
  };
  // Of powers, which make signs equal.
  if (covered([](const RationalMatrix& m, const Deadline& end) { return characteristic_polynomial(m * m, end); },
              [&](const LaurentPolynomial& rest) {
                const auto found = largest_root_modulus(rest, default_bits, deadline);
                return found && *found->largest.upper <= largest;
              }))
    return true;
  // Of pairs: the squared modulus of an eigenvalue is a positive zero, and no positive zero is larger than all of
  // these. Few bits will do; zeros above a bound are those of the reversed polynomial below its inverse.
  if (largest == 0 || std::max(a.rows(), b.rows()) > most_paired) return false;
  const Rational unit = power(Rational(2), binary_exponent(largest) - precision),
                 bound = to_multiple(largest, unit, Rounding::down);
  return covered(polynomial_of_pairs, [&](const LaurentPolynomial& rest) {
    const LaurentPolynomial inverted = rest.reversed();
    return count_real_roots(inverted.shifted(-inverted.lowest()), 0, 1 / bound, deadline) == 0;
  });
}

int jordan_power(const MatrixFamily& family, const std::vector<int>& word, const Deadline& deadline) {
  const auto product = family.product(word, deadline);
  const auto p = product ? characteristic_polynomial(*product, deadline) : std::nullopt;
  if (!p || !has_time_for_roots(*p, deadline)) return 0;
  const auto factors = irreducible_factors(*p);
  std::vector<Enclosure> moduli;
  std::size_t leading = 0;
  for (const PolynomialFactor& factor : factors) {
    moduli.push_back(largest_root_modulus(factor.polynomial).largest);
    if (*moduli.back().lower > *moduli[leading].lower) leading = moduli.size() - 1;
  }
  for (std::size_t i = 0; i < moduli.size(); ++i)
    if (i != leading && *moduli[i].upper >= *moduli[leading].lower) return 0;
  return largest_jordan_block(*product, factors[leading].polynomial) - 1;
}

}  // namespace radius
}  // namespace subcert
