#include "holder_regularity.hpp"

#include "stability.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/radii/joint/rounded_family.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <fmt/format.h>

#include <algorithm>

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
int jordan_power_of_one(const std::vector<RationalMatrix>& matrices) {
  int most = -1;
  for (const RationalMatrix& matrix : matrices)
    most = std::max(most, largest_jordan_block(matrix, LaurentPolynomial({-1, 1}, 0)) - 1);
  return most;
}

/// The growth of the largest coefficient of the powers of the divided difference scheme of order s, s the exponent, an
/// integer: docs/single-radius.md, section 4.
GrowthPower growth_at_integer(const Mask& mask, const HolderRegularity& regularity, int exponent,
                              const Deadline& deadline) {
  const int rules = regularity.bounds.sum_rules;
  const Mask scheme = divided_difference_scheme(mask, exponent);
  if (regularity.single.applies.is_yes() && (rules - exponent) % 2 == 0) {
    const LaurentPolynomial& symbol = scheme.symbol();
    const int power = central_growth(symbol.shifted(-(symbol.lowest() + symbol.highest()) / 2), mask.arity()).power;
    return {power, power};
  }
  GrowthPower growth;
  if (regularity.radius.growth.at_most) growth.at_most = *regularity.radius.growth.at_most + (exponent < rules ? 1 : 0);
  const LevelNorms norms = level_norms(scheme, 6, deadline.later(schedule::curve::growth_grace));
  if (std::any_of(norms.norms.begin(), norms.norms.end(), [](const Rational& norm) { return norm <= 1; }))
    growth.at_most = 0;
  else if (scheme.symbol().length() <= 64 * (mask.arity() - 1))
    growth.at_least = std::max(0, jordan_power_of_one(transition_matrices(scheme)));
  return growth;
}

/// Of the divided difference scheme of the largest order: by one spectral radius, or else by norms, products and
/// polytopes.
JointSpectralRadius radius_of(const Mask& derived, const SingleRadius& single, const NormProof& norms,
                              const Budget& budget) {
  JointSpectralRadius result;
  if (single.applies.is_yes()) {
    const CoefficientGrowth& growth = single.growth;
    result = {growth.radius,
              {},
              {Truth::yes, single.applies.reason},
              {growth.power, growth.power},
              SingleRadiusProof{single.symbol, growth}};
    // The radius is an eigenvalue of this letter.
    result.product = {{single.letter}, {*growth.radius.lower, 0}, growth.radius, {}};
    if (growth.radius.is_exact()) result.product.exact = growth.radius.lower;
    return result;
  }
  if (derived.symbol().length() <= most_rows * (derived.arity() - 1))
    return joint_spectral_radius(transition_matrices(derived), budget, norms);
  result.proof = norms;
  result.radius.upper = norms.bound();
  result.exact = {Truth::unknown, "the matrices are too large for polytopes"};
  return result;
}

LogarithmicFactor logarithmic_factor(const Mask& mask, const HolderRegularity& regularity, const Deadline& deadline) {
  const auto unknown = [](const char* reason) { return LogarithmicFactor{0, std::nullopt, std::nullopt, reason}; };
  const Rational& lower = *regularity.exponent.lower;
  if (!(lower > 0)) return unknown("no positive exponent is proved");
  if (!regularity.radius.exact.is_yes()) return unknown("the radius is not known exactly");
  const IntegerExponent exponent = integer_exponent(regularity, mask.arity());
  if (exponent.is_integer == Truth::unknown) return unknown("whether the exponent is an integer is not decided");
  const bool integer = exponent.is_integer == Truth::yes;
  const GrowthPower growth = integer ? growth_at_integer(mask, regularity, exponent.value, deadline)
                                     : regularity.radius.growth;
  LogarithmicFactor result{growth.at_least, growth.at_most, exponent.value - 1,
                           "by the growth of the powers of the difference scheme"};
  if (!integer) result.derivative = static_cast<int>(Integer(numerator(lower) / denominator(lower)));
  if (!regularity.stable.is_yes()) {
    result.at_least = 0;
    result.reason = "the shifts are not proved stable: an upper bound of the modulus";
  }
  return result;
}

