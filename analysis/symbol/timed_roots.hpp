#pragma once
/// Zeros of polynomials that are given up once the time has passed.

#include "balls.hpp"
#include "budget.hpp"
#include "rational_matrix.hpp"

#include <optional>

namespace subcert {

/// As without a deadline: found with ever more bits, of which each number is begun only where the time of the last one
/// says that it ends, so that nothing is to be guessed beforehand.
std::optional<std::vector<ComplexBall>> complex_roots(const LaurentPolynomial& p, slong bits, const Deadline& deadline);

/// The same for the largest of their moduli.
std::optional<RootModulus> largest_root_modulus(const LaurentPolynomial& p, int bits, const Deadline& deadline);

}  // namespace subcert
