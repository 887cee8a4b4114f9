#include <nlohmann/json.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/reports/experiments/mustafa-li-2015/damped_sine.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::experiments;
using namespace subcert::experiments::mustafa_li_2015;

namespace {

std::vector<double> random_values(std::uint64_t seed, std::size_t count) {
  auto engine = generator(seed, 0);
  return normal_noise(engine, count);
}

}  // namespace

TEST_CASE("sets that are refined together are refined as if alone") {
  const auto first = random_values(1, 40), second = random_values(2, 40);
  for (const char* scheme : {"dual:n=3", "l1:points=6", "bspline:degree=2"}) {
    INFO(scheme);
    const Batch both = refined(scheme, {{data::Axis::of(20)}, 2, {first, second}}, 2);
    const Batch alone = refined(scheme, {{data::Axis::of(20)}, 2, {second}}, 2);
    REQUIRE(both.sets.size() == 2);
    CHECK(both.sets[1] == alone.sets[0]);
    CHECK(both.axes[0].count == alone.axes[0].count);
    CHECK(parameters(both.axes[0]).size() * 2 == both.sets[0].size());
  }
  const auto a = random_values(3, 80), b = random_values(4, 80);
  for (const char* scheme : {"grid:points=6x6,d=1", "l1:points=6x6", "tensor:(bspline:degree=2)x(bspline:degree=2)"}) {
    INFO(scheme);
    const std::vector<data::Axis> axes{data::Axis::of(8), data::Axis::of(10)};
    CHECK(refined(scheme, {axes, 1, {a, b}}, 1).sets[1] == refined(scheme, {axes, 1, {b}}, 1).sets[0]);
  }
}

TEST_CASE("a batch has what refine() makes, and refuses what mixes coordinates") {
  const auto values = random_values(5, 30);
  const L1Scheme scheme{{7}, 1, {}};
  CHECK(refined("l1:points=7", {{data::Axis::of(30)}, 1, {values}}, 3).sets[0] ==
        refine(data::curve_data(std::vector<double>(values)), scheme, {3, data::Boundary::regression, 1}).values);
  CHECK_FAILS(refined("l1:points=6,residuals=joint", {{data::Axis::of(30)}, 1, {values}}, 1), domain);
  CHECK_FAILS(refined("grid:points=4x4x4", {{data::Axis::of(30)}, 1, {values}}, 1), domain);
}

TEST_CASE("the l1 schemes without reweighting are the least squares schemes") {
  const auto curve = random_values(6, 30), surface = random_values(7, 120);
  for (std::size_t m = 0; m < 3; ++m) {
    for (const auto& [methods, batch] :
         {std::pair{curve_methods(), Batch{{data::Axis::of(30)}, 1, {curve}}},
          std::pair{surface_methods(), Batch{{data::Axis::of(10), data::Axis::of(12)}, 1, {surface}}}}) {
      INFO(methods[m].name);
      const Batch linear = refined(methods[m].specification, batch, 2);
      const Batch robust = refined(methods[m + 3].specification + ",iterations=0", batch, 2);
      REQUIRE(linear.sets[0].size() == robust.sets[0].size());
      for (std::size_t i = 0; i < linear.sets[0].size(); ++i)
        CHECK(linear.sets[0][i] == Approx(robust.sets[0][i]).margin(1e-12));
    }
  }
}

TEST_CASE("a study measures errors and responses") {
  NoisyData what = damped::Setting().with_outliers(0, 0);
  Measured measured;
  study(measured, what, curve_methods(), {error_measure, error_without_measure, response_measure},
        {1, 27, 2});  // more than are refined together
  for (const Method& method : curve_methods()) {
    const auto& errors = measured.at({"error", method.name});
    CHECK(errors == measured.at({"error without", method.name}));
    for (const double response : measured.at({"response", method.name})) CHECK(response == 0);
    for (const double error : errors) CHECK(error == errors[0]);
    CHECK(errors[0] > 0);
  }
  // A linear scheme answers an outlier of height 1 by the basic limit function, whose values are at most 0.171 for S_6.
  what.outliers = 1;
  what.displace = [](std::mt19937_64&, double* height) { *height += 1; };
  study(measured, what, {curve_methods()[0]}, {response_measure}, {1, 2, 1});
  CHECK(measured.at({"response", "S_6"})[0] == Approx(0.1705).margin(1e-3));
  CHECK_FAILS(measured.at({"error", "S_9"}), domain);
}

