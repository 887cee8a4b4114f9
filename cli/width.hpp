#pragma once
/// The option --width: how narrow the enclosure of an exact number is to be.

#include "command.hpp"

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>

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

}  // namespace subcert::cli
