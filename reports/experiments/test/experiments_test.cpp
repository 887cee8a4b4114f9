#include <nlohmann/json.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/reports/collections.hpp>
#include <subcert/reports/experiments/dyn-2015/limit_trial.hpp>
#include <subcert/reports/experiments/dyn-2015/mechanical_part.hpp>
#include <subcert/reports/experiments/local_polynomial.hpp>

#include <cmath>
#include <set>

using namespace subcert;
using namespace subcert::experiments;
using namespace subcert::experiments::dyn_2015;

TEST_CASE("local regression of each degree keeps its polynomials at every bandwidth") {
  const std::vector<double> positions{0, 0.3, 10.5, 19};
  auto engine = generator(2, 0);
  const auto noise = normal_noise(engine, 20);
  for (int degree = 0; degree <= 3; ++degree) {
    const LocalPolynomialRegression regression(degree, 20, positions);
    const auto polynomial = [&](double x) { return std::pow(x / 4 - 2, degree) - 3; };
    std::vector<double> data;
    for (int i = 0; i < 20; ++i) data.push_back(polynomial(i));
    RegressionOfSum sum(regression, data, noise);
    for (const double sigma : {0.0, 1e-9, 1e-3, 1.0}) {
      CAPTURE(degree, sigma);
      std::vector<double> noisy(data);
      for (std::size_t i = 0; i < 20; ++i) noisy[i] += sigma * noise[i];
      const auto values = sum(sigma), again = regression(noisy);
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(values[i] == Approx(polynomial(positions[i])).margin(1e-9 + 5 * sigma));
        CHECK(values[i] == Approx(again[i]).margin(1e-9));
      }
    }
  }
  CHECK_FAILS(LocalPolynomialRegression(4, 20, {}), domain);
  CHECK_FAILS(LocalPolynomialRegression(1, 7, {}), domain);
}

TEST_CASE("local linear regression keeps lines, agrees with the rule by leaving out, and takes medians") {
  std::vector<double> line, noisy;
  auto engine = generator(4, 0);
  const auto noise = normal_noise(engine, 30);
  for (std::size_t i = 0; i < 30; ++i) {
    line.push_back(3 - 0.5 * static_cast<double>(i));
    noisy.push_back(line.back() + noise[i]);
  }
  for (const double bandwidth : {0.1, 0.3, 2.0, 50.0}) {
    const auto values = local_linear(line, bandwidth, 2);
    REQUIRE(values.size() == 117);
    for (std::size_t i = 0; i < values.size(); ++i)
      CHECK(values[i] == Approx(3 - 0.125 * static_cast<double>(i)).margin(1e-9));
  }
  std::vector<double> positions;
  for (int i = 0; i <= 58; ++i) positions.push_back(i / 2.0);
  const LocalPolynomialRegression leaving_out(1, 30, positions);
  const auto one = leaving_out(noisy), other = local_linear(noisy, leaving_out.bandwidth(noisy), 1);
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i] == Approx(other[i]).margin(1e-9));
  // Five data: medians 2 and 30, of the distances 1 and 10.
  const double h = std::sqrt(1 / 0.6745 * 10 / 0.6745) * std::pow(4.0 / 15, 0.2);
  CHECK(median_bandwidth({10, 20, 30, 40, 90}, 1) == Approx(h));
  CHECK(median_bandwidth({10, 20, 30, 40, 90}, 4) == Approx(h / 2));
  CHECK_FAILS(local_linear(line, 0.05, 1), domain);
}

TEST_CASE("more noise asks for a larger bandwidth") {
  const LocalPolynomialRegression regression(1, 60, {});
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
  const DenseMatrix open = limit_matrix("primal:n=3", 12, data::Boundary::regression, 1);
  std::vector<double> line;
  for (int i = 0; i < 12; ++i) line.push_back(i);
  const auto values = open * line;
  REQUIRE(values.size() == 23);
  for (std::size_t i = 0; i < 23; ++i) CHECK(values[i] == Approx(static_cast<double>(i) / 2).margin(1e-12));
  const DenseMatrix closed = limit_matrix("primal:n=2", 12, data::Boundary::periodic, 1);
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
  const double quiet = noise_deviation(4, 6, 10);
  CHECK(5 * std::log10((4 + quiet * quiet) / (quiet * quiet)) == Approx(6));
  // Four looks: at the first samples, and at 4, 16 and 64 times as many.
  CHECK(each_of(1) == Approx(0.9975));
  CHECK(each_of(20) == Approx(0.999875));
  // None of 50 does not show that there are none: 1 - 0.005^(1/50).
  CHECK(mean_interval(std::vector<double>(50, 0), 0.99).half_width == Approx(1 - std::pow(0.005, 1.0 / 50)));
  CHECK(mean_interval(std::vector<double>(50, 1), 0.99).half_width == Approx(1 - std::pow(0.005, 1.0 / 50)));
  CHECK(mean_interval({1, 2, 3, 4}, 0.99).half_width == Approx(5.84090930973 * std::sqrt(5.0 / 12)));
}

