// The shares of a budget: each is one, what follows one after the other leaves something for the last step, and shares
// of a whole sum to at most one.
#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/cmake/catch.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace subcert::schedule;

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
  check_leaves(0.6, {family::triangular_form, family::symmetries, family::symmetries});  // the search of the radius
  check_leaves(0.3, {block::commuting, block::norms, block::polytopes});                 // proofs
  check_leaves(0.2, {block::closed_proof, block::larger_polytope});                      // the proof of a larger one
  check_leaves(0.5, {block::opposite_as_one});                                           // the matrices told apart
  check_leaves(0.3, {products::coordinates, products::runs});                            // looks with contexts
  check_leaves(0.05, {forms::one_form, forms::contexts, forms::tree});                   // proofs
  check_leaves(0.3, {forms::fine_proof});                                                // a proof with doubles
  check_leaves(0.3, {curve::norms, curve::unstable});                                    // the radius
  check_leaves(0.03, {surface::stability, surface::sobolev, surface::search});           // convergence
  check_leaves(0.9, {surface::norms});
  check_leaves(0.8, {orbit::all});
  check_leaves(0.8, {p_radius::splitting});
}

TEST_CASE("shares of a whole sum to at most one") {
  CHECK(polytope::races < 1);  // the rest is for enclosing
  CHECK(polytope::first_products + 3 * polytope::later_products <= polytope::races);
  CHECK(std::max(polytope::first_race, polytope::last_look) <= polytope::races);
  CHECK(polytope::large_extras * polytope::races + polytope::last_look <= polytope::races);
}
