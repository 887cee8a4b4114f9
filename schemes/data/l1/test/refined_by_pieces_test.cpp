#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/data/l1/least_absolute_fit.hpp>
#include <subcert/schemes/data/l1/least_absolute_limit.hpp>
#include <subcert/schemes/l1_scheme.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::data;
using namespace subcert::piecewise;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// One step of the fits of least absolute deviations by another code than that of the pieces.
std::vector<Rational> refined_by_fits(int points, int degree, int arity, const std::vector<Rational>& f) {
  std::vector<Rational> places;
  for (int phase = 0; phase < arity; ++phase) places.push_back(Rational(points - 1, 2) + output_place(arity, phase));
  const LeastAbsoluteFitter fitter(points, degree, places);
  std::vector<Rational> next;
  for (auto window = f.begin(); window + points <= f.end(); ++window)
    for (const Rational& value : fitter.fit(std::vector<Rational>(window, window + points)).values)
      next.push_back(value);
  return next;
}

std::vector<Rational> differences(std::vector<Rational> f, int order) {
  for (; order > 0; --order) {
    for (std::size_t i = 0; i + 1 < f.size(); ++i) f[i] = f[i + 1] - f[i];
    f.pop_back();
  }
  return f;
}

Rational largest(const std::vector<Rational>& values) {
  Rational result = 0;
  for (const Rational& value : values) result = std::max(result, Rational(abs(value)));
  return result;
}

bool has_negative(const std::vector<Rational>& values) {
  return std::any_of(values.begin(), values.end(), [](const Rational& value) { return value < 0; });
}

}  // namespace

TEST_CASE("least absolute deviations: rules of other arities, as docs/l1.md says") {
  struct Known {
    int points, degree, arity, steps, order;
    Rational bound;
  };
  for (const Known& of : std::vector<Known>{{2, 1, 3, 1, 2, Rational(1, 6)},
                                            {3, 1, 3, 1, 2, Rational(1, 2)},
                                            {4, 1, 3, 2, 2, Rational(49, 72)},
                                            {5, 1, 3, 2, 2, Rational(5, 12)},
                                            {6, 1, 3, 1, 1, Rational(2, 3)},
                                            {6, 1, 4, 1, 1, Rational(7, 10)},
                                            {6, 1, 5, 1, 2, Rational(7, 10)},
                                            {5, 2, 3, 1, 2, Rational(11, 12)},
                                            {6, 3, 3, 1, 4, Rational(1427, 2592)}}) {
    CAPTURE(of.points, of.degree, of.arity);
    const auto limit = least_absolute_limit(of.points, of.degree, {}, of.arity);
    CHECK(limit.converges.is_yes());
    REQUIRE(limit.contraction);
    CHECK(limit.contraction->steps == of.steps);
    CHECK(limit.contraction->order == of.order);
    CHECK(limit.contraction->bound == of.bound);
    CHECK_FALSE(limit.edge);
    // Data of a function that attain the bound do so when they are refined.
    if (limit.contraction->data.empty() || !limit.unique.is_yes()) continue;
    std::vector<Rational> f = limit.contraction->data;
    CHECK(largest(differences(f, of.order)) <= 1);
    for (int step = 0; step < of.steps; ++step) f = refined_by_fits(of.points, of.degree, of.arity, f);
    CHECK(largest(differences(f, of.order)) == of.bound);
  }
  CHECK(least_absolute_limit(5, 3, {}, 3).mask->symbol().to_mask_text() ==
        "[-20,-27,-28,70,108,140,0,0,0,140,108,70,-28,-27,-20]/162@-6");
  CHECK(most_steps(2) == 8);
  CHECK(most_steps(3) == 5);
  CHECK(most_steps(16) == 2);
  CHECK_THROWS_AS(least_absolute_limit(6, 1, {.steps = 6}, 3), Error);
  CHECK_THROWS_AS(least_absolute_rule(6, 1, 1), Error);
}

TEST_CASE("least absolute deviations: random data of other arities do not break the bound of one step") {
  Random random;
  for (const auto round : rounds(40)) {
    const int arity = 3 + static_cast<int>(round % 3), points = 3 + static_cast<int>(round % 4);
    CAPTURE(arity, points);
    const auto rule = least_absolute_rule(points, 1, arity);
    const Rational bound = contraction(*rule, {1, 1}).proved.value().bound;
    std::vector<Rational> f;
    for (int j = 0; j < points + 3; ++j) f.emplace_back(random.integer(-9, 9));
    CHECK(largest(differences(refined_by_fits(points, 1, arity, f), 1)) <= bound * largest(differences(f, 1)));
  }
}

TEST_CASE("least absolute deviations: monotone and convex data need not stay so, and data show it") {
  for (const int points : {3, 6, 10})  // where minimisers are unique
    for (const int order : {1, 2}) {
      CAPTURE(points, order);
      const auto found = keeps_sign(*least_absolute_rule(points, 1), order);
      CHECK(found.kept.is_no());
      CHECK_FALSE(has_negative(differences(found.data, order)));
      CHECK(has_negative(differences(refined_by_fits(points, 1, 2, found.data), order)));
    }
  for (const int order : {1, 2}) {
    CHECK(keeps_sign(*least_absolute_rule(2, 1), order).kept.is_yes());  // Chaikin's scheme
    CHECK(keeps_sign(*least_absolute_rule(2, 1, 3), order).kept.is_yes());
  }
  CHECK(keeps_sign(*least_absolute_rule(6, 1), 1, Deadline::in(0)).kept.truth == Truth::unknown);
  CHECK_THROWS_AS(keeps_sign(*least_absolute_rule(6, 1), 3), Error);
  CHECK_THROWS_AS(keeps_sign(*least_absolute_rule(6, 1), 0), Error);
}

TEST_CASE("least absolute deviations: larger data may have smaller values") {
  const std::vector<Rational> small{1, 1, 0, 1, 1, 0}, large{2, 1, 0, 1, 1, 0};
  CHECK(refined_by_fits(6, 1, 2, small) == std::vector<Rational>{1, 1});
  CHECK(refined_by_fits(6, 1, 2, large) == std::vector<Rational>{Rational(11, 10), Rational(9, 10)});
}
