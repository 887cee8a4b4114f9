#pragma once
/// What commands read about masks that change from level to level.

#include "command.hpp"

#include <subcert/analysis/family/recurrence.hpp>
#include <subcert/proofs-checks/properties/mask_list_file.hpp>
#include <subcert/schemes/parametric_specification.hpp>

namespace subcert::cli {

/// `lists:FILE` starts like that.
inline constexpr const char* lists = "lists:";

/// Errors: throws Error for the file, which it names.
properties::MaskListFile read_lists(const std::string& file);

/// `v0=1/2`, `v0=-1..1000` or `v0=-1..inf`. Errors: throws a usage error.
FirstValues read_start(const std::string& written, const std::string& name);
/// `v=sqrt((1+v)/2)`. Errors: throws a usage error.
Recurrence read_recurrence(const std::string& written, const std::string& name, char letter);

/// Of `refine` and `limit`: which mask each level takes.
struct LevelOptions {
  std::string recurrence;
  std::string start;
  std::string values;
};
void add_level_options(Command& command, LevelOptions& options);

/// A family whose parameter follows a recurrence.
struct FollowedFamily {
  std::string specification;  ///< with the recurrence, for people
  ParametricScheme family;
  Recurrence recurrence;
  Rational start;

  /// Its masks at so many levels.
  LevelDependentScheme levels(int count) const;
};

/// Nothing where one mask for all levels is meant. The masks of a list may be of matrices. Errors: throws Error.
std::optional<std::variant<LevelDependentScheme, FollowedFamily>> read_levels(const std::string& scheme,
                                                                              const LevelOptions& options);

}  // namespace subcert::cli
