// [MB16, sec. 2.5, Figure 2]: polygons refined by the 4-point binary, ternary and quaternary schemes.

#include "parts.hpp"

#include <subcert/reports/experiments/figures.hpp>
#include <subcert/reports/experiments/refined_data.hpp>
#include <subcert/schemes/data/refine/refine.hpp>

namespace subcert::experiments::mustafa_bari_2016 {
namespace {

constexpr int seen_level = 3;

struct Polygon {
  std::string name;
  data::GridData<Rational> data;
};

/// A guitar's outline, and a wave that breaks.
std::vector<Polygon> polygons() {
  const std::vector<Rational> guitar{-9, 0,  -8, 5, -4, 7, 0,  3, 4,  5,  7,  2,  13,
                                     1,  13, -1, 7, -2, 4, -5, 0, -3, -4, -7, -8, -5};
  const std::vector<Rational> wave{-10, 0, -7, 0, -4, 1, -1, 4, 2, 8, 6,  9,  9,
                                   7,   9, 4,  6, 3,  4, 5,  5, 1, 8, -1, 12, -1};
  return {{"closed", data::curve_data(guitar, 2, true)}, {"open", data::curve_data(wave, 2)}};
}

struct Refined {
  data::GridData<double> first;
  data::GridData<double> third;
  data::GridData<double> limit;
};

Refined refinements_of(const Polygon& polygon, const FourPointScheme& one) {
  const Mask mask = one.scheme().mask.curve();
  return {rounded(refine(polygon.data, mask, {1})), rounded(refine(polygon.data, mask, {seen_level})),
          rounded(data::limit_of_data(polygon.data, {mask}, {one.limit_level}))};
}

/// The largest distance of a polygon from the limit at the same parameter, over the diameter of the limit.
double distance_to_limit(const data::GridData<double>& polygon, const data::GridData<double>& limit) {
  return relative_distance(polygon_at(polygon, parameters(limit.axes[0])), limit.values, 2);
}

bool shares_a_point(const data::GridData<double>& first, const data::GridData<double>& second) {
  for (std::size_t i = 0; i < first.values.size(); i += 2)
    for (std::size_t j = 0; j < second.values.size(); j += 2)
      if (first.values[i] == second.values[j] && first.values[i + 1] == second.values[j + 1]) return true;
  return false;
}

}  // namespace

Measured refined_polygons(const Run&) {
  formats::PlainTable table{"aary-fig2-distances",
                            "Distance from the limit at the same parameter, over the diameter of the limit curve",
                            {"polygon", "arity", "points at level 1", "initial polygon", "level 1", "level 3"},
                            {}};
  Measured result;
  for (const Polygon& polygon : polygons()) {
    formats::Figure figure{"aary-fig2-" + polygon.name,
                           "First level and limit, " + polygon.name + " polygon",
                           "Left: the polygon and its first refinement; right: the limit curve.",
                           2,
                           {}};
    const data::GridData<double> data = rounded(polygon.data);
    const formats::Curve drawn = line("polygon", line_of(data), colour::pale);
    for (const FourPointScheme& one : four_point_schemes) {
      const auto [first, third, limit] = refinements_of(polygon, one);
      const double level3 = distance_to_limit(third, limit);
      const std::string count = std::to_string(first.points());
      table.rows.push_back({polygon.name, std::to_string(one.arity), count,
                            short_number(distance_to_limit(data, limit)), short_number(distance_to_limit(first, limit)),
                            short_number(level3)});
      if (polygon.data.axes[0].closed) {
        result.add_fact("inserted", one.name, first.points() == static_cast<std::size_t>(one.arity) * data.points(),
                        count + " points from " + std::to_string(data.points()));
        const bool kept = shares_a_point(data, first);
        result.add_fact("approximating", one.name, !kept, kept ? "vertices are kept" : "no vertex is kept");
      }
      result.add_fact("third level", polygon.name + " " + one.name, level3 < 1.0 / 100, short_number(level3));
      figure.panels.push_back(
          plain_panel(one.name + ", level 1", {drawn, line("level 1", line_of(first), colour::red)}, true));
      figure.panels.back().curves.back().marked = true;
      figure.panels.push_back(
          plain_panel(one.name + ", limit", {drawn, line("limit", line_of(limit), colour::blue)}, true));
    }
    result.figures.push_back(figure);
  }
  result.tables = {table};
  return result;
}

}  // namespace subcert::experiments::mustafa_bari_2016