TEST_CASE("without noise the data without outliers are the exact ones, and noise has a response of its own") {
  NoisyData what = damped::Setting().with_outliers(2, 0);
  const std::vector<Method> methods{curve_methods()[0], curve_methods()[3]};
  Measured quiet, all_drawn, noisy;
  study(quiet, what, methods, {error_without_measure, response_measure, response_to_noise_measure}, {1, 30, 2});
  what.sigma = 1e-300;  // noise that is lost in rounding, but for the data that are 0
  study(all_drawn, what, methods, {error_without_measure, response_measure}, {1, 30, 2});
  what.sigma = 0.1;
  study(noisy, what, methods, {error_without_measure, response_to_noise_measure}, {1, 30, 2});
  for (const Method& method : methods) {
    INFO(method.name);
    for (std::size_t r = 0; r < 30; ++r) {
      CHECK(quiet.at({"response to noise", method.name})[r] == 0);
      CHECK(quiet.at({"error without", method.name})[r] == quiet.at({"error without", method.name})[0]);
      for (const char* measure : {"error without", "response"})
        CHECK(quiet.at({measure, method.name})[r] == Approx(all_drawn.at({measure, method.name})[r]).margin(1e-9));
      CHECK(quiet.at({"response", method.name})[r] > 0);
    }
  }
  // A linear scheme answers to noise as to any data.
  const auto& data = what;
  auto engine = generator(1, 7);
  const OutlierSample sample = data.draw(engine);
  std::vector<double> noise = sample.without;
  const std::vector<double> exact = data.true_points().values;
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] -= exact[i];
  const Batch limit = refined(methods[0].specification, {data.axes, 1, {noise}}, data.levels);
  CHECK(noisy.at({"response to noise", "S_6"})[7] ==
        Approx(largest_distance(limit.sets[0], std::vector<double>(limit.sets[0].size(), 0), 1)));
}

TEST_CASE("what interpolates overfits, outliers too, and a wide least squares scheme does not") {
  for (const double sigma : {0.0, 1.0}) {
    Measured measured;
    study(measured, damped::Setting().with_outliers(13, sigma), {{"4-point", "dd:n=2"}, {"wide", "primal:n=4"}},
          {overfits_measure}, {1, 10, 2});
    CHECK(measured.at({"overfits", "4-point"}) == std::vector<double>(10, 1));
    CHECK(measured.at({"overfits", "wide"}) == std::vector<double>(10, 0));
  }
}

TEST_CASE("outliers stand where they should") {
  auto engine = generator(8, 0);
  const OutlierSample sample = damped::Setting().with_outliers(13, 0.1).draw(engine);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < damped::Setting().count; ++i) {
    const double height = std::abs(sample.with[i] - sample.without[i]);
    moved += height != 0;
    if (height != 0) CHECK((height >= 4 && height <= 8 + 1e-12));
  }
  CHECK(moved == 13);
  CHECK(damped_sine(damped::Setting().position(50)) == 0);
  CHECK(damped_sine(damped::Setting().position(60)) == Approx(std::sin(3.0) * std::exp(-1.0 / 3)));
}

TEST_CASE("the printed tables of errors name each scheme once") {
  const statements::Paper paper = statements::paper("mustafa-li-2015");
  for (const char* id : {"table1", "table2", "table3"}) {
    const statements::PublishedTable& table = paper.table(id);
    const auto& methods = std::string(id) == "table3" ? surface_methods() : curve_methods();
    REQUIRE(table.cells.size() == methods.size());
    for (std::size_t i = 0; i < methods.size(); ++i) {
      CHECK(table.cells[i].column == methods[i].name);
      CHECK(table.cells[i].scheme == methods[i].specification);
      CHECK(table.cells[i].recorded == ValueVerdict::not_reproducible);
    }
  }
}

namespace {

void check_jobs(const char* id) {
  const ExperimentOptions one{5, 2, 1}, two{5, 2, 2};
  const Experiment& e = experiment(id);
  CHECK(experiment_json(run_experiment(e, one)) == experiment_json(run_experiment(e, two)));
}

}  // namespace

TEST_CASE("an experiment of the l1 paper does not depend on the number of jobs") { check_jobs("l1-fig1"); }

TEST_CASE("the other experiments of the l1 paper do not depend on the number of jobs", "[long]") {
  for (const char* id : {"l1-exp2", "l1-fig4", "l1-exp3", "l1-surface1"}) check_jobs(id);
}