/// Whether the product has a real eigenvalue whose modulus is this power of the arity for each letter.
bool has_eigenvalue(const MatrixFamily& family, const std::vector<int>& word, const Rational& modulus,
                    const Deadline& deadline) {
  if (word.empty()) return false;
  const auto product = family.product(word, deadline);
  const auto polynomial = product ? characteristic_polynomial(*product, deadline) : std::nullopt;
  const Rational value = power(modulus, static_cast<long>(word.size()));
  return polynomial && ((*polynomial)(value) == 0 || (*polynomial)(-value) == 0);
}

/// A radius of at least arity^rules, rules the order of the differences, contradicts convergence (docs/families.md).
Decision decide_convergence(const Mask& mask, const HolderRegularity& regularity, int levels, const Deadline& deadline,
                            bool rounded) {
  if (*regularity.exponent.lower > 0) return {Truth::yes, "the exponent is positive"};
  const int rules = regularity.bounds.sum_rules;
  const Rational threshold = power(Rational(mask.arity()), rules);
  Decision large{Truth::no, fmt::format("the joint spectral radius of the differences of order {} is at least {}",
                                        rules, to_text(threshold))};
  const Enclosure& radius = regularity.radius.radius;
  if (radius.lower && *radius.lower >= threshold) return large;
  if (rounded) return {Truth::unknown, "no positive exponent is proved of all masks that are meant"};
  if (radius.contains(threshold) && !regularity.single.applies.is_yes() &&
      mask.symbol().length() <= most_rows * (mask.arity() - 1) &&
      has_eigenvalue(transition_matrices(divided_difference_scheme(mask, rules)), regularity.radius.product.word,
                     threshold, deadline.after(schedule::curve::convergence)))
    return large;
  return converges(mask, {levels, deadline.after(schedule::curve::convergence)});
}

/// The exponent of a scheme that converges is that of the reduced mask.
void use_reduced(HolderRegularity& result, ReducedMask mask, HolderRegularity regularity) {
  if (result.converges.is_yes()) {
    result.exponent.lower = std::max(*result.exponent.lower, *regularity.exponent.lower);
    result.exponent.upper = regularity.exponent.upper;
    if (result.stable.is_no()) result.logarithm = regularity.logarithm;
  }
  result.reduced = std::make_shared<const ReducedRegularity>(ReducedRegularity{std::move(mask), std::move(regularity)});
}

/// What errors of the coefficients make of those of the divided difference scheme of the order of the sum rules.
Rational entry_error(const Mask& mask, const MaskRounding& rounding) {
  const auto step = static_cast<std::size_t>(mask.arity());
  std::vector<Rational> errors(mask.symbol().coefficients().size(), rounding.distance);
  for (int k = 0; k < rounding.sum_rules; ++k) {
    // Times (1 + z)/(1 - z^arity), which has the moduli of the coefficients of (1 - z)/(1 - z^arity).
    for (std::size_t i = errors.size(); i-- > 1;) errors[i] += errors[i - 1];
    for (std::size_t i = step; i < errors.size(); ++i) errors[i] += errors[i - step];
  }
  return power(Rational(mask.arity()), rounding.sum_rules) * *std::max_element(errors.begin(), errors.end());
}

/// The radius of this scheme, and where that stays open a bound by frequencies, if it is lower. Of large matrices that
/// bound comes first, as it takes longer than what may be added to the time.
JointSpectralRadius radius_or_frequencies(const Mask& derived, const SingleRadius& single, const NormProof& norms,
                                          const Budget& budget) {
  constexpr int cells = 32;
  const bool first = derived.symbol().length() > most_rows / 4 && !single.applies.is_yes();
  std::optional<FrequencyProof> found;
  if (first) found = frequency_proof(derived, cells, budget.deadline.after(schedule::curve::frequencies));
  JointSpectralRadius radius = radius_of(derived, single, norms, budget);
  if (radius.exact.is_yes() || radius.is_closed()) return radius;
  if (!first) found = frequency_proof(derived, cells, budget.deadline.later(schedule::curve::frequencies_grace));
  if (!found || found->bound >= *radius.radius.upper) return radius;
  radius.radius.upper = found->bound;
  radius.proof = std::move(*found);
  return radius;
}

