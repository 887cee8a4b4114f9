#pragma once
/// A lower end of the Hoelder exponent from a bound of the radius by frequencies.

#include <subcert/analysis/radii/frequency/frequency_proof.hpp>

namespace subcert {

/// The exponent is at least k - log(bound), to the base of the arity, k the number of sum rules.
struct FrequencyBound {
  int sum_rules;
  FrequencyProof proof;  ///< its bound is 1 and a short decimal
  Rational exponent;     ///< a proved lower end of the exponent, where it is positive
};

/// Nothing where none is found. Domain: coset sums 1; cells >= 1. Errors: throws a domain error. Error: none, balls
/// decide. Cost: that of frequency_proof(); does not grow with the exponent. Ref: SPEC.md, theorems 2 and 35.
std::optional<FrequencyBound> frequency_bound(const Mask& mask, int cells = 32);

}  // namespace subcert
