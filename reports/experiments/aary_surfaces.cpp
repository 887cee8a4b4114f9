// [MB16, sec. 3, Figures 4 and 5]: surfaces by the 16-point and 25-point schemes that are no tensor products.

#include "families.hpp"
#include "refined_data.hpp"

#include <subcert/analysis/difference/multivariate_convergence.hpp>
#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>
#include <subcert/schemes/data/refine/grid_refinement.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace subcert::experiments::aary_surfaces {
namespace {

constexpr int drawn_levels = 3, limit_level = 5;

/// A surface in space over columns and rows, both given as parts of 2 pi; `column` always goes around.
struct Mesh {
  std::string words;
  std::size_t columns;
  std::size_t rows;
  bool closed_rows;
  double zoom;  // of the picture
  std::array<double, 3> (*point)(double column, double row);
};

/// A vase with eight sides, turned as it rises.
std::array<double, 3> vase(double column, double row) {
  const double height = row / (2 * std::numbers::pi);  // from 0 to 1
  const double radius = 1.7 + 0.9 * std::sin(2 * std::numbers::pi * height + 0.4) - 0.3 * height;
  const double angle = column + 0.7 * height;
  return {radius * std::cos(angle), radius * std::sin(angle), 6 * height};
}

/// A tube around a three-lobed closed curve that rises and falls.
std::array<double, 3> ring(double column, double row) {
  const double lobes = 6 + 1.5 * std::cos(3 * column), radius = 1.8 + 0.5 * std::sin(3 * column);
  const double out = lobes + radius * std::cos(row);
  return {out * std::cos(column), out * std::sin(column), radius * std::sin(row) + 1.2 * std::sin(3 * column)};
}

data::GridData<double> points_of(const Mesh& mesh) {
  data::GridData<double> data{{}, 3, {data::Axis::of(mesh.columns, true), data::Axis::of(mesh.rows, mesh.closed_rows)}};
  const double turn = 2 * std::numbers::pi;
  const auto last = static_cast<double>(mesh.closed_rows ? mesh.rows : mesh.rows - 1);
  for (std::size_t j = 0; j < mesh.rows; ++j)
    for (std::size_t i = 0; i < mesh.columns; ++i) {
      const auto point = mesh.point(turn * static_cast<double>(i) / static_cast<double>(mesh.columns),
                                    turn * static_cast<double>(j) / last);
      data.values.insert(data.values.end(), point.begin(), point.end());
    }
  return data;
}

struct SurfaceExperiment {
  std::string id;
  std::string figure;
  std::string title;
  int points;  // along each axis
  Mesh mesh;
};

/// Whether the coefficients are products of a function of i and one of j: all minors with the leading coefficient
/// vanish.
bool is_product(const MultivariatePolynomial& symbol) {
  const auto terms = symbol.terms();
  const auto& pivot = terms.front();
  const auto low = symbol.lowest(), high = symbol.highest();
  for (long i = low[0]; i <= high[0]; ++i)
    for (long j = low[1]; j <= high[1]; ++j)
      if (symbol.coefficient({i, j}) * pivot.coefficient !=
          symbol.coefficient({i, pivot.exponents[1]}) * symbol.coefficient({pivot.exponents[0], j}))
        return false;
  return true;
}

/// The numbers of data that the four rules combine, without repetition.
std::vector<long> data_of_rules(const MultivariateMask& mask) {
  std::vector<long> result;
  for (const long i : {0, 1})
    for (const long j : {0, 1}) {
      const long count = mask.symbol().coset(2, {i, j}).count();
      if (std::find(result.begin(), result.end(), count) == result.end()) result.push_back(count);
    }
  return result;
}

/// The largest distance between two surfaces at the parameters of the second, over the diameter of the second.
double relative_distance(const data::GridData<double>& mesh, const data::GridData<double>& limit) {
  const auto all = distances(mesh_at(mesh, limit.axes), limit.values, 3);
  return *std::max_element(all.begin(), all.end()) / diameter(limit.values, 3);
}

void add_exact_claims(ExperimentResult& result, const SurfaceExperiment& experiment, const MultivariateMask& mask) {
  const long wanted = static_cast<long>(experiment.points) * experiment.points;
  const std::string name = std::to_string(wanted) + "-point";
  Evidence product, size, degree, convergence;
  product.require("", !is_product(mask.symbol()), is_product(mask.symbol()) ? "a product" : "no product");
  std::string counts;
  for (const long count : data_of_rules(mask)) counts += (counts.empty() ? "" : ", ") + std::to_string(count);
  size.require("", counts == std::to_string(wanted), counts);
  const int reproduced = polynomial_reproduction(mask).reproduction_degree;
  degree.require("", reproduced >= 3, "total degree " + std::to_string(reproduced));
  const Decision decision = converges(mask);
  convergence.require("", decision.is_yes(), to_text(decision.truth) + ", " + decision.reason);
  result.claims = {product.decides({"The " + name + " scheme is no tensor product.", "Sec. 3, " + experiment.figure},
                                   "the coefficients are no products of two sequences, exact"),
                   size.decides({"It is a " + name + " scheme.", "Sec. 3, " + experiment.figure},
                                "the data with non-zero weight in each of the four rules"),
                   degree.decides({"It fits bivariate cubic polynomials to the data (read as: cubic data are kept).",
                                   "Sec. 3, " + experiment.figure},
                                  "reproduction of total degree 3, exact"),
                   convergence.decides({"It produces the limit surface of panel (e).", experiment.figure + "(e)"},
                                       "convergence is proved")};
}

ExperimentResult run(const SurfaceExperiment& experiment) {
  const std::string side = std::to_string(experiment.points);
  const std::string specification = "grid:points=" + side + "x" + side + ",d=3";
  const auto scheme = std::get<MultivariateScheme>(make_any_scheme(specification));
  ExperimentResult result{{"The mesh is not published. Ours is " + experiment.mesh.words + ". Scheme: " +
                           specification + "; open ends take the scheme's own fit. Level 5 stands for the limit."}};
  result.random = false;
  add_exact_claims(result, experiment, scheme.mask);
  const data::GridData<double> mesh = points_of(experiment.mesh), limit = refine(mesh, scheme.mask, {limit_level});
  formats::SurfaceFigure figure{experiment.id, experiment.title, "", {drawn_surface("initial mesh", mesh)}, 3};
  formats::PlainTable table{experiment.id + "-levels",
                            "Distance from level 5 at the same parameters, over the diameter",
                            {"level", "points", "largest distance"},
                            {}};
  Evidence approach;
  double last = relative_distance(mesh, limit);
  table.rows.push_back({"0", std::to_string(mesh.points()), short_number(last)});
  for (int level = 1; level <= drawn_levels; ++level) {
    const data::GridData<double> refined = refine(mesh, scheme.mask, {level});
    const double distance = relative_distance(refined, limit);
    figure.surfaces.push_back(drawn_surface("level " + std::to_string(level), refined));
    table.rows.push_back({std::to_string(level), std::to_string(refined.points()), short_number(distance)});
    approach.require("level " + std::to_string(level),
                     distance < last && (level < drawn_levels || distance < 1.0 / 200), short_number(distance));
    last = distance;
  }
  figure.surfaces.push_back(drawn_surface("limit surface", limit));
  for (formats::DrawnSurface& surface : figure.surfaces) surface.zoom = experiment.mesh.zoom;
  result.claims.push_back(approach.decides({"The meshes of the first three levels lead to the limit surface (read as: "
                                            "the distance falls, and is below 1/200 of the diameter at level 3).",
                                            experiment.figure + "(b)-(e)"},
                                           "largest distance from level 5 at the same parameters, over the diameter"));
  result.tables.push_back(table);
  result.surface_figures.push_back(figure);
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  const std::vector<SurfaceExperiment> surfaces{
      {"aary-fig4",
       "Fig. 4",
       "A vase by the 16-point scheme",
       4,
       {"a vase with 8 x 9 vertices, closed around its axis and turned as it rises", 8, 9, false, 1.1, vase}},
      {"aary-fig5",
       "Fig. 5",
       "A ring with three lobes by the 25-point scheme",
       5,
       {"a tube of 18 x 6 vertices around a closed curve with three lobes, closed in both directions", 18, 6, true, 2,
        ring}}};
  std::vector<Experiment> result;
  for (const SurfaceExperiment& surface : surfaces)
    result.push_back({surface.id, "mustafa-bari-2016", "Figure " + surface.figure.substr(5) + ": " + surface.title,
                      [surface](const ExperimentOptions&) { return run(surface); }});
  return result;
}

}  // namespace subcert::experiments::aary_surfaces
