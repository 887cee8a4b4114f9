#pragma once
/// Exact values of the basic limit function at rational points.

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/mask.hpp>

#include <vector>

namespace subcert {

/// values[i] = phi(x + first + i), for all integers where x + first + i lies in the closed support.
struct ShiftedValues {
  long first;
  std::vector<Rational> values;
};

/// Domain: the scheme converges; x runs into a cycle of at most 64 points under multiplication by the arity modulo 1,
/// as every rational does whose denominator is small; at most 1,500 integers in the support. Errors: throws
/// Error, of kind domain where the refinement equation does not determine the values, of kind size beyond these sizes,
/// of kind undecided past the deadline.
/// Cost: one exact elimination of the size of the support, and products of such matrices along the cycle. Proof:
/// docs/limit-values.md.
ShiftedValues limit_values_at(const Mask& mask, const Rational& x, const Deadline& deadline = {});

}  // namespace subcert
