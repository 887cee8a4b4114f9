#pragma once
/// Surfaces that a reader turns.

#include "surface_figure.hpp"

#include <string>

namespace subcert::formats {

/// The drawn picture of a figure, PNG, and a button that puts the surfaces themselves in its place. `folder`: of the
/// paper, beside the page.
std::string surface_views(const SurfaceFigure& figure, const std::string& folder);

/// The script that gives these surfaces to the page: FIGURE.id + ".surfaces.js" in the folder. At most 96 points in a
/// direction, in 65,534 steps of the box; the rest is left out.
std::string surface_script(const SurfaceFigure& figure, const std::string& folder);

/// One surface with its data, for a page in one file: a place that the page's script fills.
std::string surface_view(const DrawnSurface& surface);

}  // namespace subcert::formats
