// Schemes of curves, by the code for several variables and by that for one, and products, by their factors and as a
// whole: two ways to the same numbers.
#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/regularity/sobolev.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

/// Some sum rules, or none; half of the masks are symmetric, and some have a factor that takes the stability.
Mask mask_of_curve(Random& random) {
  const int arity = static_cast<int>(random.integer(2, random.chance(70) ? 2 : 4));
  LaurentPolynomial symbol = random.nonzero_polynomial(4);
  if (random.chance(50)) symbol *= symbol.reversed();
  if (random.chance(20)) symbol *= LaurentPolynomial::all_ones(2).dilated(2);
  if (const Rational sum = symbol(1); sum != 0) symbol *= LaurentPolynomial(arity / sum);
  for (long k = random.integer(0, 4); k > 0; --k)
    symbol *= LaurentPolynomial::all_ones(arity) * LaurentPolynomial(Rational(1, arity));
  return {symbol, arity};
}

void check_overlap(const Enclosure& a, const Enclosure& b) {
  if (a.lower && b.upper) CHECK(*a.lower <= *b.upper);
  if (b.lower && a.upper) CHECK(*b.lower <= *a.upper);
}

void check_no_contradiction(const Decision& a, const Decision& b) {
  CHECK_FALSE((a.is_yes() && b.is_no()));
  CHECK_FALSE((a.is_no() && b.is_yes()));
}

void check_operators(const Mask& mask, const LatticeMask& general) {
  const LatticeMask from_zero(general.symbol().shifted({-mask.symbol().lowest()}), general.dilation());
  const std::vector<RationalMatrix> matrices = transition_matrices(mask);
  std::vector<LatticeSequence> deltas;
  std::vector<LatticePoint> points;
  for (long k = 0; k < static_cast<long>(matrices.front().rows()); ++k) {
    points.push_back({k});
    deltas.push_back({{points.back(), 1}});
  }
  const MatrixFamily family = transition_family(from_zero, deltas, points);
  REQUIRE(family.count() == matrices.size());
  for (std::size_t t = 0; t < matrices.size(); ++t) CHECK(family[t] == matrices[t]);
}

void check_values(const Mask& mask, const LatticeMask& general, int order) {
  const LimitValues values = limit_values(mask, 2, order);
  LatticeSequence others = limit_values(general, 2, {order});
  for (std::size_t i = 0; i < values.values.size(); ++i) {
    const LatticePoint point{values.first_index + static_cast<long>(i)};
    const auto other = others.find(point);
    CHECK((other == others.end() ? Rational(0) : other->second) == values.values[i]);
    if (other != others.end()) others.erase(other);
  }
  CHECK(others.empty());
}

void check_ranges(const Mask& mask, const LatticeMask& general) {
  std::optional<LimitRange> range;
  try {
    range = limit_range(mask, {Rational(1, 1000), Budget{Deadline::in(2)}});
  } catch (const Error&) {
    return;  // the differences contract too slowly for it
  }
  const LimitRange box = limit_range(general, {Rational(1, 1000), Budget{Deadline::in(2)}});
  check_overlap(range->maximum, box.maximum);
  check_overlap(range->sup_norm, box.sup_norm);
  check_overlap(range->minimum, box.minimum);
}

}  // namespace