TEST_CASE("every quantity that a claim names is measured, and every fact is claimed") {
  const ExperimentOptions two_samples{1, 2, 2};
  for (const Experiment& e : subcert::experiments::experiments()) {
    INFO(e.id);
    const Measured measured = e.measure({two_samples, e});
    Measured given = measured;
    Experiment repeated = e;
    repeated.measure = [&](const Run&) { return given; };
    const ExperimentResult result = run_experiment(repeated, two_samples).result;
    CHECK(result.claims.size() + result.remarks.size() == e.claims.size());
    for (const auto& [topic, found] : measured.facts) {
      INFO(topic);
      given = measured;
      given.facts.erase(topic);
      CHECK_FAILS(run_experiment(repeated, two_samples), domain);
    }
  }
}

TEST_CASE("experiments have different names, and do not depend on the number of jobs") {
  std::set<std::string> ids;
  for (const Experiment& e : subcert::experiments::experiments()) CHECK(ids.insert(e.id).second);
  CHECK_FAILS(experiment("fig999"), domain);
  for (const char* id : {"fig3", "fig17", "fig19", "mse"}) {
    const ExperimentOptions one{5, 4, 1}, two{5, 4, 2};
    const Experiment& e = experiment(id);
    CHECK(experiment_json(run_experiment(e, one)) == experiment_json(run_experiment(e, two)));
  }
}

TEST_CASE("every choice changes what is measured, and what is counted elsewhere is counted there") {
  const ExperimentOptions two_samples{1, 2, 2};
  for (const Experiment& e : subcert::experiments::experiments()) {
    CAPTURE(e.id);
    for (const Claim& claim : e.claims)
      if (!claim.counted_in.empty()) CHECK(experiment(claim.counted_in).paper == e.paper);
    if (e.choices.empty()) continue;
    const Measured taken = e.measure({two_samples, e});
    const auto facts = [](const Measured& measured) {
      std::string text;
      for (const auto& [topic, found] : measured.facts)
        for (const Fact& fact : found) text += fact.numbers + ";";
      return text;
    };
    for (const Choice& choice : e.choices)
      for (const std::string& other : choice.others) {
        CAPTURE(choice.name, other);
        const Measured changed = e.measure({two_samples, e, choice.name, other});
        bool same = facts(changed) == facts(taken);
        for (const auto& [quantity, samples] : changed.samples)
          same = same && taken.samples.contains(quantity) && taken.at(quantity) == samples;
        CHECK(!same);
      }
  }
}

// Long, as `subcert reproduce` decides the same with its own seed, and ./check runs it first.
TEST_CASE("with any seed and the runs of a report, every finding is the recorded one", "[long]") {
  const reports::ReportOptions defaults;
  for (const std::uint64_t seed : {defaults.seed, std::uint64_t{7}, std::uint64_t{101}, std::uint64_t{20261126}})
    for (const Experiment& e : subcert::experiments::experiments()) {
      if (!e.random && seed != defaults.seed) continue;
      const ExperimentResult result = run_experiment(e, {seed, defaults.runs, defaults.jobs}).result;
      for (const auto* list : {&result.claims, &result.remarks})
        for (const DecidedClaim& claim : *list) {
          CAPTURE(e.id, seed, claim.sentence, claim.numbers);
          CHECK(to_text(claim.finding) == to_text(claim.recorded));
        }
    }
}

TEST_CASE("every paper has a report of its experiments, and its claims are told in full") {
  for (const std::string& paper : reports::reproducible_papers())
    for (const std::string& id : reports::experiment_ids(paper)) CHECK(experiment(id).paper == paper);
  const reports::Report report = reports::make_report("dyn-2015", {{"fig15", "fig17"}, 2, {}, 1, 4});
  REQUIRE(report.experiments.size() == 2);
  CHECK(report.sections.size() == 2);
  CHECK(report.experiments.front().options.runs == 4);
  for (const RanExperiment& ran : report.experiments)
    for (const DecidedClaim& claim : ran.result.claims) {
      CHECK(!claim.place.empty());
      CHECK(!claim.statistic.empty());
      CHECK(!claim.numbers.empty());
    }
}

TEST_CASE("a finding that changes is noticed") {
  reports::Report report = reports::make_report("dyn-2015", {{"fig19"}, 1, {}, 1, 20});
  REQUIRE(report.as_recorded());
  report.experiments.front().result.claims.front().recorded = ClaimVerdict::own_data;
  CHECK(!report.as_recorded());
}

TEST_CASE("tensor product limits keep a plane, open, and turn with the data, closed") {
  const std::vector<data::Axis> axes{data::Axis::of(12), data::Axis::of(14)};
  const auto plane = [](double x, double y) { return std::array{x, y, 3 * x - 2 * y + x * y}; };
  const data::GridData<double> limit = TensorLimit("primal:n=3", axes, 1)(sampled(axes, 3, plane)),
                               wanted = sampled({finer(axes[0], 2), finer(axes[1], 2)}, 3, plane);
  REQUIRE(limit.axes[0].count == 23);
  REQUIRE(limit.axes[1].count == 27);
  REQUIRE(limit.values.size() == wanted.values.size());
  for (std::size_t i = 0; i < limit.values.size(); ++i)
    CHECK(limit.values[i] == Approx(wanted.values[i]).margin(1e-11));
}

