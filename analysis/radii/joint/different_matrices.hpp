#pragma once
/// Matrices that occur more than once in a family count once. Inner header.

#include "joint_spectral_radius.hpp"

#include <optional>
#include <vector>

namespace subcert::radius {

/// A family without matrices that occur before.
struct DifferentMatrices {
  const MatrixFamily* whole;
  std::optional<MatrixFamily> fewer;   ///< where some occur before: large families are not copied
  std::vector<std::size_t> originals;  ///< the matrix of the family that is this one
  std::vector<std::size_t> places;     ///< of each matrix of the family, among the different ones
  std::vector<bool> opposite;          ///< whether it is -1 times the one at its place
  bool are_fewer() const { return originals.size() < places.size(); }
  const MatrixFamily& family() const { return fewer ? *fewer : *whole; }
};

/// `up_to_sign`: of opposite ones that stays whose first entry is negative, so that no cone, which -1 does not keep,
/// is looked for; and no use is made of a group then. Domain: the family outlives the result.
DifferentMatrices different_matrices(const MatrixFamily& family, bool up_to_sign = false);

/// The proof for the family from that for its different matrices.
void expand(JointSpectralRadius& radius, const DifferentMatrices& different);
void expand(GraphProof& proof, const DifferentMatrices& different);

}  // namespace subcert::radius
