// subcert refine SCHEME DATA

#include "command.hpp"
#include "data_file.hpp"

#include <subcert/analysis/difference/multivariate_convergence.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/reports/formats/figure.hpp>
#include <subcert/reports/formats/surface_figure.hpp>
#include <subcert/schemes/data/axis_refinement.hpp>
#include <subcert/schemes/data/grid_refinement.hpp>
#include <subcert/schemes/data/l1_specification.hpp>
#include <subcert/schemes/data/limit_of_data.hpp>
#include <subcert/schemes/data/refine.hpp>

#include <algorithm>
#include <iostream>

namespace subcert::cli {
namespace {

struct RefineCommand : CommonOptions {
  std::string scheme;
  std::string data;
  int levels = 5;
  bool closed = false;
  std::array<bool, 3> closed_directions{false, false, false};
  std::string boundary = data::boundary_names().front();
  std::string plot;
  bool limit = false;
};

/// What refines data: a linear scheme of one, two or three variables, or a data-dependent one of one or two.
struct DataRefiner {
  std::string specification;
  std::vector<std::size_t> fewest;  ///< points in each direction
  std::function<data::GridData<double>(const data::GridData<double>&, const data::RefineOptions&)> refine;
  std::vector<Mask> factors = {};  ///< for limits: the masks of the directions, where there are such
};

DataRefiner make_refiner(const std::string& specification, data::Boundary boundary) {
  if (data::is_l1_specification(specification)) {
    const data::NamedL1Scheme named = data::make_l1_scheme(specification);
    return {named.specification,
            {named.scheme.points.begin(), named.scheme.points.end()},
            [scheme = named.scheme](const data::GridData<double>& data, const data::RefineOptions& options) {
              return refine(data, scheme, options);
            }};
  }
  const AnyScheme any = make_any_scheme(specification);
  if (const auto* scheme = std::get_if<Scheme>(&any))
    return {scheme->specification,
            {data::AxisRefiner(scheme->mask, boundary).window()},
            [mask = scheme->mask](const data::GridData<double>& data, const data::RefineOptions& options) {
              return refine(data, mask, options);
            },
            {scheme->mask}};
  const auto& scheme = std::get<MultivariateScheme>(any);
  if (scheme.factors.empty())
    return {scheme.specification, data::windows(scheme.mask),
            [mask = scheme.mask](const data::GridData<double>& data, const data::RefineOptions& options) {
              return refine(data, mask, options);
            }};
  std::vector<std::size_t> fewest;
  for (const Mask& factor : scheme.factors) fewest.push_back(data::AxisRefiner(factor, boundary).window());
  return {scheme.specification, fewest,
          [masks = scheme.factors](const data::GridData<double>& data, const data::RefineOptions& options) {
            return refine(data, masks, options);
          },
          scheme.factors};
}

/// The code to leave with where limits are not proved to exist; 0 else.
ExitCode check_convergence(const DataRefiner& refiner) {
  if (refiner.factors.empty())
    fail(ErrorKind::usage, "--limit: {}: limits are of schemes of one variable and their tensor products",
         refiner.specification);
  const Decision decision = tensor_product_converges(refiner.factors);
  if (decision.is_yes()) return done;
  std::cerr << "subcert: " << refiner.specification
            << ": no limit to evaluate; convergence: " << to_text(decision.truth) << " (" << decision.reason << ")\n";
  return decision.is_no() ? failed : undecided;
}

Json points_json(const data::GridData<double>& data) {
  Json points = Json::array();
  for (std::size_t i = 0; i < data.points(); ++i) {
    Json point = Json::array();
    for (std::size_t c = 0; c < data.dimension; ++c) point.push_back(data.values[i * data.dimension + c]);
    points.push_back(point);
  }
  return points;
}

formats::Curve drawn(const data::GridData<double>& curve, const std::string& label, bool joined) {
  const std::size_t k = curve.dimension, count = curve.points();
  formats::Curve result{label, {}, !joined, joined};
  for (std::size_t i = 0; i < count + (joined && curve.axes[0].closed && k > 1 ? 1 : 0); ++i) {
    const double* point = curve.values.data() + (i % count) * k;
    if (k == 1)
      result.points.emplace_back(data::nearest_double(curve.axes[0].parameter(i)), point[0]);
    else
      result.points.emplace_back(point[0], point[1]);
  }
  return result;
}

void draw_curve(const std::string& file, const std::string& scheme, const data::Table& table,
                const data::GridData<double>& data, const data::GridData<double>& refined) {
  const bool plane = data.dimension == 2, named = !table.header.empty();
  formats::Panel panel{scheme,
                       plane ? (named ? table.header[0] : "x") : "parameter",
                       plane ? (named ? table.header[1] : "y") : (named ? table.header[0] : "value"),
                       {drawn(data, "data", false), drawn(refined, "refined", true)}};
  panel.equal_units = plane;
  formats::draw_file({"refined", scheme, "", 1, {panel}}, file);
}

formats::DrawnSurface drawn_surface(const data::GridData<double>& data, const std::string& title) {
  formats::DrawnSurface result{title, data.axes[0].count, data.axes[1].count, false, false, {}, data.dimension == 1};
  for (std::size_t i = 0; i < data.points(); ++i) {
    if (result.heights)
      result.points.push_back({data::nearest_double(data.axes[0].parameter(i % result.columns)),
                               data::nearest_double(data.axes[1].parameter(i / result.columns)), data.values[i]});
    else
      result.points.push_back({data.values[3 * i], data.values[3 * i + 1], data.values[3 * i + 2]});
  }
  result.closed_x = !result.heights && data.axes[0].closed;
  result.closed_y = !result.heights && data.axes[1].closed;
  return result;
}

void check_plot(const std::string& plot, const data::GridData<double>& data) {
  if (plot.empty()) return;
  if (!formats::is_picture_name(plot))
    fail(ErrorKind::usage, "--plot {}: expected a name that ends in .svg or .png", plot);
  const std::size_t axes = data.axes.size(), k = data.dimension;
  if ((axes == 1 && k > 2) || (axes == 2 && k != 1 && k != 3) || axes > 2)
    fail(ErrorKind::usage,
         "--plot {}: pictures are of curves with one or two coordinates and of surfaces with one or three; the data "
         "have {}{}{}{}",
         plot, axes, (axes == 1 ? " direction and " : " directions and "), k,
         (k == 1 ? " coordinate" : " coordinates"));
}

Json axis_json(const data::Axis& axis) {
  return {{"count", axis.count}, {"first", to_text(axis.first)}, {"step", to_text(axis.step)}, {"closed", axis.closed}};
}

Json result_json(const RefineCommand& options, const DataRefiner& refiner, const DataFile& file,
                 data::Boundary boundary, const data::GridData<double>& refined) {
  const data::Axis& axis = refined.axes[0];
  Json json{{"scheme", refiner.specification},
            {"levels", options.levels},
            {"limit", options.limit},
            {"boundary", to_text(boundary)}};
  if (refined.axes.size() == 1) {
    json["closed"] = axis.closed;
    json["columns"] = file.table.header;
    json["count"] = axis.count;
    json["first"] = to_text(axis.first);
    json["step"] = to_text(axis.step);
  } else {
    json["axes"] = Json::array();
    for (const data::Axis& one : refined.axes) json["axes"].push_back(axis_json(one));
  }
  json["points"] = points_json(refined);
  return json;
}

ExitCode run(const RefineCommand& options) {
  const data::Boundary boundary = *data::parse_boundary(options.boundary);
  const DataRefiner refiner = make_refiner(options.scheme, boundary);
  const std::size_t variables = refiner.fewest.size();
  if (!options.plot.empty() && !formats::is_picture_name(options.plot))
    fail(ErrorKind::usage, "--plot {}: expected a name that ends in .svg or .png", options.plot);
  std::array<bool, 3> closed = options.closed_directions;
  for (std::size_t v = 0; v < variables; ++v) closed[v] = closed[v] || options.closed;
  if (boundary == data::Boundary::reflect || boundary == data::Boundary::shrink)
    if (std::all_of(closed.begin(), closed.begin() + static_cast<std::ptrdiff_t>(variables), [](bool c) { return c; }))
      fail(ErrorKind::usage, "--boundary {}: closed data have no boundary; leave out one of the two options",
           options.boundary);
  if (options.limit)
    if (const ExitCode code = check_convergence(refiner); code != done) return code;
  DataFile file = read_data_file(options.data, variables, closed);
  if (boundary == data::Boundary::periodic)
    for (data::Axis& axis : file.data.axes) axis = data::Axis::of(axis.count, true);
  check_data(file, options.data, refiner.specification, refiner.fewest);
  check_plot(options.plot, file.data);
  const data::RefineOptions how{options.levels, boundary, options.threads()};
  const data::GridData<double> refined = options.limit ? data::limit_of_data(file.data, refiner.factors, how)
                                                       : refiner.refine(file.data, how);
  if (!options.plot.empty()) {
    if (variables == 1)
      draw_curve(options.plot, refiner.specification, file.table, file.data, refined);
    else
      formats::draw_surfaces({drawn_surface(file.data, "data"), drawn_surface(refined, refiner.specification)},
                             options.plot);
  }
  if (options.json)
    options.answer(result_json(options, refiner, file,
                               variables == 1 && file.data.axes[0].closed ? data::Boundary::periodic : boundary,
                               refined));
  else
    options.answer(file_text(file, refined));
  return done;
}

}  // namespace

void add_refine(Command& app) {
  auto options = std::make_shared<RefineCommand>();
  Command command = add_command(app, "refine", "Applies a scheme to data",
                                "subcert refine primal:n=3 samples.csv --levels 4", options,
                                [=] { return run(*options); });
  add_scheme(command, options->scheme, true);
  command
      .option("DATA", options->data,
              "CSV: points in rows, or a matrix of heights for a scheme of two variables; .obj, .ply: a mesh of "
              "quadrilaterals; .vtk: a regular volume")
      .required();
  command.option("--levels", options->levels, "How often the scheme is applied").within(0, 1000000000).with_default();
  command.flag("--limit", options->limit, "Values of the limit at the parameters i / arity^LEVELS, at the data for 0");
  command.flag("--closed", options->closed, "The first point follows the last, in every direction");
  command.flag("--closed-x", options->closed_directions[0], "The same in the first direction alone");
  command.flag("--closed-y", options->closed_directions[1], "The same in the second direction alone");
  command.flag("--closed-z", options->closed_directions[2], "The same in the third direction alone");
  command.option("--boundary", options->boundary, "What rules at the ends read")
      .one_of(data::boundary_names())
      .with_default();
  command.option("--plot", options->plot, "Draw data and result, as .svg or .png");
}

}  // namespace subcert::cli