TEST_CASE("one variable as a case of several: sum rules, reproduction, values, ranges, exponents") {
  Random random;
  int converging = 0, exact = 0;
  for (const auto round : rounds(40)) {
    const Mask mask = mask_of_curve(random);
    CAPTURE(mask.symbol().to_text(), mask.arity());
    const LatticeMask general = LatticeMask(mask).without_factors();
    CHECK(general.dimension() == 1);
    CHECK(coset_sums(general) == coset_sums(mask));
    CHECK(operator_norm(general) == operator_norm(mask));
    check_operators(mask, general);
    const PolynomialReproduction one = polynomial_reproduction(mask);
    const PolynomialReproduction several = polynomial_reproduction(general);
    CHECK(several.sum_rules == sum_rules(mask));
    CHECK(several.factors == std::vector<int>{sum_rules(mask)});
    CHECK(several.reproduction_degree == one.reproduction_degree);
    CHECK(several.parametrization == one.parametrization);
    check_no_contradiction(converges(mask), converges(general));
    if (!is_affine(mask)) continue;
    const Budget budget{Deadline::in(3)};
    const HolderRegularity curve = holder_regularity(mask, 6, budget);
    const MultivariateRegularity surface = multivariate_regularity(general, {Deadline::in(3)});
    check_no_contradiction(curve.converges, surface.converges);
    check_no_contradiction(curve.stable, surface.stable);
    check_overlap(curve.proved_exponent(), surface.exponent);
    if (!curve.converges.is_yes()) continue;
    ++converging;
    exact += surface.exact.is_yes() && curve.deciding().radius.exact.is_yes();
    if (surface.sobolev) check_overlap(sobolev_regularity(mask).exponent, *surface.sobolev);
    for (int order = 0; order <= std::min(2, proved_smoothness(mask).order); ++order)
      check_values(mask, general, order);
    check_ranges(mask, general);
  }
  CHECK(converging > 0);
  CHECK(exact > 0);
}

TEST_CASE("two variables: products by their factors and as a whole") {
  Random random;
  int converging = 0;
  for (const auto round : rounds(20)) {
    Mask first = mask_of_curve(random), second = mask_of_curve(random);
    if (random.chance(40)) {  // the product stays the same
      const Rational factor(random.integer(1, 3), random.integer(1, 3));
      first = {first.symbol() * LaurentPolynomial(factor), first.arity()};
      second = {second.symbol() * LaurentPolynomial(1 / factor), second.arity()};
    }
    CAPTURE(first.symbol().to_text(), first.arity(), second.symbol().to_text(), second.arity());
    const LatticeMask product = tensor_product({first, second}), whole = product.without_factors();
    CHECK(operator_norm(product) == operator_norm(first) * operator_norm(second));
    const PolynomialReproduction by_factors = polynomial_reproduction(product),
                                 by_mask = polynomial_reproduction(whole);
    const Decision convergence = converges(product);
    check_no_contradiction(convergence, converges(whole));
    const std::vector<Rational> sums = coset_sums(product);
    if (!std::all_of(sums.begin(), sums.end(), [](const Rational& sum) { return sum == 1; })) {
      CHECK(convergence.is_no());
      continue;
    }
    CHECK(by_factors.sum_rules == by_mask.sum_rules);
    CHECK(by_factors.reproduction_degree == by_mask.reproduction_degree);
    CHECK(by_factors.parametrization == by_mask.parametrization);
    if (first.arity() == second.arity()) CHECK(by_factors.factors == by_mask.factors);
    if (!convergence.is_yes()) continue;
    ++converging;
    CHECK(limit_values(product, 1) == limit_values(whole, 1));
  }
  CHECK(converging > 0);
}

TEST_CASE("more time never tells less: of masks with a factor that takes the stability, and of random ones") {
  const auto is_narrower = [](const Enclosure& late, const Enclosure& early) {
    return (!early.lower || (late.lower && *late.lower >= *early.lower)) &&
           (!early.upper || (late.upper && *late.upper <= *early.upper));
  };
  std::vector<LatticeMask> masks;  // those of data that are fitted by constants
  for (const int n : {9, 17, 29})
    masks.emplace_back(Mask(LaurentPolynomial::all_ones(2 * n) * LaurentPolynomial(Rational(1, n)), 2));
  Random random;
  for ([[maybe_unused]] const auto& round : rounds(8)) masks.emplace_back(mask_of_curve(random));
  for (const LatticeMask& mask : masks) {
    CAPTURE(mask.symbol().to_text());
    Enclosure before;
    for (const double seconds : {0.0, 0.03, 0.1}) {
      const Enclosure now = regularity_of(mask, {Deadline::in(seconds)}).exponent();
      CHECK(is_narrower(now, before));
      before = now;
    }
  }
}
