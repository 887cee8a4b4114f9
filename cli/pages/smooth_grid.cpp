#include "smooth_grid.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/data_file.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/smooth/grid_smoothing.hpp>

#include <fmt/format.h>

#include <cmath>

namespace subcert::cli {
namespace {

/// A column of the answer: one for each number of a point, then its deviation and the ends of its band.
struct GridColumn {
  std::string name;
  std::vector<double> values;
};

void refuse_options_of_columns(const SmoothOptions& options) {
  const data::SampleOptions& samples = options.samples;
  if (!samples.x.empty() || !samples.y.empty() || !samples.weights.empty() || !samples.errors.empty() ||
      !samples.by.empty() || !samples.keep.empty() || options.irregular != "auto" || options.stream ||
      !samples.spacing.empty() || samples.series != "columns" || options.derivative != 0 || options.select != "risk" ||
      options.at_positions())
    fail(ErrorKind::usage,
         "--grid: expected none of --x, --y, --weights, --by, --keep, --irregular, --spacing, --series, "
         "--derivative, --select cv, --stream, --at-file, and of --at grid or data");
}

std::vector<std::string> names_of(const DataFile& file) {
  return file.kind == DataKind::matrix ? std::vector<std::string>{"value"} : file.names();
}

/// The columns of value number c, in the order of the points.
std::vector<GridColumn> columns_of(const SmoothOptions& options, const std::string& name,
                                   const data::SmoothedColumn& column) {
  std::vector<GridColumn> columns{{name, column.values}};
  if (column.deviations.empty()) return columns;
  columns.push_back({name + "_sd", column.deviations});
  if (options.bands() == 0) return columns;
  GridColumn lower{name + "_lower", column.half_widths(options.bands(), options.kind())},
      upper{name + "_upper", lower.values};
  for (std::size_t i = 0; i < column.values.size(); ++i) {
    lower.values[i] = column.values[i] - lower.values[i];
    upper.values[i] = column.values[i] + upper.values[i];
  }
  columns.push_back(std::move(lower));
  columns.push_back(std::move(upper));
  return columns;
}

/// Where the points stand along each axis.
std::vector<GridColumn> places_of(const DataFile& file, const std::vector<data::Axis>& axes) {
  std::size_t points = 1, before = 1;
  for (const data::Axis& axis : axes) points *= axis.count;
  std::vector<GridColumn> places;
  for (std::size_t v = 0; v < axes.size(); ++v) {
    const bool volume = file.kind == DataKind::volume;
    GridColumn& place = places.emplace_back(GridColumn{std::string(1, static_cast<char>('x' + v)), {}});
    for (std::size_t i = 0; i < points; ++i) {
      const double at = data::nearest_double(axes[v].parameter(i / before % axes[v].count));
      place.values.push_back(volume ? file.volume.origin[v] + at * file.volume.spacing[v] : at);
    }
    before *= axes[v].count;
  }
  return places;
}

void write_comments(std::ostream& stream, const SmoothOptions& options, const data::SmoothedGrid& grid,
                    const std::vector<std::string>& names) {
  if (options.quiet) return;
  stream << "# scheme " << grid.method << " along each axis, boundary " << options.boundary << "\n";
  if (grid.missing > 0)
    stream << fmt::format("# {} missing data, {}\n", grid.missing,
                          options.samples.missing == "keep" ? "where values are nan" : "left out of the fits");
  if (grid.choice) stream << choice_text(*grid.choice, options);
  for (std::size_t c = 0; c < grid.columns.size(); ++c) stream << noise_line(names[c], *grid.columns[c].noise);
  if (options.bands() != 0)
    stream << fmt::format("# bands: {:.6g} % {}; the bias is not in them\n", 100 * options.bands(),
                          covered_text(options.kind()));
}

/// The arrays of the file, and what belongs to them as fields of their own.
void write_volume(std::ostream& stream, const DataFile& file, const data::SmoothedGrid& grid,
                  const std::vector<std::vector<GridColumn>>& columns) {
  DataFile answer{DataKind::volume, {}, {}, {}, file.volume};
  std::vector<const std::vector<double>*> sources;
  for (const auto& of_number : columns) sources.push_back(&of_number.front().values);
  for (const auto& of_number : columns)
    for (std::size_t k = 1; k < of_number.size(); ++k) {
      answer.volume.arrays.push_back({of_number[k].name, "FIELD", 1});
      sources.push_back(&of_number[k].values);
    }
  std::vector<double> values;
  for (std::size_t i = 0; i < sources.front()->size(); ++i)
    for (const auto* source : sources) values.push_back((*source)[i]);
  const std::size_t points = sources.front()->size();
  write_data(
      stream, answer, grid.axes, [&](const auto& take) { take(values.data(), points); }, 1);
}

void write_table(std::ostream& stream, const SmoothOptions& options, const DataFile& file,
                 const std::vector<GridColumn>& columns) {
  std::vector<std::string> header;
  std::vector<data::TableColumn> table;
  for (const GridColumn& column : columns) {
    header.push_back(column.name);
    table.push_back({column.values.data()});
  }
  const char separator = file.table.columns > 1 ? file.table.separator : ',';
  stream << data::header_text(header, separator);
  data::write_rows(stream, table, columns.front().values.size(), separator, options.threads());
}

Json grid_json(const SmoothOptions& options, const data::SmoothedGrid& grid, const std::vector<std::string>& names,
               const std::vector<GridColumn>& columns) {
  Json noise = Json::array(), header = Json::array(), rows = Json::array();
  for (std::size_t c = 0; c < grid.columns.size(); ++c)
    noise.push_back({{"column", names[c]}, {"sigma", std::sqrt(grid.columns[c].noise->variance)}});
  for (const GridColumn& column : columns) header.push_back(column.name);
  for (std::size_t i = 0; i < columns.front().values.size(); ++i) {
    Json& row = rows.emplace_back(Json::array());
    for (const GridColumn& column : columns) row.push_back(column.values[i]);
  }
  return {{"scheme", grid.method},
          {"auto", grid.choice.has_value()},
          {"choice", choice_json(grid.choice)},
          {"boundary", options.boundary},
          {"missing", grid.missing},
          {"noise", noise},
          {"bands", options.bands()},
          {"bands_kind", options.bands_kind},
          {"columns", header},
          {"rows", rows}};
}

/// Errors: a data error names the file.
data::SmoothedGrid smoothed(const SmoothOptions& options, const DataFile& file, const data::SmoothingOptions& how,
                            const std::optional<double>& noise) {
  try {
    return smooth_grid(file.data, options.scheme, how, noise, options.threads());
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::data) throw;
    fail(ErrorKind::data, "{}: {}", options.samples.name(), error.what());
  }
}

/// The first number of the points, as heights.
void draw(const SmoothOptions& options, const DataFile& file, const data::SmoothedGrid& grid) {
  if (file.data.axes.size() != 2 || file.data.dimension != 1)
    fail(ErrorKind::usage, "--plot {}: pictures are of heights; found {} axes and {} numbers at a point", options.plot,
         file.data.axes.size(), file.data.dimension);
  draw_refined(options.plot, {}, file.data, {{grid.method, {grid.columns.front().values, 1, grid.axes}}});
}

}  // namespace

