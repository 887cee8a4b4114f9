#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/theorems/every_pair.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using namespace subcert::theorems;

namespace {

Mask least_squares(int n, int degree) {
  return make_scheme("primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree)).mask.curve();
}

}  // namespace

TEST_CASE("the central weight is that of the masks") {
  for (int n = 1; n <= 7; ++n)
    for (int degree = 1; degree < 2 * n; degree += 2) {
      const Mask mask = least_squares(n, degree);
      CHECK(mask.symbol().coefficient(0) == central_weight(degree, 2 * n - 1));
      Rational squares = 0;
      for (int x = 1 - 2 * n; x < 2 * n; x += 2) squares += power(mask.symbol().coefficient(x), 2);
      CHECK(squares == central_weight(degree, 2 * n));
    }
}

TEST_CASE("exact values lie between the bounds by the responses of the two rules") {
  for (int n = 1; n <= 7; ++n)
    for (int degree = 1; degree < 2 * n; degree += 2) {
      CAPTURE(n, degree);
      const Rational ceiling = curve_ceiling(n, degree), mean = squared_l2_norm(least_squares(n, degree));
      const VarianceGrid grid = variance_grid(least_squares(n, degree), 4, false);
      CHECK(grid.largest() <= ceiling);
      CHECK(2 * mean - ceiling <= grid.smallest());
      CHECK(2 * mean <= central_weight(degree, 2 * n - 1) + central_weight(degree, 2 * n));
    }
}

TEST_CASE("exact means lie within the bounds for large n") {
  for (const auto& [degree, n] : {std::pair{5, 50}, {13, 50}}) {
    CAPTURE(n, degree);
    const LargeBounds bounds = large_bounds(degree, n);
    const Rational both = (central_weight(degree, 2 * n - 1) + central_weight(degree, 2 * n)) / 2;
    const Rational lack = both - squared_l2_norm(least_squares(n, degree));
    CHECK(lack > 0);
    CHECK(lack < *bounds.deficit.enclosure().lower);
    CHECK(*bounds.ripple.enclosure().lower > 0);
    CHECK(*bounds.ripple.enclosure().upper < *bounds.deficit.enclosure().lower);
  }
}
