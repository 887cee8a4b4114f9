#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1/basin_entry.hpp>
#include <subcert/schemes/data/l1/l1_basin.hpp>
#include <subcert/schemes/data/l1/l1_refinement.hpp>
#include <subcert/schemes/data/l1/l1_regression.hpp>
#include <subcert/schemes/data/l1/reweighted_contraction.hpp>
#include <subcert/schemes/data/l1/window_range.hpp>

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
  struct Known {
    int points;
    Rational linear, contraction, residual, radius, error;
  };
  for (const Known& known : std::vector<Known>{{4, {3, 10}, {13, 20}, {41, 64}, {837, 1000}, {123, 1000}},
                                               {5, {7, 20}, {27, 40}, {73, 64}, {366, 1000}, {606, 1000}},
                                               {6, {57, 140}, {197, 280}, {115, 64}, {185, 1000}, {216, 100}},
                                               {7, {13, 28}, {41, 56}, {335, 128}, {102, 1000}, {621, 100}},
                                               {8, {11, 21}, {16, 21}, {231, 64}, {62, 1000}, {155, 10}}}) {
    CAPTURE(known.points);
    const L1Basin basin = l1_basin(known.points, 1).value();
    CHECK(basin.linear == known.linear);
    CHECK(basin.contraction == known.contraction);
    CHECK(basin.residual == known.residual);
    CHECK(basin.radius == known.radius);
    CHECK(basin.error <= known.error);
    CHECK(basin.error > known.error * Rational(99, 100));
  }
  CHECK_THROWS_AS(l1_basin(2, 1), Error);
  CHECK_THROWS_AS(l1_basin(19, 1), Error);
  CHECK_THROWS_AS(l1_basin(6, 4), Error);
  CHECK_FALSE(l1_basin(6, 0));  // means of 6 data
}

