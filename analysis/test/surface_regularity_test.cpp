#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/value_space.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/masks/lattice_symmetry.hpp>
#include <subcert/analysis/symbol/masks/torus.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>

using namespace subcert;

namespace {

Scheme surface(const std::string& specification) { return make_linear_scheme(specification); }

MultivariateRegularity regularity(const std::string& specification) {
  return multivariate_regularity(surface(specification).mask.without_factors(), {Deadline::in(100)});
}

bool encloses(const Enclosure& enclosure, double value, double width) {
  return enclosure.is_bounded() && (*enclosure.upper - *enclosure.lower).convert_to<double>() < width &&
         enclosure.lower->convert_to<double>() < value + width && enclosure.upper->convert_to<double>() > value - width;
}

}  // namespace

TEST_CASE("classical surfaces have their known exponents, exactly") {
  struct Known {
    const char* specification;
    double holder, sobolev;
  };
  // Box splines: the least number of directions that must be left out for the rest not to span, less 1, and half more
  // in L2. The butterfly scheme: [GP16]. The quincunx scheme: -2 log_2((1 + sqrt 5) / 4).
  for (const Known& known :
       {Known{"box:[1,0;0,1;1,1]", 1, 1.5}, Known{"box:[1,0;1,0;0,1;1,1]", 1, 1.5},
        Known{"box:[1,0;1,0;0,1;0,1;1,1]", 2, 2.5}, Known{"loop:", 3, 3.5}, Known{"catmull-clark:", 3, 3.5},
        Known{"doo-sabin:", 2, 2.5}, Known{"butterfly:w=1/16", 2, 2.44077}, Known{"quincunx:", 0.61152, 1.57764}}) {
    INFO(known.specification);
    const MultivariateRegularity result = regularity(known.specification);
    CHECK(result.converges.is_yes());
    CHECK(result.stable.is_yes());
    CHECK(result.exact.is_yes());
    CHECK(encloses(result.exponent, known.holder, 1e-5));
    REQUIRE(result.sobolev);
    CHECK(encloses(*result.sobolev, known.sobolev, 1e-5));
  }
}

TEST_CASE("a lower end that is asked for has a short proof, and one above the exponent has none") {
  const std::vector<std::pair<std::string, double>> known{{"butterfly", 2}, {"loop", 3}};
  for (const auto& [specification, exponent] : known) {
    CAPTURE(specification);
    const LatticeMask mask = surface(specification).mask.without_factors();
    const auto found = regularity_of_at_least(mask, Rational(11) / 10, {Deadline::in(60)});
    REQUIRE(found);
    REQUIRE(found->exponent.lower);
    CHECK(*found->exponent.lower >= Rational(11) / 10);
    CHECK(found->exponent.lower->convert_to<double>() <= exponent);
    CHECK(found->space->order == 2);
    CHECK_FALSE(regularity_of_at_least(mask, Rational(31) / 10, {Deadline::in(1)}));
    CHECK_THROWS_AS(regularity_of_at_least(mask, 0, {Deadline::in(1)}), Error);
  }
  CHECK_FALSE(regularity_of_at_least(surface("mask2:[[1,1],[1,1]]").mask.without_factors(), 1, {Deadline::in(1)}));
}

TEST_CASE("a large block that is smaller than the leading one is settled by a quadratic form") {
  // The exponent of the tensor product, dual-odd:n=2,d=3: a block of size 8 leads, one of size 56 does not.
  const MultivariateRegularity result = regularity("grid:points=5x5,d=3");
  CHECK(result.exact.is_yes());
  CHECK(encloses(result.exponent, 2.396267695259, 1e-10));
  REQUIRE(result.radius);
  REQUIRE(result.radius->by_blocks());
  const auto& blocks = result.radius->by_blocks()->blocks;
  CHECK(std::any_of(blocks.begin(), blocks.end(),
                    [](const JointSpectralRadius& block) { return std::holds_alternative<GraphProof>(block.proof); }));
}