void smooth_grid_file(const SmoothOptions& options, const std::optional<double>& noise) {
  refuse_options_of_columns(options);
  const bool raise = options.samples.missing == "raise";
  const DataFile file = read_grid_file(options.samples.file, raise ? data::Missing::refuse : data::Missing::keep);
  for (const std::string& line : file.remarks()) options.remark(options.samples.name() + ": " + line);
  data::SmoothingOptions how{*data::parse_boundary(options.boundary), options.level, 0, options.constant,
                             options.at == "data"};
  how.path = options.kind() == data::BandKind::simultaneous;
  how.keep_holes = options.samples.missing == "keep";
  const data::SmoothedGrid grid = smoothed(options, file, how, noise);
  if (grid.unknown > 0)
    options.remark(
        fmt::format("too few data in the windows of {} values, which are nan: take more points", grid.unknown));
  if (!options.plot.empty()) draw(options, file, grid);
  const std::vector<std::string> names = names_of(file);
  std::vector<std::vector<GridColumn>> columns;
  std::vector<GridColumn> all = places_of(file, grid.axes);
  for (std::size_t c = 0; c < grid.columns.size(); ++c) {
    columns.push_back(columns_of(options, names[c], grid.columns[c]));
    all.insert(all.end(), columns.back().begin(), columns.back().end());
  }
  if (options.json) return options.answer(grid_json(options, grid, names, all));
  options.answer([&](std::ostream& stream) {
    if (file.kind == DataKind::volume) return write_volume(stream, file, grid, columns);
    write_comments(stream, options, grid, names);
    write_table(stream, options, file, all);
  });
}

}  // namespace subcert::cli
