#pragma once
/// Linear systems whose solutions have long numbers, in steps that a deadline can end.

#include <subcert/analysis/symbol/support/budget.hpp>
#include "rational_matrix.hpp"

#include <optional>
#include <vector>

namespace subcert {

/// x with a x = b, checked exactly; nothing past the deadline, and where a is singular, or is so for several primes.
/// Domain: a square with at least one row, as many entries of b. Cost: one inverse modulo a prime, then a product of
/// integers per 62 bits of the solution, and few attempts to read it off. Ref: [Dix82].
std::optional<std::vector<Rational>> lifted_solution(const RationalMatrix& a, const std::vector<Rational>& b,
                                                     const Deadline& deadline);

}  // namespace subcert
