// subcert refine SCHEME|FILE.toml DATA

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/cli/commands/level_values.hpp>
#include <subcert/cli/data_file.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/vertex_arguments.hpp>
#include <subcert/proofs-checks/vertex_rules_file.hpp>
#include <subcert/schemes/data/l1/l1_remarks.hpp>
#include <subcert/schemes/data/mesh/mesh_refinement.hpp>
#include <subcert/schemes/data/refine/slab_refinement.hpp>
#include <subcert/schemes/data/scheme_refinement.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <utility>

namespace subcert::cli {
namespace {

struct RefineCommand : CommonOptions {
  std::string scheme;
  std::string data;
  int levels = 5;
  bool closed = false;
  std::array<bool, 3> closed_directions{false, false, false};
  std::string boundary = data::refinement_boundary_names().front();
  double constant = 0;
  std::string plot;
  std::vector<std::string> beside;  ///< schemes in the same picture
  bool limit = false;
  bool normals = false;
  bool join = false;
  double crease = 180;
  LevelOptions level_options;
};

/// Of whatever acts on data.
AnyScheme make_scheme_for_data(const RefineCommand& options) {
  const auto levels = read_levels(options.scheme, options.level_options);
  if (!levels) return data::make_data_scheme(options.scheme);
  if (const auto* given = std::get_if<LevelDependentScheme>(&*levels)) return *given;
  return std::get<FollowedFamily>(*levels).levels(options.levels);
}

/// The mask of which limits are drawn, where these are proved to exist.
LatticeMask mask_with_limits(const AnyScheme& scheme) {
  const std::optional<LatticeMask> mask = mask_with_factors(scheme);
  if (!mask)
    fail(ErrorKind::usage, "--limit: {}: limits are of schemes of numbers in one variable and their tensor products",
         specification_of(scheme));
  require_derivative(specification_of(scheme), *mask, LatticePoint(mask->factors().size(), 0));
  return *mask;
}

/// Lists as Json::dump(2) writes them in an object, one for each point or face.
class ListOfLists {
 public:
  explicit ListOfLists(std::ostream& stream) : stream_(stream) {}

  template <class Numbers>
  void add(const Numbers& numbers) {
    text_ += std::exchange(before_, ",\n");
    text_ += "    [\n";
    const char* between = "      ";
    for (const auto number : numbers) text_ += std::exchange(between, ",\n      ") + Json(number).dump();
    text_ += "\n    ]";
    if (text_.size() > 65536) stream_ << std::exchange(text_, {});
  }
  void end() { stream_ << text_ << "\n  ]"; }

