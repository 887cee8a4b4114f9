#include <subcert/analysis/transition/lattice_window.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

#include <set>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

using Points = std::set<LatticePoint>;

/// Where T_d v has its support for all d, by the definition: j with Mj + d - k among the exponents.
Points reached(const LatticeMask& mask, const Points& points) {
  const std::size_t variables = mask.dilation().variables();
  Points result;
  for (const LatticeMask::Term& term : mask.terms())
    for (const LatticePoint& point : points) {
      if (mask.components() > 1 && static_cast<std::size_t>(point.back()) != term.column) continue;
      LatticePoint sum = term.exponents;
      for (std::size_t v = 0; v < variables; ++v) sum[v] += point[v];
      LatticePoint image = mask.dilation().divide(sum).quotient;
      if (mask.components() > 1) image.push_back(static_cast<long>(term.row));
      result.insert(image);
    }
  return result;
}

/// A few terms, near each other or far apart.
MultivariatePolynomial entry(Random& random, int variables, long width) {
  std::vector<Monomial> terms;
  for (long k = random.integer(1, 4); k > 0; --k) {
    LatticePoint exponents;
    for (int v = 0; v < variables; ++v) exponents.push_back(random.integer(-width, width));
    terms.push_back(Monomial{1, exponents});
  }
  return {variables, terms};
}

LatticeMask random_mask(Random& random) {
  static const std::vector<std::vector<LatticePoint>> dilations = {
      {{2}}, {{-3}}, {{1, 1}, {1, -1}}, {{2, 0}, {0, 2}}, {{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}};
  const auto& rows = dilations[static_cast<std::size_t>(random.integer(0, static_cast<long>(dilations.size()) - 1))];
  const long components = random.integer(1, 2), width = random.integer(0, 2) == 0 ? 40 : 2;
  std::vector<MultivariatePolynomial> entries;
  for (long e = 0; e < components * components; ++e)
    entries.push_back(entry(random, static_cast<int>(rows.size()), width));
  return {entries, Dilation(rows)};
}

}  // namespace

TEST_CASE("lattice window: the points that words reach, by the definition") {
  Random random;
  for (const auto round : rounds(60)) {
    const LatticeMask mask = random_mask(random);
    LatticePoint origin(mask.dilation().variables() + (mask.components() > 1 ? 1 : 0), 0);
    Points all{origin}, fresh = all;
    while (!fresh.empty() && all.size() <= 3000) {
      Points next;
      for (const LatticePoint& point : reached(mask, fresh))
        if (all.insert(point).second) next.insert(point);
      fresh = std::move(next);
    }
    CAPTURE(static_cast<int>(round), all.size());
    if (all.size() > 3000) continue;
    CHECK(LatticeWindow::closure(mask, {origin}, 3000).points() == std::vector(all.begin(), all.end()));
    int steps = 0;
    for (Points kept = reached(mask, all); kept.size() != all.size(); kept = reached(mask, all), ++steps) all = kept;
    const LatticeWindow window(mask, {origin}, 3000);
    CHECK(window.points() == std::vector(all.begin(), all.end()));
    CHECK(window.steps() == steps);
  }
}
