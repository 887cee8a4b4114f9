#include "surface_view.hpp"

#include "base64.hpp"
#include "html.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace subcert::formats {
namespace {

constexpr std::size_t most_points = 96;  // in a direction
constexpr std::uint16_t hole = 65535;    // where there is no surface
constexpr double steps_of_box = hole - 1;

std::vector<std::size_t> kept(std::size_t count) {
  const std::size_t step = (count + most_points - 1) / most_points;
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
  const auto columns = kept(surface.columns), rows = kept(surface.rows);
  std::string bytes;
  for (const std::size_t j : rows)
    for (const std::size_t i : columns) {
      const auto& point = surface.points[j * surface.columns + i];
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
  return {{"title", surface.title},
          {"columns", columns.size()},
          {"rows", rows.size()},
          {"low", low},
          {"high", high},
          {"closed", {surface.closed_x, surface.closed_y}},
          {"heights", surface.heights},
          {"points", base64(bytes)}};
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
