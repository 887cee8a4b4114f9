// [MH, sec. 1.1, Figures 1 and 3 to 5]: polynomial data and the schemes of linear, quadratic and cubic polynomials.

#include "degree_study.hpp"
#include "families.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::experiments::nonlinear_polynomials {
namespace {

constexpr std::size_t count = 17;
constexpr int levels = 5;
const std::string paper = "mustafa-hameed";

/// Coordinates by their coefficients, in t = (x - 8) / 7.
struct PolynomialData {
  std::string name;
  std::vector<std::vector<double>> coordinates;

  int degree() const {
    std::size_t most = 0;
    for (const auto& c : coordinates) most = std::max(most, c.size() - 1);
    return static_cast<int>(most);
  }
  std::vector<double> at(double x) const {
    std::vector<double> point;
    for (const auto& c : coordinates) {
      double value = 0;
      for (std::size_t k = c.size(); k-- > 0;) value = value * (x - 8) / 7 + c[k];
      point.push_back(value);
    }
    return point;
  }
  data::GridData<double> sampled(const data::Axis& axis) const {
    data::GridData<double> data{{}, coordinates.size(), {axis}};
    for (const double x : parameters(axis)) {
      const auto point = at(x);
      data.values.insert(data.values.end(), point.begin(), point.end());
    }
    return data;
  }
};

const std::vector<double> quadratic{-1, 0, 2}, cubic{0, -3, 0, 4};
const std::vector<PolynomialData> polynomials{
    {"quadratic function", {quadratic}}, {"cubic function", {cubic}}, {"cubic curve in the plane", {quadratic, cubic}}};

data::GridData<double> limit(const Method& method, const data::GridData<double>& data) {
  return refined(method.specification, data, levels);
}

/// The largest distance of the refined samples from the polynomial, over the diameter of the samples.
double deviation(const PolynomialData& polynomial, const Method& method) {
  const auto data = polynomial.sampled(data::Axis::of(count));
  const auto fine = limit(method, data);
  const auto all = distances(fine.values, polynomial.sampled(fine.axes[0]).values, fine.dimension);
  return *std::max_element(all.begin(), all.end()) / diameter(data.values, data.dimension);
}

int linear_reproduction(const Method& method) {
  return polynomial_reproduction(regression_mask(data::l1_linear_part(make_l1_scheme(method.specification).rules)))
      .reproduction_degree;
}

formats::Panel panel(const PolynomialData& polynomial, const Method& method, const data::GridData<double>& data) {
  return {method.name + ", " + polynomial.name,
          "",
          "",
          {drawn_points("data", data, "#5a6773"),
           drawn_line("polynomial", polynomial.sampled({16 * 16 + 1, false, 16, 0, Rational(1, 16)}), pale),
           drawn_line("limit", limit(method, data), "#0b559f")},
          false,
          "below",
          data.dimension == 2};
}

OutlierCase noisy_cubic(double decibel) {
  const PolynomialData& polynomial = polynomials[1];
  const data::GridData<double> samples = polynomial.sampled(data::Axis::of(count));
  const double sigma = noise_deviation(mean_square(samples.values), decibel);
  return {samples.axes, 1, 3,
          [samples, sigma](std::mt19937_64& engine) {
            std::vector<double> values(samples.values);
            const auto noise = normal_noise(engine, values.size());
            for (std::size_t i = 0; i < values.size(); ++i) values[i] += sigma * noise[i];
            return OutlierSample{values, values};
          },
          [polynomial](double x, double) {
            return std::array<double, 3>{polynomial.at(x)[0], 0, 0};
          }};
}

/// Claims about the exact reproduction and the deviation in double precision of the schemes of degree 1.
void add_linear_claims(ExperimentResult& result) {
  Evidence exact, misses, trend;
  for (const int points : {6, 7, 8}) {
    const Method method = robust_method(points, 1);
    const int degree = linear_reproduction(least_squares_method(points, 1));
    exact.require("S_" + std::to_string(points), degree == 1, "degree " + std::to_string(degree));
    for (const PolynomialData& polynomial : polynomials) {
      const double found = deviation(polynomial, method);
      misses.require(method.name + ", " + polynomial.name, found > 1e-6, short_number(found));
      if (polynomial.degree() == 3 && polynomial.coordinates.size() == 1)
        trend.require(method.name, found > 0.05, short_number(found));
    }
  }
  result.claims.push_back(
      exact.decides({"The schemes of linear polynomials by least squares do not reproduce other polynomials.",
                     "Sec. 1.1, Fig. 1(a)-(c)"},
                    "reproduction degree of the mask, exact: 1"));
  result.claims.push_back(misses.decides(
      {"The schemes of linear polynomials by l1 regression do not reproduce other polynomials.",
       "Sec. 1.1, Fig. 1(a)-(c)"},
      "largest distance from the polynomial over the diameter of its samples, far above rounding: 1e-6"));
  result.claims.push_back(trend.decides({"The schemes of linear polynomials underfit data from non-linear polynomials "
                                         "without noise (read as: by more than 1/20 of the range).",
                                         "Sec. 1.1, Fig. 1(b)"},
                                        "largest distance from the cubic function over its range"));
}

ExperimentResult run_linear(const ExperimentOptions& options) {
  constexpr double decibel = 20;
  const OutlierCase noisy = noisy_cubic(decibel);
  const double sigma = noise_deviation(mean_square(polynomials[1].sampled(data::Axis::of(count)).values), decibel);
  ExperimentResult result{
      {"The polynomials are not named. Here: 2t^2 - 1, 4t^3 - 3t and the curve of both, 17 data at t = (x - 8)/7, x = "
       "0, ..., 16; the noise of (d) has 20 dB. Schemes D_6, D_7, D_8 with 6 iterations and delta = 1e-8, ends by the "
       "fit of the nearest window, 5 levels (3 for the error statistics).",
       "Underfitting is read as: the squared bias is larger than the variance, so that the error is the model's, not "
       "the noise's. Overfitting: the variance is larger than that of the noise."}};
  add_linear_claims(result);
  formats::PlainTable table{"nonlinear-fig1-errors",
                            "Mean squared error of the cubic function with noise (" + short_number(sigma * sigma) +
                                " is the variance of the noise)",
                            {"scheme", "squared bias", "variance"},
                            {}};
  std::vector<NamedMean> underfit, overfit;
  for (const int degree : {1, 2, 3})
    for (const int points : {6, 7, 8}) {
      const Method method = robust_method(points, degree);
      const ErrorParts parts = error_parts(noisy, method, options);
      table.rows.push_back(
          {method.name, mean_interval(parts.squared_bias).text(), mean_interval(parts.variance).text()});
      if (degree > 1) continue;
      underfit.push_back(paired(method.name, parts.squared_bias, parts.variance));
      overfit.push_back({method.name, mean_interval(parts.variance)});
    }
  result.claims.push_back(
      all_above({"The schemes of linear polynomials underfit data from non-linear polynomials with noise.",
                 "Sec. 1.1, Fig. 1(d)"},
                "squared bias minus variance", 0, underfit));
  result.claims.push_back(
      all_below({"The schemes of linear polynomials do not overfit.", "Sec. 1.1"}, "variance", sigma * sigma, overfit));
  formats::Figure figure{"nonlinear-fig1", "Schemes of linear polynomials on data of other polynomials", "", 2, {}};
  for (const PolynomialData& polynomial : polynomials)
    figure.panels.push_back(panel(polynomial, robust_method(6, 1), polynomial.sampled(data::Axis::of(count))));
  auto engine = generator(options.seed, 0);
  figure.panels.push_back(
      panel(polynomials[1], robust_method(6, 1), {noisy.draw(engine).with, 1, {data::Axis::of(count)}}));
  figure.panels.back().title = "D_6^1, cubic function with noise";
  result.tables.push_back(table);
  result.figures.push_back(figure);
  return result;
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
      for (const data::LatticePoint& node : window.node_points())
        data.push_back(k == 0 ? Rational(1) : node.x == 0 ? Rational(0) : power(node.x, k));
      for (const data::LatticePoint& output : window.output_points()) wanted.push_back(power(output.x, k));
      if (data::weighted_fit(window, weights, data) != wanted) return false;
    }
  }
  return true;
}

