#include "multivariate_regularity.hpp"

#include <subcert/analysis/difference/multivariate_convergence.hpp>
#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr double sobolev_share = 0.2, stability_share = 0.5;
constexpr std::size_t largest_space = 256;

/// -log of the radius, to the base by which the dilation expands.
Enclosure exponent_of(const Enclosure& radius, const Dilation& dilation) {
  const Rational variables = static_cast<long>(dilation.variables());
  const int classes = static_cast<int>(dilation.classes());
  Enclosure result;
  if (radius.upper && *radius.upper > 0) result.lower = -variables * *log_ratio(*radius.upper, classes).upper;
  if (radius.lower && *radius.lower > 0) result.upper = -variables * *log_ratio(*radius.lower, classes).lower;
  return result;
}

void prove_stability(const MultivariateMask& mask, const Deadline& deadline, MultivariateRegularity& result) {
  try {
    result.gram = gram_function(mask, deadline);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
    result.stable = {Truth::unknown, error.what()};
    return;
  }
  result.stable = result.gram ? has_stable_shifts(*result.gram, deadline)
                              : Decision{Truth::unknown, "the inner products of the shifts were not found in time"};
}

}  // namespace

MultivariateRegularity multivariate_regularity(const MultivariateMask& mask, const Budget& budget) {
  const Dilation& dilation = mask.dilation();
  require(dilation.is_isotropic(), "multivariate_regularity: need an isotropic dilation, got {}", dilation.to_text());
  MultivariateRegularity result;
  result.stable = {Truth::unknown, "the scheme is not proved to converge"};
  const auto sums = coset_sums(mask);
  if (!std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 1; })) {
    result.converges = converges(mask);
    return result;
  }
  result.sum_rules = polynomial_reproduction(mask).sum_rules;
  const Deadline sobolev_end = budget.deadline.after(sobolev_share);
  try {
    result.space = difference_space(mask, result.sum_rules);
    result.sobolev = sobolev_regularity(mask, result.sum_rules, sobolev_end);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
  }
  if (!result.space || result.space->family.size() > largest_space) {
    result.converges = converges(mask, {16, budget.deadline});
    return result;
  }
  result.radius = joint_spectral_radius(result.space->family, budget);
  const Enclosure exponent = exponent_of(result.radius->radius, dilation);
  if (!exponent.lower || *exponent.lower <= 0) {
    result.converges = converges(mask, {16, Deadline::in(std::max(budget.deadline.remaining(), 0.5))});
    return result;
  }
  result.converges = {Truth::yes, "the exponent is positive"};
  result.exponent.lower = exponent.lower;
  prove_stability(mask, Deadline::in(std::max(stability_share * budget.deadline.remaining(), 5.0)), result);
  // Differences of order m say nothing about exponents from m on.
  if (result.stable.is_yes() && exponent.upper && *exponent.upper < result.sum_rules)
    result.exponent.upper = exponent.upper;
  return result;
}

}  // namespace subcert
