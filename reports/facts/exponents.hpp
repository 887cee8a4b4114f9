#pragma once
/// Facts about exponents and radii, of whatever they are.

#include "fact.hpp"

#include <subcert/analysis/regularity/holder_bound.hpp>
#include <subcert/analysis/regularity/radius/joint_spectral_radius.hpp>

namespace subcert::facts {

/// {"levels", "norm", "holder"}.
Json bound_json(const HolderBound& bound);

/// By which kind of argument the upper end of a radius is proved.
std::string method_text(const JointSpectralRadius& radius);
/// The same with the size of the proof; and, where the ends are apart, by what the lower one is proved.
std::string sized_method_text(const JointSpectralRadius& radius);

/// `2 + 3 + 1`: the sizes of diagonal blocks.
std::string sizes_text(const std::vector<std::size_t>& sizes);

/// Radius, method, blocks, product and vertices. `digits`: of the radius in JSON, at least.
Facts radius_facts(const JointSpectralRadius& radius, int digits);

/// A Sobolev exponent. `otherwise`: why there is no upper end, and why it is exact although the shifts are not stable.
struct SobolevReasons {
  std::string no_upper_end, unstable;
};
Fact sobolev_fact(const Enclosure& exponent, const Decision& stable, const SobolevReasons& otherwise, Json json);

}  // namespace subcert::facts
