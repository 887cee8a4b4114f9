#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/smooth/method_choice.hpp>
#include <subcert/schemes/specification.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <tuple>

using namespace subcert;
using namespace subcert::data;

namespace {

std::vector<double> sampled(std::size_t count, double frequency, double sigma, unsigned long seed,
                            const std::vector<double>& weights = {}) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> gauss;
  std::vector<double> data;
  for (std::size_t i = 0; i < count; ++i) {
    const double noise = gauss(engine) * sigma / std::sqrt(weights.empty() ? 1 : weights[i]);
    data.push_back(std::sin(frequency * static_cast<double>(i)) + noise);
  }
  return data;
}

}  // namespace

TEST_CASE("the noise estimate ignores lines, and its mean and spread are those of its degrees of freedom") {
  std::vector<double> line;
  for (int i = 0; i < 30; ++i) line.push_back(3 - 0.5 * i);
  CHECK(estimate_noise(line).variance < 1e-28);
  CHECK(estimate_noise({1, 2}).terms == 0);
  CHECK(estimate_noise({1, 2, 4}, {1, 0, 1}).terms == 0);

  std::vector<double> weights;
  for (int i = 0; i < 60; ++i) weights.push_back(i % 3 == 0 ? 4 : 1);
  for (const auto& w : {std::vector<double>{}, weights}) {
    double sum = 0, squares = 0;
    const int runs = 2000;
    double nu = 0;
    for (int seed = 0; seed < runs; ++seed) {
      const NoiseEstimate noise = estimate_noise(sampled(60, 0, 2, static_cast<unsigned long>(seed), w), w);
      sum += noise.variance;
      squares += noise.variance * noise.variance;
      nu = noise.degrees_of_freedom;
    }
    const double mean = sum / runs, variance = squares / runs - mean * mean;
    // The standard errors of mean and variance of 2000 runs are about 0.8 % and 4 %.
    CHECK(mean == Approx(4).epsilon(0.03));
    CHECK(variance == Approx(2 * 16 / nu).epsilon(0.15));
    CHECK(nu > 25);
    CHECK(nu < 60);
  }
}

TEST_CASE("the estimated risk is unbiased for data with known mean") {
  const Scheme scheme = make_scheme("primal:n=4");
  const std::size_t count = 40;
  std::vector<double> weights(count, 1);
  for (std::size_t i = 0; i < count; i += 4) weights[i] = 0.5;
  std::vector<Rational> exact(weights.begin(), weights.end());
  for (const bool weighted : {false, true}) {
    const SchemeSmoother smoother(scheme.mask.curve(), {count, weighted ? exact : std::vector<Rational>{}}, {},
                                  scheme.rules);
    const std::vector<double> w = weighted ? weights : std::vector<double>{};
    const auto truth = sampled(count, 0.5, 0, 1);
    const auto clean = smoother.apply(truth);
    double bias = 0, total_weight = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double each = weighted ? weights[i] : 1;
      bias += each * std::pow(clean.values[i] - truth[i], 2);
      total_weight += each;
    }
    const double sigma = 0.3;
    double sum = 0, squares = 0;
    const int runs = weighted ? 60 : 3000;
    for (int seed = 0; seed < runs; ++seed) {
      const RiskEstimate risk = estimate_risk(
          smoother, {{sampled(count, 0.5, sigma, static_cast<unsigned long>(seed), w)}, {w.begin(), w.end()}},
          {{sigma * sigma, 100, 1}});
      sum += risk.bias_squared;
      squares += risk.bias_squared * risk.bias_squared;
    }
    const double mean = sum / runs, error = std::sqrt((squares / runs - mean * mean) / runs);
    CHECK(std::abs(mean - bias / total_weight) < 4 * error);
  }
}

TEST_CASE("more noise asks for more points, none for interpolation") {
  const auto best = [](double sigma) {
    const auto data = sampled(120, 0.2, sigma, 7);
    return rank_schemes({{data}}, {estimate_noise(data)}, {}).front();
  };
  CHECK(best(1e-4).points < best(0.3).points);
  CHECK(best(0.3).risk.variance > 0);
  const auto ranked = rank_schemes({{sampled(120, 0.2, 0.1, 7)}}, {{0.01, 60, 118}}, {Boundary::reflect});
  for (std::size_t i = 1; i < ranked.size(); ++i) CHECK(ranked[i - 1].risk.total() <= ranked[i].risk.total());
  CHECK(ranked.size() == 20 + 19 + 18);
  CHECK_THROWS_WITH(rank_schemes({{{1, 2, 3}}}, {{}}, {}), Catch::Matchers::Contains("at least 4 data, got 3"));
}