TEST_CASE("where shifts are unstable the differences of the limit tell the exponent") {
  struct Known {
    const char* specification;
    double holder, sobolev;
    bool exact;
  };
  // The box splines know their exponents; the differences of their schemes shrink as if they were 2 and 4. Of a
  // trapezoid, as a tensor product with a parabola, the exponent is that of the trapezoid.
  for (const Known& known : {Known{"zwart-powell:", 2, 2.5, true}, Known{"four-eight:", 5, 5.5, false},
                             Known{"grid:points=2x2,d=1", 2, 2.5, true},
                             Known{"grid:points=3x3,d=1", 1.9656286096237, 1.9995423444156, true},
                             Known{"mask2:[[1,3,3,1],[1,3,3,1],[0,0,0,0],[1,3,3,1],[1,3,3,1]]/8", 1, 1.5, true}}) {
    INFO(known.specification);
    const MultivariateRegularity result = regularity(known.specification);
    CHECK(result.stable.is_no());
    REQUIRE(result.space);
    CHECK(result.space->is_of_values());
    CHECK((result.exact.is_yes() || !known.exact));
    CHECK(result.converges.is_yes());
    REQUIRE(result.shrinking);
    CHECK(result.shrinking->radius.proved_upper() < 1);
    CHECK(result.shrinking->space.dilation == result.space->dilation);
    CHECK(result.shrinking->space.dilation.digits() == result.space->dilation.digits());
    CHECK_FALSE(result.shrinking->space.is_of_values());
    CHECK(encloses(result.exponent, known.holder, 1e-10));
    REQUIRE(result.sobolev);
    CHECK(encloses(*result.sobolev, known.sobolev, 1e-10));
  }
}

TEST_CASE("where shifts are stable the differences of the scheme and of the limit shrink alike") {
  for (const char* specification : {"quincunx:", "loop:", "grid:points=3x3,d=2"}) {
    INFO(specification);
    const LatticeMask mask = surface(specification).mask;
    const int order = polynomial_reproduction(mask).sum_rules;
    const auto space = value_space(mask, order);
    REQUIRE(space);
    const Rational of_limit = joint_spectral_radius(space->family, {Deadline::in(100)}).proved_upper(),
                   of_scheme = joint_spectral_radius(difference_space(mask, order).family, {Deadline::in(100)})
                                   .proved_upper();
    CHECK(abs(of_limit - of_scheme) < power(Rational(10), -10));
  }
}

TEST_CASE("another dilation of the same limits closes where the first does not") {
  const MultivariateRegularity result = regularity("sqrt3:");
  CHECK(result.exact.is_yes());
  CHECK(encloses(result.exponent, 2.63092975357146, 1e-10));  // log_3 18
  CHECK(!(result.space->dilation == surface("sqrt3:").mask.dilation()));
}

TEST_CASE("tensor products by their factors and by their masks agree") {
  for (const char* specification : {"tensor:(bspline:degree=2)x(bspline:degree=3)", "kobbelt:w=1/16"}) {
    INFO(specification);
    const Scheme scheme = surface(specification);
    REQUIRE(scheme.mask.has_factors());
    const MultivariateRegularity by_mask = multivariate_regularity(scheme.mask.without_factors(), {Deadline::in(100)}),
                                 by_factors = multivariate_regularity(scheme.mask, {Deadline::in(100)});
    CHECK(by_mask.exact.is_yes());
    CHECK(by_factors.exact.is_yes());
    CHECK(by_mask.sum_rules == by_factors.sum_rules);
    CHECK(*by_mask.exponent.lower <= *by_factors.exponent.upper);
    CHECK(*by_factors.exponent.lower <= *by_mask.exponent.upper);
    CHECK(encloses(by_mask.exponent, by_factors.exponent.lower->convert_to<double>(), 1e-10));
    CHECK(*by_mask.sobolev->lower <= *by_factors.sobolev->upper);
    CHECK(*by_factors.sobolev->lower <= *by_mask.sobolev->upper);
  }
}

TEST_CASE("dilations that are not isotropic have an exponent along each subspace") {
  // Ternary along y, and the same in another basis of the lattice.
  const LatticeMask mixed = surface("tensor:(bspline:degree=3)x(bspline:degree=2,a=3)").mask.without_factors();
  std::vector<MultivariatePolynomial::Monomial> terms = mixed.symbol().terms();
  for (auto& term : terms) term.exponents[0] += term.exponents[1];
  const LatticeMask sheared(MultivariatePolynomial(2, terms), Dilation({{2, 1}, {0, 3}}));
  for (const LatticeMask& mask : {mixed, sheared}) {
    INFO(mask.dilation().to_text());
    const MultivariateRegularity result = multivariate_regularity(mask, {Deadline::in(100)});
    CHECK(encloses(result.exponent, 2, 1e-10));
    CHECK(result.exact.is_yes());
    CHECK(result.stable.is_yes());
  }
}

