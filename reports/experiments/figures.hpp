#pragma once
/// The pictures of the experiments: points and lines in the plane, and surfaces.

#include <subcert/reports/formats/figure.hpp>
#include <subcert/reports/formats/surface_figure.hpp>
#include <subcert/schemes/data/refine/grid_data.hpp>

namespace subcert::experiments {

using Points = std::vector<std::pair<double, double>>;

/// What a colour stands for.
namespace colour {
inline const std::string blue = "#0b559f", red = "#c0392b", violet = "#7d3c98", amber = "#e0a030", grey = "#8a97a3",
                         dark = "#5a6773", pale = "#9aa5b1";
}

/// Functions over the parameter, or curves by their first two coordinates.
Points points_of(const data::GridData<double>& data);
/// The same with the first point once more at the end of a closed curve.
Points line_of(const data::GridData<double>& data);
/// Values at 0, step, 2 step, ...
Points over_steps(const std::vector<double>& values, double step);

formats::Curve dots(const std::string& label, Points points, const std::string& colour);
formats::Curve line(const std::string& label, Points points, const std::string& colour);
/// A panel without axis labels, the legend below.
formats::Panel plain_panel(const std::string& title, std::vector<formats::Curve> curves, bool equal_units = false);

/// A surface in space, or heights over the parameters: every `keep`-th point in both directions. Domain: two axes, one
/// or three coordinates, keep >= 1.
formats::DrawnSurface drawn_surface(const std::string& title, const data::GridData<double>& surface,
                                    std::size_t keep = 1);

/// The same data with parameter u at origin + scale * u. Domain: scale > 0.
data::GridData<double> placed(data::GridData<double> data, const Rational& origin, const Rational& scale);

}  // namespace subcert::experiments
