#pragma once
/// Bounds and the Sobolev exponent, as the commands print them.

#include <subcert/analysis/regularity/holder_bound.hpp>
#include <subcert/analysis/regularity/radius/joint_spectral_radius.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/cli/command.hpp>

namespace subcert::cli {

/// --width, and what it means.
void add_width(Command& command, SearchOptions& options);
struct WantedWidth {
  std::optional<Rational> width;
  int bits = default_bits;  ///< of radii and exponents
  int digits = 0;           ///< that show them

  bool holds(const Enclosure& enclosure) const {
    return !width || (enclosure.is_bounded() && *enclosure.upper - *enclosure.lower <= *width);
  }
};
/// Errors: throws a usage error for what is no width.
WantedWidth wanted_width(const SearchOptions& options);

/// {"levels", "norm", "holder"}.
Json bound_json(const HolderBound& bound);

/// The exponent, with the stability of the shifts of the mask; null where there is none.
Json sobolev_json(const std::optional<SobolevRegularity>& sobolev, const Decision& stable);
std::string sobolev_text(const SobolevRegularity& sobolev, const Decision& stable);

/// By which kind of argument the upper end of a radius is proved.
std::string method_text(const JointSpectralRadius& radius);
/// The same with the size of the proof; and, where the ends are apart, by what the lower one is proved.
std::string sized_method_text(const JointSpectralRadius& radius);

}  // namespace subcert::cli
