#pragma once
/// Certified maxima of the variance curve beside the limit C_d of n max psi.

#include "decay.hpp"

#include <optional>
#include <string>
#include <vector>

namespace subcert::conjectures {

/// n max psi / C_d - 1 for one degree. The limit for n to infinity is 0, like 1 / (4n) (docs/limit-constants.md).
struct LimitComparison {
  int degree;
  Enclosure constant;                       ///< C_d
  std::vector<CertifiedMaximum> deviation;  ///< n max psi / C_d - 1 for each n
  /// The deviation falls like n^-r from n = rate_from to the last; nothing for a single n. An end is absent where the
  /// deviation is not proved to be positive.
  int rate_from = 0;
  std::optional<Enclosure> exponent;

  std::string sentence() const;
};

/// `maxima`: max psi for each n, as decay_finding takes them. Nothing for degrees above 99, whose constants are not
/// computed. Domain: at least one value, n increasing. Cost: milliseconds to a second, by the degree. Ref: [LC, thm 5].
std::optional<LimitComparison> limit_comparison(int degree, const std::vector<CertifiedMaximum>& maxima);

}  // namespace subcert::conjectures
