#include "holder_regularity.hpp"

#include "stability.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/real_roots.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <chrono>

namespace subcert {
namespace {

constexpr long most_rows = 256;

/// Where the exponent stands among the integers.
struct IntegerExponent {
  Truth is_integer;
  int value = 0;
};

IntegerExponent integer_exponent(const HolderRegularity& regularity, int arity) {
  const Enclosure& radius = regularity.radius.radius;
  const int rules = regularity.bounds.sum_rules;
  for (int k = 0; k <= rules; ++k) {
    const Rational candidate = power(Rational(arity), k);
    if (!radius.contains(candidate)) continue;
    if (radius.is_exact()) return {Truth::yes, rules - k};
    // There an inexact radius is an irrational one.
    if (regularity.single.applies.is_yes()) return {Truth::no};
    return {Truth::unknown};
  }
  return {Truth::no};
}

/// The largest k such that some transition matrix has a Jordan block of size k + 1 for the eigenvalue 1; -1 without
/// that eigenvalue.
int jordan_power(const std::vector<RationalMatrix>& matrices) {
  int most = -1;
  for (const RationalMatrix& matrix : matrices) {
    RationalMatrix shifted = matrix;
    for (std::size_t i = 0; i < shifted.rows(); ++i) shifted(i, i) -= 1;
    RationalMatrix product = shifted;
    std::size_t nullity = kernel(product).size();
    for (int size = 1; nullity > 0; ++size) {
      most = std::max(most, size - 1);
      product = product * shifted;
      const std::size_t next = kernel(product).size();
      if (next == nullity) break;
      nullity = next;
    }
  }
  return most;
}

/// The growth of the largest coefficient of the powers of the divided difference scheme of order s, s the exponent, an
/// integer: docs/single-radius.md, section 4.
GrowthPower growth_at_integer(const Mask& mask, const HolderRegularity& regularity, int exponent) {
  const int rules = regularity.bounds.sum_rules;
  const Mask scheme = divided_difference_scheme(mask, exponent);
  if (regularity.single.applies.is_yes() && (rules - exponent) % 2 == 0) {
    const LaurentPolynomial& symbol = scheme.symbol();
    const int power = central_growth(symbol.shifted(-(symbol.lowest() + symbol.highest()) / 2), mask.arity()).power;
    return {power, power};
  }
  GrowthPower growth;
  if (regularity.radius.growth.at_most) growth.at_most = *regularity.radius.growth.at_most + (exponent < rules ? 1 : 0);
  const LevelNorms norms = level_norms(scheme, 6);
  if (std::any_of(norms.norms.begin(), norms.norms.end(), [](const Rational& norm) { return norm <= 1; }))
    growth.at_most = 0;
  else if (scheme.symbol().length() <= 64 * (mask.arity() - 1))
    growth.at_least = std::max(0, jordan_power(transition_matrices(scheme)));
  return growth;
}

/// Makes one transition matrix the product, in the block where its leading eigenvalue is.
void prove_letter(const std::vector<RationalMatrix>& matrices, int letter, JointSpectralRadius& radius) {
  if (!radius.triangular) {
    radius.product = prove_product(matrices, {letter});
    return;
  }
  for (std::size_t k = 0; k < radius.blocks.size(); ++k) {
    ProductEvidence evidence = prove_product(radius.triangular->block(k), {letter});
    if (k > 0 && *evidence.radius.lower <= *radius.product.radius.lower) continue;
    radius.product = std::move(evidence);
    radius.leading_block = k;
  }
}

LogarithmicFactor logarithmic_factor(const Mask& mask, const HolderRegularity& regularity) {
  const auto unknown = [](const char* reason) { return LogarithmicFactor{0, std::nullopt, std::nullopt, reason}; };
  const Rational& lower = *regularity.exponent.lower;
  if (!(lower > 0)) return unknown("no positive exponent is proved");
  if (!regularity.radius.exact.is_yes()) return unknown("the radius is not known exactly");
  const IntegerExponent exponent = integer_exponent(regularity, mask.arity());
  if (exponent.is_integer == Truth::unknown) return unknown("whether the exponent is an integer is not decided");
  const bool integer = exponent.is_integer == Truth::yes;
  const GrowthPower growth = integer ? growth_at_integer(mask, regularity, exponent.value) : regularity.radius.growth;
  LogarithmicFactor result{growth.at_least, growth.at_most, exponent.value - 1,
                           "by the growth of the powers of the difference scheme"};
  if (!integer) result.derivative = static_cast<int>(Integer(numerator(lower) / denominator(lower)));
  if (!regularity.stable.is_yes()) {
    result.at_least = 0;
    result.reason = "the shifts are not proved stable: an upper bound of the modulus";
  }
  return result;
}

}  // namespace

HolderRegularity holder_regularity(const Mask& mask, int levels, double seconds, HolderProof proof) {
  const auto start = std::chrono::steady_clock::now();
  HolderRegularity result{holder_bounds(mask, levels, seconds / 2), {}, {}, {}, {}, {}};
  const HolderBound& best = result.bounds.best();
  const int rules = result.bounds.sum_rules, arity = mask.arity();
  result.stable = has_stable_shifts(mask);
  const Mask derived = divided_difference_scheme(mask, rules);
  result.single = single_spectral_radius(derived);

  JointSpectralRadius& radius = result.radius;
  radius.method = JsrMethod::norm_of_products;
  radius.norm_level = best.levels;
  radius.certified_upper = *root_enclosure(best.norm, best.levels).upper;
  radius.radius.upper = radius.certified_upper;
  radius.exact = {Truth::unknown, "the matrices are too large for polytopes"};
  const bool single = result.single.applies.is_yes();
  if (derived.symbol().length() <= most_rows * (arity - 1)) {
    const auto matrices = transition_matrices(derived);
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!single || proof == HolderProof::certificate)
      radius = joint_spectral_radius(matrices, std::max(seconds - spent, 0.1 * seconds),
                                     KnownNorm{best.levels, best.norm});
    if (single) prove_letter(matrices, result.single.letter, radius);
  }
  if (single) {
    radius.method = JsrMethod::single_spectral_radius;
    radius.radius = result.single.growth.radius;
    radius.exact = {Truth::yes, result.single.applies.reason};
    radius.closed = true;
    radius.growth = {result.single.growth.power, result.single.growth.power};
  }
  result.exponent = Enclosure::at_least(
      std::max(*best.exponent.lower, Rational(rules - *log_ratio(*radius.radius.upper, arity).upper)));
  // A radius of 1 says nothing from above; larger ones do (proofs-checks/certificates/SPEC.md).
  if (result.stable.is_yes() && radius.radius.lower && *radius.radius.lower > 1)
    result.exponent.upper = rules - *log_ratio(*radius.radius.lower, arity).lower;
  result.logarithm = logarithmic_factor(mask, result);
  return result;
}

}  // namespace subcert
