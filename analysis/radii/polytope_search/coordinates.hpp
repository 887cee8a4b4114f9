#pragma once
/// The coordinates that a polytope grows in.

#include "product_search.hpp"

namespace subcert::polytope {

/// Coordinates x' = to x in which orbits are round and the symmetry acts as `action` tells. Those of non-negative
/// polytopes are the coordinates of the family.
struct Coordinates {
  CoordinateChange change;
  GroupAction action;
  std::vector<std::size_t> blocks;  ///< of coordinates on which an element of the symmetry has one sign
};

/// Domain: at least one matrix. Cost: that of orbit_shape and a symmetric eigenvalue problem.
Coordinates working_coordinates(const SearchFamily& family, PolytopeKind kind, const Deadline& deadline);

}  // namespace subcert::polytope
