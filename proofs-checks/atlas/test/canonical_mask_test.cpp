#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/proofs-checks/atlas/canonical_mask.hpp>
#include <subcert/proofs-checks/certificates/identity.hpp>
#include <subcert/schemes/specification.hpp>

using namespace subcert;
using namespace subcert::atlas;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

Mask mask_of(const char* text, int arity = 2) { return {LaurentPolynomial::parse_mask(text), arity}; }

Mask steps_of(const Mask& mask, int steps) {
  LaurentPolynomial symbol(1);
  int arity = 1;
  for (int n = 0; n < steps; ++n, arity *= mask.arity()) symbol *= mask.symbol().dilated(arity);
  return {symbol, arity};
}

/// Of a random symbol, scaled to the sum that masks have.
std::optional<Mask> random_mask(Random& random, int arity) {
  const LaurentPolynomial symbol = random.nonzero_polynomial(7);
  const Rational sum = symbol(1);
  if (sum == 0) return std::nullopt;
  return Mask(symbol * LaurentPolynomial(Rational(arity) / sum), arity);
}

}  // namespace

TEST_CASE("an entry is named by its mask") {
  const Mask cubic = mask_of("[1,4,6,4,1]/8@-2");
  CHECK(mask_text(canonical_mask(cubic)) == "mask:[1,4,6,4,1]/8@0");
  CHECK(entry_id(canonical_mask(cubic)) == content_id("mask:[1,4,6,4,1]/8@0").substr(0, 12));
  CHECK(mask_text(canonical_mask(mask_of("[1,2,3,2,1]/3@7", 3))) == "mask:[1,2,3,2,1]/3@0,arity=3");
  CHECK(is_entry_id(entry_id(canonical_mask(cubic))));
  for (const char* other : {"", "0123456789a", "0123456789abc", "0123456789aB", "mask:[1,1]@0"})
    CHECK_FALSE(is_entry_id(other));
  CHECK(make_scheme(mask_text(canonical_mask(cubic))).mask.curve() == canonical_mask(cubic));
  CHECK(mask_text(canonical_mask(mask_of("[3]@5"))) == "mask:[3]@0");
}

TEST_CASE("shifts, reflections and steps do not change the entry, and anything else does") {
  Random random;
  for (const auto round : rounds(200)) {
    const int arity = static_cast<int>(random.integer(2, 4));
    const std::optional<Mask> mask = random_mask(random, arity);
    if (!mask) continue;
    const Mask canonical = canonical_mask(*mask);
    CHECK(canonical.symbol().lowest() == 0);
    CHECK(canonical_mask(canonical) == canonical);
    const auto same = [&](const Mask& other) { return canonical_mask(other) == canonical; };
    CHECK(same({mask->symbol().shifted(random.integer(-9, 9)), arity}));
    CHECK(same({mask->symbol().reversed(), arity}));
    CHECK(same(steps_of(*mask, 2)));
    if (arity == 2) CHECK(same(steps_of(*mask, 3)));
    // Coefficients that differ are another entry, and so is another arity of the same ones.
    const LaurentPolynomial changed = mask->symbol() + LaurentPolynomial::monomial(1, mask->symbol().highest() + 1);
    CHECK_FALSE(same({changed, arity}));
    CHECK(mask_text(canonical_mask({mask->symbol(), 5})) != mask_text(canonical_mask({mask->symbol(), 7})));
    CHECK(round >= 0);
  }
}

TEST_CASE("roots: found where they are, and nowhere else") {
  const Mask chaikin = mask_of("[1,3,3,1]/4@0");
  CHECK(root_of(steps_of(chaikin, 2), 2) == chaikin);
  CHECK(root_of(steps_of(chaikin, 3), 2) == chaikin);
  CHECK(root_of(steps_of(chaikin, 4), 4) == steps_of(chaikin, 2));
  CHECK_FALSE(root_of(chaikin, 2));
  CHECK_FALSE(root_of(steps_of(chaikin, 2), 3));
  CHECK_THROWS_AS(root_of(chaikin, 1), Error);
  Mask near = steps_of(chaikin, 2);
  CHECK_FALSE(root_of({near.symbol() + LaurentPolynomial::parse_mask("[1,0,-1]/64@3"), 4}, 2));
  CHECK_FALSE(root_of({near.symbol() * LaurentPolynomial(2), 4}, 2));
  CHECK_FALSE(root_of(mask_of("[1,0,-1]@0", 4), 2));
  CHECK(canonical_mask(mask_of("[4]@3", 4)) == mask_of("[2]@0"));
}

TEST_CASE("a mask and its root have the same values of the limit, and sum rules") {
  const Mask dd = make_scheme("dd:n=2").mask.curve(), twice = steps_of(dd, 2);
  const LimitValues fine = limit_values(dd, 4), coarse = limit_values(twice, 2);
  CHECK(fine.first_index == coarse.first_index);
  CHECK(fine.values == coarse.values);
  CHECK(polynomial_reproduction(dd).sum_rules == polynomial_reproduction(twice).sum_rules);
}
