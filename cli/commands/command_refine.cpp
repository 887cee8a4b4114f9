// subcert refine SCHEME DATA

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/data_file.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/schemes/data/l1/l1_remarks.hpp>
#include <subcert/schemes/data/refine/slab_refinement.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

struct RefineCommand : CommonOptions {
  std::string scheme;
  std::string data;
  int levels = 5;
  bool closed = false;
  std::array<bool, 3> closed_directions{false, false, false};
  std::string boundary = data::refinement_boundary_names().front();
  std::string plot;
  bool limit = false;
};

/// The mask of which limits are drawn, where these are proved to exist.
LatticeMask mask_with_limits(const AnyScheme& scheme) {
  const std::optional<LatticeMask> mask = mask_with_factors(scheme);
  if (!mask)
    fail(ErrorKind::usage, "--limit: {}: limits are of schemes of numbers in one variable and their tensor products",
         specification_of(scheme));
  require_derivative(specification_of(scheme), *mask, LatticePoint(mask->factors().size(), 0));
  return *mask;
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

Json axis_json(const data::Axis& axis) {
  return {{"count", axis.count}, {"first", to_text(axis.first)}, {"step", to_text(axis.step)}, {"closed", axis.closed}};
}

Json result_json(const RefineCommand& options, const std::string& scheme, const DataFile& file, data::Boundary boundary,
                 const data::GridData<double>& refined) {
  const data::Axis& axis = refined.axes[0];
  const std::vector<std::string> names = file.names();
  Json json{{"scheme", scheme}, {"levels", options.levels}, {"limit", options.limit}, {"boundary", to_text(boundary)}};
  if (refined.axes.size() == 1) {
    json["closed"] = axis.closed;
    json["count"] = axis.count;
    json["first"] = to_text(axis.first);
    json["step"] = to_text(axis.step);
  } else {
    json["axes"] = Json::array();
    for (const data::Axis& one : refined.axes) json["axes"].push_back(axis_json(one));
  }
  if (refined.axes.size() == 1 || !names.empty()) json["columns"] = names;
  json["points"] = points_json(refined);
  return json;
}

/// Which of the directions are closed.
std::array<bool, 3> closed_directions(const RefineCommand& options, std::size_t variables, data::Boundary boundary) {
  std::array<bool, 3> closed = options.closed_directions;
  const auto end = closed.begin() + static_cast<std::ptrdiff_t>(variables);
  if (options.closed) std::fill(closed.begin(), end, true);
  if ((boundary == data::Boundary::reflect || boundary == data::Boundary::shrink) &&
      std::all_of(closed.begin(), end, [](bool c) { return c; }))
    fail(ErrorKind::usage, "--boundary {}: closed data have no boundary; leave out one of the two options",
         options.boundary);
  return closed;
}

/// The mask of a scheme whose result need not be held in memory.
const LatticeMask* mask_for_slabs(const RefineCommand& options, const AnyScheme& scheme) {
  const auto* linear = std::get_if<Scheme>(&scheme);
  const bool whole = options.json || options.limit || !options.plot.empty() || !linear || !linear->mask.has_factors();
  return whole ? nullptr : &linear->mask;
}

ExitCode run(const RefineCommand& options) {
  const data::Boundary boundary = *data::parse_boundary(options.boundary);
  const AnyScheme scheme = data::make_data_scheme(options.scheme);
  const std::string& name = specification_of(scheme);
  const std::vector<std::size_t> fewest = fewest_points(scheme, boundary);
  require_picture_name(options.plot);
  const std::array<bool, 3> closed = closed_directions(options, fewest.size(), boundary);
  const std::optional<LatticeMask> mask = options.limit ? std::optional(mask_with_limits(scheme)) : std::nullopt;
  DataFile file = read_data_file(options.data, fewest.size(), closed);
  if (boundary == data::Boundary::periodic)
    for (data::Axis& axis : file.data.axes) axis.close();
  check_data(file, options.data, name, fewest, fewest_points(scheme, data::Boundary::periodic));
  require_columns(scheme, file.data, [&](std::optional<std::size_t> row) {
    return input_name(options.data) + (row ? ", line " + std::to_string(file.table.lines[*row]) : "");
  });
  if (!options.plot.empty()) require_drawable(options.plot, without_derivatives(scheme, file.data));
  for (const std::string& line : file.remarks()) options.remark(input_name(options.data) + ": " + line);
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme))
    for (const std::string& line : data::remarks(*l1)) options.remark(line);
  const data::RefineOptions how{options.levels, boundary, options.threads()};
  if (const LatticeMask* factors = mask_for_slabs(options, scheme)) {
    const data::SlabRefinement slabs(file.data, *factors, how);
    options.answer([&](std::ostream& stream) {
      write_data(
          stream, file, slabs.axes(), [&](const auto& take) { slabs.run(take); }, options.threads());
    });
    return done;
  }
  const data::GridData<double> refined = mask ? limit_of_data(file.data, *mask, how) : refine(file.data, scheme, how);
  if (!options.plot.empty())
    draw_refined(options.plot, name, file.table, without_derivatives(scheme, file.data),
                 without_derivatives(scheme, refined));
  if (options.json)
    options.answer(result_json(options, name, file,
                               fewest.size() == 1 && file.data.axes[0].closed ? data::Boundary::periodic : boundary,
                               refined));
  else
    options.answer([&](std::ostream& stream) {
      const PointSource all = [&](const auto& take) { take(refined.values.data(), refined.points()); };
      write_data(stream, file, refined.axes, all, options.threads());
    });
  return done;
}

}  // namespace

void add_refine(Command& app) {
  auto options = std::make_shared<RefineCommand>();
  Command command = add_command(app, "refine", "Applies a scheme to data",
                                "subcert refine primal:n=3 samples.csv --levels 4", options,
                                [=] { return run(*options); });
  add_scheme(command, options->scheme, true, true);
  command
      .option("DATA", options->data,
              "CSV: points in rows, for Hermite schemes values, then derivatives, also after one column of positions; "
              "or a matrix of heights for a scheme of two variables; .obj, .ply: a mesh of "
              "quadrilaterals; .vtk: a regular volume; - is standard input, read as CSV")
      .required();
  command.option("--levels", options->levels, "How often the scheme is applied").within(0, 1000000000).with_default();
  command.flag("--limit", options->limit, "Values of the limit at the parameters i / arity^LEVELS, at the data for 0");
  command.flag("--closed", options->closed, "The first point follows the last, in every direction");
  command.flag("--closed-x", options->closed_directions[0], "The same in the first direction alone");
  command.flag("--closed-y", options->closed_directions[1], "The same in the second direction alone");
  command.flag("--closed-z", options->closed_directions[2], "The same in the third direction alone");
  command.option("--boundary", options->boundary, "What rules at the ends read")
      .one_of(data::refinement_boundary_names())
      .with_default();
  command.option("--plot", options->plot, "Draw data and result, as .svg, .png, .pdf, .tex or .html");
}

}  // namespace subcert::cli
