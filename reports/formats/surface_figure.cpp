
#include "surface_figure.hpp"

#include "figure.hpp"
#include "gnuplot_text.hpp"
#include "html.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>
#include <gnuplot-iostream.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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
  if (!surface.values.empty()) most = std::max(surface.columns, surface.rows) + 1;
  for (const std::size_t j : drawn_indices(surface.rows, surface.closed_y, most)) {
    for (const std::size_t i : drawn_indices(surface.columns, surface.closed_x, most)) {
      const std::size_t at = j * surface.columns + i;
      const auto& p = surface.points[at];
      text << p[0] << ' ' << p[1] << ' ' << p[2];
      if (!surface.values.empty()) text << ' ' << std::clamp(surface.values[at], -surface.most, surface.most);
      text << '\n';
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
  gnuplot << "set encoding utf8\n"
          << kind.numbers() << "set terminal " << kind.terminal << " size "
          << kind.size(static_cast<int>(520 * columns), static_cast<int>(380 * rows)) << "\n"
          << "set output " << quoted(target.string()) << "\n"
          << "set multiplot layout " << rows << "," << columns << "\n"
          << "set xyplane relative 0.05\nset tics textcolor rgb '#333333'\nset border lc rgb '#888888'\n"
          << "set palette defined (0 '#0b559f', 0.5 '#e8e8e8', 1 '#c0392b')\nunset colorbox\nunset key\n"
          << "set pm3d lighting primary 0.4 specular 0.1\n";
  for (const DrawnSurface& surface : surfaces) {
    const bool coarse = surface.columns * surface.rows <= 2500;
    gnuplot << "set title " << kind.title(surface.title) << "\n"
            << (surface.heights ? "set view 60,30,1\n"
                                : "set view equal xyz\nset view 60,30," + std::to_string(surface.zoom) +
                                      "\nunset tics\nunset border\n")
            << "set pm3d depthorder " << (coarse ? "border lc rgb '#303030' lw 0.4\n" : "noborder\n")
            << (surface.values.empty() ? "set autoscale cb\nsplot '-' with pm3d\n"
                                       : fmt::format("set cbrange [{}:{}]\nsplot '-' using 1:2:3:4 with pm3d\n",
                                                     -surface.most, surface.most))
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

namespace {

constexpr std::size_t most_points = 96;  // in a direction
constexpr std::uint16_t hole = 65535;    // where there is no surface
constexpr double steps_of_box = hole - 1;

std::vector<std::size_t> kept(std::size_t count, bool whole) {
  const std::size_t step = whole ? 1 : (count + most_points - 1) / most_points;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count; i += std::max<std::size_t>(step, 1)) result.push_back(i);
  return result;
}

nlohmann::json data_of(const DrawnSurface& surface) {
  constexpr double most = std::numeric_limits<double>::max();
  std::array<double, 3> low{most, most, most}, high{-most, -most, -most};
  const auto is_point = [](const std::array<double, 3>& p) {
    return std::ranges::all_of(p, [](double c) { return std::isfinite(c); });
  };
  for (const auto& point : surface.points)
    if (is_point(point))
      for (std::size_t c = 0; c < 3; ++c) low[c] = std::min(low[c], point[c]), high[c] = std::max(high[c], point[c]);
  require(low[0] <= high[0], "surface_view: need a surface with points, got none");
  const bool whole = !surface.values.empty();
  const auto columns = kept(surface.columns, whole), rows = kept(surface.rows, whole);
  std::string bytes;
  auto values = nlohmann::json::array();
  for (const std::size_t j : rows)
    for (const std::size_t i : columns) {
      const auto& point = surface.points[j * surface.columns + i];
      if (whole)
        values.push_back(
            std::isfinite(surface.values[j * surface.columns + i])
                ? std::lround(100 * std::clamp(surface.values[j * surface.columns + i] / surface.most, -1.0, 1.0))
                : 0);
      for (std::size_t c = 0; c < 3; ++c) {
        const double size = high[c] - low[c];
        const auto step = !is_point(point) ? hole
                          : size > 0
                              ? static_cast<std::uint16_t>(std::lround((point[c] - low[c]) / size * steps_of_box))
                              : std::uint16_t{0};
        bytes += static_cast<char>(step & 0xFFU);
        bytes += static_cast<char>(step >> 8U);
      }
    }
  nlohmann::json data{{"title", surface.title},
                      {"columns", columns.size()},
                      {"rows", rows.size()},
                      {"low", low},
                      {"high", high},
                      {"closed", {surface.closed_x, surface.closed_y}},
                      {"heights", surface.heights},
                      {"points", base64(bytes)}};
  if (whole) data["values"] = std::move(values);  // hundredths of the most
  return data;
}

std::string script_name(const SurfaceFigure& figure, const std::string& folder) {
  return folder + "/" + figure.id + ".surfaces.js";
}

}  // namespace

std::string surface_views(const SurfaceFigure& figure, const std::string& folder) {
  return fmt::format(
      "<div class=surfaces><img src=\"{}/{}.png\" alt=\"{}\" loading=lazy><button type=button class=turn "
      "data-surfaces=\"{}\">turn the surfaces</button></div>",
      folder, figure.id, html(figure.title), html(script_name(figure, folder)));
}

std::string surface_script(const SurfaceFigure& figure, const std::string& folder) {
  nlohmann::json surfaces = nlohmann::json::array();
  for (const DrawnSurface& surface : figure.surfaces) surfaces.push_back(data_of(surface));
  return fmt::format("subcert_file({}, {});\n", nlohmann::json(script_name(figure, folder)).dump(), surfaces.dump());
}

std::string surface_view(const DrawnSurface& surface) {
  return fmt::format("<div class=\"surfaces\" data-surface=\"{}\"></div>", html(data_of(surface).dump()));
}

}  // namespace subcert::formats
