#include "../reweighting.hpp"

#include <subcert/cmake/catch.hpp>

using namespace subcert;
using namespace subcert::statements;

namespace {

const std::vector<Variable> taus{{"tau1", 1}, {"tau2", 1}, {"tau3", 1000}};

}  // namespace

TEST_CASE("weighted fits of windows solve their normal equations") {
  WeightedWindow data = random_window(-1, 2, 1, 7);
  CHECK(data.nodes.size() == 4);
  CHECK(random_window(-1, 2, 1, 7).weights == data.weights);
  for (std::size_t i = 0; i < 4; ++i) data.data[i] = 3 - 2 * data.nodes[i].first;
  CHECK(weighted_coefficients(data, {f("1"), f("r")}) == std::vector<Rational>{3, -2});
  CHECK_THROWS_AS(weighted_coefficients(data, {f("r"), f("2*r")}), Undefined);
  CHECK(sum_over(window(-1, 2, 2), f("r*s"), 0, 1) == 1);
  CHECK(sum_over(window(-1, 2, 1), f("w"), 1, 2) == 2);
}

TEST_CASE("moments characterise a weighted line for all weights") {
  const Formula slope = f("(r*tau1 - tau2)/(tau1*tau3 - tau2^2)");
  CHECK_FALSE(weighted_moments(slope, 1, {f("0"), f("1")}, taus).failed());
  CHECK(weighted_moments(slope, 1, {f("1"), f("0")}, taus).failed());
  CHECK(weighted_moments(f("r^2/tau1"), 1, {f("0"), f("1")}, taus).failed());
  CHECK_FALSE(is_weighted_datum(f("r*w*f"), {{"r", 1}}).failed());
  CHECK(is_weighted_datum(f("r*w*f + 1"), {{"r", 1}}).failed());
}

TEST_CASE("closed forms of fits on grids are proved and refuted") {
  const auto plane = [](const char* weight) {
    return grid_fit({f(weight), {-1, 0}, {1, 0}, f("x"), f("y"), 1, 1, {{"x", 0}, {"y", 0}}}, 2);
  };
  CHECK_FALSE(plane("1/(2*n + 1)^2*(1 + 3*(x*r + y*s)/(n*(n + 1)))").failed());
  CHECK(plane("1/(2*n + 1)^2*(1 + 3*(x*r + y*s)/(n*(n + 2)))").failed());
  CHECK(plane("1/(2*n + 1)^2*(1 + 3*(x*r - y*s)/(n*(n + 1)))").failed());
  // Wrong from n = 4 on, beyond what is compared.
  CHECK(plane("1/(2*n + 1)^2*(1 + (n - 1)*(n - 2)*(n - 3) + 3*(x*r + y*s)/(n*(n + 1)))").failed());
}

TEST_CASE("the index of a datum moves with its rule") {
  CHECK_FALSE(moving_index(f("i + r"), "i", "r").failed());
  for (const char* wrong : {"r", "i", "i - r", "2*i + r", "i + r + 1"}) {
    CAPTURE(wrong);
    CHECK(moving_index(f(wrong), "i", "r").failed());
  }
  CHECK(moving_index(f("r"), "i", "r").failure() == "i = 1, r = 0, the datum used: printed 0, derived 1");
}
