// [MH, sec. 1.1, Figures 1 and 3 to 5]: polynomial data and the schemes of linear, quadratic and cubic polynomials.

#include "parts.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/reports/experiments/figures.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::experiments::mustafa_hameed {
namespace {

constexpr std::size_t count = 17;
constexpr int levels = 5;

/// Coordinates by their coefficients, in t = (x - 8) / 7.
struct PolynomialData {
  std::string name;
  std::vector<std::vector<double>> coordinates;

  int degree() const {
    std::size_t most = 0;
    for (const auto& c : coordinates) most = std::max(most, c.size() - 1);
    return static_cast<int>(most);
  }
  std::array<double, 3> at(double x) const {
    std::array<double, 3> point{};
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      for (std::size_t k = coordinates[i].size(); k-- > 0;) point[i] = point[i] * (x - 8) / 7 + coordinates[i][k];
    return point;
  }
  data::GridData<double> samples(const data::Axis& axis = data::Axis::of(count)) const {
    return sampled({axis}, coordinates.size(), [this](double x, double) { return at(x); });
  }
};

const std::vector<double> quadratic{-1, 0, 2}, cubic{0, -3, 0, 4};
const std::vector<PolynomialData> polynomials{
    {"quadratic function", {quadratic}}, {"cubic function", {cubic}}, {"cubic curve in the plane", {quadratic, cubic}}};

/// The largest distance of the refined samples from the polynomial, over the diameter of the samples.
double deviation(const PolynomialData& polynomial, const Method& method) {
  const auto data = polynomial.samples(), fine = refined(method.specification, data, levels);
  return largest_distance(fine.values, polynomial.samples(fine.axes[0]).values, fine.dimension) /
         diameter(data.values, data.dimension);
}

int linear_reproduction(const Method& method) {
  return subcert::polynomial_reproduction(
             regression_mask(data::l1_linear_part(make_l1_scheme(method.specification).rules)))
      .reproduction_degree;
}

formats::Panel polynomial_panel(const PolynomialData& polynomial, const Method& method,
                                const data::GridData<double>& data) {
  return plain_panel(method.name + ", " + polynomial.name,
                     {dots("data", points_of(data), colour::dark),
                      line("polynomial", points_of(polynomial.samples(finer(data.axes[0], 16))), colour::pale),
                      line("limit", points_of(refined(method.specification, data, levels)), colour::blue)},
                     data.dimension == 2);
}

NoisyData noisy_cubic() {
  const PolynomialData& polynomial = polynomials[1];
  return {.axes = {data::Axis::of(count)},
          .levels = 3,
          .truth = [polynomial](double x, double) { return polynomial.at(x); },
          .sigma = noise_deviation(mean_square(polynomial.samples().values), 20)};
}

const std::vector<int> windows_of_linear{6, 7, 8};

/// The exact reproduction and the deviation in double precision of the schemes of degree 1.
void find_linear_reproduction(Measured& measured) {
  for (const int points : windows_of_linear) {
    const Method method = l1_method(points, 1);
    const int degree = linear_reproduction(least_squares_method(points, 1));
    measured.add_fact("exact", "S_" + std::to_string(points), degree == 1, "degree " + std::to_string(degree));
    for (const PolynomialData& polynomial : polynomials) {
      const double found = deviation(polynomial, method);
      measured.add_fact("misses", method.name + ", " + polynomial.name, found > 1e-6, short_number(found));
      if (polynomial.degree() == 3 && polynomial.coordinates.size() == 1)
        measured.add_fact("trend", method.name, found > 0.05, short_number(found));
    }
  }
}

constexpr long trials = 20;

/// Whether fits with different positive weights to t^k, k <= degree, are t^k at the outputs, in rational numbers.
bool weights_do_not_matter(const Method& method) {
  const L1Scheme scheme = make_l1_scheme(method.specification).rules;
  const data::RegressionWindow window = data::l1_window(scheme);
  for (long trial = 0; trial < trials; ++trial) {
    std::vector<Rational> weights;
    for (long i = 0; i < static_cast<long>(window.nodes()); ++i)
      weights.push_back(power(Rational(1 + (5 * i + 3 * trial) % 11, 1 + (7 * i + trial) % 13), 3));
    for (int k = 0; k <= scheme.degree; ++k) {
      std::vector<Rational> data, wanted;
      for (const data::Position& node : window.node_points())
        data.push_back(k == 0 ? Rational(1) : node[0] == 0 ? Rational(0) : power(node[0], k));
      for (const data::Position& output : window.output_points()) wanted.push_back(power(output[0], k));
      if (data::weighted_fit(window, weights, data) != wanted) return false;
    }
  }
  return true;
}

}  // namespace

