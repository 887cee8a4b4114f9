#include "surface_figure.hpp"

#include "figure.hpp"
#include "gnuplot_text.hpp"
#include "html.hpp"
#include "surface_view.hpp"

#include <subcert/schemes/data/runtime/files.hpp>

#include <gnuplot-iostream.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace subcert::formats {
namespace {

/// The points 0, ..., count - 1 that are drawn: all, or at most so many of them with both ends; closed directions end
/// with 0.
std::vector<std::size_t> drawn_indices(std::size_t count, bool closed, std::size_t most) {
  const std::size_t step = count / most + 1;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; i += step) result.push_back(i);
  if (closed)
    result.push_back(0);
  else if (result.back() + 1 < count)
    result.push_back(count - 1);
  return result;
}

/// Rows of points with an empty line after each, as splot reads a grid.
std::string grid_text(const DrawnSurface& surface, std::size_t most) {
  std::ostringstream text;
  text.precision(9);
  for (const std::size_t j : drawn_indices(surface.rows, surface.closed_y, most)) {
    for (const std::size_t i : drawn_indices(surface.columns, surface.closed_x, most)) {
      const auto& p = surface.points[j * surface.columns + i];
      text << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    text << '\n';
  }
  return text.str();
}

/// `most`: points in a direction.
void plot(const std::vector<DrawnSurface>& surfaces, std::size_t columns, std::size_t most, const PictureKind& kind,
          const std::filesystem::path& target) {
  const std::size_t rows = (surfaces.size() + columns - 1) / columns;
  Gnuplot gnuplot(gnuplot_command);
  gnuplot << "set encoding utf8\nset terminal " << kind.terminal << " size "
          << kind.size(static_cast<int>(520 * columns), static_cast<int>(380 * rows)) << "\n"
          << "set output " << quoted(target.string()) << "\n"
          << "set multiplot layout " << rows << "," << columns << "\n"
          << "set xyplane relative 0.05\nset tics textcolor rgb '#333333'\nset border lc rgb '#888888'\n"
          << "set palette defined (0 '#0b559f', 0.5 '#e8e8e8', 1 '#c0392b')\nunset colorbox\nunset key\n"
          << "set pm3d lighting primary 0.4 specular 0.1\n";
  for (const DrawnSurface& surface : surfaces) {
    const bool coarse = surface.columns * surface.rows <= 2500;
    gnuplot << "set title " << kind.quoted_text(surface.title) << "\n"
            << (surface.heights ? "set view 60,30,1\n"
                                : "set view equal xyz\nset view 60,30," + std::to_string(surface.zoom) +
                                      "\nunset tics\nunset border\n")
            << "set pm3d depthorder " << (coarse ? "border lc rgb '#303030' lw 0.4\n" : "noborder\n")
            << "splot '-' with pm3d\n"
            << grid_text(surface, most) << "e\n";
  }
  gnuplot << "unset multiplot\nunset output\n";
  gnuplot.flush();
}

}  // namespace

void draw(const SurfaceFigure& figure, const std::filesystem::path& folder) {
  for (const char* ending : {".svg", ".png"})
    draw_surfaces(figure.surfaces, folder / (figure.id + ending), figure.columns);
}

void draw_surfaces(const std::vector<DrawnSurface>& surfaces, const std::filesystem::path& file, std::size_t columns) {
  if (file.extension() == ".html") {
    std::string views;
    for (const DrawnSurface& surface : surfaces) views += surface_view(surface);
    return runtime::write_file(file, html_page(html(surfaces.front().title), views));
  }
  const bool is_drawn = file.extension() != ".png";
  // Each facet is a line of text, but in pictures of points.
  const double count = static_cast<double>(surfaces.size());
  const std::size_t most = is_drawn ? std::max<std::size_t>(20, static_cast<std::size_t>(100 / std::sqrt(count))) : 200;
  write_picture(file, [&](const PictureKind& kind, const std::filesystem::path& target) {
    plot(surfaces, columns == 0 ? surfaces.size() : std::min(columns, surfaces.size()), most, kind, target);
  });
}

}  // namespace subcert::formats
