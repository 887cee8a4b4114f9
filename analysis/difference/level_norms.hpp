#pragma once
/// Exact norms of the powers of a subdivision operator.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>
#include <vector>

namespace subcert {

/// norms[l-1] is the maximum norm of S^l, a rational number. Fewer entries than were asked for mean that the deadline
/// passed; those that are there are exact all the same, and the first one is always there.
struct LevelNorms {
  std::vector<Rational> norms;
  std::uint64_t visited = 0;  ///< nodes of the search tree
  std::uint64_t exact = 0;    ///< cosets that had to be summed in exact arithmetic
  std::uint64_t held = 0;     ///< the most cosets that were kept for that at one time, at most most_held
  static constexpr std::uint64_t most_held = 10'000;
};

/// The norms of S, S^2, ..., S^levels. Domain: levels >= 1. Error: none, the numbers are exact.
/// Cost: at most arity^levels products of a matrix of half the mask's length with a vector, fewer by the mirror
/// symmetry of the mask and by branch and bound. A floating point pass with a proved error bound discards the cosets
/// that cannot hold the maximum (docs/level-norms.md); the remaining ones are summed in integers, as soon as most_held
/// of them are kept. Memory: levels * arity vectors of half the mask's length, and what is kept. Ref: [DL02, sec. 4.2].
LevelNorms level_norms(const Mask& mask, int levels, const Deadline& deadline = {});

}  // namespace subcert
