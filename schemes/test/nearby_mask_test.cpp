#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/nearby_mask.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>

using namespace subcert;

namespace {

Rational decimal(const Rational& x, int places) { return *parse_number(to_decimal(x, places, Rounding::nearest)); }

std::vector<Rational> coefficients_of(const Mask& mask) {
  std::vector<Rational> result;
  for (long i = mask.symbol().lowest(); i <= mask.symbol().highest(); ++i)
    result.push_back(mask.symbol().coefficient(i));
  return result;
}

}  // namespace

TEST_CASE("of decimals the mask with as many sum rules is found") {
  for (const char* specification : {"daubechies:n=2", "daubechies:n=5", "daubechies:n=12", "dd:n=4", "bspline:degree=5",
                                    "cdf:n=3,m=5", "ary:a=3,points=4,d=3", "bspline:degree=2,a=4", "daubechies:n=1"}) {
    CAPTURE(specification);
    const Mask mask = make_scheme(specification).mask.curve();
    for (const int places : {8, 12, 16}) {
      std::vector<Rational> printed;
      for (const Rational& c : coefficients_of(mask)) printed.push_back(decimal(c, places));
      const Rational accuracy = power(Rational(10), 1 - places);
      const auto found = nearby_mask(printed, mask.symbol().lowest(), mask.arity(), accuracy);
      REQUIRE(found);
      CHECK(found->sum_rules >= sum_rules(mask));
      CHECK(found->factor == 1);
      CHECK(found->change <= accuracy);
      const Mask nearby(found->symbol, mask.arity());
      CHECK(sum_rules(nearby) == found->sum_rules);
      Rational change = 0;
      for (std::size_t i = 0; i < printed.size(); ++i)
        change = std::max(
            change,
            Rational(abs(printed[i] - nearby.symbol().coefficient(mask.symbol().lowest() + static_cast<long>(i)))));
      CHECK(change == found->change);
    }
  }
}

TEST_CASE("filters are printed with other sums") {
  const Mask mask = make_scheme("daubechies:n=4").mask.curve();
  const Rational root = *root_enclosure(2, 2).lower;
  for (const Rational& factor : {Rational(1), Rational(1, 2), Rational(1 / root)}) {
    std::vector<Rational> printed;
    for (const Rational& c : coefficients_of(mask)) printed.push_back(decimal(factor * c, 12));
    const auto found = nearby_mask(printed, 0, 2, power(Rational(10), -10));
    REQUIRE(found);
    CHECK(found->sum_rules == 4);
    CHECK(abs(found->factor * factor - 1) < power(Rational(10), -10));
    for (long i = 0; i < 8; ++i)
      CHECK(abs(found->symbol.coefficient(i) - mask.symbol().coefficient(i)) < power(Rational(10), -10));
  }
  CHECK_FALSE(nearby_mask({3, 1}, 0, 2, power(Rational(10), -3)));
  CHECK_FALSE(nearby_mask({2, 0}, 0, 2, power(Rational(10), -3)));
}

TEST_CASE("no mask is nearer than the one that is found, in the sum of squares") {
  subcert::testing::Random random;
  for (int round = 0; round < 20; ++round) {
    const int arity = static_cast<int>(random.integer(2, 4));
    const Mask mask = make_scheme("bspline:degree=2,a=" + std::to_string(arity)).mask.curve();
    std::vector<Rational> printed;
    for (const Rational& c : coefficients_of(mask))
      printed.push_back(c + Rational(random.integer(-1000, 1000), 100'000'000));
    const auto found = nearby_mask(printed, 0, arity, power(Rational(10), -4));
    REQUIRE(found);
    CHECK(found->sum_rules == 3);
    // Its differences from the printed ones are orthogonal to the masks with these sum rules and the sum 0.
    const LaurentPolynomial sigma(std::vector<Rational>(static_cast<std::size_t>(arity), 1), 0);
    const LaurentPolynomial step = sigma.pow(3) * LaurentPolynomial({1, -1}, 0);
    const long count = static_cast<long>(printed.size());
    for (long shift = 0; shift + step.highest() < count; ++shift) {
      Rational product = 0;
      for (long k = 0; k <= step.highest(); ++k)
        product += step.coefficient(k) *
                   (found->symbol.coefficient(shift + k) - printed[static_cast<std::size_t>(shift + k)]);
      CHECK(abs(product) < power(Rational(10), -12));
    }
  }
}

TEST_CASE("mask:...,nearly= says what it changed") {
  const Scheme scheme = make_scheme(
      "mask:[0.48296291314453,0.83651630373780,0.22414386804201,-0.12940952255126],"
      "nearly=1e-12");
  CHECK(sum_rules(scheme.mask.curve()) == 2);
  CHECK(scheme.title.find("2 sum rules") != std::string::npos);
  CHECK(scheme.title.find("changed by") != std::string::npos);
  CHECK_FALSE(scheme.rounding);
  CHECK(make_scheme(scheme.specification).mask.curve().symbol() == scheme.mask.curve().symbol());
}
