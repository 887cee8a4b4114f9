#include "sobolev.hpp"

#include "stability.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/radii/joint/cost.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

namespace subcert {
namespace {

constexpr long most_small_coefficients = 120;

}  // namespace

SobolevRegularity sobolev_regularity(const Mask& mask) { return *sobolev_regularity(mask, Deadline::never()); }

std::optional<SobolevRegularity> sobolev_regularity(const Mask& mask, const Deadline& deadline) {
  const ReducedMask other = reduced(mask);
  const bool is_exact = sum_rules(other.mask) >= 1;
  const Mask& used = is_exact ? other.mask : mask;
  const int rules = sum_rules(used), arity = mask.arity();
  require(rules >= 1, "sobolev_regularity: need at least one sum rule, got 0");
  const LaurentPolynomial b = divided_difference_scheme(used, rules).symbol();
  const LaurentPolynomial autocorrelation = b * b.reversed();
  const long reach = (b.length() - 1) / (arity - 1);
  if (reach > 400) fail(ErrorKind::size, "sobolev_regularity: need masks up to length 400, got {}", b.length());
  const auto characteristic = characteristic_polynomial(central_matrix(autocorrelation, arity), deadline);
  if (!characteristic || !radius::has_time_for_roots(*characteristic, deadline)) return std::nullopt;
  const Enclosure radius = largest_root_modulus(*characteristic).largest;
  const Enclosure low = log_ratio(*radius.lower / arity, arity), high = log_ratio(*radius.upper / arity, arity);
  SobolevRegularity result{rules, radius, Enclosure::at_least(rules - *high.upper / 2)};
  if (is_exact) result.exponent.upper = rules - *low.lower / 2;
  return result;
}

std::optional<SobolevRegularity> sobolev_if_small(const Mask& mask, const Deadline& deadline) {
  if (mask.symbol().length() > most_small_coefficients) return std::nullopt;
  return sobolev_regularity(mask, deadline);
}

}  // namespace subcert
