#pragma once
/// Facts about exponents and radii, of whatever they are.

#include "fact.hpp"

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/regularity/holder_bound.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>

namespace subcert::facts {

/// The ends that say something about exponents of limits: positive ones.
Enclosure positive_part(const Enclosure& exponent);

/// {"levels", "norm", "holder"}.
Json bound_json(const HolderBound& bound);
/// Of one variable, by norms.
Fact bound_fact(std::string label, const HolderBound& bound);

/// By which kind of argument the upper end of a radius is proved.
std::string method_text(const JointSpectralRadius& radius);
/// The same with the size of the proof; and, where the ends are apart, by what the lower one is proved.
std::string sized_method_text(const JointSpectralRadius& radius);

/// `2 + 3 + 1`: the sizes of diagonal blocks.
std::string sizes_text(const std::vector<std::size_t>& sizes);

/// `exact`, `exactness` and `closed`, for programs alone.
Facts exact_facts(const Decision& exact, bool closed);

/// Radius, method, blocks, product and vertices. `digits`: of the radius in JSON, at least.
Facts radius_facts(const JointSpectralRadius& radius, int digits);

/// The Sobolev exponent, of one variable with the spectral radius behind it; null where there is none.
Fact sobolev_fact(const std::optional<SobolevRegularity>& sobolev, const Decision& stable);
Fact sobolev_fact(const std::optional<Enclosure>& exponent, const Decision& stable, bool of_values = false);

}  // namespace subcert::facts
