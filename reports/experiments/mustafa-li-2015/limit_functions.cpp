// [MLZD15, sec. 2.4, Figure 2, Proposition 1]: basic limit functions of data-dependent schemes.

#include "parts.hpp"

#include <subcert/reports/experiments/figures.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::experiments::mustafa_li_2015 {
namespace {

constexpr int level = 8;

/// A basic limit function at the points of a level.
struct Response {
  std::vector<double> at;
  std::vector<double> values;
};

Response response(int points, const L1Options& options) {
  const data::GridData<double> data = data::l1_impulse_response({{points}, 1, options}, level);
  return {parameters(data.axes[0]), data.values};
}

std::string name_of(int points) { return "D_" + std::to_string(points); }

/// 4n - 1 for 2n points, 4n + 1 for 2n + 1.
int support_width(int points) { return 2 * points - 1; }

/// The distance of the first and the last value that is not zero.
double extent(const Response& r) {
  double first = INFINITY, last = -INFINITY;
  for (std::size_t i = 0; i < r.at.size(); ++i)
    if (r.values[i] != 0) {
      first = std::min(first, r.at[i]);
      last = std::max(last, r.at[i]);
    }
  return last - first;
}

std::size_t nonzero_outside(const Response& r, double half_width) {
  std::size_t result = 0;
  for (std::size_t i = 0; i < r.at.size(); ++i) result += std::abs(r.at[i]) > half_width && r.values[i] != 0;
  return result;
}

struct Shape {
  double height;      ///< largest value
  double centre;      ///< value next to 0
  std::size_t peaks;  ///< local maxima of at least half the height that stand out by a tenth of it
  double valley;      ///< least value between the first and the last of these, over the height
};

/// How far the values fall on the way from place i to a larger one, on the side where they fall less.
double prominence(const std::vector<double>& values, std::size_t i) {
  double left = values[i], right = values[i];
  for (std::size_t j = i; j-- > 0 && values[j] <= values[i];) left = std::min(left, values[j]);
  for (std::size_t j = i + 1; j < values.size() && values[j] <= values[i]; ++j) right = std::min(right, values[j]);
  return values[i] - std::max(left, right);
}

Shape shape(const Response& r) {
  Shape result{*std::max_element(r.values.begin(), r.values.end()), 0, 0, 1};
  std::size_t first = 0, last = 0;
  const auto centre = std::min_element(r.at.begin(), r.at.end(),
                                       [](double a, double b) { return std::abs(a) < std::abs(b); });
  result.centre = r.values[static_cast<std::size_t>(centre - r.at.begin())];
  for (std::size_t i = 1; i + 1 < r.values.size();) {
    std::size_t end = i;  // of the plateau of equal values
    while (end + 1 < r.values.size() && r.values[end + 1] == r.values[i]) ++end;
    if (end + 1 == r.values.size()) break;
    if (r.values[i] > r.values[i - 1] && r.values[end] > r.values[end + 1] && r.values[i] >= result.height / 2 &&
        prominence(r.values, i) >= result.height / 10) {
      if (result.peaks++ == 0) first = i;
      last = i;
    }
    i = end + 1;
  }
  if (result.peaks > 1)
    result.valley = *std::min_element(r.values.begin() + static_cast<std::ptrdiff_t>(first),
                                      r.values.begin() + static_cast<std::ptrdiff_t>(last)) /
                    result.height;
  return result;
}

formats::PlainTable shapes_table() {
  formats::PlainTable table{"l1-fig2-shapes", "Shape over iterations and delta", {"iterations", "delta"}, {}};
  for (const int points : {6, 7, 8})
    for (const char* what : {"height", "value at 0", "peaks"}) table.head.push_back(name_of(points) + " " + what);
  std::vector<L1Options> settings;
  for (const int iterations : {0, 1, 2, 3, 6, 7, 20}) settings.push_back({1e-8, iterations});
  for (const double delta : {1e-2, 1e-4, 1e-6, 1e-10, 1e-12}) settings.push_back({delta, 6});
  for (const L1Options& setting : settings) {
    std::vector<std::string> row{std::to_string(setting.iterations), short_number(setting.delta)};
    for (const int points : {6, 7, 8}) {
      const Shape s = shape(response(points, setting));
      row.insert(row.end(), {short_number(s.height), short_number(s.centre), std::to_string(s.peaks)});
    }
    table.rows.push_back(row);
  }
  return table;
}

formats::Figure drawn_functions() {
  formats::Figure figure{
      "l1-fig2",
      "Basic limit functions of D_6, D_7 and D_8",
      "Above: 6 reweighted fits, delta = 1e-8. Below: 0 to 3 reweighted fits; 0 is the least squares scheme.",
      3,
      {}};
  const auto drawn = [](const std::string& label, int points, int fits) {
    return line(label, points_of(data::l1_impulse_response({{points}, 1, {1e-8, fits}}, level)), "");
  };
  for (const int points : {6, 7, 8}) figure.panels.push_back({name_of(points), "", "", {drawn("", points, 6)}});
  for (const int points : {6, 7, 8}) {
    figure.panels.push_back({name_of(points), "", "", {}});
    for (const int fits : {0, 1, 2, 3})
      figure.panels.back().curves.push_back(drawn(std::to_string(fits), points, fits));
  }
  return figure;
}

}  // namespace

Measured limit_functions(const Run& run) {
  const L1Options options{run.number("delta"), static_cast<int>(run.number("fits"))};
  Measured result;
  for (const int points : {6, 7, 8}) {
    const std::string name = name_of(points);
    const Response r = response(points, options);
    const std::size_t outside = nonzero_outside(r, support_width(points) / 2.0);
    result.add_fact("local", name, outside == 0, std::to_string(outside));
    if (points % 2 == 0) {
      const double expected = support_width(points) * (1 - std::ldexp(1.0, -level));
      result.add_fact("width", name, extent(r) == expected,
                      short_number(extent(r)) + ", (4n - 1)(1 - 2^-8) = " + short_number(expected));
    }
    const Shape s = shape(r);
    result.add_fact("peaks", name, s.peaks == 2 && s.valley < 0.5,
                    std::to_string(s.peaks) + " of height " + short_number(s.height) + ", valley / height " +
                        short_number(s.valley));
    add_smoothness(
        result, name,
        [&](int at_level) {
          return data::l1_impulse_response({{points}, 1, options}, at_level);
        },
        6, 10);
  }
  if (run.is_alternative()) return result;
  result.tables = {shapes_table()};
  result.figures = {drawn_functions()};
  return result;
}

}  // namespace subcert::experiments::mustafa_li_2015
