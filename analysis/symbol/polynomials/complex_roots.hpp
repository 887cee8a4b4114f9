#pragma once
/// Values and zeros of polynomials as balls.

#include "laurent_polynomial.hpp"

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>
#include <vector>

namespace subcert {

/// The value of a polynomial. Domain: p not zero, lowest exponent 0 or more.
ComplexBall value_at(const LaurentPolynomial& p, const ComplexBall& z);

/// The zeros, disjoint balls of relative accuracy 2^-bits. Domain: no multiple zeros, lowest exponent 0.
std::vector<ComplexBall> complex_roots(const LaurentPolynomial& p, slong bits);

/// As without a deadline: found with ever more bits, of which each number is begun only where the time of the last one
/// says that it ends, so that nothing is to be guessed beforehand.
std::optional<std::vector<ComplexBall>> complex_roots(const LaurentPolynomial& p, slong bits, const Deadline& deadline);

/// Of a polynomial known in balls, the lowest coefficient first, for all points of them; nothing where the zeros are
/// not separated. Domain: a degree >= 1, the last coefficient not 0.
std::optional<std::vector<ComplexBall>> complex_roots(const std::vector<Ball>& coefficients);

}  // namespace subcert
