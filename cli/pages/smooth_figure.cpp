#include "smooth_figure.hpp"

#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/smooth/uniform_grid.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace subcert::cli {
namespace {

constexpr const char *data_colour = "#777777", *limit_colour = "#0b559f";
constexpr std::size_t most_large_marks = 200;

/// The y of a picture: the column, or its derivative by x.
std::string drawn_name(const SmoothPage& page, std::size_t column) {
  const std::string& name = page.samples.names[column];
  const int order = page.options.derivative;
  if (order == 0) return name;
  const std::string unit = page.samples.dates ? page.samples.dates->unit_name() : page.samples.x_name;
  static const char* const endings[] = {"th", "st", "nd", "rd"};
  const bool special = order % 10 <= 3 && (order < 11 || order > 13);
  return (order == 1 ? std::string() : fmt::format("{}{} ", order, endings[special ? order % 10 : 0])) +
         "derivative of " + name + " by " + unit;
}

/// On the axis of a picture, where time runs evenly.
double on_axis(const data::NamedSamples& samples, double position) {
  return samples.dates ? time_of(position, *samples.dates) : position;
}

double position(const data::NamedSamples& samples, std::size_t i) {
  return on_axis(samples, samples.uniform() ? data::nearest_double(samples.origin + samples.spacing * Rational(i))
                                            : samples.positions[i]);
}

/// The limit at the data, one column of values for each of the samples.
std::vector<data::SmoothedColumn> at_the_data(const SmoothPage& page) {
  const SmoothOptions& options = page.options;
  const data::SmoothingOptions how{*data::parse_boundary(options.boundary), 0, 0, options.constant, true};
  return smooth(page.samples, page.result.method, how, options.threads()).columns;
}

formats::Panel panel_of(const SmoothPage& page, std::size_t column) {
  const std::string& group = page.samples.group;
  const auto& dates = page.samples.dates;
  formats::Panel panel{(group.empty() ? "" : group + ": ") + page.result.method,
                       page.samples.x_name,
                       drawn_name(page, column),
                       {},
                       false,
                       "below"};
  panel.plain_texts = true;
  if (dates) panel.date_unit = dates->times ? 1 : 86'400;
  return panel;
}

/// The points of the samples that count.
formats::Curve dots(const SmoothPage& page, const std::vector<double>& values, const std::string& label) {
  formats::Curve curve{label, {}, true, false, data_colour};
  if (values.size() > most_large_marks) curve.mark_size = 0.2;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (page.samples.weights.empty() || page.samples.weights[i] > 0)
      curve.points.emplace_back(position(page.samples, i), values[i]);
  return curve;
}

/// The outputs from left to right, without those that lie outside the data.
std::vector<std::size_t> drawn_outputs(const SmoothPage& page, std::size_t column) {
  std::vector<std::size_t> outputs;
  for (std::size_t o = 0; o < page.rows(); ++o)
    if (!std::isnan(page.result.columns[column].values[o])) outputs.push_back(o);
  if (page.options.at_positions())
    std::ranges::stable_sort(outputs, {}, [&](std::size_t o) { return page.result.positions[o]; });
  return outputs;
}

formats::Panel panel_of_limit(const SmoothPage& page, std::size_t column) {
  formats::Panel panel = panel_of(page, column);
  if (page.options.derivative == 0) panel.curves.push_back(dots(page, page.samples.columns[column], "data"));
  formats::Curve limit{"limit", {}, page.options.at_positions(), true, limit_colour};
  const std::vector<std::size_t> outputs = drawn_outputs(page, column);
  for (const std::size_t o : outputs)
    limit.points.emplace_back(on_axis(page.samples, page.result.positions[o]), page.result.columns[column].values[o]);
  panel.curves.push_back(std::move(limit));
  if (!page.bands) return panel;
  formats::Band band{fmt::format("{:.6g} % band", 100 * page.options.bands()), {}, limit_colour};
  for (const std::size_t o : outputs)
    band.ends.push_back({on_axis(page.samples, page.result.positions[o]), page.columns[2 * column][o],
                         page.columns[2 * column + 1][o]});
  panel.bands.push_back(std::move(band));
  return panel;
}

formats::Panel panel_of_residuals(const SmoothPage& page, std::size_t column, const std::vector<double>& limit) {
  formats::Panel panel = panel_of(page, column);
  panel.title.clear();
  panel.key = "off";
  panel.y_label = "residual of " + page.samples.names[column];
  panel.height = 0.6;
  std::vector<double> residuals = page.samples.columns[column];
  for (std::size_t i = 0; i < residuals.size(); ++i) residuals[i] -= limit[i];
  panel.curves = {dots(page, residuals, "residual")};
  const auto& points = panel.curves.front().points;
  panel.curves.push_back({"", {{points.front().first, 0}, {points.back().first, 0}}, false, true, limit_colour});
  return panel;
}

}  // namespace

formats::Figure figure_of(const std::vector<std::unique_ptr<SmoothPage>>& pages) {
  formats::Figure figure{"smooth", pages.front()->result.method, "", 1, {}};
  for (const auto& page : pages) {
    std::vector<data::SmoothedColumn> limits;
    if (page->options.derivative == 0) limits = at_the_data(*page);
    for (std::size_t c = 0; c < page->result.columns.size(); ++c) {
      figure.panels.push_back(panel_of_limit(*page, c));
      if (!limits.empty()) figure.panels.push_back(panel_of_residuals(*page, c, limits[c].values));
    }
  }
  return figure;
}

}  // namespace subcert::cli
