#pragma once
/// The part of `subcert levels` that is about lists of masks.

#include "command.hpp"

namespace subcert::cli {

/// `lists:FILE` starts like that.
inline constexpr const char* lists = "lists:";

/// `property`: empty where none is asked for. `certificates`: a folder, or empty. Errors: throws Error.
ExitCode run_levels_of_list(const SearchOptions& options, const std::string& file, const std::string& property,
                            const std::string& certificates);

}  // namespace subcert::cli
