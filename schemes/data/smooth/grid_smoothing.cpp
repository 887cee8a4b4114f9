#include "grid_smoothing.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::data {
namespace {

/// What smooths along each axis.
std::vector<SmoothingMethod> methods_along(std::string_view specification, std::size_t axes) {
  if (!specification.starts_with("tensor:"))
    return std::vector<SmoothingMethod>(axes, make_smoothing_method(specification));
  const AnyScheme any = make_any_scheme(specification);
  const auto& scheme = std::get<Scheme>(any);
  require(scheme.mask.has_factors() && scheme.mask.factors().size() == axes, "{}: need a factor for each of {} axes",
          scheme.specification, axes);
  std::vector<SmoothingMethod> methods;
  for (const Mask& factor : scheme.mask.factors()) {
    Scheme one = scheme;
    one.mask = LatticeMask(factor);
    one.rules.reset();
    methods.emplace_back(std::move(one));
  }
  return methods;
}

void add_outside(GridData<double>& data, std::size_t k, const std::vector<RoundedRow>& rows, double constant) {
  std::size_t inner = data.dimension;
  for (std::size_t l = 0; l < k; ++l) inner *= data.axes[l].count;
  for (std::size_t i = 0; i < data.values.size(); ++i)
    data.values[i] += rows[i / inner % rows.size()].outside * constant;
}

/// Smooths along axis k, and multiplies the variances, one for each point so far, by those of the rows.
void smooth_along(GridData<double>& data, std::size_t k, const SmoothingMethod& method, const SmoothingOptions& options,
                  int threads, std::vector<double>& variances) {
  const Axis axis = data.axes[k];
  const std::unique_ptr<LinearSmoother> smoother = make_smoother(Samples{{std::vector<double>(axis.count)}}, method,
                                                                 options);
  const std::vector<RoundedRow> rows = smoother->rounded_rows();
  AxisRefinement<double> step{axis, axis, {}, {}, 0, {}};
  step.output.count = rows.size();
  step.output.step = axis.step / Rational(smoother->scale());
  for (const RoundedRow& row : rows) {
    WeightRow<double>& one = step.head.emplace_back(WeightRow<double>{{}, row.weights});
    for (std::size_t i = 0; i < row.weights.size(); ++i) one.at.push_back(row.first + i);
  }
  data = apply_along(data, k, step, threads);
  if (options.boundary == Boundary::constant) add_outside(data, k, rows, options.constant);
  std::vector<double> products;
  products.reserve(variances.size() * rows.size());
  for (const RoundedRow& row : rows)
    for (const double variance : variances) products.push_back(variance * row.variance);
  variances = std::move(products);
}

}  // namespace

std::vector<NoiseEstimate> estimate_noise(const GridData<double>& grid) {
  GridData<double> residuals = grid;
  double degrees = 1;
  bool differences = false;
  for (std::size_t k = 0; k < grid.axes.size(); ++k) {
    const std::size_t count = grid.axes[k].count;
    if (count < 3) {  // residuals at its data are independent
      degrees *= static_cast<double>(count);
      continue;
    }
    differences = true;
    degrees *= estimate_noise(std::vector<double>(count)).degrees_of_freedom;
    AxisRefinement<double> step{grid.axes[k], grid.axes[k], {}, {}, 0, {}};
    step.output.count = count - 2;
    const double norm = 1 / std::sqrt(1.5);
    for (std::size_t i = 0; i + 2 < count; ++i)
      step.head.push_back({{i, i + 1, i + 2}, {0.5 * norm, -norm, 0.5 * norm}});
    residuals = apply_along(residuals, k, step);
  }
  std::vector<NoiseEstimate> noise(grid.dimension);
  if (!differences) return noise;
  const std::size_t terms = residuals.points();
  for (std::size_t i = 0; i < residuals.values.size(); ++i)
    noise[i % grid.dimension].variance += residuals.values[i] * residuals.values[i] / static_cast<double>(terms);
  for (NoiseEstimate& one : noise) one = {one.variance, degrees, terms};
  return noise;
}

SmoothedGrid smooth_grid(const GridData<double>& grid, std::string_view specification, const SmoothingOptions& options,
                         const std::optional<double>& noise, int threads) {
  require(grid.is_canonical(), "smooth_grid: need as many values as points times numbers");
  require(options.derivative == 0, "smooth_grid: need derivative 0, got {}", options.derivative);
  const std::vector<SmoothingMethod> methods = methods_along(specification, grid.axes.size());
  GridData<double> data = grid;
  std::vector<double> variances{1};
  for (std::size_t k = 0; k < grid.axes.size(); ++k) smooth_along(data, k, methods[k], options, threads, variances);
  SmoothedGrid result{to_text(methods.front()), data.axes, {}};
  const std::vector<NoiseEstimate> estimates = noise ? std::vector(grid.dimension, known_noise(*noise))
                                                     : estimate_noise(grid);
  for (std::size_t c = 0; c < grid.dimension; ++c) {
    SmoothedColumn& column = result.columns.emplace_back(SmoothedColumn{{}, estimates[c]});
    for (std::size_t i = 0; i < variances.size(); ++i) {
      column.values.push_back(data.values[i * grid.dimension + c]);
      if (estimates[c].exists()) column.deviations.push_back(std::sqrt(estimates[c].variance * variances[i]));
    }
  }
  return result;
}

}  // namespace subcert::data
