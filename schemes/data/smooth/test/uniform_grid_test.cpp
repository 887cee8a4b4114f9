#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>
#include <subcert/schemes/data/smooth/uniform_grid.hpp>

#include <cmath>

using namespace subcert;
using namespace subcert::data;
using subcert::testing::Random;

TEST_CASE("positions on a grid are the nearest doubles of the exact ones") {
  Random random;
  for (int run = 0; run < 40; ++run) {
    const Rational origin = random.rational(), spacing = abs(random.rational()) + Rational(1, 1000);
    const std::size_t scale = 1U << (run % 5);
    const GridPositions grid(origin, spacing, scale);
    for (std::size_t o = 0; o < 300; ++o)
      CHECK(grid.at(o) == nearest_double(Rational(origin + spacing * Rational(o) / Rational(scale))));
  }
  // Cancellation, and a position half way between two doubles.
  const GridPositions through_zero(Rational(-1, 10), Rational(1, 30), 1);
  CHECK(through_zero.at(3) == 0);
  const GridPositions between(Rational(1), power(Rational(2), -53), 1);
  CHECK(between.at(1) == nearest_double(Rational(1) + power(Rational(2), -53)));
}

TEST_CASE("a grid is judged as by exact arithmetic") {
  std::vector<double> rounded, broken;
  for (int i = 0; i < 1000; ++i) rounded.push_back(std::round(100.0 * i / 3) / 100);
  const UniformGrid grid = uniform_grid(rounded);
  CHECK(grid.uniform);
  CHECK(grid.origin == 0);
  CHECK(grid.spacing == Rational(333) / 999);
  broken = rounded;
  broken[500] += 0.02;
  const UniformGrid other = uniform_grid(broken);
  CHECK_FALSE(other.uniform);
  CHECK(other.worst == 499);
  // Each at the edge of what is allowed: one unit of the last place.
  CHECK(uniform_grid({0, 1.01, 2, 3}).uniform);
  CHECK_FALSE(uniform_grid({0, 1.0101, 2.02, 3}).uniform);
  CHECK(decimal_value(0.1) == Rational(1, 10));
  CHECK(decimal_value(-2.5e-7) == Rational(-25, 100000000));
  CHECK(uniform_grid({1e-300, 2e-300, 3e-300}).uniform);
  CHECK(uniform_grid({0, 5e-324, 1e-323}).uniform);
}

TEST_CASE("grids that are not uniform: the farthest spacing is that of exact arithmetic, the first of several") {
  Random random;
  for (int run = 0; run < 200; ++run) {
    // Spacings that are equal but for rounding, and some that are not.
    const double unit = std::pow(10.0, run % 7 - 3), start = static_cast<double>(random.integer(-99, 99)) * unit;
    std::vector<double> x{start};
    for (int i = 1; i < 60; ++i)
      x.push_back(start + unit * static_cast<double>(i) + (i > 20 ? unit / 2 : 0) + (i > 40 ? unit / 2 : 0));
    if (run % 2 == 1) x[static_cast<std::size_t>(random.integer(1, 58))] += unit / 4;
    const Rational mean = (decimal_value(x.back()) - decimal_value(x.front())) / 59;
    std::size_t worst = 0;
    for (std::size_t i = 1; i + 1 < x.size(); ++i)
      if (abs(decimal_value(x[i + 1]) - decimal_value(x[i]) - mean) >
          abs(decimal_value(x[worst + 1]) - decimal_value(x[worst]) - mean))
        worst = i;
    const UniformGrid grid = uniform_grid(x);
    CHECK_FALSE(grid.uniform);
    CHECK(grid.worst == worst);
  }
}

TEST_CASE("the spacing of a grid with gaps") {
  const auto common = [](const std::vector<double>& x) { return common_spacing(x).value_or(0); };
  CHECK(common({0, 1, 2, 5, 6, 7}) == 1);
  CHECK(common({0.1, 0.2, 0.3, 0.6, 0.7}) == Rational(1, 10));
  CHECK(common({-0.3, -0.2, 0.1, 0.4, 0.5}) == Rational(1, 10));  // two and two: half of them
  CHECK(common({0, 1, 3, 6, 10}) == 0);
  CHECK(common({0, 1, 2, 3, 1000}) == 0);  // mostly gap
  CHECK(common({0, 1, 2, 3, 10}) == 1);
  CHECK(common({0, 1, 2, 3, 10.5}) == 0);
  CHECK(common({4}) == 0);
  CHECK(common({1e9, 1e9 + 0.25, 1e9 + 0.5, 1e9 + 1}) == Rational(1, 4));
  Samples samples;
  samples.put_at({0, 1, 2, 2, 5, 6});
  CHECK(samples.spacing == 1);
  samples.put_at({0, 1, 3, 6, 10});
  CHECK(samples.spacing == Rational(5, 2));
}
