#include "multivariate_regularity.hpp"

#include "holder_regularity.hpp"
#include "sobolev.hpp"

#include <subcert/analysis/difference/multivariate_convergence.hpp>
#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert {
namespace {

constexpr double norm_share = 0.05, sobolev_share = 0.2, stability_share = 0.5;  // of the time that is left
constexpr int levels = 16;  // of norms, where they decide convergence
constexpr std::size_t largest_space = 256;

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
  std::optional<MultivariateSobolev> sobolev;
  try {
    result.space = difference_space(mask, result.sum_rules);
    sobolev = sobolev_regularity(mask, result.sum_rules, budget.deadline.after(sobolev_share));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
  }
  if (sobolev) result.sobolev = Enclosure::at_least(*sobolev->exponent.lower);
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
  if (exponent.lower && *exponent.lower > 0)
    result.converges = {Truth::yes, "the exponent is positive"};
  else
    result.converges = converges(mask, {levels, Deadline::in(std::max(budget.deadline.remaining(), 0.5))});
  if (!result.converges.is_yes()) return result;
  prove_stability(mask, Deadline::in(std::max(stability_share * budget.deadline.remaining(), 5.0)), result);
  if (sobolev && result.stable.is_yes()) result.sobolev = sobolev->exponent;
  // Differences of order m say nothing about exponents from m on.
  if (!exponent.upper || *exponent.upper >= result.sum_rules || !result.stable.is_yes()) exponent.upper.reset();
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
