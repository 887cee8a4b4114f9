#include "frequency_bound.hpp"

#include <subcert/analysis/difference/difference.hpp>

namespace subcert {

std::optional<FrequencyBound> frequency_bound(const Mask& mask, int cells) {
  const int rules = sum_rules(mask);
  std::optional<FrequencyProof> proof = frequency_proof(divided_difference_scheme(mask, rules), cells);
  if (!proof) return std::nullopt;
  const Rational exponent = rules - *log_ratio(proof->bound, mask.arity()).upper;
  return FrequencyBound{rules, std::move(*proof), exponent};
}

}  // namespace subcert
