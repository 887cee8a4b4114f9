#include "sobolev.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

namespace subcert {

SobolevRegularity sobolev_regularity(const Mask& mask) {
  const int rules = sum_rules(mask), arity = mask.arity();
  require(rules >= 1, "sobolev_regularity: need at least one sum rule, got 0");
  const LaurentPolynomial b = divided_difference_scheme(mask, rules).symbol();
  const LaurentPolynomial autocorrelation = b * b.reversed();
  const long reach = (b.length() - 1) / (arity - 1);
  if (reach > 400) fail(ErrorKind::size, "sobolev_regularity: need masks up to length 400, got {}", b.length());
  const RationalMatrix matrix = central_matrix(autocorrelation, arity);
  const Enclosure radius = largest_root_modulus(characteristic_polynomial(matrix)).largest;
  const Enclosure low = log_ratio(*radius.lower / arity, arity), high = log_ratio(*radius.upper / arity, arity);
  return {rules, radius, {rules - *high.upper / 2, rules - *low.lower / 2}};
}

}  // namespace subcert
