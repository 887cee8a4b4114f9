#include "derivatives.hpp"

#include "multivariate_regularity.hpp"

#include <subcert/analysis/difference/difference.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace subcert {
namespace {

constexpr int reason_digits = 12;

std::string exponent_reason(const Enclosure& exponent) {
  return "the exponent is " + enclosure_text(exponent, reason_digits);
}

/// No, where fewer sum rules hold than so smooth limits need.
std::optional<Decision> refuted_by_sum_rules(const Mask& mask, long order) {
  const ReducedMask least = reduced(mask);
  const int rules = sum_rules(least.mask);
  if (order < rules || !has_stable_shifts(least.mask).is_yes()) return std::nullopt;
  return Decision{Truth::no, fmt::format("the {}mask has only {} sum rule{}, and its shifts are stable",
                                         least.changes() ? "reduced " : "", rules, rules == 1 ? "" : "s")};
}

/// Of a scheme that converges, order >= 1, beyond what norms prove.
DerivativeProof by_exponent(const Mask& mask, long order, const std::string& obstacle, const ProofLimits& limits) {
  const HolderRegularity found = holder_regularity(mask, limits.levels, {limits.deadline});
  const Truth smooth = has_derivatives(found, order);
  if (smooth == Truth::no) return {{smooth, refutation(found, order)}};
  const std::string reason = exponent_reason(found.proved_exponent());
  if (smooth == Truth::yes && !found.reduced) return {{smooth, reason}};
  const int rules = sum_rules(mask);
  if (order >= rules && smooth == Truth::yes)
    return {{Truth::unknown, fmt::format("{}, but the divided differences need {} sum rules, of which the mask has {}",
                                         reason, order + 1, rules)},
            true};
  return {{Truth::unknown, obstacle}, found.deciding().radius.is_closed()};
}

DerivativeProof of_curve(const Mask& mask, long order, const ProofLimits& limits) {
  Decision convergence = converges(mask, limits);
  if (convergence.truth == Truth::unknown && is_affine(mask))
    if (const Decision by_radius = holder_regularity(mask, limits.levels, {limits.deadline}).converges;
        by_radius.truth != Truth::unknown)
      convergence = by_radius;
  if (order == 0 || !convergence.is_yes()) return {convergence};
  if (order >= sum_rules(mask))
    if (const auto refuted = refuted_by_sum_rules(mask, order)) return {*refuted};
  const SmoothnessProof proof = proved_smoothness(mask, limits);
  if (proof.order >= order) return {{Truth::yes, proof.evidence}};
  if (!is_affine(mask)) return {{Truth::unknown, proof.obstacle}};
  return by_exponent(mask, order, proof.obstacle, limits);
}

/// No where a factor says so, else unknown where one does.
DerivativeProof of_factors(const LatticeMask& mask, const LatticePoint& orders, const ProofLimits& limits) {
  const std::vector<Mask>& factors = mask.factors();
  DerivativeProof all{{Truth::yes, ""}};
  for (std::size_t v = 0; v < factors.size() && !all.decision.is_no(); ++v) {
    DerivativeProof one = of_curve(factors[v], orders[v], limits);
    if (one.decision.is_yes() && v > 0) continue;
    if (!one.decision.is_yes() && factors.size() > 1)
      one.decision.reason = fmt::format("factor {}: {}", v + 1, one.decision.reason);
    if (all.decision.is_yes() || one.decision.is_no()) all = std::move(one);
  }
  return all;
}

DerivativeProof of_surface(const LatticeMask& mask, long total, const ProofLimits& limits) {
  MultivariateRegularity found;
  for (const double share : {0.2, 1.0}) {  // most need little of the time
    found = multivariate_regularity(mask, {limits.deadline.after(share)});
    const auto& exponent = found.exponent.lower;
    if (total == 0 ? found.converges.is_yes() : exponent && *exponent > total) break;
    if (found.converges.is_no() || found.is_closed()) break;
  }
  if (total == 0 || !found.converges.is_yes()) return {found.converges};
  if (found.exponent.lower && *found.exponent.lower > total) return {{Truth::yes, exponent_reason(found.exponent)}};
  return {{Truth::unknown, fmt::format("the exponent is proved to be at least {}, and has to be above {}",
                                       found.exponent.lower_text(reason_digits), total)},
          found.is_closed()};
}

}  // namespace

std::string refutation(const HolderRegularity& regularity, long order) {
  const Enclosure exponent = regularity.proved_exponent();
  if (exponent.upper && *exponent.upper < order) return fmt::format("the exponent is below {}", order);
  return fmt::format("the exponent is at most {}, and the shifts{} are stable", order,
                     regularity.reduced ? " of the reduced mask" : "");
}

DerivativeProof has_derivative(const LatticeMask& mask, const LatticePoint& orders, const ProofLimits& limits) {
  require(orders.size() == static_cast<std::size_t>(mask.dimension()) &&
              std::ranges::all_of(orders, [](long order) { return order >= 0; }),
          "has_derivative: need {} orders >= 0, got {}", mask.dimension(), fmt::join(orders, ","));
  if (mask.has_factors()) return of_factors(mask, orders, limits);
  return of_surface(mask, std::accumulate(orders.begin(), orders.end(), 0L), limits);
}

void require_convergence(const std::string& scheme, const Decision& convergence) {
  if (convergence.is_yes()) return;
  throw NoLimit(fmt::format("{}: no limit function; convergence: {} ({})", scheme, to_text(convergence.truth),
                            convergence.reason),
                {convergence});
}

void require_derivative(const std::string& scheme, const LatticeMask& mask, const LatticePoint& orders,
                        const ProofLimits& limits) {
  const DerivativeProof proof = has_derivative(mask, orders, limits);
  if (proof.decision.is_yes()) return;
  if (std::ranges::all_of(orders, [](long order) { return order == 0; }))
    return require_convergence(scheme, proof.decision);
  throw NoLimit(
      fmt::format("{}: derivative {} is {}; {}", scheme, fmt::join(orders, ","),
                  proof.decision.is_no() ? "not continuous" : "not proved to be continuous", proof.decision.reason),
      proof);
}

}  // namespace subcert
