#include <subcert/cmake/catch.hpp>
#include <subcert/reports/experiments/degree_study.hpp>

#include <cmath>
#include <numeric>

using namespace subcert;
using namespace subcert::experiments;

namespace {

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// A parabola with noise, without outliers where `height` is 0.
OutlierCase parabola(double sigma, double height) {
  const auto value = [](double x) { return (x - 10) * (x - 10) / 20; };
  return {{data::Axis::of(21)},
          1,
          2,
          [=](std::mt19937_64& engine) {
            OutlierSample sample;
            for (const double noise : normal_noise(engine, 21))
              sample.without.push_back(value(static_cast<double>(sample.without.size())) + sigma * noise);
            sample.with = sample.without;
            sample.with[9] += height;
            return sample;
          },
          [=](double x, double) {
            return std::array<double, 3>{value(x), 0, 0};
          }};
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

TEST_CASE("squared bias and variance add up to the error; without noise there is no variance") {
  const Method method = robust_method(6, 1);
  const ExperimentOptions options{3, 400, 2};
  const OutlierCase noisy = parabola(0.2, 3);
  const ErrorParts parts = error_parts(noisy, method, options);
  REQUIRE(parts.squared_bias.size() == 200);
  const Outcome whole = study(noisy, {method}, options).front();
  // Of a pair, the mean of both squares is e . e' + |e - e'|^2 / 2.
  CHECK(mean(parts.squared_bias) + mean(parts.variance) == Approx(mean(whole.error)));
  const ErrorParts quiet = error_parts(parabola(0, 0), method, {3, 4, 1});
  CHECK(mean(quiet.variance) == 0);
  CHECK(mean(quiet.squared_bias) == Approx(mean(study(parabola(0, 0), {method}, {3, 4, 1}).front().error)));
  CHECK(mean(quiet.squared_bias) > 0.001);
  CHECK(mean(error_parts(parabola(0, 0), robust_method(6, 2), {3, 4, 1}).squared_bias) < 1e-20);
}

TEST_CASE("the distance from the data leaves outliers out") {
  const ErrorParts parts = error_parts(parabola(0, 1000), robust_method(8, 2), {1, 2, 1});
  // The square of the outlier's own distance would be at least 40,000 in the mean over 21 data.
  for (const double square : parts.from_data) CHECK(square < 10);
}

TEST_CASE("experiments of the a-ary paper and of the non-linear families find what is recorded") {
  std::size_t found = 0;
  for (const Experiment& e : subcert::experiments::experiments())
    if (e.paper == "mustafa-bari-2016" || e.paper == "mustafa-hameed") {
      ++found;
      const RanExperiment ran = run_experiment(e, {1, 50, 2});
      for (const Claim& claim : ran.result.claims) {
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
    const ExperimentResult one = e.run({1, 2, 1}), two = e.run({2, 3, 1});
    CHECK(!one.random);
    REQUIRE(one.claims.size() == two.claims.size());
    for (std::size_t i = 0; i < one.claims.size(); ++i) CHECK(one.claims[i].numbers == two.claims[i].numbers);
  }
}
