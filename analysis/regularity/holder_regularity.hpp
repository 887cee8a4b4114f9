#pragma once
/// The Hoelder exponent, enclosed with proof.

#include "holder_bound.hpp"
#include "joint_spectral_radius.hpp"

namespace subcert {

struct HolderRegularity {
  HolderBounds bounds;         ///< by norms of the difference scheme, level by level
  JointSpectralRadius radius;  ///< of the transition matrices of the divided difference scheme of order sum_rules
  Decision stable;             ///< of the integer shifts; the upper end is claimed only where it is yes
  /// Contains the Hoelder exponent of the limits; the lower end holds where it is positive, and then proves convergence.
  Enclosure exponent;
};

/// Domain: coset sums 1; levels >= 1, seconds > 0; at most 256 rows in the transition matrices (larger masks keep the
/// bounds by norms). Errors: throws std::invalid_argument. Error: none, both ends are proved; see
/// joint_spectral_radius for the width. Ref: [Rio92], [JW93], [GP13].
HolderRegularity holder_regularity(const Mask& mask, int levels, double seconds);

}  // namespace subcert
