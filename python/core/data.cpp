#include "arrays.hpp"
#include "work.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>
#include <subcert/schemes/data/smooth/grid_smoothing.hpp>
#include <subcert/schemes/data/smooth/smooth.hpp>
#include <subcert/schemes/data/smooth/uniform_grid.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace subcert::python {
namespace {

data::Boundary boundary_of(const std::string& name) {
  const auto boundary = data::parse_boundary(name);
  if (!boundary) fail(ErrorKind::usage, "boundary: '{}' is not known", name);
  return *boundary;
}

/// Nothing beyond the numbers that a refinement takes.
void require_finite(const std::vector<double>& numbers, const char* what) {
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!std::isfinite(numbers[i]))
      fail(ErrorKind::data, "{}: need finite numbers, got {} at index {}", what, numbers[i], i);
}

/// One scheme, or several in turn, one for each level.
AnyScheme scheme_of(const std::vector<std::string>& specifications) {
  require(!specifications.empty(), "refine: need a scheme, got none");
  if (specifications.size() == 1) return data::make_data_scheme(specifications.front());
  return levels_in_turn({}, specifications);
}

/// Points in the order of numpy's rows: the last index of the points runs along the first axis of the scheme.
py::tuple refine(const std::vector<std::string>& specifications, const DoubleArray& values,
                 const std::vector<bool>& closed, int levels, const std::string& boundary_name, double constant,
                 bool limit, int jobs, const py::object& progress) {
  const AnyScheme scheme = scheme_of(specifications);
  const std::string& specification = specification_of(scheme);
  const data::Boundary boundary = boundary_of(boundary_name);
  const std::vector<std::size_t> fewest = fewest_points(scheme, boundary),
                                 fewest_closed = fewest_points(scheme, data::Boundary::periodic);
  const std::size_t axes = fewest.size(), given = static_cast<std::size_t>(values.ndim());
  if (given != axes && given != axes + 1)
    fail(ErrorKind::domain, "refine: need an array of {} or {} dimensions for a scheme of {}, got {}", axes, axes + 1,
         axes == 1   ? "one variable"
         : axes == 2 ? "two variables"
                     : "three variables",
         given);
  data::GridData<double> grid{
      numbers_of(values),
      given == axes ? 1 : static_cast<std::size_t>(values.shape(static_cast<py::ssize_t>(axes))),
      {}};
  require_finite(grid.values, "refine");
  for (std::size_t k = 0; k < axes; ++k) {
    const auto count = static_cast<std::size_t>(values.shape(static_cast<py::ssize_t>(axes - 1 - k)));
    const std::size_t needed = closed[axes - 1 - k] ? fewest_closed[k] : fewest[k];
    if (count < needed)
      fail(ErrorKind::domain, "refine: {} needs at least {} points along axis {}, got {}", specification, needed,
           axes - 1 - k, count);
    grid.axes.push_back(data::Axis::of(count, closed[axes - 1 - k] || boundary == data::Boundary::periodic));
  }
  if (grid.dimension == 0) fail(ErrorKind::domain, "refine: need at least one coordinate, got none");
  const data::RefineOptions options{levels, boundary, jobs, constant};
  data::GridData<double> refined = interruptible(progress, [&] {
    if (!limit) return data::refine(grid, scheme, options);
    const std::optional<LatticeMask> mask = mask_with_factors(scheme);
    if (!mask)
      fail(ErrorKind::domain, "limit: {}: limits are of schemes of one variable and their tensor products",
           specification);
    require_derivative(specification, *mask, LatticePoint(mask->factors().size(), 0));
    return data::SlabRefinement(grid, limit_steps(grid.axes, grid.dimension, *mask, options)).whole();
  });
  std::vector<std::size_t> shape;
  py::list parameters;
  for (std::size_t k = axes; k-- > 0;) {
    shape.push_back(refined.axes[k].count);
    parameters.append(py::make_tuple(refined.axes[k].first, refined.axes[k].step));
  }
  if (given > axes) shape.push_back(refined.dimension);
  return py::make_tuple(array_of(std::move(refined.values)).reshape(shape), parameters);
}

py::dict column_dict(data::SmoothedColumn column, double bands, data::BandKind kind) {
  py::dict result;
  const bool has_bands = bands > 0 && !column.deviations.empty();
  if (has_bands) {
    std::vector<double> lower = column.half_widths(bands, kind), upper = lower;
    for (std::size_t i = 0; i < lower.size(); ++i) {
      upper[i] = column.values[i] + lower[i];
      lower[i] = column.values[i] - lower[i];
    }
    result["lower"] = array_of(std::move(lower));
    result["upper"] = array_of(std::move(upper));
  }
  if (column.noise && column.noise->exists()) result["noise_variance"] = column.noise->variance;
  if (!column.deviations.empty()) result["deviation"] = array_of(std::move(column.deviations));
  result["values"] = array_of(std::move(column.values));
  return result;
}

