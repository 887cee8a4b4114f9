#pragma once
/// A lower end of the Hoelder exponent from a supersolution of the transfer operator on cells of frequencies.

#include <subcert/analysis/symbol/mask.hpp>

#include <optional>

namespace subcert {

/// The exponent is at least k - log2(1 + excess), k the number of sum rules.
struct FrequencyBound {
  int sum_rules;
  Rational excess;    ///< a short decimal
  Rational exponent;  ///< a proved lower end of the exponent
  int cells;          ///< of each octave of frequencies
};

/// Whether the mask is in the domain of frequency_bound(): binary, symmetric, with two sum rules.
bool has_frequency_bound(const Mask& mask);

/// Nothing where no supersolution on so many cells is found. Domain: has_frequency_bound(mask); cells >=
/// 1, a power of two. Errors: throws a domain error. Error: none, balls decide. Cost: for 200 coefficients and 32
/// cells a tenth of a second; does not grow with the exponent. Ref: docs/theorems/smoothness.tex, Lemma on exponents.
std::optional<FrequencyBound> frequency_bound(const Mask& mask, int cells = 32);

}  // namespace subcert
