#include "arrays.hpp"
#include "work.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/vertex/every_valence.hpp>
#include <subcert/analysis/vertex/weight_map.hpp>
#include <subcert/proofs-checks/vertex_rules_file.hpp>
#include <subcert/reports/facts/stencil_facts.hpp>
#include <subcert/reports/facts/weight_facts.hpp>
#include <subcert/schemes/data/mesh/mesh_refinement.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <cmath>
#include <variant>

namespace subcert::python {
namespace {

using IndexArray = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

py::array_t<std::int64_t> indices_of(const std::vector<std::uint32_t>& numbers) {
  py::array_t<std::int64_t> result(static_cast<py::ssize_t>(numbers.size()));
  std::copy(numbers.begin(), numbers.end(), result.mutable_data());
  return result;
}

/// Vertices in rows; the corners of all faces, and how many of them each face has. The same of the result.
py::tuple refine_mesh(const std::variant<VertexScheme, std::string>& scheme, const DoubleArray& vertices,
                      const IndexArray& corners, const IndexArray& sides, int levels, bool limit, bool normals,
                      std::optional<double> crease, bool keep_faces, const py::object& progress) {
  if (vertices.ndim() != 2 || vertices.shape(1) == 0)
    fail(ErrorKind::domain, "vertices: need an array of two dimensions with a column or more");
  data::PolygonMesh mesh{numbers_of(vertices), static_cast<std::size_t>(vertices.shape(1)), {}, {0}};
  for (std::size_t i = 0; i < mesh.values.size(); ++i)
    if (!std::isfinite(mesh.values[i]))
      fail(ErrorKind::data, "refine: need finite numbers, got {} at vertex {}", mesh.values[i], i / mesh.dimension);
  if (std::max<py::ssize_t>(vertices.shape(0), corners.size()) > 4'000'000'000)
    fail(ErrorKind::size, "refine: need at most 4000000000 vertices and corners of faces");
  py::ssize_t at = 0;
  for (py::ssize_t f = 0; f < sides.size(); ++f) {
    for (py::ssize_t end = at + sides.data()[f]; at < end; ++at) {
      const std::int64_t vertex = corners.data()[at];
      if (vertex < 0 || vertex >= vertices.shape(0))
        fail(ErrorKind::data, "face {}: expected the number of a vertex from 0 to {}; found {}", f,
             vertices.shape(0) - 1, vertex);
      mesh.corners.push_back(static_cast<std::uint32_t>(vertex));
    }
    mesh.end_face();
  }
  data::PolygonMesh refined = interruptible(progress, [&] {
    return std::visit(
        [&](const auto& rules) {
          return data::refine_mesh(std::move(mesh), rules, {levels, limit, normals, crease, keep_faces},
                                   [](std::size_t face) { return "face " + std::to_string(face); });
        },
        scheme);
  });
  std::vector<std::uint32_t> counts;
  for (std::size_t f = 0; f < refined.faces(); ++f)
    counts.push_back(static_cast<std::uint32_t>(refined.face(f).size()));
  const auto rows = static_cast<py::ssize_t>(refined.vertices()), columns = static_cast<py::ssize_t>(refined.dimension);
  return py::make_tuple(array_of(std::move(refined.values)).reshape({rows, columns}), indices_of(refined.corners),
                        indices_of(counts));
}

VertexScheme vertex_scheme(const Scheme& scheme) {
  if (!has_vertex_rules(scheme)) fail(ErrorKind::domain, "{} has no rules at vertices", scheme.specification);
  return VertexScheme::named(scheme.specification);
}

template <class Valences>
void require_valences(const char* asked, const Valences& valences, long least) {
  for (const auto n : valences)
    if (n < least || n > largest_valence)
      fail(ErrorKind::domain, "{}: need valences from {} to {}, got {}", asked, least, largest_valence, n);
}

/// For each valence what is proved there.
py::list vertices(const VertexScheme& scheme, const std::vector<int>& valences, double seconds,
                  const py::object& progress) {
  require_valences("vertices", valences, smallest_valence);
  const auto found = interruptible(progress, [&] {
    const std::vector<SectorRules> rules = scheme.at(valences);
    if (rules.empty()) return std::vector<VertexSmoothness>{};
    return vertex_smoothness(rules, regular_part(rules.front(), {Deadline::in(seconds)}), all_cores());
  });
  py::list result;
  for (const VertexSmoothness& at : found) {
    const auto known = [](const Enclosure& value) {
      return value.lower || value.upper ? std::optional(value) : std::nullopt;
    };
    result.append(py::make_tuple(at.valence, at.c1, at.frequency, known(at.subdominant), known(at.next),
                                 known(at.exponent),
                                 at.curvature ? std::optional(to_text(*at.curvature)) : std::nullopt));
  }
  return result;
}

py::tuple every_valence_of(const VertexScheme& scheme, long first, double seconds, const py::object& progress) {
  const SectorRuleFamily family = scheme.family();
  require_valences("every_valence", std::vector<long>{first}, family.least);
  const EveryValence found = interruptible(progress, [&] {
    const Budget budget{Deadline::in(seconds)};
    return every_valence(family, regular_part(family.at(first), budget), first, budget);
  });
  py::list open;
  for (const EveryValence::Range& range : found.open) open.append(py::make_tuple(range.first, range.last));
  return py::make_tuple(found.first, found.c1, open, found.intervals);
}

/// (point, sector, weight, exact weight or None) of the limit and of both tangents.
py::list stencils_of(const VertexScheme& scheme, long valence, double seconds, const py::object& progress) {
  require_valences("vertex_stencils", std::vector<long>{valence}, smallest_valence);
  const VertexStencils found = interruptible(progress, [&] {
    const SectorRules rules = scheme.at(valence);
    return vertex_stencils(rules, vertex_smoothness(rules, regular_part(rules, {Deadline::in(seconds)})));
  });
  py::list result;
  for (const auto* stencil : {&found.limit, &found.tangents[0], &found.tangents[1]}) {
    py::list weights;
    for (const StencilWeight& weight : *stencil)
      weights.append(py::make_tuple(py::tuple(py::cast(weight.at.point)), weight.at.turn, weight.value,
                                    weight.exact
                                        ? std::optional(facts::exact_weight_text(weight, stencil == &found.tangents[1]))
                                        : std::nullopt));
    result.append(weights);
  }
  return result;
}

WrittenRules with_free_letters(const VertexScheme& scheme, const std::vector<std::string>& letters) {
  if (!scheme.written) fail(ErrorKind::usage, "{}: need rules with a letter", scheme.specification);
  return scheme.written->with_free(letters);
}

/// (valence, pieces, ends) for each valence.
py::list vertex_ranges(const VertexScheme& scheme, const std::string& letter, const std::string& property_text,
                       const Rational& low, const Rational& high, const Rational& width,
                       const std::vector<int>& valences, double seconds, int jobs, const py::object& progress) {
  require_valences("vertex_ranges", valences, smallest_valence);
  const WrittenRules written = with_free_letters(scheme, {letter});
  const WeightProperty property = facts::parse_weight_property(property_text, "property");
  const auto found = interruptible(progress, [&] {
    std::vector<WeightRange> ranges;
    const Budget budget{Deadline::in(seconds)};
    std::optional<RegularPart> regular;
    for (const int n : valences) {
      const SectorRules rules = rules_with_letters(written, n);
      if (!regular) regular = regular_part(rules, budget);
      ranges.push_back(weight_range(rules, *regular, property, low, high, width, jobs, budget));
    }
    return ranges;
  });
  py::list result;
  for (const WeightRange& range : found) {
    py::list pieces, ends;
    for (const WeightPiece& piece : range.pieces)
      pieces.append(py::make_tuple(piece.low, piece.high, piece.holds.truth, piece.holds.reason));
    for (const WeightEnd& end : range.ends)
      ends.append(py::make_tuple(Enclosure{end.low, end.high},
                                 end.value ? std::optional(to_text(*end.value, 'c')) : std::nullopt,
                                 facts::polynomial_text(end, letter.front()), end.holds.truth, end.holds.reason));
    result.append(py::make_tuple(range.valence, pieces, ends));
  }
  return result;
}

/// (cells, whether all that is not decided is small).
py::tuple vertex_map(const VertexScheme& scheme, const std::vector<std::string>& letters,
                     const std::string& property_text, const std::vector<Rational>& low,
                     const std::vector<Rational>& high, int valence, int resolution, double seconds, int jobs,
                     const py::object& progress) {
  require_valences("vertex_map", std::vector<int>{valence}, smallest_valence);
  const WrittenRules written = with_free_letters(scheme, letters);
  const WeightProperty property = facts::parse_weight_property(property_text, "property");
  const auto map = interruptible(progress, [&] {
    const Budget budget{Deadline::in(seconds)};
    const SectorRules rules = rules_with_letters(written, valence);
    return weight_map(rules, regular_part(rules, budget), property, {low, high}, {resolution, jobs, budget});
  });
  py::list cells;
  for (const MapCell& cell : map.cells)
    cells.append(
        py::make_tuple(py::tuple(py::cast(cell.box.low)), py::tuple(py::cast(cell.box.high)), cell.holds, cell.reason));
  return py::make_tuple(cells, map.complete);
}

}  // namespace

void add_meshes(py::module_& module) {
  py::class_<VertexScheme>(module, "VertexScheme")
      .def_readonly("specification", &VertexScheme::specification)
      .def_readonly("title", &VertexScheme::title);
  module.def("vertex_scheme", &vertex_scheme);
  module.def("read_vertex_rules", &read_vertex_rules);
  module.def("refine_mesh", &refine_mesh);
  module.def("vertices", &vertices);
  module.def("every_valence", &every_valence_of);
  module.def("vertex_stencils", &stencils_of);
  module.def("vertex_ranges", &vertex_ranges);
  module.def("vertex_map", &vertex_map);
}

}  // namespace subcert::python
