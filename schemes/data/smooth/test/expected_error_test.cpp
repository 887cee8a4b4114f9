#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/smooth/expected_error.hpp>
#include <subcert/schemes/data/smooth/scheme_smoother.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using namespace subcert::data;

TEST_CASE("away from the ends the expected squared error is eq. (16)") {
  const Rational h(1, 10), sigma_squared(1, 25);
  const auto f = [](const Rational& x) { return Rational(x * x - 2 * x * x * x); };
  std::vector<Rational> samples;
  for (int i = 0; i < 41; ++i) samples.push_back(f(i * h));
  for (const char* text : {"primal:n=2", "primal:n=4", "primal:n=3,d=3"}) {
    const Scheme scheme = make_scheme(text);
    const SchemeSmoother smoother(scheme.mask.curve(), samples.size(), {Boundary::reflect, 2, 0});
    const LimitValues phi = limit_values(scheme.mask.curve(), 2);
    const VarianceGrid psi = variance_grid(scheme.mask.curve(), 2, false);
    for (std::size_t o = 80; o < 84; ++o) {
      Rational limit = 0;
      for (long j = 0; j < 41; ++j)
        limit += samples[static_cast<std::size_t>(j)] * phi.at(static_cast<long>(o) - 4 * j);
      const Rational truth = f(h * static_cast<long>(o) / 4);
      const ExpectedError error = expected_error(smoother.row(o), samples, truth, sigma_squared);
      CHECK(error.bias == limit - truth);
      CHECK(error.variance == sigma_squared * psi.values[o - 80]);
      if (scheme.rules->degree == 3) CHECK(error.bias == 0);
    }
  }
}

TEST_CASE("simulation agrees with the exact expected error, also at the ends") {
  const Scheme scheme = make_scheme("primal:n=3");
  std::vector<Rational> samples;
  std::vector<double> rounded;
  for (int i = 0; i < 20; ++i) {
    samples.emplace_back(i * i, 40);
    rounded.push_back(i * i / 40.0);
  }
  for (const Boundary kind : {Boundary::regression, Boundary::nearest}) {
    const SchemeSmoother smoother(scheme.mask.curve(), samples.size(), {kind, 1, 0});
    for (const std::size_t o : {0u, 1u, 5u, 19u, 38u}) {
      const Rational x = smoother.position(o), truth = x * x / 40;
      const SmoothingRow row = smoother.row(o);
      const double exact = static_cast<double>(expected_error(row, samples, truth, Rational(9, 100)).total());
      const SimulatedError simulated = simulated_error(row, rounded, static_cast<double>(truth), 0.3, 20000, 5, 0.9999);
      CHECK(simulated.lower < exact);
      CHECK(exact < simulated.upper);
      CHECK(simulated.upper - simulated.lower < 0.12 * exact);
    }
  }
  const SchemeSmoother smoother(scheme.mask.curve(), samples.size(), {});
  CHECK_THROWS_WITH(expected_error(smoother.row(38), {1, 2}, 0, 1), Catch::Matchers::Contains("got 2"));
  CHECK_THROWS_WITH(simulated_error(smoother.row(0), rounded, 0, 1, 1, 1), Catch::Matchers::Contains("runs >= 2"));
}
