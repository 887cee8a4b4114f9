#pragma once
/// What kind of polytope a norm belongs to: the one notion that the search for a polytope and its proof share.

namespace subcert {

/// The hull a polytope norm is taken over.
enum class PolytopeKind {
  real,         ///< symmetric hull: { sum l_j v_j : sum |l_j| <= 1 }, l_j real
  nonnegative,  ///< cone hull: { x >= 0 : x <= sum l_j v_j, l_j >= 0, sum l_j <= 1 }, vertices and points non-negative
  complex       ///< balanced complex hull of the vertices and their conjugates, l_j complex
};

}  // namespace subcert