TEST_CASE("measures of a limit beside samples, truth and the limit without noise") {
  const auto points = [](std::vector<double> values) {
    const std::size_t count = values.size() / 2;
    return data::GridData<double>{std::move(values), 2, {data::Axis::of(count)}};
  };
  const auto limit = points({0, 1, 2, 2}), truth = points({0, 0, 2, 0}), quiet = points({0, 0.5, 2, 0.5}),
             noisy = points({0, 4, 2, 2}), exact = points({0, 0, 2, 0});
  const TrialSample sample{limit, truth, quiet, noisy, exact};
  CHECK(squared_noise(sample) == Approx((0.25 + 2.25) / 2));
  CHECK(squared_bias(sample) == Approx(0.25));
  CHECK(square_to_noisy(sample) == Approx(9.0 / 2));
  CHECK(square_to_exact(sample) == Approx(5.0 / 2));
  CHECK(sample_error(sample) == Approx(std::sqrt(20.0 / 4)));
  CHECK(shape_error({truth, truth, quiet, points({0, 0, 6, 0}), exact}) == Approx(0).margin(1e-12));
  CHECK(sample_shape_error({limit, truth, quiet, points({0, 0, 6, 0}), exact}) == Approx(0).margin(1e-12));
}

TEST_CASE("whether a linear limit is nearer to the samples than to the truth is seen from its value at 0") {
  const Experiment& e = experiment("fig17");
  const Measured measured = e.measure({{1, 400, 2}, e});
  const double noise = 2 * 8.5 / (10 - 1);  // mean square of both coordinates at 10 dB
  for (const std::string scheme : {"S_3", "S_5", "S_4^3", "S_6^3"}) {
    CAPTURE(scheme);
    const MeanInterval found = mean_difference(measured.at({"from samples", scheme + " at 10 dB"}),
                                               measured.at({"from curve", scheme + " at 10 dB"}), 0.9999);
    CHECK(std::abs(found.mean - noise * (1 - 2 * measured.number("phi(0) of " + scheme))) < found.half_width);
  }
  CHECK(measured.number("phi(0) of S_3") == Approx(180.0 / 983));
}

TEST_CASE("both parts of an error on a function: one without noise, one that grows as the noise") {
  const Experiment& e = experiment("figs10-11");
  const Measured measured = e.measure({{1, 40, 2}, e});
  const auto mean_of_squares = [&](const std::string& name, int decibel) {
    return mean_square(measured.at({name, std::to_string(decibel)}));
  };
  for (const std::string name : {"S_5 on f_3", "S_5^3 on f_4"}) {
    CAPTURE(name);
    // The mean of the product of both parts is 0.
    const double parts = mean_of_squares(name + ", deterministic", 5) + mean_of_squares(name + ", noise", 5);
    CHECK(mean_of_squares(name, 5) == Approx(parts).epsilon(0.1));
    CHECK(mean_of_squares(name + ", deterministic", 1) == mean_of_squares(name + ", deterministic", 20));
    // The squares of the deviations at 1 and 20 dB.
    const double ratio = (std::pow(10, 2) - 1) / (std::pow(10, 0.1) - 1);
    CHECK(mean_of_squares(name + ", noise", 1) == Approx(ratio * mean_of_squares(name + ", noise", 20)));
  }
  CHECK(measured.at({"gain of S_5^3 on f_3", "9"})[3] ==
        measured.at({"S_5 on f_3", "9"})[3] - measured.at({"S_5^3 on f_3", "9"})[3]);
}

TEST_CASE("with little noise the limits on the torus are tori") {
  const Experiment& e = experiment("fig19");
  CHECK(e.measure({{1, 2, 2}, e}).at({"torus kept", "S_3 at 15 dB"}) == std::vector<double>{1, 1});
}

TEST_CASE("the mechanical part has the size of the scan and the heights of its parts") {
  const data::GridData<double> part = sampled(part_axes(), 3, part_point);
  CHECK(part.points() == 3969);
  CHECK(part.values.size() == 3 * 3969);
  CHECK(part_height(-10, 0) == 0);
  CHECK(part_height(10, 20) == 6);
  CHECK(part_height(0, 28) == 2);
  CHECK(part_height(3 + 8, -14) == Approx(12));
  CHECK(part_height(3, -14) == Approx(4));
  CHECK(part_height(-18, -12) == 4);
}

TEST_CASE("names of the schemes as the paper prints them") {
  CHECK(scheme_name("primal:n=3") == "S_3");
  CHECK(scheme_name("primal:n=4,d=3") == "S_4^3");
  CHECK(scheme_name("bspline:degree=3") == "bspline:degree=3");
}
