#pragma once
/// The Hoelder exponent in several variables, enclosed with proof.

#include "gram_function.hpp"
#include "radius/joint_spectral_radius.hpp"

#include <subcert/analysis/difference/difference_space.hpp>

namespace subcert {

struct MultivariateRegularity {
  int sum_rules = 0;
  std::optional<DifferenceSpace> space;       ///< nothing without sum rules, or where it grows past its limit
  std::optional<JointSpectralRadius> radius;  ///< of the transition operators on the space
  Decision converges;
  Decision stable;  ///< of the integer shifts; the upper end is claimed only where it is yes
  /// Contains the Hoelder exponent of the limits; absent where no positive lower end is proved, and the upper end where
  /// the shifts are not proved stable.
  Enclosure exponent;
  std::optional<MultivariateSobolev> sobolev;
  std::optional<LatticeSequence> gram;  ///< where the scheme converges

  bool is_exact() const { return stable.is_yes() && radius && radius->exact.is_yes() && exponent.is_bounded(); }
};

/// Domain: any mask with an isotropic dilation. Errors: throws Error otherwise. Error: none, both ends are proved.
/// Cost: as joint_spectral_radius on the difference space of the largest order. Proof: docs/surfaces.md. Ref: [Jia98],
/// [Jia99], [CM19].
MultivariateRegularity multivariate_regularity(const MultivariateMask& mask, const Budget& budget);

}  // namespace subcert
