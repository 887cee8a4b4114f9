#pragma once
/// The part of `subcert levels` that is about lists of masks.

#include "command.hpp"

#include <subcert/analysis/family/mask_list.hpp>
#include <subcert/analysis/family/property_of_levels.hpp>

namespace subcert::cli {

/// `convergent`, `C2`, `holder>=3/2` or, of matrices, `HC1`. Errors: throws a usage error for another text.
RangeProperty read_levels_property(const std::string& text, bool of_matrices = false);

/// The exponent, whether it is exact, and its closed form.
Json exponent_json(const ExponentOfList& found);
/// The closed form, or nothing.
std::string formula_line(const ExponentOfList& found);

/// `property`: empty where none is asked for. `certificates`: a folder, or empty. Errors: throws Error.
ExitCode run_levels_of_list(const SearchOptions& options, const std::string& file, const std::string& property,
                            const std::string& certificates);

}  // namespace subcert::cli
