#include <subcert/analysis/symbol/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1/l1_basin.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/l1/l1_regression.hpp>

#include <algorithm>
#include <cmath>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

double largest_difference(std::vector<double> f, int order) {
  for (; order > 0; --order) {
    for (std::size_t i = 0; i + 1 < f.size(); ++i) f[i] = f[i + 1] - f[i];
    f.pop_back();
  }
  double largest = 0;
  for (const double difference : f) largest = std::max(largest, std::abs(difference));
  return largest;
}

std::vector<double> step(const L1Fitter& fitter, const std::vector<double>& f) {
  const std::size_t points = fitter.window().nodes();
  std::vector<double> next;
  for (std::size_t i = 0; i + points <= f.size(); ++i)
    for (const double value :
         fitter.fit(std::vector<double>(f.begin() + static_cast<long>(i), f.begin() + static_cast<long>(i + points))))
      next.push_back(value);
  return next;
}

}  // namespace

TEST_CASE("basin of least squares: the numbers of 6 points, as docs/l1.md says") {
  const L1Basin six = l1_basin(6, 1);
  CHECK(six.linear == Rational(57, 140));
  CHECK(six.contraction == Rational(197, 280));
  CHECK(six.radius == Rational(0));
  for (const int points : {4, 5, 6, 7, 8, 10}) {
    CAPTURE(points);
    const L1Basin basin = l1_basin(points, 1);
    CHECK(basin.linear < 1);
    CHECK(basin.radius > 0);
    CHECK(basin.contraction < 1);
    WARN(points << ": " << basin.linear << " " << basin.residual << " " << basin.radius << " " << basin.error);
  }
  CHECK_THROWS_AS(l1_basin(2, 1), Error);
  CHECK_THROWS_AS(l1_basin(19, 1), Error);
  CHECK_THROWS_AS(l1_basin(6, 4), Error);
}

TEST_CASE("basin of least squares: random data at its edge contract, and are refined nearly as by least squares") {
  Random random;
  for (const int points : {4, 5, 6, 7, 8})
    for (const int degree : {1, 2}) {
      CAPTURE(points, degree);
      const L1Basin basin = l1_basin(points, degree);
      const RegressionWindow window = l1_window({{points}, degree, {}});
      for (const auto round : rounds(20)) {
        const double delta = std::pow(10.0, static_cast<double>(random.integer(-8, 4)));
        const int fits = static_cast<int>(random.integer(1, 9));
        const double largest = basin.radius.convert_to<double>() * std::sqrt(delta);
        std::vector<double> f(static_cast<std::size_t>(points) + 3);
        for (double& value : f)
          value = round % 2 == 0 ? static_cast<double>(random.integer(-1000, 1000))
                                 : static_cast<double>(random.integer(-1, 1));
        const double found = largest_difference(f, degree + 1);
        if (found == 0) continue;
        for (double& value : f) value *= largest / found;
        const std::vector<double> refined = step(L1Fitter(window, {delta, fits, 0, false}), f);
        const std::vector<double> linear = step(L1Fitter(window, {delta, 0, 0, false}), f);
        CHECK(largest_difference(refined, degree + 1) <= basin.contraction.convert_to<double>() * largest);
        CHECK(largest_difference(linear, degree + 1) <= basin.linear.convert_to<double>() * largest * (1 + 1e-9));
        double apart = 0;
        for (std::size_t i = 0; i < linear.size(); ++i) apart = std::max(apart, std::abs(linear[i] - refined[i]));
        CHECK(apart <= basin.error.convert_to<double>() * largest * largest * largest / delta);
      }
    }
}
