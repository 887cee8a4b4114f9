#pragma once
/// Solutions of refinement equations at finitely many points.

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>

#include <optional>
#include <vector>

namespace subcert {

/// The vector x = matrix x with x_0 weights_0 + x_1 weights_1 + ... = 1; nothing where it does not exist or is not the
/// only one. Domain: square, a weight for each row. Errors: throws Error of kind undecided past the deadline. Cost: one
/// lifted solution; where the last equation does not follow from the others, an elimination without end.
std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const std::vector<Rational>& weights,
                                                  const Deadline& deadline = {});
/// With the weights 1, weight, weight, ....
std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const Rational& weight = 1,
                                                  const Deadline& deadline = {});

}  // namespace subcert
