#pragma once
/// Exact norms of the powers of a subdivision operator.

#include <subcert/analysis/symbol/mask.hpp>

#include <cstdint>
#include <vector>

namespace subcert {

/// norms[l-1] is the maximum norm of S^l, a rational number. Fewer entries than were asked for mean that the time ran
/// out; those that are there are exact all the same.
struct LevelNorms {
  std::vector<Rational> norms;
  std::uint64_t visited = 0;  ///< nodes of the search tree
  std::uint64_t exact = 0;    ///< residue classes that had to be summed in exact arithmetic
};

/// The norms of S, S^2, ..., S^levels. Domain: levels >= 1, seconds > 0. Error: none, the numbers are exact.
/// Cost: at most arity^levels products of a matrix of half the mask's length with a vector, fewer by the mirror
/// symmetry of the mask and by branch and bound. A floating point pass with a proved error bound discards the residue
/// classes that cannot hold the maximum (docs/level-norms.md); the remaining ones are summed in integers.
/// Ref: [DL02, sec. 4.2].
LevelNorms level_norms(const Mask& mask, int levels, double seconds = 1e9);

}  // namespace subcert
