// [MB16, sec. 3, Figures 4 and 5]: surfaces by the 16-point and 25-point schemes that are no tensor products.

#include "parts.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/reports/experiments/figures.hpp>
#include <subcert/reports/experiments/refined_data.hpp>
#include <subcert/reports/formats/limit_figure.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace subcert::experiments::mustafa_bari_2016 {
namespace {

constexpr int drawn_levels = 3, limit_level = 5;

/// A surface in space over columns and rows, both given as parts of 2 pi; `column` always goes around.
struct Mesh {
  std::size_t columns;
  std::size_t rows;
  bool closed_rows;
  double zoom;  // of the picture
  std::array<double, 3> (*point)(double column, double row);
};

/// A vase with eight sides, turned as it rises.
std::array<double, 3> vase_point(double column, double row) {
  const double height = row / (2 * std::numbers::pi);  // from 0 to 1
  const double radius = 1.7 + 0.9 * std::sin(2 * std::numbers::pi * height + 0.4) - 0.3 * height;
  const double angle = column + 0.7 * height;
  return {radius * std::cos(angle), radius * std::sin(angle), 6 * height};
}

/// A tube around a three-lobed closed curve that rises and falls.
std::array<double, 3> ring_point(double column, double row) {
  const double lobes = 6 + 1.5 * std::cos(3 * column), radius = 1.8 + 0.5 * std::sin(3 * column);
  const double out = lobes + radius * std::cos(row);
  return {out * std::cos(column), out * std::sin(column), radius * std::sin(row) + 1.2 * std::sin(3 * column)};
}

data::GridData<double> points_of_mesh(const Mesh& mesh) {
  const double turn = 2 * std::numbers::pi, columns = static_cast<double>(mesh.columns),
               rows = static_cast<double>(mesh.closed_rows ? mesh.rows : mesh.rows - 1);
  return sampled({data::Axis::of(mesh.columns, true), data::Axis::of(mesh.rows, mesh.closed_rows)}, 3,
                 [&](double i, double j) { return mesh.point(turn * i / columns, turn * j / rows); });
}

struct MeshExperiment {
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
std::vector<long> data_of_rules(const LatticeMask& mask) {
  std::vector<long> result;
  for (const long i : {0, 1})
    for (const long j : {0, 1}) {
      const long count = mask.symbol().coset(2, {i, j}).count();
      if (std::find(result.begin(), result.end(), count) == result.end()) result.push_back(count);
    }
  return result;
}

/// The largest distance between two surfaces at the parameters of the second, over the diameter of the second.
double distance_between(const data::GridData<double>& mesh, const data::GridData<double>& limit) {
  return relative_distance(mesh_at(mesh, limit.axes), limit.values, 3);
}

/// Whether the scheme converges is one of them, and the answer.
Decision find_exact_facts(Measured& measured, int side, const LatticeMask& mask) {
  const bool product = is_product(mask.symbol());
  measured.add_fact("product", "", !product, product ? "a product" : "no product");
  std::string counts;
  for (const long count : data_of_rules(mask)) counts += (counts.empty() ? "" : ", ") + std::to_string(count);
  measured.add_fact("size", "", counts == std::to_string(side * side), counts);
  const int reproduced = polynomial_reproduction(mask).reproduction_degree;
  measured.add_fact("degree", "", reproduced >= 3, "total degree " + std::to_string(reproduced));
  Decision decision = converges(mask);
  measured.add_fact("convergence", "", decision.is_yes(), to_text(decision.truth) + ", " + decision.reason);
  return decision;
}

formats::SurfaceFigure limit_function_figure(const std::string& id, const std::string& points, const Scheme& scheme) {
  return {id + "-limit-function",
          "The basic limit function of the " + points + "-point scheme",
          "Exact values, rounded for the picture, over the support.",
          {formats::limit_surface(scheme.mask, scheme.specification)},
          1};
}

Measured measured_surface(const MeshExperiment& experiment, const Run& run) {
  const std::string side = std::to_string(experiment.points), id = run.experiment.id;
  const auto scheme = make_linear_scheme("grid:points=" + side + "x" + side + ",d=3");
  Measured result;
  const Decision convergence = find_exact_facts(result, experiment.points, scheme.mask);
  const data::GridData<double> mesh = points_of_mesh(experiment.mesh), limit = refine(mesh, scheme.mask, {limit_level});
  formats::SurfaceFigure figure{id, experiment.title, "", {drawn_surface("initial mesh", mesh)}, 3};
  formats::PlainTable table{id + "-levels",
                            "Distance from level 5 at the same parameters, over the diameter",
                            {"level", "points", "largest distance"},
                            {}};
  double last = distance_between(mesh, limit);
  table.rows.push_back({"0", std::to_string(mesh.points()), short_number(last)});
  for (int k = 1; k <= drawn_levels; ++k) {
    const data::GridData<double> refined = refine(mesh, scheme.mask, {k});
    const double distance = distance_between(refined, limit);
    const std::string name = "level " + std::to_string(k);
    figure.surfaces.push_back(drawn_surface(name, refined));
    table.rows.push_back({std::to_string(k), std::to_string(refined.points()), short_number(distance)});
    result.add_fact("approach", name, distance < last && (k < drawn_levels || distance < 1.0 / 100),
                    short_number(distance));
    last = distance;
  }
  figure.surfaces.push_back(drawn_surface("limit surface", limit));
  for (formats::DrawnSurface& surface : figure.surfaces) surface.zoom = experiment.mesh.zoom;
  result.tables = {table};
  result.surface_figures = {figure};
  if (convergence.is_yes())
    result.surface_figures.push_back(
        limit_function_figure(id, std::to_string(experiment.points * experiment.points), scheme));
  return result;
}

}  // namespace

Measured vase(const Run& run) {
  return measured_surface({"A vase by the 16-point scheme", 4, {8, 9, false, 1.1, vase_point}}, run);
}

Measured ring(const Run& run) {
  return measured_surface({"A ring with three lobes by the 25-point scheme", 5, {18, 6, true, 2, ring_point}}, run);
}

}  // namespace subcert::experiments::mustafa_bari_2016