TEST_CASE("the method chosen is the best one of schemes and wider windows, no bias is negative") {
  const Samples noisy{{sampled(120, 0.2, 0.1, 7)}};
  for (const Selection selection : {Selection::risk, Selection::cross_validation}) {
    SmoothingOptions options;
    options.selection = selection;
    const MethodChoice best = choose_method(noisy, options);
    CHECK(to_text(best.method) == best.candidates[0].specification);
    CHECK(best.candidates.size() > 40);
    CHECK_FALSE(best.widest_tried());
    for (const SmoothingCandidate& one : best.candidates) {
      CHECK(one.risk.bias_squared >= 0);
      CHECK(one.risk.total() >= best.candidates[0].risk.total());
    }
  }
  const MethodChoice smooth = choose_method(noisy, {Boundary::regression, 0, 2});
  CHECK(smooth.candidates[0].degree > 2);
  CHECK_FAILS(choose_method(noisy, {Boundary::regression, 0, 17}), domain);
  CHECK_FAILS(choose_method({{{1, 2, 3}}}, {}), data);
  CHECK_FAILS(choose_method({{{1, 2, 3, 4, 5, 6}}, {1, 1, 0, 1, 1, 0}}, {}), data);
  // A line wants all data; equal values and few have a choice, too.
  std::vector<double> line = sampled(200, 0, 1, 3);
  for (std::size_t i = 0; i < 200; ++i) line[i] += static_cast<double>(i);
  const MethodChoice widest = choose_method({{line}}, {}, LocalPolynomial{});
  CHECK(widest.candidates[0].points > 100);
  CHECK_FALSE(widest.widest_tried());
  for (const std::size_t count : {4, 5, 7, 90})
    for (const int derivative : {0, 1}) {
      const MethodChoice any = choose_method({{std::vector<double>(count, 3)}}, {Boundary::regression, 0, derivative});
      CHECK(any.candidates[0].risk.total() < 1e-20);
    }
  for (const double huge : {1e151, 1e200, 1e-141, 1e-300})
    CHECK_FAILS(choose_method({{{huge, -huge, huge, -huge, huge}}}, {}), data);
}

