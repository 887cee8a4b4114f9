#include "vertex_pictures.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/surface_figure.hpp>

#include <fmt/format.h>

#include <cmath>

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

/// The net of the characteristic map, as lines.
std::string net_svg(const VertexSurface& surface) {
  constexpr double size = 200;
  std::string path;
  const auto add_line = [&](std::size_t count, const auto& place) {
    bool is_open = false;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& p = surface.points[place(i)];
      if (std::isfinite(p[0])) path += fmt::format("{}{:.1f} {:.1f}", is_open ? "L" : "M", size * p[0], -size * p[1]);
      is_open = std::isfinite(p[0]);
    }
  };
  for (std::size_t j = 0; j < surface.rows; ++j)
    add_line(surface.columns, [&](std::size_t i) { return j * surface.columns + i; });
  for (std::size_t i = 0; i < surface.columns; ++i)
    add_line(surface.rows, [&](std::size_t j) { return j * surface.columns + i; });
  return fmt::format(
      "<svg viewBox=\"-204 -204 408 408\" role=img aria-label=\"characteristic map, valence {}\" "
      "style=\"width:min(100%,22rem)\"><path d=\"{}\" fill=none stroke=currentColor stroke-width=.7 "
      "vector-effect=non-scaling-stroke></path></svg>",
      surface.valence, path);
}

}  // namespace

void draw_vertices(const std::string& plot, const VertexScheme& scheme, const std::vector<VertexPicture>& pictures) {
  std::vector<formats::DrawnSurface> surfaces;
  for (const VertexPicture& picture : pictures)
    if (picture.surface)
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
  std::string body = "<div class=scroll><pre>" + formats::html(facts) + "</pre></div>\n";
  body +=
      "<p>Refined data near a vertex: in the plane those of the characteristic map, above it the eigenfunction of the "
      "largest eigenvalue behind λ. Colours are the root of the modulus of Gauss's curvature, with its sign: blue "
      "below "
      "0, grey at 0, red above, full from twice the median of the outer half on. Where the curvature is zero at the "
      "vertex colours fade towards it, where it is unbounded they fill up, where it is bounded they stay.</p>\n";
  for (const VertexPicture& picture : pictures) {
    const long n = picture.smoothness.valence;
    body += fmt::format("<h2 id=\"n{0}\">n = {0}, {1}</h2>\n", n, curvature_of(picture));
    if (!picture.surface) {
      body +=
          "<p>No picture: the subdominant eigenvalue is not proved to have frequency 1, or that behind it not to be "
          "one real number.</p>\n";
      continue;
    }
    body += fmt::format(
        "<p>Heights have frequency {}; full colour from {:.3g} on.</p>\n<div class=surfaces>{}</div>{}\n",
        picture.surface->frequency, picture.surface->scale, net_svg(*picture.surface),
        formats::surface_view(drawn(picture, fmt::format("surface, n = {}", n))));
  }
  return formats::html_page(formats::html(scheme.title) + ", at vertices", body);
}

}  // namespace subcert::cli
