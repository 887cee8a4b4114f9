#include <nlohmann/json.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/reports/experiments/mustafa-hameed/parts.hpp>

#include <cmath>
#include <numeric>

using namespace subcert;
using namespace subcert::experiments;
using subcert::experiments::mustafa_hameed::l1_method;

namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// A parabola with noise, without outliers where `height` is 0.
NoisyData parabola(double sigma, double height) {
  return {.axes = {data::Axis::of(21)},
          .levels = 2,
          .truth =
              [](double x, double) {
                return std::array{(x - 10) * (x - 10) / 20, 0.0, 0.0};
              },
          .sigma = sigma,
          .outliers = height == 0 ? 0u : 1u,
          .displace = [height](std::mt19937_64&, double* value) { *value += height; }};
}

/// The mean of a measure of one method.
double mean_of(const std::string& measure, const NoisyData& data, const Method& method,
               const ExperimentOptions& options) {
  Measured measured;
  study(measured, data, {method}, {error_measure}, options);
  study_error_parts(measured, data, {method}, options);
  return mean(measured.at({measure, method.name}));
}

}  // namespace

TEST_CASE("polygons between their points: inside, beyond open ends, around closed ones") {
  data::GridData<double> open = data::curve_data<double>({0, 0, 1, 2, 3, 2}, 2);
  open.axes[0].first = Rational(1, 2);
  CHECK(polygon_at(open, {0.5, 1, 2, 0, 3}) == std::vector<double>{0, 0, 0.5, 1, 2, 2, -0.5, -1, 4, 2});
  const data::GridData<double> closed = data::curve_data<double>({0, 4, 8}, 1, true);
  CHECK(polygon_at(closed, {0, 2.5, -0.5, 3.5}) == std::vector<double>{0, 4, 4, 2});
}

TEST_CASE("meshes are bilinear between their points") {
  const data::GridData<double> surface{{0, 1, 2, 3, 5, 7}, 1, {data::Axis::of(3), data::Axis::of(2)}};
  const data::Axis x{2, false, 2, Rational(1, 2), 1}, y{2, false, 1, Rational(1, 4), Rational(1, 2)};
  CHECK(mesh_at(surface, {x, y}) == std::vector<double>{1.375, 2.625, 3.125, 4.875});
}

TEST_CASE("distances and diameters") {
  CHECK(distances({0, 0, 1, 1}, {3, 4, 1, 1}, 2) == std::vector<double>{5, 0});
  CHECK(diameter({0, 0, 3, 1, 1, 4}, 2) == 5);
}

TEST_CASE("squared bias and variance add up to the error, without noise there is no variance") {
  const Method method = l1_method(6, 1);
  const ExperimentOptions many{3, 400, 2}, few{3, 4, 1};
  const NoisyData noisy = parabola(0.2, 3), quiet = parabola(0, 0);
  // Of a pair, the mean of both squares is e . e' + |e - e'|^2 / 2.
  CHECK(mean_of("squared bias", noisy, method, many) + mean_of("variance", noisy, method, many) ==
        Approx(mean_of("error", noisy, method, many)));
  CHECK(mean_of("variance", quiet, method, few) == 0);
  CHECK(mean_of("squared bias", quiet, method, few) == Approx(mean_of("error", quiet, method, few)));
  CHECK(mean_of("squared bias", quiet, method, few) > 0.001);
  CHECK(mean_of("squared bias", quiet, l1_method(6, 2), few) < 1e-20);
}

TEST_CASE("the distance from the data leaves outliers out") {
  Measured measured;
  study(measured, parabola(0, 1000), {l1_method(8, 2)}, {from_data_measure}, {1, 4, 1});
  REQUIRE(measured.at({"from data", "D_8^2"}).size() == 4);
  // The square of the outlier's own distance would be at least 40,000 in the mean over 21 data.
  for (const double square : measured.at({"from data", "D_8^2"})) CHECK(square < 10);
}

TEST_CASE("experiments of the a-ary paper and of the non-linear families find what is recorded") {
  std::size_t found = 0;
  for (const Experiment& e : subcert::experiments::experiments())
    if (e.paper == "mustafa-bari-2016" || e.paper == "mustafa-hameed") {
      ++found;
      const RanExperiment ran = run_experiment(e, {1, 50, 2});
      for (const DecidedClaim& claim : ran.result.claims) {
        INFO(e.id << ": " << claim.sentence << " " << claim.numbers);
        CHECK(claim.finding == claim.recorded);
      }
    }
  CHECK(found == 11);
  const Experiment& e = experiment("nonlinear-fig8");
  CHECK(experiment_json(run_experiment(e, {5, 4, 1})) == experiment_json(run_experiment(e, {5, 4, 2})));
}

TEST_CASE("experiments without random numbers do not depend on the seed") {
  for (const Experiment& e : subcert::experiments::experiments()) {
    if (e.paper != "mustafa-bari-2016" && e.id != "nonlinear-fig3" && e.id != "nonlinear-fig7") continue;
    const ExperimentResult one = run_experiment(e, {1, 2, 1}).result, two = run_experiment(e, {2, 3, 1}).result;
    CHECK(!e.random);
    REQUIRE(one.claims.size() == two.claims.size());
    for (std::size_t i = 0; i < one.claims.size(); ++i) CHECK(one.claims[i].numbers == two.claims[i].numbers);
  }
}
