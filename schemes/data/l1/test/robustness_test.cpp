#include <cmath>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/data/l1/least_absolute_fit.hpp>
#include <subcert/schemes/data/l1/robustness.hpp>
#include <subcert/schemes/l1_scheme.hpp>
#include <subcert/schemes/outlier_remainder.hpp>

#include <random>

using namespace subcert;
using data::least_absolute_robustness;
using data::LeastAbsoluteRobustness;

namespace {

using Bounds = std::vector<std::optional<Rational>>;
using PlacePairs = std::vector<std::pair<int, int>>;

Rational middle_of(const Enclosure& enclosure) { return (*enclosure.lower + *enclosure.upper) / 2; }

}  // namespace

TEST_CASE("what one and two outliers do to lines: known values") {
  const Rational half(1, 2);
  const LeastAbsoluteRobustness five = least_absolute_robustness(5, 1), six = least_absolute_robustness(6, 1);
  const LeastAbsoluteRobustness seven = least_absolute_robustness(7, 1), eight = least_absolute_robustness(8, 1);
  const LeastAbsoluteRobustness ten = least_absolute_robustness(10, 1);
  CHECK(five.one == Bounds{7 * half, Rational(5, 4), 1, Rational(5, 4), 7 * half});
  CHECK(six.one == Bounds{Rational(7, 4), 1, 1, 1, 1, Rational(7, 4)});
  CHECK(six.two_break == PlacePairs{{0, 1}, {0, 2}, {0, 5}, {3, 5}, {4, 5}});
  CHECK(six.two == 9 * half);
  CHECK(seven.one == Bounds{Rational(7, 6), Rational(7, 6), 1, 1, 1, Rational(7, 6), Rational(7, 6)});
  CHECK(seven.two_break == PlacePairs{{0, 1}, {0, 2}, {0, 6}, {4, 6}, {5, 6}});
  // At the ends of 7 the line M x / 3 is as good as 0.
  const data::LeastAbsoluteFitter ends(7, 1, {Rational(13, 4)});
  CHECK(abs(ends.fit({-1200, 0, 0, 0, 0, 0, 1200}).values[0]) == 50);
  CHECK(eight.one == Bounds(8, Rational(1)));
  CHECK(eight.two_break == PlacePairs{{0, 1}, {6, 7}});
  CHECK(ten.two_break.empty());
  CHECK(ten.two == Rational(13, 6));
  CHECK(six.sharpness == Rational(4, 11));
  CHECK(ten.sharpness == Rational(4, 19));
  CHECK_FALSE(seven.sharpness);
  CHECK_FALSE(least_absolute_robustness(4, 1).one[0]);
  CHECK(least_absolute_robustness(6, 1, 3).one == Bounds{Rational(11, 6), 1, 1, 1, 1, Rational(11, 6)});
  CHECK(least_absolute_robustness(6, 1, 3).sharpness == Rational(6, 17));
  CHECK(*outlier_remainder(6, 1, 6, 3)->lower >
        *outlier_remainder(6, 1, 6)->upper);  // its outputs are nearer to the ends
  CHECK_THROWS_AS(least_absolute_robustness(6, 1, 1), Error);
  CHECK_THROWS_AS(outlier_remainder(6, 1, 1, 1), Error);
  CHECK_THROWS_AS(least_absolute_robustness(13, 1), Error);
  CHECK_THROWS_AS(least_absolute_robustness(3, 2), Error);
}

TEST_CASE("no data with an outlier exceed the bounds, and large outliers break down where it is said") {
  std::mt19937 engine(Catch::rngSeed());
  for (int degree = 0; degree <= 3; ++degree)
    for (int points = degree + 2; points <= 8; ++points) {
      const int arity = 2 + (points + degree) % 3;
      const LeastAbsoluteRobustness known = least_absolute_robustness(points, degree, arity);
      std::vector<Rational> places;
      for (int phase = 0; phase < arity; ++phase)
        places.push_back(Rational(points - 1, 2) + output_place(arity, phase));
      const data::LeastAbsoluteFitter fitter(points, degree, places);
      for (int trial = 0; trial < 200; ++trial) {
        std::vector<Rational> data;
        for (int i = 0; i < points; ++i) data.emplace_back(std::uniform_int_distribution<int>(-4, 4)(engine), 4);
        const auto place = std::uniform_int_distribution<std::size_t>(0, data.size() - 1)(engine);
        data[place] = std::uniform_int_distribution<int>(-100, 100)(engine);
        const auto fit = fitter.fit(data);
        CAPTURE(degree, points, place, data);
        if (known.one[place])
          for (const Rational& value : fit.values) CHECK(abs(value) <= *known.one[place]);
      }
    }
}

TEST_CASE("what fits leave of an outlier: the table, its factor, and the fits for a part in a million") {
  // The table has so many digits; its numbers are known to half a unit of the last, or a little more.
  const auto close = [](int points, int m, double value, double unit) {
    const auto left = outlier_remainder(points, 1, m);
    REQUIRE(left);
    CHECK(*left->upper - *left->lower < Rational(1, 1'000'000'000));
    CHECK(std::abs(static_cast<double>(middle_of(*left)) - value) <= 0.51 * unit);
  };
  close(6, 0, 0.202, 1e-3);
  close(6, 6, 0.0156, 1e-4);
  close(6, 20, 6.4e-6, 1e-7);
  close(7, 1, 0.104, 1e-3);
  close(7, 6, 0.0028, 1e-4);
  close(8, 6, 8.1e-4, 1e-5);
  CHECK(outlier_factor(6, 1) == Rational(4, 7));
  for (int m = 0; m <= 12; ++m)  // with the constant of the proof
    CHECK(*outlier_remainder(6, 1, m)->upper <= 2 * power(Rational(4, 7), m));
  CHECK(outlier_factor(7, 1) == Rational(5, 11));
  CHECK(outlier_factor(8, 1) == Rational(5, 13));
  CHECK(iterations_for_remainder(6, 1, Rational(1, 1'000'000)) == 24);
  CHECK_FALSE(iterations_for_remainder(4, 1, Rational(1, 100)));
  for (int points = 3; points <= 12; ++points)
    for (int degree = 0; degree + 2 <= points && degree <= 3; ++degree) {
      const auto one = least_absolute_robustness(points, degree).one;
      CHECK((outlier_factor(points, degree) < 1) ==
            std::all_of(one.begin(), one.end(), [](const auto& value) { return value.has_value(); }));
    }
  CHECK_THROWS_AS(outlier_remainder(6, 5, 1), Error);
  CHECK_THROWS_AS(outlier_factor(2, 1), Error);
}