template <class Value>
void reorder(std::vector<Value>& values, const std::vector<std::size_t>& rows) {
  if (values.empty()) return;
  std::vector<Value> result;
  for (const std::size_t row : rows) result.push_back(values[row]);
  values = std::move(result);
}

/// Sorts the samples by their positions, and sets these; other than uniform ones only where `irregular`.
data::PositionOrder set_positions(data::Samples& samples, const DoubleArray& positions, bool irregular) {
  std::vector<double> x = numbers_of(positions);
  require_finite(x, "x");
  data::PositionOrder order = data::order_of(x);
  reorder(x, order.rows);
  for (auto& column : samples.columns) reorder(column, order.rows);
  reorder(samples.weights, order.rows);
  if (order.repeated && !irregular)
    fail(ErrorKind::data, "x: need one datum for each position, got {} twice; irregular=True takes several",
         x[*order.repeated]);
  if (x.front() == x.back()) fail(ErrorKind::data, "x: need two different positions, got {} alone", x.front());
  const data::UniformGrid grid = samples.put_at(std::move(x));
  if (!samples.uniform() && !irregular) {
    const double low = samples.positions[grid.worst], high = samples.positions[grid.worst + 1];
    fail(ErrorKind::data,
         "x: need a uniform grid, got the spacing {:g} between {} and {} where the mean is {:g}; irregular=True takes "
         "positions as they are",
         high - low, low, high, grid.spacing.convert_to<double>());
  }
  return order;
}

/// Puts answers into the order of the samples as they were given: at the data row by row, on a grid the same direction.
void restore_order(data::SmoothedSamples& smoothed, const data::PositionOrder& order, bool at_data) {
  std::vector<std::size_t> back(smoothed.positions.size());
  std::iota(back.begin(), back.end(), std::size_t{0});
  if (at_data)
    std::ranges::sort(back, {}, [&](std::size_t i) { return order.rows[i]; });
  else if (order.falling)
    std::ranges::reverse(back);
  reorder(smoothed.positions, back);
  for (data::SmoothedColumn& column : smoothed.columns) {
    reorder(column.values, back);
    reorder(column.deviations, back);
  }
}

void require_choices(int level, double bands, const std::optional<double>& noise, const std::string& kind_name,
                     const std::string& at) {
  require(level >= 0 && level <= 12, "smooth: need 0 <= level <= 12, got {}", level);
  require(bands >= 0 && bands < 1, "smooth: need 0 <= bands < 1, got {}", bands);
  require(!noise || data::is_noise(*noise), "smooth: need 1e-150 <= noise <= 1e150, got {}", noise.value_or(0));
  if (!data::parse_band_kind(kind_name))
    fail(ErrorKind::usage, "kind: expected {}, got '{}'", fmt::join(data::band_kind_names(), ", "), kind_name);
  if (at != "grid" && at != "data") fail(ErrorKind::usage, "at: expected grid or data, got '{}'", at);
}

py::list candidates_of(const std::optional<data::MethodChoice>& choice) {
  py::list candidates;
  if (choice)
    for (const data::SmoothingCandidate& one : choice->candidates)
      candidates.append(py::make_tuple(one.specification, one.risk.total()));
  return candidates;
}

/// The axes of a grid of heights or of a volume: the last index of numpy's runs along the first.
data::GridData<double> grid_of(const DoubleArray& values, bool missing) {
  data::GridData<double> grid{numbers_of(values), 1, {}};
  if (!missing) require_finite(grid.values, "smooth");
  if (std::ranges::any_of(grid.values, [](double value) { return std::isinf(value); }))
    fail(ErrorKind::data, "smooth: need finite numbers, or nan, got inf");
  for (py::ssize_t k = values.ndim(); k-- > 0;)
    grid.axes.push_back(data::Axis::of(static_cast<std::size_t>(values.shape(k))));
  return grid;
}

/// Heights or a volume.
py::dict smooth_grid(const DoubleArray& values, const std::string& scheme, const std::string& boundary, double constant,
                     int level, double bands, const std::string& kind_name, const std::string& at,
                     const std::optional<double>& noise, const std::string& missing, int jobs,
                     const py::object& progress) {
  require_choices(level, bands, noise, kind_name, at);
  require(values.size() > 0, "smooth: need at least one number, got none");
  const data::BandKind kind = *data::parse_band_kind(kind_name);
  data::SmoothingOptions options{boundary_of(boundary), level, 0, constant, at == "data"};
  options.path = kind == data::BandKind::simultaneous;
  options.keep_holes = missing == "keep";
  const data::GridData<double> grid = grid_of(values, missing != "raise");
  data::SmoothedGrid smoothed = interruptible(progress,
                                              [&] { return data::smooth_grid(grid, scheme, options, noise, jobs); });
  py::dict answer = column_dict(std::move(smoothed.columns.front()), bands, kind);
  py::list places;
  for (const data::Axis& axis : smoothed.axes) {
    std::vector<double> along;
    for (std::size_t i = 0; i < axis.count; ++i) along.push_back(data::nearest_double(axis.parameter(i)));
    places.insert(0, array_of(std::move(along)));
  }
  if (answer.contains("lower")) answer["bands_method"] = to_text(data::BandMethod::linear);
  answer["x"] = py::tuple(places);
  answer["scheme"] = smoothed.method;
  answer["candidates"] = candidates_of(smoothed.choice);
  return answer;
}

