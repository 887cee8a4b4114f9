#include "plot.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/reports/formats/limit_figure.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

namespace subcert::cli {
namespace {

formats::DrawnSurface drawn_surface(const data::GridData<double>& data, const std::string& title) {
  formats::DrawnSurface result{title, data.axes[0].count, data.axes[1].count, false, false, {}, data.dimension == 1};
  for (std::size_t i = 0; i < data.points(); ++i) {
    if (result.heights)
      result.points.push_back({data::nearest_double(data.axes[0].parameter(i % result.columns)),
                               data::nearest_double(data.axes[1].parameter(i / result.columns)), data.values[i]});
    else
      result.points.push_back(
          {data.values[data.dimension * i], data.values[data.dimension * i + 1], data.values[data.dimension * i + 2]});
  }
  result.closed_x = !result.heights && data.axes[0].closed;
  result.closed_y = !result.heights && data.axes[1].closed;
  return result;
}

}  // namespace

void require_picture_name(const std::string& plot) {
  if (!plot.empty() && !formats::is_picture_name(plot))
    fail(ErrorKind::usage, "--plot {}: expected a name that ends in {}", plot, formats::picture_endings);
}

void require_drawable(const std::string& plot, const data::GridData<double>& data) {
  const std::size_t axes = data.axes.size(), k = data.dimension;
  if (!plot.empty() && ((axes == 1 && k > 2) || (axes == 2 && k == 2) || axes > 2))
    fail(ErrorKind::usage,
         "--plot {}: pictures are of curves with one or two coordinates and of surfaces with one, three or more; the "
         "data "
         "have {}{}{}{}",
         plot, axes, (axes == 1 ? " direction and " : " directions and "), k,
         (k == 1 ? " coordinate" : " coordinates"));
}

void draw_refined(const std::string& plot, const data::Table& table, const data::GridData<double>& data,
                  const std::vector<NamedGrid>& refined) {
  if (data.axes.size() == 2) {
    std::vector<formats::DrawnSurface> surfaces{drawn_surface(data, "data")};
    for (const auto& [scheme, grid] : refined) surfaces.push_back(drawn_surface(grid, scheme));
    formats::draw_surfaces(surfaces, plot);
    return;
  }
  const bool several = refined.size() > 1;
  const std::string title = several ? "" : refined.front().first;
  const bool plane = data.dimension == 2, named = !table.header.empty();
  // In the plane the data are a polygon, which tells their order.
  formats::Curve points = formats::data_curve(data, "data", plane);
  points.marked = true;
  points.colour = "#999999";
  formats::Panel panel{title,
                       plane ? (named ? table.header[0] : "x") : "parameter",
                       plane ? (named ? table.header[1] : "y") : (named ? table.header[0] : "value"),
                       {points}};
  for (const auto& [scheme, grid] : refined)
    panel.curves.push_back(formats::data_curve(grid, several ? scheme : "refined", true));
  if (!several) panel.curves.back().colour = "#0b559f";
  panel.key = "below";
  panel.equal_units = plane;
  panel.plain_texts = several;
  formats::draw_file({"refined", title, "", 1, {panel}}, plot);
}

void require_drawable(const std::string& plot, const Scheme& scheme) {
  if (!plot.empty() && scheme.mask.dimension() > 2)
    fail(ErrorKind::usage, "--plot {}: pictures are of functions of one or two variables; {} has {}", plot,
         scheme.specification, scheme.mask.dimension());
}

void draw_limit(const std::string& plot, const Scheme& scheme, const Decision& convergence) {
  const formats::DrawnLimit what = convergence.is_yes() ? formats::DrawnLimit::values
                                                        : formats::DrawnLimit::refined_delta;
  const std::string& name = scheme.specification;
  if (scheme.mask.dimension() > 1)
    formats::draw_surfaces({formats::limit_surface(scheme.mask, name, what)}, plot);
  else
    formats::draw_file({"limit", name, "", 1, {formats::limit_panel(scheme.mask.curve(), name, what)}}, plot);
}

void draw_vector(const std::string& plot, const Scheme& scheme, const FunctionVector& vector) {
  if (!vector.continuous.is_yes() || !vector.values || scheme.mask.dimension() > 1)
    fail(ErrorKind::undecided,
         "--plot {}: pictures are of vectors of functions of one variable that are proved continuous, one up to "
         "a factor; {} is none",
         plot, scheme.specification);
  formats::draw_file({"limit",
                      scheme.specification,
                      "",
                      1,
                      {formats::vector_panel(scheme.mask, scheme.quadratic, *vector.values, scheme.specification)}},
                     plot);
}

}  // namespace subcert::cli
