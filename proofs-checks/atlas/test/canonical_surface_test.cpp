#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/atlas/canonical_mask.hpp>
#include <subcert/proofs-checks/atlas/canonical_surface.hpp>
#include <subcert/schemes/specification.hpp>

#include <optional>
#include <set>

using namespace subcert;
using namespace subcert::atlas;
using subcert::testing::Random;
using subcert::testing::rounds;
using Points = std::vector<LatticePoint>;

namespace {

/// A product of shears, a swap and a change of sign: any of determinant 1 or -1 may come.
Points random_unimodular(Random& random) {
  Points t{{1, 0}, {0, 1}};
  for (long k = random.integer(0, 3); k >= 0; --k) {
    t = times(t, {{1, random.integer(-2, 2)}, {0, 1}});
    t = times(t, {{1, 0}, {random.integer(-2, 2), 1}});
  }
  if (random.integer(0, 1) == 1) t = times(t, {{0, 1}, {1, 0}});
  return t;
}

Points inverse_of(const Points& t) {
  const long sign = t[0][0] * t[1][1] - t[0][1] * t[1][0];
  return {{sign * t[1][1], -sign * t[0][1]}, {-sign * t[1][0], sign * t[0][0]}};
}

/// In the coordinates T x + shift.
LatticeMask in_basis(const LatticeMask& mask, const Points& t, const LatticePoint& shift) {
  std::vector<Monomial> terms;
  for (const LatticeMask::Term& term : mask.terms())
    terms.push_back({term.coefficient, times(t, term.exponents) + shift});
  return {MultivariatePolynomial(2, terms), Dilation(times(times(t, mask.dilation().rows()), inverse_of(t)))};
}

LatticeMask surface_of(const std::string& text) { return make_linear_scheme(text).mask.without_factors(); }

LatticeMask random_surface(Random& random) {
  std::vector<Monomial> terms;
  for (long k = random.integer(3, 9); k > 0; --k)
    terms.push_back({Rational(random.integer(1, 3)), {random.integer(-2, 2), random.integer(-2, 2)}});
  static const std::vector<Points> dilations = {
      {{2, 0}, {0, 2}}, {{3, 0}, {0, 3}}, {{1, -1}, {1, 1}}, {{1, 2}, {-2, -1}}};
  return {MultivariatePolynomial(2, terms), Dilation(dilations[static_cast<std::size_t>(random.integer(0, 3))])};
}

}  // namespace

TEST_CASE("corners of a hull") {
  CHECK(corners_of_hull({}).empty());
  CHECK(corners_of_hull({{3, 4}, {3, 4}}).size() < 3);
  CHECK(corners_of_hull({{0, 0}, {1, 2}, {2, 4}}).size() < 3);
  CHECK(corners_of_hull({{0, 0}, {1, 0}, {2, 0}, {0, 2}, {1, 1}, {2, 2}}) == Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
}

TEST_CASE("surfaces: affine maps of the lattice do not change the entry") {
  Random random;
  int compared = 0;
  for (const auto round : rounds(200)) {
    const LatticeMask mask = random_surface(random);
    std::optional<LatticeMask> canonical;
    try {
      canonical = canonical_surface(mask);
    } catch (const Error&) {
      continue;  // on a line
    }
    CHECK(canonical->symbol().lowest() == LatticePoint{0, 0});
    CHECK(canonical_surface(*canonical) == *canonical);
    const Points t = random_unimodular(random);
    CAPTURE(round, mask_text(*canonical), to_text(t));
    std::optional<LatticeMask> other;
    try {
      other = in_basis(mask, t, {random.integer(-9, 9), random.integer(-9, 9)});
    } catch (const Error&) {
      continue;  // a dilation beyond the sizes
    }
    CHECK(canonical_surface(*other) == *canonical);
    ++compared;
  }
  CHECK(compared > 10);
}

TEST_CASE("surfaces: other masks are other entries") {
  // The same hull, one coefficient changed; all choices of 0, 1, 2 within a triangle: as many entries as classes under
  // its six affine symmetries.
  std::set<std::string> ids;
  std::size_t fixed = 0;
  const Points corners{{0, 0}, {2, 0}, {0, 2}}, inner{{1, 0}, {0, 1}, {1, 1}};
  for (long code = 0; code < 27; ++code) {
    std::vector<Monomial> terms;
    for (const LatticePoint& corner : corners) terms.push_back({1, corner});
    long rest = code;
    for (const LatticePoint& point : inner) {
      terms.push_back({Rational(rest % 3), point});
      rest /= 3;
    }
    ids.insert(entry_id(canonical_mask(LatticeMask(MultivariatePolynomial(2, terms), Dilation::multiple(2, 2)))));
    ++fixed;
  }
  CHECK(fixed == 27);
  CHECK(ids.size() == 10);  // multisets of three of 0, 1, 2
}

TEST_CASE("surfaces: known schemes") {
  CHECK(entry_id(canonical_mask(surface_of("box:[1,0;1,0;0,1;0,1;1,1;1,1]"))) ==
        entry_id(canonical_mask(surface_of("box:[1,0;1,0;0,1;0,1;1,-1;1,-1]"))));
  CHECK(entry_id(canonical_mask(surface_of("loop"))) != entry_id(canonical_mask(surface_of("butterfly:w=1/16"))));
  CHECK(mask_text(canonical_mask(surface_of("tensor:(bspline:degree=1)x(bspline:degree=1)"))) ==
        "mask2:[[1,2,1],[2,4,2],[1,2,1]]/4@0,0");
  for (const char* text : {"loop", "quincunx", "sqrt3", "butterfly:w=1/16", "grid:points=4x4,d=1,a=3"}) {
    const LatticeMask canonical = canonical_surface(surface_of(text));
    CHECK(surface_of(mask_text(canonical)) == canonical);
  }
  // Two coefficients, on a line that a twin dragon's dilation leaves
  const LatticeMask dragon = surface_of("mask2:[[1,1]]@0,0,dilation=[1,-1;1,1]");
  CHECK(canonical_surface(in_basis(dragon, {{2, 1}, {1, 1}}, {4, -7})) == canonical_surface(dragon));
  CHECK_THROWS_AS(canonical_surface(LatticeMask(MultivariatePolynomial(2, Rational(4)), 2)), Error);
  CHECK_THROWS_AS(canonical_surface(LatticeMask(MultivariatePolynomial(2, {{1, {0, 0}}, {1, {2, 4}}, {2, {1, 2}}}), 2)),
                  Error);
}