/// By the positions, one for each value.
void add_slopes(data::Samples& samples, const DoubleArray& slopes, const std::optional<double>& noise) {
  samples.columns.push_back(numbers_of(slopes));
  require_finite(samples.columns.back(), "slopes");
  require(samples.columns.back().size() == samples.columns.front().size(),
          "slopes: need as many as samples, {}, got {}", samples.columns.front().size(), samples.columns.back().size());
  require(!noise || data::is_noise(*noise), "smooth: need 1e-150 <= slope_noise <= 1e150, got {}", noise.value_or(0));
  samples.slopes = true;
  samples.slope_noise = noise;
}

/// `scheme`: a specification, or empty for the choice by estimated error.
py::dict smooth(const DoubleArray& y, const std::optional<DoubleArray>& x, const std::vector<Rational>& weights,
                const Rational& origin, const std::optional<Rational>& spacing, const std::string& scheme,
                const std::string& boundary, double constant, int level, int derivative, double bands,
                const std::string& kind_name, const std::optional<bool>& irregular, const std::string& at,
                const std::optional<DoubleArray>& places, const std::optional<double>& noise,
                const std::optional<DoubleArray>& slopes, const std::optional<double>& slope_noise,
                const std::string& select, int resamples, std::uint64_t seed, int jobs, const py::object& progress) {
  if (y.ndim() != 1) fail(ErrorKind::domain, "smooth: need an array of one dimension, got {}", y.ndim());
  require_choices(level, bands, noise, kind_name, at);
  require(derivative >= 0 && derivative <= 20, "smooth: need 0 <= derivative <= 20, got {}", derivative);
  require(!spacing || *spacing > 0, "smooth: need spacing > 0");
  const auto kind = data::parse_band_kind(kind_name);
  require(*kind != data::BandKind::prediction || derivative == 0, "smooth: a new datum has no derivative");
  data::Samples samples{{numbers_of(y)}, weights, origin, spacing.value_or(1)};
  require_finite(samples.columns.front(), "smooth");
  samples.noise = noise;
  if (slopes) add_slopes(samples, *slopes, slope_noise);
  data::PositionOrder order;
  if (x) order = set_positions(samples, *x, irregular.value_or(data::takes_any_positions(scheme)));
  if (!samples.uniform()) {
    if (spacing) samples.spacing = *spacing;
    const auto missing = [&](std::size_t row) { return !weights.empty() && weights[row] == 0; };
    samples.drop_missing();
    std::erase_if(order.rows, missing);
  }
  if (select != "risk" && select != "cv") fail(ErrorKind::usage, "select: expected risk or cv, got '{}'", select);
  require(resamples == 0 || (resamples >= 2 && resamples <= 100'000),
          "smooth: need 2 <= resamples <= 100000, or 0, got {}", resamples);
  data::SmoothingOptions options{boundary_of(boundary), level, derivative, constant, at == "data"};
  options.path = *kind == data::BandKind::simultaneous;
  if (select == "cv") options.selection = data::Selection::cross_validation;
  options.resamples = resamples;
  options.seed = seed;
  if (places) options.places = numbers_of(*places);
  data::SmoothedSamples smoothed = interruptible(
      progress, [&] { return data::smooth(samples, std::string_view(scheme), options, jobs); });
  require(*kind == data::BandKind::pointwise || smoothed.band_method != data::BandMethod::bootstrap,
          "smooth: bands of l1 schemes are pointwise");
  require(*kind != data::BandKind::prediction || smoothed.band_method == data::BandMethod::linear,
          "smooth: a new datum may be an outlier, of which robust steps know nothing");
  if (x && !places) restore_order(smoothed, order, at == "data");
  std::size_t outliers = 0;
  for (const data::SmoothedColumn& column : smoothed.columns) outliers += column.outliers;
  const std::optional<double> correlated = smoothed.columns.front().correlated;
  py::dict answer = column_dict(std::move(smoothed.columns.front()), bands, *kind);
  answer["outliers"] = outliers;
  answer["correlated"] = correlated;
  if (smoothed.columns.size() == 2) answer["slopes"] = column_dict(std::move(smoothed.columns.back()), bands, *kind);
  if (answer.contains("lower")) answer["bands_method"] = to_text(smoothed.band_method);
  answer["x"] = array_of(std::move(smoothed.positions));
  answer["scheme"] = smoothed.method;
  answer["candidates"] = candidates_of(smoothed.choice);
  return answer;
}

}  // namespace

void add_data(py::module_& module) {
  module.def("refine", &refine);
  module.def("smooth", &smooth);
  module.def("smooth_grid", &smooth_grid);
  module.def("finds_its_noise", &data::finds_its_noise);
  module.def("remark_on_correlations", &data::remark_on_correlations);
  module.def("all_cores", &all_cores);
}

}  // namespace subcert::python