TEST_CASE("basin of least squares: random data at its edge contract, and are refined nearly as by least squares") {
  Random random;
  const std::vector<std::pair<int, int>> rules{{3, 1}, {4, 1}, {6, 1}, {7, 1}, {8, 1}, {4, 2}, {6, 3}, {7, 3}};
  for (const auto& [points, degree] : rules) {
    CAPTURE(points, degree);
    const int arity = 2 + (points + degree) % 3;
    const L1Basin basin = l1_basin(points, degree, arity).value();
    const RegressionWindow window = l1_window({{points}, degree, {}, arity});
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

// Doubles see the level, too, where it is not within rounding of the bound.
TEST_CASE("basin of least squares: data enter it at the level at which refinement in doubles does") {
  Random random;
  for (const auto round : rounds(12)) {
    const int points = 4 + static_cast<int>(round % 5);
    const double delta = std::pow(10.0, static_cast<double>(random.integer(-6, 2)));
    const L1Scheme scheme{
        {points}, 1, {.delta = delta, .iterations = static_cast<int>(random.integer(1, 8))}, 2 + points % 2};
    std::vector<Rational> data;
    for (int j = 0; j < 3; ++j) data.emplace_back(random.integer(-9, 9));
    CAPTURE(points, delta, scheme.options.iterations, data[0], data[1], data[2]);
    std::vector<double> f(300, 0);
    for (std::size_t j = 0; j < 3; ++j) f[150 + j] = data[j].convert_to<double>();
    const L1Fitter fitter(l1_window(scheme), scheme.options);
    const double bound = l1_basin(points, 1, scheme.arity)->radius.convert_to<double>() * std::sqrt(delta);
    const std::optional<int> level = basin_entry(scheme, data, 6);
    for (int k = 0; k <= level.value_or(6); ++k) {
      if (k > 0) f = step(fitter, f);
      const double largest = largest_difference(f, 2);
      CHECK(((level && k == *level) ? largest <= bound * (1 + 1e-6) : largest >= bound * (1 - 1e-6)));
    }
  }
  const L1Scheme six{{6}, 1, {.delta = 1e-8, .iterations = 6}};
  CHECK(basin_entry(six, {1}, 7) == 7);
  CHECK_FALSE(basin_entry(six, {1}, 6));
  CHECK_FALSE(basin_entry(six, {1}, 7, Deadline::in(0)));
  CHECK(basin_entry(six, {}, 0) == 0);
  CHECK(basin_entry(six, {Rational(1, 200000)}, 0) == 0);
  CHECK_FALSE(basin_entry({{6}, 0, {}}, {1}, 2));  // means do not contract
  CHECK_THROWS_AS(basin_entry({{6, 6}, 1, {}}, {1}, 2), Error);
  CHECK_THROWS_AS(basin_entry({{6}, 1, {.exact = true}}, {1}, 2), Error);
  CHECK_THROWS_AS(basin_entry({{6}, 1, {.tolerance = 1}}, {1}, 2), Error);
  CHECK_THROWS_AS(basin_entry({{6}, 1, {.iterations = 101}}, {1}, 2), Error);
  CHECK_THROWS_AS(basin_entry(six, {1}, 17), Error);
}

TEST_CASE("reweighted fits: second differences of all data shrink, as docs/l1.md says") {
  struct Known {
    int points, fits;
    double boxes;  // all of them, roughly: fewer would leave some out
  };
  for (const Known& of : std::vector<Known>{
           {3, 6, 10}, {4, 0, 80}, {4, 7, 1000}, {4, 10, 2796}, {5, 2, 2592}, {5, 7, 10412}, {6, 1, 49200}}) {
    CAPTURE(of.points, of.fits);
    const auto found = reweighted_contraction(of.points, of.fits, {.bound = Rational(19, 20)});
    REQUIRE(found);
    CHECK(found->fits == of.fits);
    CHECK(found->bound == Rational(19, 20));
    CHECK(static_cast<double>(found->boxes) > 0.95 * of.boxes);
  }
  // Bounds that some data exceed, with the quotients 1.02 and 0.82: see below.
  CHECK_FALSE(reweighted_contraction(7, 5, {.bound = Rational(99, 100), .most_boxes = 300}));
  CHECK_FALSE(reweighted_contraction(8, 2, {.bound = Rational(4, 5), .most_boxes = 300}));
  CHECK_FALSE(reweighted_contraction(4, 6, {.bound = Rational(16, 25)}));  // the boxes do, near to least squares 13/20
  CHECK_FALSE(reweighted_contraction(4, 6, {.deadline = Deadline::in(0)}));
  CHECK_FALSE(reweighted_contraction(7, 6, {.most_boxes = 1000}));
  CHECK_THROWS_AS(reweighted_contraction(2, 6), Error);
  CHECK_THROWS_AS(reweighted_contraction(9, 6), Error);
  CHECK_THROWS_AS(reweighted_contraction(4, 41), Error);
  CHECK_THROWS_AS(reweighted_contraction(4, 6, {.bound = 1}), Error);
}

TEST_CASE("reweighted fits: the largest case of docs/l1.md, the rule of the papers", "[long]") {
  const auto found = reweighted_contraction(6, 6, {.bound = Rational(19, 20), .most_boxes = 4'000'000});
  REQUIRE(found);
  CHECK(static_cast<double>(found->boxes) > 0.95 * 2'559'050);
}

TEST_CASE("reweighted fits: the range of second differences contains those of data and delta of a box") {
  Random random;
  const auto inside = [&](const Ends& of) {
    return of.lower + (of.upper - of.lower) * static_cast<double>(random.integer(0, 4)) / 4;
  };
  for (const auto round : rounds(400)) {
    const int points = 3 + static_cast<int>(round % 4), fits = static_cast<int>(random.integer(0, 5));
    const double width = std::pow(2.0, static_cast<double>(random.integer(-20, 0)));
    DifferenceBox box;
    for (int j = 0; j + 1 < points; ++j) {
      const double at = static_cast<double>(random.integer(-2, 2)) / 2;
      box.differences.push_back({std::max(-1.0, at - width), std::min(1.0, at + width)});
    }
    const double root = round % 3 == 0 ? 0 : std::pow(2.0, static_cast<double>(random.integer(-30, 2)));
    box.root = {root, root + width};
    const auto range = second_differences(points, fits, box);
    for (int draw = 0; draw < 4; ++draw) {
      std::vector<double> f{0, 0}, next;
      for (const Ends& one : box.differences) f.push_back(2 * f.back() - f[f.size() - 2] + inside(one));
      const double delta = std::pow(std::max(inside(box.root), 1e-12), 2);
      for (std::size_t i = 0; i < 2; ++i) {
        const L1Fitter fitter(l1_window({{points}, 1, {}}),
                              {delta, static_cast<int>(random.integer(0, fits)), 0, false});
        const auto begin = f.begin() + static_cast<long>(i);
        for (const double value : fitter.fit(std::vector<double>(begin, begin + points))) next.push_back(value);
      }
      CAPTURE(points, fits, width, root, f, delta);
      for (std::size_t k = 0; k < 2; ++k) {
        const double second = next[k] - 2 * next[k + 1] + next[k + 2];
        CHECK(second >= range[k].lower - 1e-6);
        CHECK(second <= range[k].upper + 1e-6);
      }
    }
  }
  // The data 2, -3, 0, 1, 0, 0 have least squares 0, so that the next line goes through the other three for delta = 0.
  DifferenceBox three;
  for (const double d : {1.0, -0.25, -0.25, 0.125, 0.0})
    three.differences.push_back({std::max(-1.0, d - 1e-9), std::min(1.0, d + 1e-9)});
  for (const Ends& one : second_differences(6, 1, three)) CHECK(one.upper - one.lower < 0.2);
  CHECK_THROWS_AS(second_differences(4, 1, {{{0, 0}, {0, 0}}, {0, 1}}), Error);
  CHECK_THROWS_AS(second_differences(4, 1, {{{0, 0}, {0, 0}, {0, 2}}, {0, 1}}), Error);
  CHECK_THROWS_AS(second_differences(4, 1, {{{0, 0}, {0, 0}, {0, 1}}, {-1, 1}}), Error);
  CHECK_THROWS_AS(second_differences(9, 1, {std::vector<Ends>(8, {0, 0}), {0, 1}}), Error);
}

TEST_CASE("reweighted fits: what a window gives does not depend on the difference that the other one has for itself") {
  for (int points = 3; points <= 8; ++points)
    for (std::size_t which = 0; which < 2; ++which) {
      DifferenceBox box{std::vector<Ends>(static_cast<std::size_t>(points) - 1, {0.25, 0.5}), {0.1, 0.2}};
      Ends& other = which == 0 ? box.differences.back() : box.differences.front();
      const auto window = window_range(points, which);
      const WindowRange::Parts parts = window->parts(box, 2);
      other = {-8, 8};
      for (std::size_t k = 0; k < 2; ++k) {
        CHECK(window->parts(box, 2)[k].lower == parts[k].lower);
        CHECK(window->parts(box, 2)[k].upper == parts[k].upper);
        CHECK(parts[k].lower < parts[k].upper);
      }
    }
}

TEST_CASE("reweighted fits: data whose second differences do not shrink, or not much") {
  struct Known {
    int points, fits;
    std::vector<double> differences;
    double quotient;
  };
  for (const Known& of : std::vector<Known>{{7, 5, {-0.0247, 1, 1, 0.8259, -1, -1}, 1.02},
                                            {8, 2, {0.8897, 1, 1, 1, -0.9941, -0.8835, 0.7394}, 0.82}}) {
    CAPTURE(of.points);
    std::vector<double> f{0, 0};
    for (const double d : of.differences) f.push_back(2 * f.back() - f[f.size() - 2] + d);
    CHECK(largest_difference(step(L1Fitter(l1_window({{of.points}, 1, {}}), {1e-10, of.fits, 0, false}), f), 2) >
          of.quotient);
  }
}

TEST_CASE("reweighted fits: random data do not exceed the bound, nor windows with their own numbers of fits") {
  Random random;
  for (const auto round : rounds(200)) {
    const int points = 3 + static_cast<int>(round % 4);
    const RegressionWindow window = l1_window({{points}, 1, {}});
    const double delta = std::pow(10.0, static_cast<double>(random.integer(-12, 3)));
    std::vector<double> f(static_cast<std::size_t>(points) + 1), next;
    for (double& value : f) value = static_cast<double>(round % 2 == 0 ? random.integer(-9, 9) : random.integer(-1, 1));
    for (std::size_t i = 0; i < 2; ++i) {
      const int fits = static_cast<int>(random.integer(0, 6));
      const L1Fitter fitter(window, {delta, fits, 0, false});
      const auto begin = f.begin() + static_cast<long>(i);
      for (const double value : fitter.fit(std::vector<double>(begin, begin + points))) next.push_back(value);
    }
    CHECK(largest_difference(next, 2) <= 0.95 * largest_difference(f, 2) + 1e-12);
  }
}