ExperimentResult run_reproduction(const ExperimentOptions&) {
  ExperimentResult result{{"The polynomials of nonlinear-fig1 and the schemes of degrees 2 and 3 on 5 to 10 data.",
                           "A weighted least squares fit with positive weights to data of a polynomial of the fitted "
                           "degree has residual 0 for this polynomial and for no other, whatever the weights. So each "
                           "reweighted step returns the polynomial, and the schemes reproduce it on every level. This "
                           "is checked in rational numbers for twenty choices of weights whose ratios go up to 10^6."}};
  result.random = false;
  formats::PlainTable table{
      "nonlinear-fig3-degrees",
      "Reproduction degree of the linear part, exact, and largest deviation of the l1 schemes over the diameter",
      {"scheme", "exact degree", "quadratic function", "cubic function", "cubic curve in the plane"},
      {}};
  Evidence exact, weighted, measured;
  for (const int degree : {2, 3}) {
    double worst = 0;
    for (int points = 5; points <= 10; ++points) {
      const Method method = robust_method(points, degree);
      const int found = linear_reproduction(method);
      std::vector<std::string> row{method.name, std::to_string(found)};
      exact.require(method.name, found >= degree, std::to_string(found));
      const bool kept = weights_do_not_matter(method);
      weighted.require(method.name, kept, kept ? "kept" : "not kept");
      for (const PolynomialData& polynomial : polynomials) {
        const double largest = deviation(polynomial, method);
        row.push_back(short_number(largest));
        if (polynomial.degree() <= degree) worst = std::max(worst, largest);
      }
      table.rows.push_back(row);
    }
    measured.require("degree " + std::to_string(degree), worst < 1e-12, "at most " + short_number(worst));
  }
  const std::string place = "Sec. 1.1, Fig. 3-5";
  result.claims = {
      exact.decides(
          {"The least squares schemes of quadratic and cubic polynomials reproduce the polynomial data.", place},
          "reproduction degree of the mask, exact: at least the degree of the fit"),
      weighted.decides(
          {"The reweighted steps of the l1 schemes of quadratic and cubic polynomials reproduce the polynomial data.",
           place},
          "fits with twenty choices of positive weights to monomials of at most the degree of the fit, exact"),
      measured.decides({"Five levels of the l1 schemes of quadratic and cubic polynomials, in double precision, "
                        "reproduce the polynomial data.",
                        place},
                       "largest distance from the polynomial over the diameter, below 1e-12, polynomials of at most "
                       "the degree of the fit")};
  formats::Figure figure{"nonlinear-fig3", "Polynomial data kept by schemes of degrees 2 and 3", "", 3, {}};
  const std::vector<Method> shown{robust_method(6, 2), robust_method(8, 3), robust_method(8, 3)};
  for (std::size_t k = 0; k < polynomials.size(); ++k)
    figure.panels.push_back(panel(polynomials[k], shown[k], polynomials[k].sampled(data::Axis::of(count))));
  result.tables.push_back(table);
  result.figures.push_back(figure);
  return result;
}

}  // namespace

std::vector<Experiment> all() {
  return {{"nonlinear-fig1", paper, "Figure 1: linear polynomials on data of other polynomials", run_linear},
          {"nonlinear-fig3", paper, "Figures 3 to 5: reproduction of polynomials", run_reproduction}};
}

}  // namespace subcert::experiments::nonlinear_polynomials
