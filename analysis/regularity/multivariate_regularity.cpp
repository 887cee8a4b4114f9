#include "multivariate_regularity.hpp"

#include "holder_regularity.hpp"
#include "sobolev.hpp"
#include "value_space.hpp"

#include <subcert/analysis/difference/multivariate_convergence.hpp>
#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/index_arithmetic.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr double norm_share = 0.05, sobolev_share = 0.2, stability_share = 0.5;  // of the time that is left
constexpr int levels = 16;  // of norms, where they decide convergence
constexpr std::size_t largest_space = 256;

/// Provided that the scheme converges.
void decide_stability(const MultivariateMask& mask, const Deadline& deadline, MultivariateRegularity& result) {
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

/// Provided that phi is continuous.
std::optional<MultivariateSobolev> decide_sobolev(const MultivariateMask& mask, const Deadline& deadline,
                                                  const MultivariateRegularity& result) {
  if (result.gram && !result.stable.is_yes())
    if (auto found = sobolev_regularity(mask, *result.gram, deadline)) return found;
  auto found = sobolev_regularity(mask, result.sum_rules, deadline);
  if (found && !result.stable.is_yes()) found->exponent.upper.reset();
  return found;
}

/// Where the shifts are not proved stable the differences of phi, as those of the scheme give no upper end.
DifferenceSpace space_of_differences(const MultivariateMask& mask, const MultivariateRegularity& result,
                                     const std::optional<MultivariateSobolev>& sobolev) {
  if (!result.stable.is_yes() && sobolev && sobolev->exponent.upper) {
    // The exponent is at most the Sobolev exponent.
    const int order = static_cast<int>(floor_index(*sobolev->exponent.upper)) + 1;
    if (auto space = value_space(mask, order)) return std::move(*space);
  }
  return difference_space(mask, result.sum_rules);
}

}  // namespace

Enclosure exponent_of_radius(const Enclosure& radius, const Dilation& dilation) {
  const auto variables = static_cast<long>(dilation.variables());
  const int classes = static_cast<int>(dilation.classes());
  Enclosure result;
  if (radius.upper && *radius.upper > 0) result.lower = -*log_ratio(power(*radius.upper, variables), classes).upper;
  if (radius.lower && *radius.lower > 0) result.upper = -*log_ratio(power(*radius.lower, variables), classes).lower;
  return result;
}

MultivariateRegularity multivariate_regularity(const MultivariateMask& mask, const Budget& budget) {
  const Dilation& dilation = mask.dilation();
  require(dilation.is_isotropic(), "regularity: need an isotropic dilation or a tensor product, got the dilation {}",
          dilation.to_text());
  MultivariateRegularity result;
  result.stable = {Truth::unknown, "the scheme is not proved to converge"};
  const auto sums = coset_sums(mask);
  if (!std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 1; })) {
    result.converges = converges(mask);
    return result;
  }
  result.sum_rules = polynomial_reproduction(mask).sum_rules;
  decide_stability(mask, Deadline::in(std::max(stability_share * budget.deadline.remaining(), 5.0)), result);
  std::optional<MultivariateSobolev> sobolev;
  try {
    sobolev = decide_sobolev(mask, budget.deadline.after(sobolev_share), result);
    result.space = space_of_differences(mask, result, sobolev);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
  }
  Enclosure exponent;
  if (result.space && result.space->family.size() <= largest_space) {
    const NormProof norms = norm_of_products(result.space->family, {budget.deadline.after(norm_share), budget.memory});
    result.bound = HolderBound{norms.level, norms.norm,
                               exponent_of_radius(root_enclosure(norms.norm, norms.level), dilation)};
    result.radius = joint_spectral_radius(result.space->family, budget, norms);
    result.exact = result.radius->exact;
    exponent = exponent_of_radius(result.radius->radius, dilation);
  } else {
    result.exact = {Truth::unknown, "the transition operators act on too many lattice points"};
  }
  const bool continuous = exponent.lower && *exponent.lower > 0,
             of_values = result.space && result.space->is_of_values();
  if (continuous && !of_values)
    result.converges = {Truth::yes, "the exponent is positive"};
  else
    result.converges = converges(mask, {levels, Deadline::in(std::max(budget.deadline.remaining(), 0.5))});
  if (!continuous && !result.converges.is_yes()) {
    result.gram.reset();
    result.stable = {Truth::unknown, "the scheme is not proved to converge"};
    if (sobolev) result.sobolev = Enclosure::at_least(*sobolev->exponent.lower);
    return result;
  }
  if (sobolev) result.sobolev = sobolev->exponent;
  // Differences of order m say nothing about exponents from m on.
  const int order = result.space ? result.space->order : 0;
  if (!exponent.upper || *exponent.upper >= order || !(of_values || result.stable.is_yes())) exponent.upper.reset();
  if (exponent.lower && *exponent.lower > order) exponent.lower = order;
  result.exponent = {std::max(Rational(0), exponent.lower.value_or(0)), exponent.upper};
  if (!result.sobolev) return result;
  // H^r lies in the Hoelder space of exponent r - s/2, and functions of compact support and Hoelder exponent r in all
  // H^(r - epsilon).
  result.exponent.lower = std::max(*result.exponent.lower,
                                   Rational(*result.sobolev->lower - Rational(mask.dimension(), 2)));
  if (result.sobolev->upper && (!exponent.upper || *result.sobolev->upper < *exponent.upper))
    result.exponent.upper = result.sobolev->upper;
  return result;
}

