#include "reduced_mask.hpp"

#include <subcert/analysis/symbol/real_roots.hpp>

#include <numeric>

namespace subcert {

std::optional<long> cyclic_order(const Mask& mask) {
  const int arity = mask.arity();
  // Phi_{m d} | a for all divisors d > 1 of the arity, m coprime to it. Orders k with totient(k) <= degree are at most
  // 7 degree: k / totient(k) < e^gamma log log k + 2.51 / log log k for k >= 3 [RS62], which stays below 7 for
  // 30 <= k <= 10^9; below 30 it is at most 3.
  const long degree = mask.symbol().length() - 1;
  for (long m = 2; arity * m <= 7 * degree; ++m) {
    if (std::gcd(m, static_cast<long>(arity)) != 1) continue;
    bool cyclic = true;
    for (long d = 2; d <= arity && cyclic; ++d)
      if (arity % d == 0)
        cyclic = totient(m * d) <= degree && mask.symbol().exact_quotient(cyclotomic(m * d)).has_value();
    if (cyclic) return m;
  }
  return std::nullopt;
}

ReducedMask reduced(const Mask& mask) {
  ReducedMask result{1, mask};
  for (;;) {
    LaurentPolynomial factor = common_factor_of_cosets(result.mask);
    factor = factor.shifted(-factor.lowest());
    if (factor.length() == 1) {
      const auto order = cyclic_order(result.mask);
      if (!order) return result;
      factor = cyclotomic(*order);
    }
    const int arity = mask.arity();
    result.factor *= factor;
    result.mask = Mask(*(result.mask.symbol() * factor).exact_quotient(factor.dilated(arity)), arity);
  }
}

}  // namespace subcert