/// Without a look at other masks.
HolderRegularity own_regularity(const Mask& mask, int levels, const Budget& budget,
                                const std::optional<MaskRounding>& rounding, int bits) {
  HolderRegularity result;
  result.bounds = holder_bounds(mask, levels, budget.deadline.after(schedule::curve::norms));
  const int rules = result.bounds.sum_rules, arity = mask.arity();
  const Mask derived = divided_difference_scheme(mask, rules);
  if (rounding) {
    require(rounding->sum_rules == rules, "holder_regularity: need a rounded mask with {} sum rules, got {}",
            rounding->sum_rules, rules);
    const radius::RoundedFamily family(transition_matrices(derived), entry_error(mask, *rounding),
                                       {rounding->symmetric, true});
    for (HolderBound& bound : result.bounds.levels)
      bound = holder_bound(bound.levels, bound.norm + family.change_of_products(bound.levels), rules, arity);
    result.stable = budget.deadline.expired()
                        ? Decision{Truth::unknown, "whether shifts are stable was not decided in time"}
                        : has_stable_shifts(mask, rounding->distance, rules);
    result.single.applies = {Truth::unknown, "the coefficients are rounded"};
    const HolderBound& best = result.bounds.best();
    result.radius = family.radius({best.levels, best.norm}, budget, bits + 2);
  } else {
    const HolderBound& best = result.bounds.best();
    result.stable = has_stable_shifts(mask);
    result.single = single_spectral_radius(derived);
    result.radius = radius_or_frequencies(derived, result.single, {best.levels, best.norm}, budget);
  }
  // Two bits are lost by the logarithm and by both ends.
  if (!rounding && result.radius.exact.is_yes() && derived.symbol().length() <= most_rows * (arity - 1))
    sharpen(result.radius, transition_matrices(derived), bits + 2, budget.deadline);
  const HolderBound& best = result.bounds.best();
  const Enclosure& radius = result.radius.radius;
  result.exponent = Enclosure::at_least(
      std::max(*best.exponent.lower, Rational(rules - *log_ratio(*radius.upper, arity, bits + 2).upper)));
  // A radius of 1 says nothing from above; larger ones do, and so does the number of sum rules
  // (proofs-checks/certificates/SPEC.md, theorems 3 and 23).
  if (result.stable.is_yes()) {
    if (radius.lower && *radius.lower > 1)
      result.exponent.upper = rules - *log_ratio(*radius.lower, arity, bits + 2).lower;
    else if (!rounding)
      result.exponent.upper = rules;
  }
  result.converges = decide_convergence(mask, result, levels, budget.deadline, rounding.has_value());
  result.logarithm = logarithmic_factor(mask, result, budget.deadline);
  return result;
}

}  // namespace

HolderRegularity holder_regularity(const Mask& mask, int levels, const Budget& budget, HolderProof proof,
                                   const std::optional<MaskRounding>& rounding, int bits) {
  if (rounding) return own_regularity(mask, levels, budget, rounding, bits);
  ReducedMask other = reduced(mask);
  const bool needed = other.changes() && is_affine(other.mask) &&
                      (proof == HolderProof::certificate || has_stable_shifts(mask).is_no());
  if (!needed) return own_regularity(mask, levels, budget, rounding, bits);
  // First the one that tells the exponent: what the proofs of the other take beyond its share is not its loss.
  HolderRegularity stable = own_regularity(
      other.mask, levels, {budget.deadline.after(schedule::curve::reduced), budget.memory}, rounding, bits);
  HolderRegularity result = own_regularity(mask, levels, budget, rounding, bits);
  use_reduced(result, std::move(other), std::move(stable));
  return result;
}

Enclosure HolderRegularity::proved_exponent() const {
  if (!converges.is_yes()) return {};
  return {std::max(Rational(0), *exponent.lower), exponent.upper};
}

Truth has_derivatives(const HolderRegularity& regularity, const Rational& order) {
  const Enclosure& exponent = regularity.exponent;
  if (*exponent.lower > order) return Truth::yes;
  if (regularity.converges.is_no()) return Truth::no;
  if (regularity.reduced && regularity.converges.is_yes()) return has_derivatives(regularity.deciding(), order);
  if (!exponent.upper) return Truth::unknown;
  const bool decided = (exponent.is_exact() && *exponent.lower == order) ||
                       (*exponent.upper == order && order == regularity.bounds.sum_rules);
  return *exponent.upper < order || (decided && regularity.stable.is_yes()) ? Truth::no : Truth::unknown;
}

}  // namespace subcert
