#pragma once
/// Sums of congruences, which map positive semidefinite matrices to such, for sources (never for public headers).

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>
#include <vector>

namespace subcert::radius {

/// Rows of balls.
using BallMatrix = std::vector<std::vector<Ball>>;

/// The spectral radius of X -> sum of A X A^T over the matrices, on symmetric X: the number of matrices times the
/// square of their 2-radius. Domain: square matrices of one size, at most 22. Error: holds it for all matrices in the
/// balls; relative width below 2^-bits. Nothing where the balls are too wide, it is 0 without being a number, or the
/// deadline comes first. Cost: some ten linear systems of n(n+1)/2 unknowns. Proof: docs/vectors.md, section 8.
std::optional<Enclosure> radius_of_congruences(const std::vector<BallMatrix>& matrices, int bits,
                                               const Deadline& deadline);

/// The precision of the balls that this needs, for entries of moderate size.
constexpr slong bits_for_congruences(int bits) { return 3 * static_cast<slong>(bits) + 256; }

}  // namespace subcert::radius
