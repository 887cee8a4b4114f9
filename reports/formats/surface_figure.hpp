#pragma once
/// Pictures of surfaces, drawn by gnuplot.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace subcert::formats {

/// A grid of points in space: points[j * columns + i]; closed directions are joined. Heights that are no numbers leave
/// holes.
struct DrawnSurface {
  std::string title;
  std::size_t columns;
  std::size_t rows;
  bool closed_x;
  bool closed_y;
  std::vector<std::array<double, 3>> points;
  bool heights = false;  ///< a function over a grid: x and y scaled freely against z
  double zoom = 2;       ///< of surfaces that are no heights; tall ones need less
  /// What colours tell at each point, from -most to most, with grey for 0: then no point is left out. Heights, if there
  /// are none.
  std::vector<double> values = {};
  double most = 1;
};

/// Surfaces side by side, at most `columns` in a row.
struct SurfaceFigure {
  std::string id;
  std::string title;
  std::string caption;
  std::vector<DrawnSurface> surfaces;
  std::size_t columns = 2;
};

/// Writes FOLDER/ID.svg and FOLDER/ID.png. Errors: as draw_surfaces().
void draw(const SurfaceFigure& figure, const std::filesystem::path& folder);

/// Writes one picture with the surfaces side by side, at most `columns` in a row where it is not 0, as .svg or .png;
/// or as .html, surfaces that turn.
/// Errors: throws a domain error for another ending, missing_file where gnuplot is missing or fails.
void draw_surfaces(const std::vector<DrawnSurface>& surfaces, const std::filesystem::path& file,
                   std::size_t columns = 0);

/// The drawn picture of a figure, PNG, and a button that puts the surfaces themselves in its place. `folder`: of the
/// paper, beside the page.
std::string surface_views(const SurfaceFigure& figure, const std::string& folder);

/// The script that gives these surfaces to the page: FIGURE.id + ".surfaces.js" in the folder. At most 96 points in a
/// direction, in 65,534 steps of the box; the rest is left out.
std::string surface_script(const SurfaceFigure& figure, const std::string& folder);

/// One surface with its data, for a page in one file: a place that the page's script fills.
std::string surface_view(const DrawnSurface& surface);

}  // namespace subcert::formats