 private:
  std::ostream& stream_;
  std::string text_;
  const char* before_ = "[\n";
};

void write_points(std::ostream& stream, std::size_t dimension, const PointSource& source) {
  ListOfLists list(stream);
  source([&](const double* values, std::size_t points) {
    for (std::size_t i = 0; i < points; ++i) list.add(std::span(values + i * dimension, dimension));
  });
  list.end();
}

Json axis_json(const data::Axis& axis) {
  return {{"count", axis.count}, {"first", to_text(axis.first)}, {"step", to_text(axis.step)}, {"closed", axis.closed}};
}

/// All but the points.
Json result_json(const RefineCommand& options, const std::string& scheme, const DataFile& file, data::Boundary boundary,
                 const std::vector<data::Axis>& axes) {
  const data::Axis& axis = axes[0];
  const std::vector<std::string> names = file.names();
  Json json{{"scheme", scheme}, {"levels", options.levels}, {"limit", options.limit}, {"boundary", to_text(boundary)}};
  if (axes.size() == 1) {
    json["closed"] = axis.closed;
    json["count"] = axis.count;
    json["first"] = to_text(axis.first);
    json["step"] = to_text(axis.step);
  } else {
    json["axes"] = Json::array();
    for (const data::Axis& one : axes) json["axes"].push_back(axis_json(one));
  }
  if (axes.size() == 1 || !names.empty()) json["columns"] = names;
  return json;
}

/// Which of the directions are closed.
std::array<bool, 3> closed_directions(const RefineCommand& options, std::size_t variables, data::Boundary boundary) {
  std::array<bool, 3> closed = options.closed_directions;
  const auto end = closed.begin() + static_cast<std::ptrdiff_t>(variables);
  if (options.closed) std::fill(closed.begin(), end, true);
  if (boundary != data::Boundary::regression && boundary != data::Boundary::periodic &&
      std::all_of(closed.begin(), end, [](bool c) { return c; }))
    fail(ErrorKind::usage, "--boundary {}: closed data have no boundary; leave out one of the two options",
         options.boundary);
  return closed;
}

/// Whatever writes a list in the place of one of these fields.
using ListWriter = std::function<void(std::ostream&)>;

/// The answer as JSON, its long lists piece by piece, after all other fields.
void answer_json(const RefineCommand& options, Json json,
                 const std::vector<std::pair<const char*, ListWriter>>& lists) {
  for (const auto& [name, write] : lists) json[name] = std::string("(") + name + ")";
  const std::string text = json_text(std::move(json));
  options.answer([&](std::ostream& stream) {
    std::size_t at = 0;
    for (const auto& [name, write] : lists) {
      const std::string mark = std::string("\"(") + name + ")\"";
      const std::size_t found = text.find(mark);
      stream << text.substr(at, found - at);
      write(stream);
      at = found + mark.size();
    }
    stream << text.substr(at);
  });
}

/// Whether the data are a mesh that the scheme refines whatever its topology.
bool is_mesh_scheme(const RefineCommand& options, const AnyScheme& scheme) {
  return data::mesh_format(options.data) && std::holds_alternative<Scheme>(scheme) &&
         data::has_mesh_rules(specification_of(scheme));
}

/// Rules of a file, which are of meshes.
VertexScheme written_rules(const RefineCommand& options) {
  if (!data::mesh_format(options.data))
    fail(ErrorKind::usage, "{}: rules at vertices refine meshes, .obj, .ply, .off, .stl; got {}", options.scheme,
         input_name(options.data));
  const LevelOptions& levels = options.level_options;
  if (!levels.recurrence.empty() || !levels.start.empty() || !levels.values.empty())
    fail(ErrorKind::usage, "{}: rules at vertices are the same on all levels", options.scheme);
  VertexScheme scheme = read_vertex_rules(read_input(options.scheme), options.scheme);
  require_values(scheme, "refine");
  return scheme;
}

void require_mesh_options(const RefineCommand& options, const std::string& scheme) {
  const auto refuse = [&](const char* option, const char* why) {
    fail(ErrorKind::usage, "{}: {}: {}", option, scheme, why);
  };
  if (options.boundary != data::refinement_boundary_names().front())
    refuse("--boundary", "a mesh has the boundary rules of the scheme");
  if (options.closed || std::ranges::count(options.closed_directions, true) > 0)
    refuse("--closed", "the faces of a mesh say where it is closed");
  if (!options.plot.empty())
    refuse("--plot", "meshes that are no grids are not drawn; --out writes .obj, .ply, .off, .stl");
}

ExitCode run_mesh(const RefineCommand& options, const VertexScheme& rules) {
  const std::string& scheme = rules.specification;
  require_mesh_options(options, scheme);
  data::MeshFile file = read_mesh_file(options.data, options.out, options.join);
  if (file.format == data::MeshFormat::stl && options.normals)
    fail(ErrorKind::usage, "--normals: an STL file has none at vertices; write .obj, .ply or .off");
  for (const std::string& line : file.remarks) options.remark(input_name(options.data) + ": " + line);
  const data::PolygonMesh refined = refine_mesh(std::exchange(file.mesh, {}), rules,
                                                {options.levels, options.limit, options.normals,
                                                 options.crease < 180 ? std::optional(options.crease) : std::nullopt},
                                                [&](std::size_t face) { return file.place(face); });
  if (options.normals)
    for (const char* name : {"nx", "ny", "nz"}) file.properties.push_back({name});
  if (!options.json) {
    if (file.format == data::MeshFormat::stl && !refined.has_only(3))
      fail(ErrorKind::usage, "--out: an STL file holds triangles; {} makes other faces: write .obj, .ply or .off",
           scheme);
    options.answer([&](std::ostream& stream) { write_mesh(stream, file, refined); });
    return done;
  }
  Json json{{"scheme", scheme}, {"levels", options.levels}, {"limit", options.limit}, {"columns", Json::array()}};
  for (const data::VertexProperty& property : file.properties) json["columns"].push_back(property.name);
  const auto points = [&](std::ostream& stream) {
    write_points(stream, refined.dimension, [&](const auto& take) { take(refined.values.data(), refined.vertices()); });
  };
  const auto faces = [&](std::ostream& stream) {
    ListOfLists list(stream);
    for (std::size_t f = 0; f < refined.faces(); ++f) list.add(refined.face(f));
    list.end();
  };
  answer_json(options, std::move(json), {{"points", points}, {"faces", faces}});
  return done;
}

/// What other schemes make of the same data, of which that many numbers are drawn.
std::vector<NamedGrid> refined_beside(const RefineCommand& options, const DataFile& file,
                                      const data::RefineOptions& how, std::size_t drawn) {
  std::vector<NamedGrid> result;
  for (const std::string& specification : options.beside) {
    const AnyScheme scheme = data::make_data_scheme(specification);
    const std::string& name = specification_of(scheme);
    const std::vector<std::size_t> fewest = fewest_points(scheme, how.boundary);
    if (fewest.size() != file.data.axes.size())
      fail(ErrorKind::usage, "--beside {}: expected a scheme of as many variables as {}", specification,
           options.scheme);
    check_data(file, options.data, name, fewest, fewest_points(scheme, data::Boundary::periodic));
    if (without_derivatives(scheme, file.data).dimension != drawn)
      fail(ErrorKind::usage, "--beside {}: expected a scheme that reads the columns as {} does", specification,
           options.scheme);
    auto steps = options.limit
                     ? std::optional(limit_steps(file.data.axes, file.data.dimension, mask_with_limits(scheme), how))
                     : refinement_steps(file.data.axes, file.data.dimension, scheme, how);
    result.emplace_back(name,
                        without_derivatives(scheme, steps ? data::SlabRefinement(file.data, *std::move(steps)).whole()
                                                          : refine(file.data, scheme, how)));
  }
  return result;
}

ExitCode run(const RefineCommand& options) {
  if (is_rules_file(options.scheme)) return run_mesh(options, written_rules(options));
  const data::Boundary boundary = *data::parse_boundary(options.boundary);
  const AnyScheme scheme = make_scheme_for_data(options);
  const std::string& name = specification_of(scheme);
  if (is_mesh_scheme(options, scheme)) return run_mesh(options, VertexScheme::named(name));
  if (options.normals || options.join || options.crease < 180)
    fail(ErrorKind::usage, "{}: of a mesh and one of {}; {} refines grids",
         options.normals ? "--normals"
         : options.join  ? "--join"
                         : "--crease",
         fmt::join(data::schemes_with_mesh_rules(), ", "), name);
  const std::vector<std::size_t> fewest = fewest_points(scheme, boundary);
  require_picture_name(options.plot);
  if (!options.beside.empty() && options.plot.empty())
    fail(ErrorKind::usage, "--beside: expected --plot, whose picture has these schemes, too");
  const std::array<bool, 3> closed = closed_directions(options, fewest.size(), boundary);
  const std::optional<LatticeMask> mask = options.limit ? std::optional(mask_with_limits(scheme)) : std::nullopt;
  DataFile file = read_data_file(options.data, fewest.size(), closed, !options.json);
  if (boundary == data::Boundary::periodic)
    for (data::Axis& axis : file.data.axes) axis.close();
  check_data(file, options.data, name, fewest, fewest_points(scheme, data::Boundary::periodic));
  require_columns(scheme, file.data, [&](std::optional<std::size_t> row) {
    return input_name(options.data) + (row ? ", line " + std::to_string(file.lines.at(*row)) : "");
  });
  if (!options.plot.empty()) require_drawable(options.plot, without_derivatives(scheme, file.data));
  for (const std::string& line : file.remarks()) options.remark(input_name(options.data) + ": " + line);
  if (const auto* l1 = std::get_if<DataDependentScheme>(&scheme))
    for (const std::string& line : data::remarks(*l1)) options.remark(line);
  const data::RefineOptions how{options.levels, boundary, options.threads(), options.constant};
  auto steps = mask ? std::optional(limit_steps(file.data.axes, file.data.dimension, *mask, how))
                    : refinement_steps(file.data.axes, file.data.dimension, scheme, how);
  // A picture needs all points, and so do vectors.
  std::optional<data::GridData<double>> whole;
  if (!steps) whole = refine(file.data, scheme, how);
  const data::SlabRefinement slabs(file.data, steps ? *std::exchange(steps, {}) : data::SliceSteps());
  if (!whole && !options.plot.empty()) whole = slabs.whole();
  const PointSource source = [&](const auto& take) {
    if (whole) return take(whole->values.data(), whole->points());
    slabs.run(take);
  };
  const std::vector<data::Axis>& axes = whole ? whole->axes : slabs.axes();
  if (!options.plot.empty()) {
    const data::GridData<double> points = without_derivatives(scheme, file.data);
    std::vector<NamedGrid> drawn = refined_beside(options, file, how, points.dimension);
    drawn.insert(drawn.begin(), {name, without_derivatives(scheme, *whole)});
    draw_refined(options.plot, file.table, points, drawn);
  }
  if (options.json) {
    const bool round = fewest.size() == 1 && file.data.axes[0].closed;
    const auto points = [&](std::ostream& stream) { write_points(stream, file.data.dimension, source); };
    answer_json(options, result_json(options, name, file, round ? data::Boundary::periodic : boundary, axes),
                {{"points", points}});
  } else {
    options.answer([&](std::ostream& stream) { write_data(stream, file, axes, source, options.threads()); });
  }
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
              "or a matrix of heights for a scheme of two variables; .obj, .ply, .off, .stl: "
              "a mesh; .vtk: a regular volume; - is standard input, read as CSV")
      .required();
  command.option("--levels", options->levels, "How often the scheme is applied").within(0, 1000000000).with_default();
  command.flag("--limit", options->limit, "Values of the limit at the parameters i / arity^LEVELS, at the data for 0");
  command.flag("--normals", options->normals, "Of a mesh: the normals of the limit surface at its vertices, too");
  command.flag("--join", options->join, "Of a mesh: vertices all of whose numbers are equal are made one");
  command
      .option("--crease", options->crease,
              "Of a mesh: edges stay sharp where the normals of their faces differ by more degrees")
      .within(0, 180)
      .with_default();
  command.flag("--closed", options->closed, "The first point follows the last, in every direction");
  command.flag("--closed-x", options->closed_directions[0], "The same in the first direction alone");
  command.flag("--closed-y", options->closed_directions[1], "The same in the second direction alone");
  command.flag("--closed-z", options->closed_directions[2], "The same in the third direction alone");
  command
      .option("--boundary", options->boundary,
              "What rules at the ends read; an open curve begins and ends at the first and last point where the scheme "
              "is interpolatory, else near them")
      .one_of(data::refinement_boundary_names())
      .with_default();
  command.option("--constant", options->constant, "The value of --boundary constant")
      .within(-1e300, 1e300)
      .with_default();
  add_level_options(command, options->level_options);
  command.option("--plot", options->plot, "Draw data and result, as .svg, .png, .pdf, .tex or .html");
  command.option("--beside", options->beside, "Another scheme in that picture, once for each")
      .one_each()
      .suggest(suggested_schemes);
}

}  // namespace subcert::cli
