// [MB16, sec. 2.5, Figure 3]: a car's profile by a cubic polynomial, a B-spline and the 4-point binary scheme.

#include "parts.hpp"

#include <subcert/analysis/symbol/polynomials/real_roots.hpp>
#include <subcert/reports/experiments/figures.hpp>
#include <subcert/schemes/data/refine/refine.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>

namespace subcert::experiments::mustafa_bari_2016 {
namespace {

constexpr int drawn_level = 4;
constexpr int spacing = 20;

/// Heights in cm, every 20 cm from the front bumper to the rear one.
const std::vector<Rational> car{25,  55,  68,  74,  78,  82,  86,  92,  110, 125, 136, 142, 145,
                                146, 145, 142, 137, 127, 113, 104, 101, 99,  95,  80,  30};

struct Fit {
  std::string name;
  std::string specification;  // none: the cubic polynomial of all data
};

const Fit cubic{"cubic by least squares", ""};
const Fit four_point{"4-point binary scheme", "ary:a=2,points=4,d=3"};
const std::vector<Fit> splines{{"cubic B-spline", "bspline:degree=3"}, {"quadratic B-spline", "bspline:degree=2"}};

std::vector<Fit> all_fits() { return {cubic, splines[0], splines[1], four_point}; }

/// Values at the multiples of 2^-at_level of the spacing.
std::vector<Rational> values(const Fit& method, int at_level) {
  if (!method.specification.empty())
    return data::limit_of_data(data::curve_data(car), {make_scheme(method.specification).mask.curve()}, {at_level})
        .values;
  std::vector<Rational> nodes, result;
  for (std::size_t i = 0; i < car.size(); ++i) nodes.emplace_back(i);
  const std::size_t scale = std::size_t{1} << at_level;
  for (std::size_t i = 0; i <= (car.size() - 1) * scale; ++i) {
    const auto weights = regression_weights(nodes, {}, 3, Rational(i) / Rational(scale));
    Rational sum = 0;
    for (std::size_t k = 0; k < car.size(); ++k) sum += weights[k] * car[k];
    result.push_back(sum);
  }
  return result;
}

std::vector<Rational> residuals(const Fit& method) {
  std::vector<Rational> result = values(method, 0);
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = car[i] - result[i];
  return result;
}

/// Sum of v_i v_{i+lag}.
Rational lagged_sum(const std::vector<Rational>& v, std::size_t lag) {
  Rational sum = 0;
  for (std::size_t i = 0; i + lag < v.size(); ++i) sum += v[i] * v[i + lag];
  return sum;
}

std::vector<Rational> about_mean(std::vector<Rational> v) {
  Rational mean = 0;
  for (const Rational& x : v) mean += x / Rational(v.size());
  for (Rational& x : v) x -= mean;
  return v;
}

double to_double(const Rational& value) { return value.convert_to<double>(); }

/// What the limit at the data takes from them: sum of l_k z^k, where the limit at datum i is the sum of l_k f_{i-k}.
LaurentPolynomial limit_at_data(const std::string& specification) {
  std::vector<Rational> impulse(17, 0);
  impulse[8] = 1;
  return {
      data::limit_of_data(data::curve_data(impulse, 1, true), {make_scheme(specification).mask.curve()}, {0}).values,
      -8};
}

/// Whether for each closed polygon the limit of the scheme is at most as far from the vertices, in the root mean
/// square, as that of the other: |1 - l| <= |1 - other| on the unit circle, for symmetric l.
bool is_nearer_for_all_closed_data(const std::string& scheme, const std::string& other) {
  const LaurentPolynomial near = 1 - limit_at_data(scheme), far = 1 - limit_at_data(other);
  return is_nonnegative_on_unit_circle(far * far - near * near);
}

std::vector<double> rounded_values(const std::vector<Rational>& values) {
  std::vector<double> result;
  for (const Rational& value : values) result.push_back(to_double(value));
  return result;
}

formats::Panel profile_panel(const Fit& fit) {
  const Points fine = over_steps(rounded_values(values(fit, drawn_level)), std::ldexp(spacing, -drawn_level));
  formats::Panel panel = plain_panel(fit.name, {line("data", over_steps(rounded_values(car), spacing), colour::pale),
                                                line("curve", fine, colour::blue)});
  panel.curves[0].marked = true;
  panel.x_label = panel.y_label = "cm";
  return panel;
}

Rational sum_of_squares(const Fit& fit) { return lagged_sum(residuals(fit), 0); }

}  // namespace

Measured car_profile(const Run&) {
  Measured result;
  const Rational squares = sum_of_squares(cubic);
  const double correlation = to_double(lagged_sum(residuals(cubic), 1) / squares);
  const double bound = 1.96 / std::sqrt(static_cast<double>(car.size()));
  const Rational explained = 1 - squares / lagged_sum(about_mean(car), 0);
  result.add_fact("correlated", "", correlation > bound, short_number(correlation) + " against " + short_number(bound));
  result.add_fact("trend", "", explained > Rational(1, 2), short_number(to_double(explained)));
  for (const Fit& spline : splines) {
    const Rational ratio = sum_of_squares(four_point) / sum_of_squares(spline);
    result.add_fact("nearer", spline.name, ratio < 1,
                    "ratio of the sums of squares, 4-point over B-spline, " + short_number(to_double(ratio)));
    const bool all = is_nearer_for_all_closed_data(four_point.specification, spline.specification);
    result.add_fact("always", spline.name, all, all ? "proved" : "there are polygons with the contrary");
  }
  formats::PlainTable table{"aary-fig3-distances",
                            "Distance between data and curve at the data, in cm",
                            {"curve", "root mean square", "largest"},
                            {}};
  formats::Figure figure{"aary-fig3", "Profile of a car", "", 2, {}};
  for (const Fit& fit : all_fits()) {
    Rational largest = 0;
    for (const Rational& r : residuals(fit)) largest = std::max(largest, Rational(abs(r)));
    table.rows.push_back({fit.name,
                          short_number(std::sqrt(to_double(sum_of_squares(fit)) / static_cast<double>(car.size()))),
                          short_number(to_double(largest))});
    figure.panels.push_back(profile_panel(fit));
  }
  result.tables = {table};
  result.figures = {figure};
  return result;
}

}  // namespace subcert::experiments::mustafa_bari_2016
