// The shares of a budget: each is one, what follows one after the other leaves something for the last step, and shares
// of a whole sum to at most one. Rounds: a longer budget repeats those of a shorter one.
#include <subcert/analysis/radii/joint/rounds.hpp>
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// The parts of the whole that steps take, each a share of what those before it leave, and what is left in the end.
std::vector<double> parts_of_whole(const std::vector<double>& shares_of_rest) {
  std::vector<double> parts;
  double left = 1;
  for (const double share : shares_of_rest) {
    CHECK(share > 0);
    CHECK(share < 1);
    parts.push_back(share * left);
    left -= parts.back();
  }
  parts.push_back(left);
  return parts;
}

void check_leaves(double least, const std::vector<double>& shares_of_rest) {
  const std::vector<double> parts = parts_of_whole(shares_of_rest);
  CHECK(std::accumulate(parts.begin(), parts.end(), 0.0) == Approx(1));
  CHECK(parts.back() >= least);
}

/// An answer with these ends whose proof is of norms.
JointSpectralRadius enclosed(const Rational& lower, const Rational& upper, Truth exact = Truth::unknown) {
  JointSpectralRadius result;
  result.radius = {lower, upper};
  result.product.radius = result.radius;
  result.exact = {exact, "as it is"};
  result.proof = NormProof{1, upper};
  return result;
}

/// What a search finds that depends on nothing but its time, in steps that the accuracy of the clock does not matter
/// for, and not monotonically.
JointSpectralRadius found_in(double seconds) {
  const double step = std::round(10 * std::log(seconds) / std::log(3.0));
  const auto part = [&](double frequency) {
    return Rational(static_cast<long>(50 + 49 * std::sin(frequency * step)), 100);
  };
  return enclosed(1 - part(7), 1 + part(11));
}

template <class Search>
JointSpectralRadius best_of(double seconds, const Search& search) {
  return radius::best_of_rounds({RationalMatrix::identity(2)}, {Deadline::in(seconds)},
                                [&](const Budget& round) { return search(round.deadline.remaining()); });
}

}  // namespace

TEST_CASE("the rounds of a third of the budget are the last ones, and all are the budget") {
  using schedule::family::least_round, schedule::family::most_of_shorter_rounds;
  const auto after_the_first = [](double seconds) {
    std::vector<double> all = radius::seconds_of_rounds(seconds);
    all.erase(all.begin());
    return all;
  };
  Random random;
  for (const auto round : rounds(200)) {
    const double third = least_round * std::exp(0.01 * static_cast<double>(random.integer(1, 900)));
    const std::vector<double> all = radius::seconds_of_rounds(3 * third),
                              expected = radius::seconds_of_rounds(std::min(third, most_of_shorter_rounds)),
                              others = after_the_first(3 * third);
    INFO(round << ", " << third);
    CHECK(std::accumulate(all.begin(), all.end(), 0.0) == Approx(3 * third));
    CHECK(std::ranges::is_sorted(all, std::ranges::greater{}));
    CHECK(all.back() > 0.6 * least_round);
    REQUIRE(others.size() == expected.size());
    for (std::size_t r = 0; r < others.size(); ++r) CHECK(others[r] == Approx(expected[r]));
  }
  CHECK(radius::seconds_of_rounds(0) == std::vector<double>{0});
  CHECK(radius::seconds_of_rounds(2 * least_round).size() == 1);
  const double endless = std::numeric_limits<double>::infinity();
  CHECK(radius::seconds_of_rounds(endless).front() == endless);
  CHECK(after_the_first(endless) == radius::seconds_of_rounds(most_of_shorter_rounds));
}

TEST_CASE("three times the budget does not widen what searches find that are better with less time") {
  int narrower = 0;
  for (int step = -25; step <= 10; ++step) {
    const double seconds = 1.5 * std::pow(3, 0.1 * step);
    const Enclosure before = best_of(seconds, found_in).radius, after = best_of(3 * seconds, found_in).radius;
    INFO(seconds);
    CHECK(*after.lower >= *before.lower);
    CHECK(*after.upper <= *before.upper);
    narrower += after.upper < before.upper || after.lower > before.lower;
  }
  CHECK(narrower > 0);
}

TEST_CASE("rounds end with the first one that is exact, and with the budget") {
  std::vector<double> seconds;
  const auto exact_below = [&](double limit) {
    seconds.clear();
    return [&seconds, limit](double left) {
      seconds.push_back(left);
      return enclosed(1, 2, left < limit ? Truth::yes : Truth::unknown);
    };
  };
  CHECK(best_of(9, exact_below(10)).exact.is_yes());
  CHECK(seconds.size() == 1);
  CHECK(best_of(9, exact_below(1)).exact.is_yes());
  CHECK(seconds.size() == 3);
  CHECK(best_of(0, exact_below(0)).exact.truth == Truth::unknown);
  CHECK(seconds.size() == 1);
  // An exact answer is the better one, whatever it is beside.
  const auto once_exact = [](double left) { return left > 1 ? enclosed(1, 2) : enclosed(0, 3, Truth::yes); };
  CHECK(best_of(3, once_exact).radius.upper == 3);
}

TEST_CASE("shares of what is left leave time for the step after them") {
  check_leaves(0.6, {schedule::family::triangular_form, schedule::family::symmetries,
                     schedule::family::symmetries});  // the search of the radius
  check_leaves(0.3, {schedule::block::commuting, schedule::block::norms, schedule::block::polytopes});  // proofs
  check_leaves(0.2, {schedule::block::closed_proof, schedule::block::larger_polytope});  // the proof of a larger one
  check_leaves(0.5, {schedule::block::opposite_as_one});                                 // the matrices told apart
  check_leaves(0.3, {schedule::products::coordinates, schedule::products::runs});        // looks with contexts
  check_leaves(0.05, {schedule::forms::one_form, schedule::forms::contexts, schedule::forms::tree});  // proofs
  check_leaves(0.3, {schedule::forms::fine_proof});  // a proof with doubles
  check_leaves(0.5, {schedule::curve::norms});       // the radius
  check_leaves(0.3, {schedule::curve::reduced});     // the mask that does not tell the exponent
  check_leaves(0.03,
               {schedule::surface::stability, schedule::surface::sobolev, schedule::surface::search});  // convergence
  check_leaves(0.9, {schedule::surface::norms});
  check_leaves(0.8, {schedule::orbit::all});
  check_leaves(0.8, {schedule::p_radius::splitting});
}

TEST_CASE("shares of a whole sum to at most one") {
  CHECK(schedule::polytope::races < 1);  // the rest is for enclosing
  CHECK(schedule::polytope::first_products + 3 * schedule::polytope::later_products <= schedule::polytope::races);
  CHECK(std::max(schedule::polytope::first_race, schedule::polytope::last_look) <= schedule::polytope::races);
  CHECK(schedule::polytope::large_extras * schedule::polytope::races + schedule::polytope::last_look <=
        schedule::polytope::races);
}