bool MultivariateRegularity::is_closed() const {
  if (radius) return radius->is_closed();
  return exponent.is_bounded() && *exponent.upper - *exponent.lower < power(Rational(10), -12);
}

MultivariateRegularity tensor_product_regularity(const std::vector<Mask>& factors, const Budget& budget) {
  require(!factors.empty(), "tensor_product_regularity: need at least one factor, got none");
  MultivariateRegularity result;
  result.converges = {Truth::yes, "every factor converges"};
  result.stable = {Truth::yes, "the shifts of every factor are stable"};
  std::vector<HolderRegularity> regularities;
  std::vector<SobolevRegularity> sobolev;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const Deadline share = budget.deadline.after(1.0 / static_cast<double>(factors.size() - k));
    regularities.push_back(holder_regularity(factors[k], levels, {share, budget.memory}));
    const HolderRegularity& one = regularities.back();
    if (!one.stable.is_yes() && !result.stable.is_no()) result.stable = one.stable;
    if (!(*one.exponent.lower > 0)) {
      const Decision decision = converges(factors[k]);
      if (!decision.is_yes() && !result.converges.is_no()) result.converges = decision;
    }
    const auto found = one.bounds.sum_rules >= 1 ? sobolev_regularity(factors[k], budget.deadline) : std::nullopt;
    if (found) sobolev.push_back(*found);
  }
  const auto by_lower_end = [](const auto& a, const auto& b) { return *a.exponent.lower < *b.exponent.lower; };
  const auto roughest = std::min_element(regularities.begin(), regularities.end(), by_lower_end);
  result.sum_rules = std::min_element(regularities.begin(), regularities.end(), [](const auto& a, const auto& b) {
                       return a.bounds.sum_rules < b.bounds.sum_rules;
                     })->bounds.sum_rules;
  result.exact = roughest->radius.exact;
  if (sobolev.size() == factors.size())
    result.sobolev = std::min_element(sobolev.begin(), sobolev.end(), by_lower_end)->exponent;
  if (!result.stable.is_yes() && result.sobolev) result.sobolev->upper.reset();
  if (!(*roughest->exponent.lower > 0)) return result;
  result.exponent.lower = roughest->exponent.lower;
  // The smallest exponent is at most the upper end of any.
  for (const HolderRegularity& one : regularities)
    if (one.exponent.upper && (!result.exponent.upper || *one.exponent.upper < *result.exponent.upper))
      result.exponent.upper = one.exponent.upper;
  return result;
}

}  // namespace subcert
