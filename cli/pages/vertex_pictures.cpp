#include "vertex_pictures.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/surface_figure.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace subcert::cli {
namespace {

std::string curvature_of(const VertexPicture& picture) {
  const auto& curvature = picture.smoothness.curvature;
  return curvature ? "curvature " + to_text(*curvature) : "curvature open";
}

formats::DrawnSurface drawn(const VertexPicture& picture, const std::string& title) {
  const VertexSurface& surface = *picture.surface;
  formats::DrawnSurface result{title, surface.columns, surface.rows, false, false, surface.points};
  result.values = surface.curvature;
  result.most = surface.scale > 0 ? surface.scale : 1;
  return result;
}

constexpr int shades = 4;  // on both sides of grey

/// From blue by grey to red, as the view that turns has it.
std::string colour_of(int shade) {
  constexpr int low[] = {11, 85, 159}, middle[] = {228, 231, 235}, high[] = {192, 57, 43};
  const auto part = [&](std::size_t c) {
    return middle[c] + (shade < 0 ? low[c] - middle[c] : high[c] - middle[c]) * std::abs(shade) / shades;
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

}  // namespace

std::string map_svg(const VertexSurface& surface) {
  constexpr double size = 500;
  std::map<int, std::string> paths;
  const auto step = [](long value) { return value < 0 ? std::to_string(value) : " " + std::to_string(value); };
  for (std::size_t j = 0; j + 1 < surface.rows; ++j)
    for (std::size_t i = 0; i + 1 < surface.columns; ++i) {
      const std::size_t at = j * surface.columns + i;
      const std::size_t corners[] = {at, at + 1, at + surface.columns + 1, at + surface.columns};
      if (!std::ranges::all_of(corners, [&](std::size_t place) { return std::isfinite(surface.points[place][0]); }))
        continue;
      double curvature = 0;
      for (const std::size_t place : corners) curvature += surface.curvature[place] / 4;
      const double share = surface.scale > 0 ? std::clamp(curvature / surface.scale, -1.0, 1.0) : 0;
      std::string& path = paths[static_cast<int>(std::lround(shades * share))];
      long x = 0, y = 0;
      for (const std::size_t place : corners) {
        const long to_x = std::lround(size * surface.points[place][0]),
                   to_y = std::lround(-size * surface.points[place][1]);
        path += (place == at ? "M" : "l") + step(to_x - x) + step(to_y - y);
        x = to_x, y = to_y;
      }
      path += "z";
    }
  std::string cells;
  for (const auto& [shade, path] : paths)
    cells += fmt::format("<path d=\"{}\" fill=\"{}\"></path>", path, colour_of(shade));
  return fmt::format(
      "<svg viewBox=\"-504 -504 1008 1008\" role=img aria-label=\"characteristic map, valence {}\" "
      "style=\"width:100%\" stroke=\"#33404d\" stroke-width=1.5 stroke-linejoin=round>{}</svg>",
      surface.valence, cells);
}

std::string curvature_scale(double most) {
  return fmt::format(
      "<span style=\"white-space:nowrap\">−{0:.3g} <span role=img aria-label=\"from blue by grey to red\" "
      "style=\"display:inline-block;width:9rem;height:.7rem;background:linear-gradient(90deg,{1},{2},{3})\"></span> "
      "{0:.3g}</span>",
      most, colour_of(-shades), colour_of(0), colour_of(shades));
}

std::string curvature_factor(const VertexSmoothness& smoothness) {
  const auto middle = [](const Enclosure& enclosure) { return enclosure.lower->convert_to<double>(); };
  const double lambda = middle(smoothness.subdominant);
  return fmt::format("{:.4g}", middle(smoothness.next) / (lambda * lambda));
}

void draw_vertices(const std::string& plot, const VertexScheme& scheme, const std::vector<VertexPicture>& pictures) {
  std::vector<formats::DrawnSurface> surfaces;
  for (const VertexPicture& picture : pictures)
    if (picture.surface && picture.surface->frequency)
      surfaces.push_back(drawn(picture, fmt::format("{}, n = {}: {}", scheme.specification, picture.surface->valence,
                                                    curvature_of(picture))));
  if (surfaces.empty())
    fail(ErrorKind::domain,
         "--plot: {}: a surface is drawn where the subdominant eigenvalue is proved to have frequency 1, and that "
         "behind it to be one real number",
         scheme.specification);
  formats::draw_surfaces(surfaces, plot, 3);
}

std::string vertex_html(const VertexScheme& scheme, const std::string& facts,
                        const std::vector<VertexPicture>& pictures) {
  std::string body = fmt::format(
      "<h1>{}: surfaces near vertices</h1>\n<div class=scroll><pre>{}</pre></div>\n"
      "<p>Refined data near a vertex: in the plane those of the characteristic map, above it those of the largest "
      "eigenvalue μ behind λ. Colours are the root of the modulus of Gauss's curvature, with its sign: red above 0, "
      "blue below, grey at 0. From one ring to the next, towards the vertex, it is multiplied by |μ|/λ², apart from "
      "slopes: where curvature is zero at the vertex colours fade, where it is bounded they stay, where it is "
      "unbounded they fill up. Pictures are for the eye; what is proved stands above.</p>\n",
      formats::html(scheme.specification), formats::html(facts));
  for (const VertexPicture& picture : pictures) {
    const long n = picture.smoothness.valence;
    body += fmt::format("<h2 id=\"n{0}\">n = {0}, {1}</h2>\n", n, curvature_of(picture));
    if (!picture.surface) {
      body += "<p>No picture: the subdominant eigenvalue is not proved to have frequency 1.</p>\n";
      continue;
    }
    const VertexSurface& surface = *picture.surface;
    const std::string map = fmt::format("<figure>{}<figcaption>The characteristic map</figcaption></figure>\n",
                                        map_svg(surface));
    if (!surface.frequency)
      body += fmt::format(
          "<p>No surface: the eigenvalue behind λ is not proved to be one real number.</p>\n<div class=pictures>\n"
          "{}</div>\n",
          map);
    else
      body += fmt::format(
          "<p>Heights have frequency {}; |μ|/λ² = {}; colours {}</p>\n<div class=pictures>\n{}"
          "<figure>{}<figcaption>The surface, to be turned</figcaption></figure>\n</div>\n",
          *surface.frequency, curvature_factor(picture.smoothness), curvature_scale(surface.scale), map,
          formats::surface_view(drawn(picture, fmt::format("surface, n = {}", n))));
  }
  return formats::html_page(formats::html(scheme.title) + ", at vertices", body);
}

}  // namespace subcert::cli
