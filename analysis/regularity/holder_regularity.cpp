#include "holder_regularity.hpp"

#include "stability.hpp"
#include "transition.hpp"

#include <subcert/analysis/difference/difference.hpp>

#include <algorithm>
#include <chrono>

namespace subcert {

HolderRegularity holder_regularity(const Mask& mask, int levels, double seconds) {
  const auto start = std::chrono::steady_clock::now();
  HolderRegularity result{holder_bounds(mask, levels, seconds / 2), {}, {}, {}};
  const HolderBound& best = result.bounds.best();
  result.exponent = Enclosure::at_least(*best.exponent.lower);
  result.stable = has_stable_shifts(mask);
  const Mask derived = divided_difference_scheme(mask, result.bounds.sum_rules);
  const KnownNorm known{best.levels, best.norm};
  if (derived.symbol().length() > 256 * (mask.arity() - 1)) {
    result.radius.method = JsrMethod::norm_of_products;
    result.radius.norm_level = best.levels;
    result.radius.radius.upper = root_enclosure(best.norm, best.levels).upper;
    return result;
  }
  const auto matrices = transition_matrices(derived);
  const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.radius = joint_spectral_radius(matrices, std::max(seconds - spent, 0.1 * seconds), known);
  const Enclosure& radius = result.radius.radius;
  const int rules = result.bounds.sum_rules, arity = mask.arity();
  result.exponent.lower = std::max(*result.exponent.lower, Rational(rules - *log_ratio(*radius.upper, arity).upper));
  // A radius of 1 says nothing from above; larger ones do (proofs-checks/certificates/SPEC.md).
  if (result.stable.is_yes() && radius.lower && *radius.lower > 1)
    result.exponent.upper = rules - *log_ratio(*radius.lower, arity).lower;
  return result;
}

}  // namespace subcert
