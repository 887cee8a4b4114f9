#include "stability.hpp"

#include <subcert/analysis/symbol/real_roots.hpp>

#include <numeric>

namespace subcert {

Decision has_stable_shifts(const Mask& mask) {
  const int arity = mask.arity();
  // Zeros shared by z, zeta z, ..., zeta^(a-1) z are the a-th roots of the common zeros of the cosets.
  const LaurentPolynomial common = common_factor_of_cosets(mask);
  if (common.is_zero() || has_root_on_unit_circle(common))
    return {Truth::no, "the sub-symbols have a common zero on the unit circle"};
  // Cyclic zeros of a rational symbol: an m coprime to the arity with Phi_{m d} | a for all divisors d > 1 of it.
  const long degree = mask.symbol().length() - 1;
  // Orders k with totient(k) <= degree are at most 7 degree: k / totient(k) < e^gamma log log k + 2.51 / log log k for
  // k >= 3 [RS62], which stays below 7 for 30 <= k <= 10^9; below 30 it is at most 3.
  for (long m = 2; arity * m <= 7 * degree; ++m) {
    if (std::gcd(m, static_cast<long>(arity)) != 1) continue;
    bool cyclic = true;
    for (long d = 2; d <= arity && cyclic; ++d)
      if (arity % d == 0)
        cyclic = totient(m * d) <= degree && mask.symbol().exact_quotient(cyclotomic(m * d)).has_value();
    if (cyclic) return {Truth::no, "the symbol vanishes on a cycle of roots of unity of order " + std::to_string(m)};
  }
  return {Truth::yes, common.length() == 1 ? "the sub-symbols have no common zero, and there are no cyclic zeros"
                                           : "no common zero of the sub-symbols lies on the unit circle, and there are "
                                             "no cyclic zeros"};
}

}  // namespace subcert
