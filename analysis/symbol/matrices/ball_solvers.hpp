#pragma once
/// Linear systems and integrals in balls, for sources (never for public headers).

#include <subcert/analysis/symbol/numbers/balls.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace subcert {

/// x with matrix x = right, where the matrix is proved regular. Domain: square, given row by row, as many rows as
/// `right` has entries. Cost: one inverse in floating point, a few products of balls.
std::optional<std::vector<Ball>> solve(const std::vector<std::vector<Ball>>& matrix, const std::vector<Ball>& right,
                                       slong bits);

/// Whether all symmetric matrices in the balls are proved to be positive definite. Domain: square, given row by row.
bool is_positive_definite(const std::vector<std::vector<Ball>>& matrix, slong bits);

/// Domain: square, given row by row. Cost: one elimination in balls.
Ball determinant(const std::vector<std::vector<Ball>>& matrix, slong bits);

/// The integral of a function along the segment from start to end. Domain: the function is holomorphic wherever it is
/// finite; it gives what is not finite on balls where it is not. Error: aims at 2^-wanted, the ball holds what was
/// reached. Cost: Gauss-Legendre rules on adaptive pieces. Ref: [Joh17].
ComplexBall integral(const std::function<ComplexBall(const ComplexBall&)>& function, const ComplexBall& start,
                     const ComplexBall& end, slong wanted, slong bits);

}  // namespace subcert