namespace {

double mean_square_apart(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("dense data get wide windows: near the best of all, by the error and by cross-validation") {
  constexpr std::size_t count = 30'000;
  const std::vector<double> truth = sampled(count, 0.002, 0, 1), data = sampled(count, 0.002, 0.3, 11);
  std::vector<double> places, uneven_truth, uneven_data;
  std::mt19937_64 engine(12);
  std::exponential_distribution<double> gap(1);
  std::normal_distribution<double> gauss(0, 0.3);
  for (double x = 0; places.size() < count; x += gap(engine)) {
    places.push_back(x);
    uneven_truth.push_back(std::sin(0.002 * x));
    uneven_data.push_back(uneven_truth.back() + gauss(engine));
  }
  for (const bool uniform : {true, false}) {
    Samples samples{{uniform ? data : uneven_data}};
    if (!uniform) samples.positions = places;
    const std::vector<double>& wanted = uniform ? truth : uneven_truth;
    const auto error_of = [&](const LocalPolynomial& method) {
      const LocalSmoother smoother(method, samples.sites(), {.at_data = true, .path = false});
      return std::sqrt(mean_square_apart(smoother.apply(samples.columns[0]).values, wanted));
    };
    double best = 1;
    for (const std::size_t points : {200, 280, 400, 560, 800, 1100, 1600})
      best = std::min(best, error_of({1, LocalWeight::tricube, points}));
    for (const Selection selection : {Selection::risk, Selection::cross_validation}) {
      const MethodChoice choice = choose_method(samples, {.selection = selection}, LocalPolynomial{});
      CAPTURE(uniform, best, choice.candidates[0].specification);
      CHECK(error_of(std::get<LocalPolynomial>(choice.method)) < 1.1 * best);
      // The risks are those of the windows themselves.
      const LocalSmoother whole(std::get<LocalPolynomial>(choice.method), samples.sites(),
                                {.at_data = true, .path = false});
      const RiskEstimate risk = estimate_risk(whole, samples, {known_noise(0.3)});
      CHECK(choice.candidates[0].risk.variance == Approx(risk.variance).epsilon(0.03));
    }
  }
}

TEST_CASE("windows for derivatives are chosen for these, near the best of all") {
  for (const auto& [derivative, degree, count] : {std::tuple{1, 2, 4000}, {2, 3, 4000}, {1, 2, 300}}) {
    const double frequency = 60.0 / count;
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> wanted;
    for (std::size_t i = 0; i < size; ++i) {
      const double phase = frequency * static_cast<double>(i);
      wanted.push_back(derivative == 1 ? frequency * std::cos(phase) : -frequency * frequency * std::sin(phase));
    }
    LocalPolynomial pattern;
    pattern.degree = degree;
    double chosen = 0, best = 0;
    for (unsigned long seed = 0; seed < 3; ++seed) {
      const Samples samples{{sampled(size, frequency, 0.2, 100 + seed)}};
      const SmoothingOptions options{.derivative = derivative, .at_data = true, .path = false};
      const auto error_of = [&](const LocalPolynomial& method) {
        return std::sqrt(
            mean_square_apart(LocalSmoother(method, size, options).apply(samples.columns[0]).values, wanted));
      };
      double least = 1e9;
      for (std::size_t points = 8; points < size / 4; points += 1 + points / 6)
        least = std::min(least, error_of({degree, LocalWeight::tricube, points}));
      best += least;
      chosen += error_of(std::get<LocalPolynomial>(choose_method(samples, options, pattern).method));
    }
    CAPTURE(derivative, count, chosen / best);
    CHECK(chosen < 1.25 * best);
  }
  // Where there is no bias, none is taken from the noise of the pilot.
  LocalPolynomial quadratic;
  quadratic.degree = 2;
  double share = 0;
  for (unsigned long seed = 0; seed < 10; ++seed) {
    const auto ranked = choose_method({{sampled(400, 0, 1, seed)}}, {Boundary::regression, 0, 1}, quadratic).candidates;
    share += static_cast<double>(ranked.front().points) / 4000;
  }
  CAPTURE(share);
  CHECK(share > 0.8);
}

TEST_CASE("the choice for several columns does not depend on their units, nor on one that is constant") {
  const std::vector<double> wave = sampled(150, 0.2, 0.1, 7), slow = sampled(150, 0.02, 0.2, 8);
  std::vector<double> large = slow;
  for (double& value : large) value = 1e6 * value + 3e6;
  const std::string chosen = to_text(choose_method({{wave, slow}}, {}).method);
  CHECK(to_text(choose_method({{wave, large}}, {}).method) == chosen);
  CHECK(to_text(choose_method({{large, wave}}, {}).method) == chosen);
  CHECK(to_text(choose_method({{wave, std::vector<double>(150, 0.1)}}, {}).method) ==
        to_text(choose_method({{wave}}, {}).method));
}

TEST_CASE("the estimated error of a derivative lies in its range nearly always, and the window is near the best") {
  // Functions on [0, 1] with their first and second derivatives.
  struct Known {
    std::function<double(double)> of[3];
  };
  const auto wave = [](double w) {
    return Known{{[=](double t) { return std::sin(w * t); }, [=](double t) { return w * std::cos(w * t); },
                  [=](double t) { return -w * w * std::sin(w * t); }}};
  };
  const Known functions[] = {
      wave(19),
      wave(3),
      wave(38),
      {{[](double t) { return std::exp(2 * t) / 4; }, [](double t) { return std::exp(2 * t) / 2; },
        [](double t) { return std::exp(2 * t); }}},
      {{[](double t) { return std::exp(-100 * (t - 0.4) * (t - 0.4)); },
        [](double t) { return -200 * (t - 0.4) * std::exp(-100 * (t - 0.4) * (t - 0.4)); },
        [](double t) { return (40'000 * (t - 0.4) * (t - 0.4) - 200) * std::exp(-100 * (t - 0.4) * (t - 0.4)); }}}};
  std::mt19937_64 engine(21);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> anywhere;
  for (const int derivative : {1, 2}) {
    int cases = 0, covered = 0;
    double regret = 0;
    for (const Known& function : functions)
      for (const double sigma : {0.02, 0.3})
        for (const bool uniform : {true, false})
          for (int draw = 0; draw < 3; ++draw) {
            constexpr std::size_t count = 240;
            std::vector<double> places, data, wanted;
            for (std::size_t i = 0; i < count; ++i)
              places.push_back(uniform ? static_cast<double>(i) / (count - 1) : anywhere(engine));
            std::ranges::sort(places);
            for (const double t : places) {
              data.push_back(function.of[0](t) + sigma * gauss(engine));
              wanted.push_back(function.of[derivative](t));
            }
            Samples samples{{data}};
            samples.put_at(places);
            const SmoothingOptions options{.derivative = derivative, .at_data = true, .path = false};
            const MethodChoice choice = choose_method(samples, options);
            const double unit = std::pow(nearest_double(samples.spacing), -derivative);
            std::vector<double> truth;
            for (const double t : places) truth.push_back(function.of[0](t));
            // The bias is that on the function itself, the variance exact.
            const auto risk_of = [&](const SmoothingCandidate& candidate) {
              const LocalSmoother smoother(make_local_polynomial(candidate.specification), samples.sites(), options);
              const SmoothedData smoothed = smoother.apply(truth);
              double sum = 0;
              for (std::size_t i = 0; i < count; ++i) {
                const double bias = unit * smoothed.values[i] - wanted[i];
                sum += bias * bias + sigma * sigma * unit * unit * smoothed.variances[i];
              }
              return sum / count;
            };
            const SmoothingCandidate& best = choice.candidates.front();
            const double risk = risk_of(best);
            REQUIRE(best.range);
            CHECK(best.range->first <= best.risk.total());
            CHECK(best.range->second >= best.risk.total());
            ++cases;
            covered += best.range->first <= risk && risk <= best.range->second ? 1 : 0;
            double least = risk;
            for (std::size_t k = 1; k < choice.candidates.size(); k += 3)
              least = std::min(least, risk_of(choice.candidates[k]));
            regret += std::log(risk / least) / (2 * 2 * 3 * 5);
          }
    CAPTURE(derivative, cases, covered, regret);
    CHECK(covered >= 0.85 * cases);
    CHECK(regret < std::log(1.6));
  }
}

TEST_CASE("bands have the width of Student's quantiles") {
  CHECK(band_factor(0.95, {1, 10, 10}) == Approx(2.228).epsilon(1e-3));
  CHECK(band_factor(0.95, {1, 1e6, 10}) == Approx(1.96).epsilon(1e-3));
  CHECK_FAILS(band_factor(1, {1, 10, 10}), domain);
  CHECK_FAILS(band_factor(0.95, {}), domain);
}

TEST_CASE("the number of points chosen is the one of the closed form, where the derivative and the noise are known") {
  // The first digits of C_d, `subcert theorem limit-constants`.
  for (const auto& [degree, limit] : {std::pair{1, 0.4044}, {3, 1.0446}, {5, 1.6858}})
    for (const double best : {7.0, 10.0, 14.0}) {
      const double N = 2 * best - 0.5;
      const std::size_t count = 3000;
      // Periodic data; the mean square of the derivative of order d + 1 is frequency^(2d + 2)/2.
      const double periods = std::round(static_cast<double>(count) / (2 * std::numbers::pi * N) *
                                        (1 + 0.2 * (degree - 1))),
                   frequency = 2 * std::numbers::pi * periods / static_cast<double>(count);
      const std::string widest = "primal:n=20,d=" + std::to_string(degree);
      const double constant = mean_bias(make_scheme(widest).mask.curve()).constant.convert_to<double>() /
                              std::pow(39.5, degree + 1);
      const double bias = std::abs(constant) * std::pow(frequency, degree + 1) / std::numbers::sqrt2;
      // The noise for which N^(2d + 3) = C_d sigma^2/((d + 1) B^2).
      const double sigma = bias * std::sqrt((degree + 1) * std::pow(N, 2 * degree + 3) / limit);
      double sum = 0;
      const int draws = 5;
      for (int seed = 0; seed < draws; ++seed) {
        const Samples samples{{sampled(count, frequency, sigma, static_cast<unsigned long>(100 + seed))}};
        for (const SmoothingCandidate& one : rank_schemes(samples, {known_noise(sigma)}, {Boundary::periodic})) {
          if (one.degree != degree) continue;
          sum += static_cast<double>(one.points) / 2;
          break;
        }
      }
      CAPTURE(degree, best, frequency * N, sigma, sum / draws);
      CHECK(std::abs(sum / draws - best) < 0.2 * best);
    }
}
