// [MB16, sec. 2.5, Figure 2]: polygons refined by the 4-point binary, ternary and quaternary schemes.

#include "batch.hpp"
#include "families.hpp"
#include "refined_data.hpp"

#include <subcert/schemes/data/refine/limit_of_data.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>

namespace subcert::experiments::aary_curves {
namespace {

struct Arity {
  int arity;
  std::string name;
  int level;  // of the values that stand for the limit, 64 or 81 for each edge
};

const std::vector<Arity> arities{{2, "binary", 6}, {3, "ternary", 4}, {4, "quaternary", 3}};
constexpr int drawn_levels = 3;

struct Polygon {
  std::string name;
  data::GridData<Rational> data;
};

/// A guitar's outline, and a wave that breaks.
std::vector<Polygon> polygons() {
  const auto pairs = [](const std::vector<std::pair<int, int>>& vertices, bool closed) {
    std::vector<Rational> values;
    for (const auto& [x, y] : vertices) values.insert(values.end(), {x, y});
    return data::curve_data<Rational>(values, 2, closed);
  };
  return {{"closed", pairs({{-9, 0},
                            {-8, 5},
                            {-4, 7},
                            {0, 3},
                            {4, 5},
                            {7, 2},
                            {13, 1},
                            {13, -1},
                            {7, -2},
                            {4, -5},
                            {0, -3},
                            {-4, -7},
                            {-8, -5}},
                           true)},
          {"open", pairs({{-10, 0},
                          {-7, 0},
                          {-4, 1},
                          {-1, 4},
                          {2, 8},
                          {6, 9},
                          {9, 7},
                          {9, 4},
                          {6, 3},
                          {4, 5},
                          {5, 1},
                          {8, -1},
                          {12, -1}},
                         false)}};
}

struct Refined {
  data::GridData<double> first;
  data::GridData<double> third;
  data::GridData<double> limit;
};

Refined refined(const Polygon& polygon, const Arity& arity) {
  const Mask mask = make_scheme("ary:a=" + std::to_string(arity.arity) + ",points=4,d=3").mask;
  return {rounded(refine(polygon.data, mask, {1})), rounded(refine(polygon.data, mask, {drawn_levels})),
          rounded(data::limit_of_data(polygon.data, {mask}, {arity.level}))};
}

/// The largest distance of a polygon from the limit at the same parameter, over the diameter of the limit.
double distance_to_limit(const data::GridData<double>& polygon, const data::GridData<double>& limit) {
  const auto all = distances(polygon_at(polygon, parameters(limit.axes[0])), limit.values, 2);
  return *std::max_element(all.begin(), all.end()) / diameter(limit.values, 2);
}

bool shares_a_point(const data::GridData<double>& first, const data::GridData<double>& second) {
  for (std::size_t i = 0; i < first.values.size(); i += 2)
    for (std::size_t j = 0; j < second.values.size(); j += 2)
      if (first.values[i] == second.values[j] && first.values[i + 1] == second.values[j + 1]) return true;
  return false;
}

formats::Panel panel(const std::string& title, const Polygon& polygon, const formats::Curve& curve) {
  return {title, "", "", {drawn_line("polygon", rounded(polygon.data), pale), curve}, false, "below", true};
}

ExperimentResult run(const ExperimentOptions&) {
  ExperimentResult result{
      {"The polygons are not published. A closed one with 13 vertices, the outline of a guitar, and an open one "
       "with 13, a breaking wave, both with integer coordinates, are refined by ary:a=2|3|4,points=4,d=3 in rational "
       "numbers; "
       "open ends take the scheme's own fit. Limits are exact at 64 or 81 parameters for each edge. The text names the "
       "panels (a)-(c) first "
       "level and (d)-(f) limits; the caption says (a), (c), (e) and (b), (d), (f)."}};
  result.random = false;
  formats::PlainTable table{"aary-fig2-distances",
                            "Distance from the limit at the same parameter, over the diameter of the limit curve",
                            {"polygon", "arity", "points at level 1", "initial polygon", "level 1", "level 3"},
                            {}};
  Evidence inserted, approximating, third;
  for (const Polygon& polygon : polygons()) {
    formats::Figure figure{"aary-fig2-" + polygon.name,
                           "First level and limit, " + polygon.name + " polygon",
                           "Left: the polygon and its first refinement; right: the limit curve.",
                           2,
                           {}};
    const data::GridData<double> data = rounded(polygon.data);
    for (const Arity& arity : arities) {
      const Refined curves = refined(polygon, arity);
      const double level3 = distance_to_limit(curves.third, curves.limit);
      table.rows.push_back({polygon.name, std::to_string(arity.arity), std::to_string(curves.first.points()),
                            short_number(distance_to_limit(data, curves.limit)),
                            short_number(distance_to_limit(curves.first, curves.limit)), short_number(level3)});
      if (polygon.data.axes[0].closed)
        inserted.require(arity.name, curves.first.points() == static_cast<std::size_t>(arity.arity) * data.points(),
                         std::to_string(curves.first.points()) + " points from " + std::to_string(data.points()));
      if (polygon.data.axes[0].closed)
        approximating.require(arity.name, !shares_a_point(data, curves.first),
                              shares_a_point(data, curves.first) ? "vertices are kept" : "no vertex is kept");
      third.require(polygon.name + " " + arity.name, level3 < 1.0 / 200, short_number(level3));
      figure.panels.push_back(panel(arity.name + ", level 1", polygon, drawn_line("level 1", curves.first, "#c0392b")));
      figure.panels.back().curves.back().marked = true;
      figure.panels.push_back(panel(arity.name + ", limit", polygon, drawn_line("limit", curves.limit, "#0b559f")));
    }
    result.figures.push_back(figure);
  }
  result.claims = {
      inserted.decides({"The arity is the number of points for each edge of the polygon.", "Sec. 1, Fig. 2(a,c,e)"},
                       "points of the first level for the closed polygon: arity times its vertices"),
      approximating.decides({"The schemes are approximating.", "Sec. 2, Fig. 2(a,c,e)"},
                            "no vertex of the closed polygon is a point of the first level"),
      third.decides(
          {"After the third iteration one sees the limit curve (read as: the polygon is nearer than 1/200 of the "
           "diameter).",
           "Fig. 2, caption"},
          "distance from the limit at the same parameter, over the diameter, below 1/200")};
  result.tables.push_back(table);
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  return {{"aary-fig2", "mustafa-bari-2016", "Figure 2: polygons refined with arities 2, 3 and 4", run}};
}

}  // namespace subcert::experiments::aary_curves
