#pragma once
/// What `subcert smooth --grid` does: heights and volumes.

#include "smooth_page.hpp"

namespace subcert::cli {

/// Reads a matrix of heights or a volume, smooths it along each axis and answers: with a table of places and values, of
/// a volume with one that has arrays for deviations and bands, too, or with JSON. Errors: throws a usage error for
/// options that are of samples in columns, else as smooth_grid() and read_grid_file().
void smooth_grid_file(const SmoothOptions& options, const std::optional<double>& noise);

}  // namespace subcert::cli