TEST_CASE("masks that do not converge are told so") {
  const LatticeMask shifted(surface("loop:").mask.symbol() * MultivariatePolynomial(2, 2), 2);
  CHECK(multivariate_regularity(shifted, {Deadline::in(1)}).converges.is_no());
  // Shifts that are not stable, and no continuous limit whose values could be told apart.
  CHECK(regularity("mask2:[[0,0,9,9],[-7,-7,9,9],[-7,-7,0,0]]/2").converges.is_no());
  const LatticeMask shearing(surface("loop:").mask.symbol(), Dilation({{2, 1}, {0, 2}}));
  CHECK_THROWS_AS(multivariate_regularity(shearing, {Deadline::in(1)}), Error);
}

TEST_CASE("difference spaces are invariant and hold the differences after some steps") {
  for (const char* specification : {"quincunx:", "loop:", "grid:points=3x3,d=2"}) {
    INFO(specification);
    const LatticeMask mask = surface(specification).mask;
    const DifferenceSpace space = difference_space(mask, polynomial_reproduction(mask).sum_rules);
    const auto is_inside = [&](LatticeSequence v) {
      for (std::size_t c = 0; c < space.basis.size(); ++c) {
        const auto at = v.find(space.pivots[c]);
        if (at == v.end()) continue;
        const Rational factor = at->second;
        for (const auto& [point, value] : space.basis[c])
          if ((v[point] -= factor * value) == 0) v.erase(point);
      }
      return v.empty();
    };
    for (const LatticeSequence& vector : space.basis)
      for (const LatticeSequence& image : transitions(mask, vector)) CHECK(is_inside(image));
    std::vector<LatticeSequence> moved = differences_of_delta(2, space.order);
    for (int step = 0; step < space.window.steps(); ++step) {
      std::vector<LatticeSequence> next;
      for (const LatticeSequence& v : moved)
        for (LatticeSequence& image : transitions(mask, v)) next.push_back(std::move(image));
      moved = std::move(next);
    }
    for (const LatticeSequence& v : moved) CHECK(is_inside(v));
  }
}

TEST_CASE("inner products of shifts belong to the box spline one order higher") {
  // <phi, phi(. - k)> of the three-directional linear element: 1/2 in the middle and 1/12 at the six neighbours.
  const auto gram = gram_function(surface("box:[1,0;0,1;1,1]").mask);
  REQUIRE(gram);
  CHECK(gram->size() == 7);
  CHECK(gram->at({0, 0}) == Rational(1, 2));
  CHECK(gram->at({1, 1}) == Rational(1, 12));
  CHECK(gram->at({-1, 0}) == Rational(1, 12));
}

TEST_CASE("values of limits solve the refinement equation and sum to 1") {
  for (const char* specification : {"quincunx:", "loop:", "butterfly:w=1/16", "grid:points=3x3,d=2"}) {
    INFO(specification);
    const LatticeMask mask = surface(specification).mask;
    const LatticeSequence values = limit_values(mask, 0), finer = limit_values(mask, 2);
    Rational sum = 0;
    for (const auto& [point, value] : values) {
      sum += value;
      // The same point on the finer lattice.
      const auto same = finer.find(mask.dilation() * (mask.dilation() * point));
      CHECK((same != finer.end() && same->second == value));
    }
    CHECK(sum == 1);
  }
  // The three-directional quartic box spline.
  const LatticeSequence loop = limit_values(surface("loop:").mask, 0);
  CHECK(loop.at({0, 0}) == Rational(1, 2));
  CHECK(loop.at({1, 1}) == Rational(1, 12));
}

