#include <subcert/cmake/catch.hpp>
#include <subcert/reports/experiments/experiment.hpp>
#include <subcert/reports/experiments/linear_method.hpp>
#include <subcert/reports/experiments/statistics.hpp>

#include <cmath>
#include <set>

using namespace subcert;

TEST_CASE("local linear regression reproduces linear functions at any bandwidth") {
  const LocalLinearRegression regression(20, {0, 0.3, 10.5, 19});
  std::vector<double> data;
  for (int i = 0; i < 20; ++i) data.push_back(2.0 * i - 7);
  const auto values = regression(data);
  CHECK(values[0] == Approx(-7));
  CHECK(values[1] == Approx(-6.4));
  CHECK(values[2] == Approx(14));
  CHECK(values[3] == Approx(31));
}

TEST_CASE("more noise asks for a larger bandwidth") {
  const LocalLinearRegression regression(60, {});
  auto engine = generator(3, 0);
  const auto noise = normal_noise(engine, 60);
  std::vector<double> quiet, loud;
  for (std::size_t i = 0; i < 60; ++i) {
    const double f = std::sin(static_cast<double>(i) / 3);
    quiet.push_back(f + 0.01 * noise[i]);
    loud.push_back(f + noise[i]);
  }
  CHECK(regression.bandwidth(quiet) < regression.bandwidth(loud));
}

TEST_CASE("the limit matrix keeps linear data, and wraps") {
  const DenseMatrix open = limit_matrix("primal:n=3", 12, Extension::interp, 1);
  std::vector<double> line;
  for (int i = 0; i < 12; ++i) line.push_back(i);
  const auto values = open * line;
  REQUIRE(values.size() == 23);
  for (std::size_t i = 0; i < 23; ++i) CHECK(values[i] == Approx(static_cast<double>(i) / 2).margin(1e-12));
  const DenseMatrix closed = limit_matrix("primal:n=2", 12, Extension::wrap, 1);
  REQUIRE(closed.rows() == 24);
  for (std::size_t r = 0; r < 24; ++r)
    for (std::size_t c = 0; c < 12; ++c)
      CHECK(closed.at((r + 2) % 24, (c + 1) % 12) == Approx(closed.at(r, c)).margin(1e-12));
}

TEST_CASE("means with confidence: known values, coverage and the ratio of noise") {
  const MeanInterval interval = mean_interval({1, 2, 3, 4});
  CHECK(interval.mean == Approx(2.5));
  CHECK(interval.half_width == Approx(3.18244630528 * std::sqrt(5.0 / 12)));
  int covered = 0;
  for (std::size_t run = 0; run < 1000; ++run) {
    auto engine = generator(11, run);
    const MeanInterval sample = mean_interval(normal_noise(engine, 10));
    covered += !sample.is_negative() && !sample.is_positive();
  }
  CHECK(covered > 920);
  CHECK(covered < 980);
  const double sigma = noise_deviation(4, 6);
  CHECK(10 * std::log10((4 + sigma * sigma) / (sigma * sigma)) == Approx(6));
}

TEST_CASE("experiments have different names, and do not depend on the number of jobs") {
  std::set<std::string> ids;
  for (const Experiment& e : experiments()) CHECK(ids.insert(e.id).second);
  CHECK_THROWS_AS(experiment("fig999"), std::out_of_range);
  for (const char* id : {"fig3", "fig17", "mse"}) {
    const ExperimentOptions one{5, 4, 1}, two{5, 4, 2};
    const Experiment& e = experiment(id);
    CHECK(experiment_json(run_experiment(e, one)) == experiment_json(run_experiment(e, two)));
  }
}
