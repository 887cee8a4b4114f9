#pragma once
/// Radii that are roots of rational numbers, by finitely many rational vectors. Inner header.

#include "joint_spectral_radius.hpp"

namespace subcert::radius {

/// That the radius is a known number.
struct ClosedOrbit {
  Rational power;         ///< the radius^length
  int length;             ///< of the products whose images of the vectors stay in the hull of these and their negatives
  std::vector<int> word;  ///< of a product that attains the radius, from left to right
  std::optional<PolytopeProof> proof;  ///< of an upper bound, where there is one of the family itself
};

/// Looks for vectors whose hull is mapped into itself by all products of so many letters, over the power of the radius:
/// for a product that attains the radius where its power is a rational number. Images may lie on the boundary, as all
/// is exact. `words`: products, from left to right, that seem to attain the radius. Nothing where none closes in the
/// time, which is short. Domain: size >= 2. Cost: a small linear program and a linear system for each image.
std::optional<ClosedOrbit> closed_orbit(const MatrixFamily& family, const std::vector<std::vector<int>>& words,
                                        const Budget& budget);

}  // namespace subcert::radius