TEST_CASE("symmetries of masks and what the dilation leaves of them") {
  const auto count = [](const char* specification) {
    const LatticeMask mask = surface(specification).mask;
    const auto group = lattice_symmetries(mask.symbol());
    return std::pair(group.size(), symmetries_along(group, mask.dilation()).size());
  };
  CHECK(count("loop:") == std::pair<std::size_t, std::size_t>(12, 12));
  CHECK(count("catmull-clark:") == std::pair<std::size_t, std::size_t>(8, 8));
  CHECK(count("sqrt3:") == std::pair<std::size_t, std::size_t>(12, 12));
  CHECK(count("tensor:(bspline:degree=1)x(bspline:degree=3)") == std::pair<std::size_t, std::size_t>(4, 4));
}

TEST_CASE("positive on the torus or not, exactly") {
  const auto polynomial = [](const char* text) { return MultivariatePolynomial::parse(text, 2); };
  const MultivariatePolynomial x = polynomial("x + x^-1"), y = polynomial("y + y^-1"), one(2, 1);
  CHECK(is_positive_on_torus(x + y + one * MultivariatePolynomial(2, Rational(401, 100))).is_yes());
  CHECK(is_positive_on_torus(x + y + one * MultivariatePolynomial(2, Rational(399, 100))).is_no());
  // The least value at cos x = cos y = -1/4.
  const MultivariatePolynomial dip = polynomial("x+1/x+x^2+x^-2+y+1/y+y^2+y^-2+9/2");
  CHECK(is_positive_on_torus(dip + MultivariatePolynomial(2, Rational(1, 25))).is_yes());
  CHECK(is_positive_on_torus(dip + MultivariatePolynomial(2, Rational(-1, 25))).is_no());
  // The cells need more than a kilobyte.
  CHECK(is_positive_on_torus(dip + MultivariatePolynomial(2, Rational(1, 25)), {{}, 1000}).truth == Truth::unknown);
  CHECK(zero_on_torus(x + y + MultivariatePolynomial(2, 4)) == "2 pi (1/2, 1/2)");
  CHECK(zero_on_torus(x + MultivariatePolynomial(2, 1)) == "2 pi (1/3, 0)");
  CHECK(!zero_on_torus(x + y + MultivariatePolynomial(2, 5)));
}

TEST_CASE("dilations and digits are checked") {
  CHECK_THROWS_WITH(Dilation({{1, 1}, {0, 2}}), Catch::Contains("larger than 1"));
  CHECK_THROWS_WITH(Dilation({{2, 0}, {0, 0}}), Catch::Contains("larger than 1"));
  CHECK_THROWS_WITH(Dilation({{2, 0}, {0, 2, 1}}), Catch::Contains("square"));
  CHECK_THROWS_WITH(Dilation({{2}}, {{0}, {2}}), Catch::Contains("of one class"));
  CHECK_THROWS_WITH(Dilation({{2}}, {{0}}), Catch::Contains("need 2 digits"));
  CHECK(Dilation({{1, 2}, {-2, -1}}).is_isotropic());
  CHECK(Dilation({{1, -1}, {1, 1}}).is_isotropic());
  CHECK(!Dilation({{2, 0}, {0, 3}}).is_isotropic());
  CHECK(!Dilation({{2, 1}, {0, 2}}).is_isotropic());
  CHECK(Dilation({{2, 1}, {0, 2}}).isotropic_subspaces().empty());
  CHECK(Dilation({{3, 1}, {1, 2}}).isotropic_subspaces().empty());
  const auto sheared = Dilation({{2, 1}, {0, 3}}).isotropic_subspaces();
  REQUIRE(sheared.size() == 2);
  CHECK((sheared[0].classes == 2 && sheared[0].basis == std::vector<LatticePoint>{{1, 0}}));
  CHECK((sheared[1].classes == 3 && sheared[1].basis == std::vector<LatticePoint>{{1, 1}}));
  CHECK(Dilation({{0, 0, 2}, {1, 0, 0}, {0, 1, 0}}).is_isotropic());
  const Dilation sqrt3({{1, 2}, {-2, -1}});
  for (long i = -5; i <= 5; ++i)
    for (long j = -5; j <= 5; ++j) {
      const Dilation::Division at = sqrt3.divide({i, j});
      CHECK(sqrt3 * at.quotient + sqrt3.digits()[at.digit] == LatticePoint{i, j});
    }
}
