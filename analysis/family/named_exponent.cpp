#include "named_exponent.hpp"

#include "parametric_family.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/named_radius.hpp>
#include <subcert/analysis/transition/transition.hpp>

namespace subcert {
namespace {

constexpr int most_powers = 12;  // of the base, which are split off from a radius
constexpr std::size_t largest_conjugates = 64;

AttainedNumber rational_number(const Rational& radius) {
  const Rational q(denominator(radius));
  return {LaurentPolynomial({-radius * q, q}, 0), {radius, 0}, 1};
}

/// The product of a word of the T_t(t), t by the matrix with which it multiplies 1, t, t^2, ... modulo a polynomial.
/// Its eigenvalues are those of the products for all zeros of the polynomial in the place of t.
RationalMatrix product_of_conjugates(const ParametricFamily& family, const LaurentPolynomial& modulus,
                                     const std::vector<int>& word) {
  const auto degree = static_cast<std::size_t>(modulus.highest());
  const std::size_t size = family.size() * degree;
  RationalMatrix companion(degree, degree), power = RationalMatrix::identity(degree);
  for (std::size_t i = 0; i < degree; ++i) {
    if (i > 0) companion(i, i - 1) = 1;
    companion(i, degree - 1) = -modulus.coefficient(static_cast<long>(i)) / modulus.coefficient(modulus.highest());
  }
  std::vector<RationalMatrix> matrices(static_cast<std::size_t>(family.mask.arity()), RationalMatrix(size, size));
  const Rational denominator = family.mask.denominator()(0);
  for (const LaurentPolynomial& coefficient : family.mask.powers()) {
    const std::vector<RationalMatrix> own = family.matrices_of(coefficient);
    for (std::size_t t = 0; t < own.size(); ++t)
      for (std::size_t i = 0; i < size; ++i)
        for (std::size_t j = 0; j < size; ++j)
          matrices[t](i, j) += own[t](i / degree, j / degree) * power(i % degree, j % degree) / denominator;
    power = power * companion;
  }
  return MatrixFamily(std::move(matrices)).product(word);
}

std::optional<NamedExponent> of_curve(const Mask& mask, const HolderRegularity& whole,
                                      const std::optional<AlgebraicMask>& meant) {
  const HolderRegularity& its = whole.deciding();
  const Enclosure exponent = whole.proved_exponent();
  const JointSpectralRadius& found = its.radius;
  if (!exponent.is_bounded() || exponent.is_exact()) return std::nullopt;
  const int rules = its.bounds.sum_rules;
  NamedExponent named{rules, mask.arity(), 1, {}};
  if (found.radius.is_exact()) {
    named.radius = rational_number(*found.radius.lower);
    return named;
  }
  // A radius of at most 1 tells nothing of the exponent from above.
  if (!found.exact.is_yes() || !(*found.radius.lower > 1)) return std::nullopt;
  std::optional<AttainedNumber> number;
  if (!meant) {
    const Mask& deciding = whole.reduced ? whole.reduced->mask.mask : mask;
    number = named_radius(transition_matrices(divided_difference_scheme(deciding, rules)), found, largest_named_degree);
  } else if (const ParametricFamily family = transition_matrices(divided_difference_scheme(meant->mask, rules));
             family.size() * static_cast<std::size_t>(meant->polynomial.highest()) <= largest_conjugates) {
    const std::vector<int>& word = found.product.word;
    number = named_radius(product_of_conjugates(family, meant->polynomial, word), word.size(), found.product.eigenvalue,
                          found.radius, largest_named_degree);
  }
  if (!number) return std::nullopt;
  named.radius = std::move(*number);
  return named;
}

/// Times a power of the base: the least one with which the number is an algebraic integer, or else at least 1.
void split_off(NamedExponent& named) {
  const auto times_power = [&](int power_of_base) {
    return NamedExponent{static_cast<int>(named.dimension) * power_of_base, named.base, named.dimension,
                         scaled(named.radius, power(Rational(named.base), power_of_base))};
  };
  const auto is_integral = [](const NamedExponent& one) {
    return abs(one.radius.polynomial.coefficient(one.radius.polynomial.highest())) == 1;
  };
  std::optional<NamedExponent> large;
  for (int k = 0; k <= most_powers; ++k) {
    NamedExponent next = times_power(k);
    if (is_integral(next)) {
      named = std::move(next);
      return;
    }
    if (!large && next.radius.point.squared_modulus() >= 1) large = std::move(next);
  }
  if (large) named = std::move(*large);
}

std::optional<NamedExponent> of_operators(const LatticeMask& mask, const MultivariateRegularity& found) {
  const Dilation& dilation = mask.dilation();
  if (!found.radius || !found.space || !dilation.is_isotropic() || !found.exact.is_yes() ||
      !found.exponent.is_bounded() || found.exponent.is_exact())
    return std::nullopt;
  if (found.vector && (found.vector->root != 0 || found.vector->components.size() != mask.components()))
    return std::nullopt;
  // The hypotheses of the upper end: docs/surfaces.md, docs/vectors.md.
  const Enclosure exponent = exponent_of_radius(found.radius->radius, dilation.classes(), dilation.variables());
  if (!exponent.upper || !(*exponent.upper < found.space->order) ||
      !(found.space->is_of_values() || found.stable.is_yes()))
    return std::nullopt;
  auto number = named_radius(found.space->family, *found.radius, largest_named_degree);
  if (!number) return std::nullopt;
  NamedExponent named{0, dilation.classes(), dilation.variables(), std::move(*number)};
  if (const auto root = exact_root(Rational(named.base), named.dimension)) {
    named.base = to_integer(*root, Rounding::nearest).convert_to<long>();
    named.dimension = 1;
  }
  split_off(named);
  return named;
}

}  // namespace

std::optional<NamedExponent> named_exponent(const LatticeMask& mask, const Regularity& found,
                                            const std::optional<AlgebraicMask>& meant) {
  return found.curve ? of_curve(mask.curve(), *found.curve, meant) : of_operators(mask, *found.surface);
}

std::optional<NamedExponent> named_exponent(const ExponentOfList& found) {
  if (!found.exact.is_yes() || found.exponent.is_exact()) return std::nullopt;
  if (found.vectors && found.is_one_sequence()) return of_operators(*found.vectors->one, *found.vectors->functions);
  auto number = named_radius(found.family, found.radius, largest_named_degree);
  if (!number) return std::nullopt;
  long base = 1;
  for (std::size_t level = 0; level < std::max<std::size_t>(found.list.period.size(), 1); ++level)
    base *= found.list.masks.front().arity();
  return NamedExponent{found.sum_rules, base, 1, std::move(*number)};
}

}  // namespace subcert
