#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/theorems/conjectures.hpp>
#include <subcert/proofs-checks/theorems/degree_one.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using namespace subcert::theorems;

TEST_CASE("every inequality of the degree-1 theorems holds") {
  for (const auto& checks : {conjecture_7_degree_one(), conjecture_8_in_n_degree_one()}) {
    for (const Check& check : checks) {
      CAPTURE(check.id, check.claim, check.decision.reason);
      CHECK(check.decision.is_yes());
    }
    CHECK(verdict(checks).is_yes());
  }
}

TEST_CASE("the theorems agree with exact values on a grid") {
  const Rational c = *limit_constant(1, 30).lower;
  VarianceGrid before;
  for (int n = 1; n <= 12; ++n) {
    const VarianceGrid grid = variance_grid(make_scheme("primal:n=" + std::to_string(n)).mask, 4, n > 1);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      const Rational deviation = grid.values[i] * Rational(4 * n - 1, 4) / c - 1;
      CHECK(deviation < Rational(2, n * n));
      CHECK(-deviation < Rational(2, n * n));
      if (n > 1) CHECK(grid.values[i] < before.values[i]);
    }
    before = grid;
  }
}

TEST_CASE("a verdict is only as good as its weakest check") {
  const Check yes{"1", "", {Truth::yes, ""}}, no{"2", "", {Truth::no, ""}}, unknown{"3", "", {Truth::unknown, ""}};
  CHECK(verdict({yes, yes}).is_yes());
  CHECK(verdict({yes, unknown, no}).is_no());
  CHECK(verdict({yes, unknown}).truth == Truth::unknown);
}
