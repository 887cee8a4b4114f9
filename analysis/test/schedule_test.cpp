// The shares of a budget: each is one, what follows one after the other leaves something for the last step, and shares
// of a whole sum to at most one.
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/cmake/catch.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

namespace schedule = subcert::schedule;

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

}  // namespace

TEST_CASE("shares of what is left leave time for the step after them") {
  check_leaves(0.6, {schedule::family::triangular_form, schedule::family::symmetries,
                     schedule::family::symmetries});  // the search of the radius
  check_leaves(0.3, {schedule::block::commuting, schedule::block::norms, schedule::block::polytopes});  // proofs
  check_leaves(0.2, {schedule::block::closed_proof, schedule::block::larger_polytope});  // the proof of a larger one
  check_leaves(0.5, {schedule::block::opposite_as_one});                                 // the matrices told apart
  check_leaves(0.3, {schedule::products::coordinates, schedule::products::runs});        // looks with contexts
  check_leaves(0.05, {schedule::forms::one_form, schedule::forms::contexts, schedule::forms::tree});  // proofs
  check_leaves(0.3, {schedule::forms::fine_proof});                        // a proof with doubles
  check_leaves(0.3, {schedule::curve::norms, schedule::curve::unstable});  // the radius
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
