#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;

namespace {

/// Whether one refinement step maps samples of x^degree at j + s to samples at (i + s) / arity.
bool step_keeps(const Mask& mask, int degree, const Rational& shift) {
  for (long i = 0; i < 3 * mask.arity(); ++i) {
    Rational sum = 0;
    for (long j = -60; j <= 60; ++j) sum += mask.symbol().coefficient(i - mask.arity() * j) * power(j + shift, degree);
    if (sum != power((i + shift) / mask.arity(), degree)) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("reproduction degrees and parametrizations, checked on samples") {
  const struct {
    const char* specification;
    int generation, reproduction;
    Rational shift;
  } known[] = {{"primal:n=3", 1, 1, 0},
               {"primal:n=3,d=2", 3, 3, 0},
               {"dual:n=3", 2, 1, Rational(-1, 2)},
               {"dual:n=2,d=3", 4, 3, Rational(-1, 2)},
               {"primal-odd:n=2", 1, 1, 0},
               {"dual-odd:n=2", 2, 1, Rational(-1, 2)},
               {"dd:n=3", 5, 5, 0},
               {"bspline:degree=3", 3, 1, 0},
               {"bspline:degree=4", 4, 1, Rational(-1, 2)},
               {"ary:a=3,points=4,d=3", 3, 3, Rational(-1, 4)},
               {"ary:a=3,points=5,d=2", 2, 2, 0},
               {"ary:a=4,points=4,d=1", 1, 1, Rational(-1, 6)},
               {"four-point:w=1/20", 1, 1, 0}};
  for (const auto& [specification, generation, reproduction, shift] : known) {
    CAPTURE(specification);
    const Mask mask = make_scheme(specification).mask.curve();
    const PolynomialReproduction result = polynomial_reproduction(mask);
    CHECK(result.generation_degree() >= generation);
    CHECK(result.reproduction_degree == reproduction);
    CHECK(result.parametrization == std::vector<Rational>{shift});
    CHECK(result.approximation_order() == reproduction + 1);
    for (int k = 0; k <= reproduction; ++k) CHECK(step_keeps(mask, k, shift));
    CHECK_FALSE(step_keeps(mask, reproduction + 1, shift));
  }
}

TEST_CASE("the bias in the mean: known constants, and the mean of exact values over a grid") {
  const auto of = [](const char* scheme) { return mean_bias(make_scheme(scheme).mask.curve()); };
  // The quadratic B-spline has the variance 3/12, so that f is missed by 1/8 f''.
  CHECK(of("mask:[1,3,3,1]/4").order == 2);
  CHECK(of("mask:[1,3,3,1]/4").constant == Rational(1, 8));
  CHECK(of("four-point:w=1/16").order == 4);
  for (int n = 2; n <= 6; ++n) {  // degree 1: ((2n-1)^2 - 1 + (2n)^2 - 1)/36
    const MeanBias bias = mean_bias(make_scheme("primal:n=" + std::to_string(n)).mask.curve());
    CHECK(bias.order == 2);
    CHECK(bias.constant == Rational((2 * n - 1) * (2 * n - 1) + 4 * n * n - 2, 36));
  }
  // Sums over j of (j - x)^p phi(x - j) at x = i/16, in the mean.
  for (const char* scheme : {"primal:n=3", "primal:n=4,d=3", "bspline:degree=4,a=3", "dual:n=2"}) {
    CAPTURE(scheme);
    const Mask mask = make_scheme(scheme).mask.curve();
    const auto [order, constant] = mean_bias(mask);
    const Rational shift = polynomial_reproduction(mask).parametrization.front();
    const int level = 5;
    const LimitValues phi = limit_values(mask, level);
    Rational sum = 0, points = power(Rational(mask.arity()), level);
    for (std::size_t i = 0; i < phi.values.size(); ++i)
      sum += phi.values[i] * power(Rational(shift - phi.point(i)), order);
    Rational factorial = 1;
    for (int k = 2; k <= order; ++k) factorial *= k;
    CHECK(abs(Rational(sum / points / factorial / constant - 1)) < Rational(1, 1000));
  }
}
