// subcert refine SCHEME DATA

#include "command.hpp"

#include <subcert/reports/figure.hpp>
#include <subcert/schemes/data/axis_refinement.hpp>
#include <subcert/schemes/data/l1_specification.hpp>
#include <subcert/schemes/data/refine.hpp>
#include <subcert/schemes/data/table.hpp>

namespace subcert::cli {
namespace {

struct RefineCommand : CommonOptions {
  std::string scheme;
  std::string data;
  int levels = 5;
  bool closed = false;
  std::string boundary = boundary_names().front();
  std::string plot;
};

/// A curve and how its file was written.
struct CurveFile {
  Table table;
  GridData<double> curve;
};

/// Domain: fewest >= 2. Errors: throws DataFormatError.
CurveFile read_curve(const std::string& path, bool closed, std::size_t fewest, const std::string& scheme) {
  Table table = parse_table(read_file(path), path);
  const std::size_t rows = table.rows(), columns = table.columns;
  if (rows < fewest)
    throw DataFormatError(path + ": expected at least " + std::to_string(fewest) + " rows for " + scheme + "; found " +
                          std::to_string(rows));
  if (closed && std::equal(table.values.begin(), table.values.begin() + static_cast<std::ptrdiff_t>(columns),
                           table.values.end() - static_cast<std::ptrdiff_t>(columns)))
    throw DataFormatError(path + ", line " + std::to_string(table.lines.back()) +
                          ": expected each point of a closed curve once; found the first row again");
  GridData<double> curve = curve_data(std::move(table.values), columns, closed);
  table.values.clear();
  return {std::move(table), std::move(curve)};
}

Json points_json(const GridData<double>& curve) {
  Json points = Json::array();
  for (std::size_t i = 0; i < curve.points(); ++i) {
    Json point = Json::array();
    for (std::size_t c = 0; c < curve.dimension; ++c) point.push_back(curve.values[i * curve.dimension + c]);
    points.push_back(point);
  }
  return points;
}

subcert::Curve drawn(const GridData<double>& curve, const std::string& label, bool joined) {
  const std::size_t k = curve.dimension, count = curve.points();
  subcert::Curve result{label, {}, !joined, joined};
  for (std::size_t i = 0; i < count + (joined && curve.axes[0].closed && k > 1 ? 1 : 0); ++i) {
    const double* point = curve.values.data() + (i % count) * k;
    if (k == 1)
      result.points.emplace_back(nearest_double(curve.axes[0].parameter(i)), point[0]);
    else
      result.points.emplace_back(point[0], point[1]);
  }
  return result;
}

void draw_curve(const std::string& file, const std::string& scheme, const Table& table, const GridData<double>& data,
                const GridData<double>& refined) {
  const bool plane = data.dimension == 2, named = !table.header.empty();
  Panel panel{scheme,
              plane ? (named ? table.header[0] : "x") : "parameter",
              plane ? (named ? table.header[1] : "y") : (named ? table.header[0] : "value"),
              {drawn(data, "data", false), drawn(refined, "refined", true)}};
  panel.equal_units = plane;
  draw_file({"refined", scheme, "", 1, {panel}}, file);
}

/// What refines a curve: a linear scheme or a data-dependent one.
struct CurveRefiner {
  std::string specification;
  std::size_t fewest;  ///< points of a curve
  std::function<GridData<double>(const GridData<double>&, const RefineOptions&)> refine;
};

CurveRefiner make_refiner(const std::string& specification, Boundary boundary) {
  if (is_l1_specification(specification)) {
    const NamedL1Scheme named = make_l1_scheme(specification);
    if (named.scheme.points.size() != 1)
      throw UsageError(named.specification + ": expected a scheme for curves, as l1:points=6");
    return {named.specification, static_cast<std::size_t>(named.scheme.points[0]),
            [=](const GridData<double>& data, const RefineOptions& options) { return refine(data, named.scheme, options); }};
  }
  const Scheme scheme = make_scheme(specification);
  return {scheme.specification, AxisRefiner(scheme.mask, boundary).window(),
          [=](const GridData<double>& data, const RefineOptions& options) { return refine(data, scheme.mask, options); }};
}

int run(const RefineCommand& options) {
  const Boundary boundary = *parse_boundary(options.boundary);
  if (options.closed && boundary != Boundary::regression && boundary != Boundary::periodic)
    throw UsageError("--boundary " + options.boundary + ": closed data have no boundary; leave out one of the two options");
  if (!options.plot.empty() && !is_picture_name(options.plot))
    throw UsageError("--plot " + options.plot + ": expected a name that ends in .svg or .png");
  const bool closed = options.closed || boundary == Boundary::periodic;
  const CurveRefiner refiner = make_refiner(options.scheme, boundary);
  const auto [table, data] = read_curve(options.data, closed, refiner.fewest, refiner.specification);
  if (!options.plot.empty() && data.dimension > 2)
    throw UsageError("--plot " + options.plot + ": pictures need one or two columns; " + options.data + " has " +
                     std::to_string(data.dimension));
  const GridData<double> refined = refiner.refine(data, {options.levels, boundary, options.threads()});
  if (!options.plot.empty()) draw_curve(options.plot, refiner.specification, table, data, refined);
  const Axis& axis = refined.axes[0];
  if (options.json) {
    options.answer(Json{{"scheme", refiner.specification},
                        {"levels", options.levels},
                        {"boundary", to_text(closed ? Boundary::periodic : boundary)},
                        {"closed", closed},
                        {"columns", table.header},
                        {"count", axis.count},
                        {"first", to_text(axis.first)},
                        {"step", to_text(axis.step)},
                        {"points", points_json(refined)}});
    return done;
  }
  Table answer = table;
  answer.values = refined.values;
  options.answer(to_text(answer));
  return done;
}

}  // namespace

void add_refine(CLI::App& app) {
  auto options = std::make_shared<RefineCommand>();
  CLI::App& command = add_command(app, "refine", "Applies a scheme to data", "subcert refine primal:n=3 samples.csv --levels 4",
                                  options, [=] { return run(*options); });
  add_scheme(command, options->scheme);
  command.add_option("DATA", options->data, "Points, one a row: CSV with one column for each coordinate")->required();
  command.add_option("--levels", options->levels, "How often the scheme is applied")
      ->check(CLI::Range(0, 1000000000))
      ->capture_default_str();
  command.add_flag("--closed", options->closed, "The first point follows the last");
  command.add_option("--boundary", options->boundary, "What rules at the ends read")
      ->check(CLI::IsMember(boundary_names()))
      ->capture_default_str();
  command.add_option("--plot", options->plot, "Draw data and result, as .svg or .png");
}

}  // namespace subcert::cli
