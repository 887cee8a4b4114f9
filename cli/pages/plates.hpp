#pragma once
/// Schemes with what is known of each, as pages and as JSON.

#include <subcert/cli/command.hpp>
#include <subcert/reports/gallery/gallery.hpp>

#include <vector>

namespace subcert::cli {

/// On at most options.threads() threads, with progress. Errors: as reports::make_plate().
std::vector<reports::Plate> make_plates(const std::vector<reports::GalleryScheme>& schemes,
                                        const reports::PlateOptions& plate_options, const CommonOptions& options);

/// {"schemes": [...]}.
Json plates_json(const std::vector<reports::Plate>& plates);

/// failed where one does not converge, or one does that is known to diverge, else undecided where one is. Domain: the
/// plates of these schemes, in this order.
ExitCode exit_code(const std::vector<reports::GalleryScheme>& schemes, const std::vector<reports::Plate>& plates);

}  // namespace subcert::cli