Measured linear_polynomials(const Run& run) {
  Measured result;
  find_linear_reproduction(result);
  const NoisyData noisy = noisy_cubic();
  const std::vector<Method> methods = l1_methods(windows_of_linear, {1, 2, 3});
  study(result, noisy, methods, {error_measure, from_data_measure}, run);
  study_error_parts(result, noisy, methods, run);
  const double variance = *noisy.sigma * *noisy.sigma;
  result.numbers = {{"noise", variance}};
  result.tables = {MeansTable{"nonlinear-fig1-errors",
                              "Mean squared error of the cubic function with noise (" + short_number(variance) +
                                  " is the variance of the noise)",
                              {"scheme"},
                              rows_of(methods),
                              {{"squared bias", "squared bias"}, {"variance", "variance"}}}
                       .filled(result)};
  formats::Figure figure{"nonlinear-fig1", "Schemes of linear polynomials on data of other polynomials", "", 2, {}};
  for (const PolynomialData& polynomial : polynomials)
    figure.panels.push_back(polynomial_panel(polynomial, l1_method(6, 1), polynomial.samples()));
  figure.panels.push_back(polynomial_panel(polynomials[1], l1_method(6, 1), noisy.first_data(run.seed)));
  figure.panels.back().title = "D_6^1, cubic function with noise";
  result.figures = {figure};
  return result;
}

Measured polynomial_reproduction(const Run&) {
  formats::PlainTable table{
      "nonlinear-fig3-degrees",
      "Reproduction degree of the linear part, exact, and largest deviation of the l1 schemes over the diameter",
      {"scheme", "exact degree", "quadratic function", "cubic function", "cubic curve in the plane"},
      {}};
  Measured result;
  for (const int degree : {2, 3}) {
    double worst = 0;
    for (const Method& method : l1_methods({5, 6, 7, 8, 9, 10}, {degree})) {
      const int found = linear_reproduction(method);
      std::vector<std::string> row{method.name, std::to_string(found)};
      result.add_fact("exact", method.name, found >= degree, std::to_string(found));
      const bool kept = weights_do_not_matter(method);
      result.add_fact("weighted", method.name, kept, kept ? "kept" : "not kept");
      for (const PolynomialData& polynomial : polynomials) {
        const double largest = deviation(polynomial, method);
        row.push_back(short_number(largest));
        if (polynomial.degree() <= degree) worst = std::max(worst, largest);
      }
      table.rows.push_back(row);
    }
    result.add_fact("measured", "degree " + std::to_string(degree), worst < 1e-12, "at most " + short_number(worst));
  }
  formats::Figure figure{"nonlinear-fig3", "Polynomial data kept by schemes of degrees 2 and 3", "", 3, {}};
  const std::vector<Method> shown{l1_method(6, 2), l1_method(8, 3), l1_method(8, 3)};
  for (std::size_t k = 0; k < polynomials.size(); ++k)
    figure.panels.push_back(polynomial_panel(polynomials[k], shown[k], polynomials[k].samples()));
  result.tables = {table};
  result.figures = {figure};
  return result;
}

}  // namespace subcert::experiments::mustafa_hameed
