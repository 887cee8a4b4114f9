#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/test/specimens.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/papers/dyn-2015/checks.hpp>
#include <subcert/proofs-checks/papers/dyn-2015/numerical_recipe.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::statements::dyn_2015;
using subcert::testing::mask_of;

TEST_CASE("the whole sum over limit values is the exact variance grid") {
  const Mask mask = mask_of("primal:n=3,d=3");
  for (int level : {5, 7}) {
    const VarianceGrid grid = variance_grid(mask, level, false);
    const RecipeValues one = evaluate_numerical_recipe({{false, level, std::nullopt}, false}, mask, 3);
    CHECK(one.maximum == grid.largest());
    CHECK(one.slope == grid.steepest());
    // Points two steps apart: at most the mean of two neighbouring differences.
    CHECK(evaluate_numerical_recipe({{false, level, std::nullopt}, true}, mask, 3).slope <= one.slope);
  }
}

TEST_CASE("a window leaves terms out, by the definition") {
  const int n = 3, level = 5;
  const Mask mask = mask_of("primal:n=3");
  const LimitValues phi = limit_values(mask, level);
  Rational largest = 0, steepest = 0, before;
  for (long i = 0; i <= 32; ++i) {
    Rational sum = 0;
    for (long j = -n; j <= n + 1; ++j) sum += phi.at(i - 32 * j) * phi.at(i - 32 * j);
    largest = std::max(largest, sum);
    if (i > 0) steepest = std::max(steepest, Rational(abs(sum - before) * 32));
    before = sum;
  }
  const RecipeValues values = evaluate_numerical_recipe({{false, level, SampledVariance::Window{0, true}}, false}, mask,
                                                        n);
  CHECK(values.maximum == largest);
  CHECK(values.slope == steepest);
}

TEST_CASE("refined pulses of an interpolatory scheme are its limit values") {
  const Mask mask = mask_of("primal:n=2,d=3");
  const RecipeValues limit = evaluate_numerical_recipe({{false, 6, std::nullopt}, false}, mask, 2);
  const RecipeValues pulse = evaluate_numerical_recipe({{true, 6, std::nullopt}, false}, mask, 2);
  CHECK(limit.maximum == pulse.maximum);
  CHECK(limit.slope == pulse.slope);
}

TEST_CASE("all recipes at once are each of them alone") {
  const Mask mask = mask_of("primal:n=2");
  const auto& list = numerical_recipes();
  const auto values = evaluate_numerical_recipes(mask, 2);
  CHECK(list.size() == 264);
  REQUIRE(values.size() == list.size());
  for (std::size_t s = 0; s < list.size(); s += 13) {
    CAPTURE(list[s].text());
    const RecipeValues alone = evaluate_numerical_recipe(list[s], mask, 2);
    CHECK(values[s].maximum == alone.maximum);
    CHECK(values[s].slope == alone.slope);
  }
}

TEST_CASE("printed digits: rounded or cut, nothing else") {
  CHECK(gives_digits(Rational(84973, 1000000), "0.0850"));
  CHECK(gives_digits(Rational(84973, 1000000), "0.0849"));
  CHECK_FALSE(gives_digits(Rational(84973, 1000000), "0.0851"));
  CHECK_FALSE(gives_digits(Rational(84873, 1000000), "0.0850"));
  CHECK(gives_digits(2, "2"));
}

TEST_CASE("one recipe gives the digits of Table 3") {
  const statements::PublishedTable& table = statements::paper("dyn-2015").table("table3");
  NumericalRecipeSearch::Values values;
  for (const statements::PublishedCell& cell : table.cells)
    if (values[cell.scheme].empty()) values[cell.scheme] = evaluate_numerical_recipes(mask_of(cell.scheme), *cell.n);
  const NumericalRecipeSearch search(table, values);
  const NumericalRecipe& best = numerical_recipes()[search.best()];
  CHECK(search.cells_given() == 42);
  REQUIRE(best.curve.window);
  CHECK(best.curve.refined_pulse);
  CHECK(best.curve.level == 9);
  CHECK(best.curve.window->beyond == 0);
  CHECK(best.curve.window->one_more);
  CHECK(best.two_steps);
  for (const statements::PublishedCell& cell : table.cells) {
    CAPTURE(cell.row, cell.column);
    CHECK(search.gives(cell, search.best()) == (cell.row != "d=1, n=1" || !scaled_maximum(cell).slope));
  }
  for (std::size_t other = 0; other < numerical_recipes().size(); ++other) {
    if (other == search.best()) continue;
    CAPTURE(numerical_recipes()[other].text());
    const auto& cells = table.cells;
    CHECK(std::count_if(cells.begin(), cells.end(), [&](const auto& cell) { return search.gives(cell, other); }) <= 40);
  }
}
