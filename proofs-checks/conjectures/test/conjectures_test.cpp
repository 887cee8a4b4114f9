#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/conjectures/conjecture_7.hpp>
#include <subcert/proofs-checks/conjectures/conjecture_8.hpp>
#include <subcert/proofs-checks/sweeps/journal.hpp>
#include <subcert/schemes/specification.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace subcert;
using namespace subcert::conjectures;

namespace {

std::vector<CertifiedMaximum> exact_values(const std::vector<int>& n, int exponent, const Rational& constant) {
  std::vector<CertifiedMaximum> values;
  for (int i : n) values.push_back({i, Enclosure::exactly(constant * power(Rational(i), -exponent))});
  return values;
}

bool has(const std::vector<PrimalScheme>& schemes, int d, int n) {
  return std::find(schemes.begin(), schemes.end(), PrimalScheme{d, n}) != schemes.end();
}

}  // namespace

TEST_CASE("schemes that coincide are left out, with the reason") {
  const PrimalSchemes odd = distinct_primal_schemes({1, 2, 3, 4}, {1, 3, 5});
  CHECK(odd.schemes.size() == 9);
  REQUIRE(odd.skipped.size() == 3);
  CHECK(odd.skipped[0].scheme == PrimalScheme{3, 1});
  CHECK(odd.skipped[0].reason() == "2n = 2 data fix no degree above 1: the same scheme as primal:n=1,d=1");
  CHECK(has(odd.schemes, 3, 2));
  CHECK(has(odd.schemes, 5, 3));

  const PrimalSchemes all = distinct_primal_schemes({1, 2, 3, 4, 5}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  CHECK(all.skipped_lines().front() == "d = 0 with n = 1..5: the same masks as d = 1");
  CHECK(all.skipped_lines().back() ==
        "d = 10 with n = 1..5: 2n data fix no degree above 2n-1; these are the schemes with d = 2n-1");
  // Left out means: a scheme of the list has the same mask. Kept means: no other one has.
  for (const PrimalScheme& a : all.schemes)
    for (const PrimalScheme& b : all.schemes)
      CHECK((a == b) == (make_scheme(a.specification()).mask.curve() == make_scheme(b.specification()).mask.curve()));
  for (const auto& skipped : all.skipped)
    CHECK(std::any_of(all.schemes.begin(), all.schemes.end(), [&](const PrimalScheme& kept) {
      return make_scheme(kept.specification()).mask.curve() == make_scheme(skipped.scheme.specification()).mask.curve();
    }));
  CHECK(all.schemes.size() + all.skipped.size() == 55);
  // An even degree alone is a scheme like any other.
  CHECK(distinct_primal_schemes({3}, {2}).schemes.size() == 1);
}

TEST_CASE("rates are not observed from a scheme that interpolates") {
  // n max psi of Table 3 for d = 5: 3, 1.8968 and 1.8020.
  std::vector<CertifiedMaximum> values{{3, Enclosure::exactly(1), true},
                                       {5, Enclosure::exactly(Rational(3793, 10000))},
                                       {7, Enclosure::exactly(Rational(2574, 10000))}};
  CHECK(rate_start(values) == 1);
  CHECK(decay_finding(1, values).rate.is_yes());
  values.front().interpolates = false;
  CHECK(rate_start(values) == 0);
  CHECK(decay_finding(1, values).rate.is_no());
  values.erase(values.begin() + 1);  // nothing else is there
  values.front().interpolates = true;
  CHECK(rate_start(values) == 0);
}

TEST_CASE("the decay exponent is enclosed") {
  const auto exponent = [](Enclosure first, Enclosure second) { return decay_exponent(10, first, 40, second); };
  CHECK(exponent(Enclosure::exactly(16), Enclosure::exactly(1)).contains(2));
  CHECK(exponent(Enclosure::exactly(1), Enclosure::exactly(1)).contains(0));
  CHECK(exponent(Enclosure::exactly(1), Enclosure::exactly(4)).contains(-1));
  CHECK(*exponent(Enclosure::exactly(1), Enclosure::exactly(4)).upper < Rational(-99, 100));
  const Enclosure wide = exponent({Rational(8), Rational(32)}, {Rational(1), Rational(2)});
  CHECK(wide.contains(1));
  CHECK(wide.contains(Rational(5, 2)));
  CHECK(*wide.lower > Rational(99, 100));
  CHECK(*wide.upper < Rational(251, 100));
  CHECK_FALSE(exponent(Enclosure::at_least(1), Enclosure::exactly(1)).upper);
  CHECK_FALSE(exponent({Rational(0), Rational(1)}, Enclosure::exactly(1)).lower);
  // Between n that are not powers of two of each other.
  CHECK(decay_exponent(3, Enclosure::exactly(125), 5, Enclosure::exactly(27)).contains(3));
  CHECK_FAILS(decay_exponent(5, Enclosure::exactly(1), 5, Enclosure::exactly(1)), domain);
}

TEST_CASE("findings tell bounds from rates") {
  const std::vector<int> n{1, 2, 3, 5, 9, 10, 11, 20};
  const DecayFinding sharp = decay_finding(1, exact_values(n, 1, Rational(2, 5)));
  CHECK(sharp.upper_bound.is_yes());
  CHECK(sharp.rate.is_yes());
  CHECK(sharp.rate_from == 10);
  CHECK(sharp.largest.is_exact());
  CHECK(*sharp.largest.lower == Rational(2, 5));
  CHECK(sharp.sentence("max psi") ==
        "n max psi lies between 0.4 and 0.4 for n from 1 to 20. From n = 10 to 20 max psi falls like n^-r with r = 1. "
        "So on this range 1/n is a true upper bound, and it is the observed rate.");

  const DecayFinding fast = decay_finding(2, exact_values(n, 4, 1));
  CHECK(fast.upper_bound.is_yes());
  CHECK(fast.rate.is_no());
  CHECK(*fast.largest.upper == 1);
  CHECK(*fast.smallest.lower == Rational(1, 400));
  CHECK(fast.sentence("max |psi'|").find("but not the observed rate: the maximum falls faster") != std::string::npos);

  const DecayFinding slow = decay_finding(2, exact_values(n, 1, 1));
  CHECK(slow.upper_bound.is_no());
  CHECK(slow.rate.is_no());

  const DecayFinding wide = decay_finding(1,
                                          {{1, {Rational(1), Rational(2)}}, {2, Enclosure::at_least(Rational(1, 3))}});
  CHECK(wide.upper_bound.truth == Truth::unknown);
  CHECK_FALSE(wide.largest.upper);
  CHECK(*wide.largest.lower == 1);
  CHECK(*wide.smallest.lower == Rational(2, 3));
  CHECK(*wide.smallest.upper == 2);
  // From n = 5 to n = 10 the exponent is log2 of the quotient. Half a power away from the claim is the border, and what
  // straddles it decides nothing.
  const auto between = [](const Rational& low, const Rational& high) {
    return decay_finding(1, {{5, {low, high}}, {10, Enclosure::exactly(1)}});
  };
  for (const auto& [low, high, bound, rate] : std::vector<std::tuple<Rational, Rational, Truth, Truth>>{
           {Rational(7, 5), Rational(7, 5), Truth::no, Truth::no},      // 0.485
           {Rational(5, 4), Rational(5, 4), Truth::no, Truth::no},      // 0.32
           {Rational(3, 2), Rational(3, 2), Truth::yes, Truth::yes},    // 0.585
           {Rational(14, 5), Rational(14, 5), Truth::yes, Truth::yes},  // 1.485
           {Rational(3), Rational(3), Truth::yes, Truth::no},           // 1.585
           {Rational(4), Rational(4), Truth::yes, Truth::no},           // 2
           {Rational(6, 5), Rational(8, 5), Truth::unknown, Truth::unknown},
           {Rational(2), Rational(4), Truth::yes, Truth::unknown},
           {Rational(6, 5), Rational(4), Truth::unknown, Truth::unknown}}) {
    CAPTURE(low, high);
    CHECK(between(low, high).upper_bound.truth == bound);
    CHECK(between(low, high).rate.truth == rate);
  }
  CHECK(decay_finding(1, {{4, Enclosure::exactly(1)}}).sentence("max psi") ==
        "n max psi is 4 for n = 4; a single n has no rate.");
  CHECK(decay_finding(1, {{4, {Rational(1, 4), Rational(1, 3)}}}).sentence("max psi") ==
        "n max psi is 1 ... 1.33334 for n = 4; a single n has no rate.");
  CHECK_FAILS(decay_finding(1, {}), domain);
}

TEST_CASE("neighbours imply all other comparisons") {
  const auto schemes = distinct_primal_schemes({1, 2, 3, 4, 6}, {1, 3, 5}).schemes;
  const auto pairs = neighbouring_pairs(schemes);
  const auto implied = [&](const PrimalScheme& larger, const PrimalScheme& smaller) {
    std::vector<PrimalScheme> reached{larger};
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const VariancePair& pair : pairs)
        if (pair.larger == reached[i]) reached.push_back(pair.smaller);
    return std::find(reached.begin(), reached.end(), smaller) != reached.end();
  };
  for (const PrimalScheme& a : schemes)
    for (const PrimalScheme& b : schemes)
      if ((a.n == b.n && a.d > b.d) || (a.d == b.d && a.n < b.n)) CHECK(implied(a, b));
  for (const VariancePair& pair : pairs) CHECK((pair.larger.n == pair.smaller.n) != (pair.larger.d == pair.smaller.d));
  CHECK(pairs.size() == 7 + 9);
}

TEST_CASE("enclosures survive a journal") {
  for (const Enclosure& enclosure : {Enclosure{Rational(-1, 3), Rational(7, 5)}, Enclosure::at_least(2), Enclosure{}}) {
    const Enclosure again = sweeps::enclosure_from(sweeps::exact_json(enclosure));
    CHECK(again.lower == enclosure.lower);
    CHECK(again.upper == enclosure.upper);
  }
  for (const char* text :
       {"3", R"({"lower": 1})", R"({"lower": "0.5"})", R"({"middle": "1"})", R"({"lower": "2", "upper": "1"})"})
    CHECK_FAILS(sweeps::enclosure_from(nlohmann::ordered_json::parse(text)), domain);
}

TEST_CASE("maxima beside their limit") {
  // Synthetic maxima C (1 + 1/(4n)) / n: the deviation is 1/(4n), of rate 1.
  const Rational constant = *limit_comparison(1, {{1, Enclosure::exactly(1)}})->constant.lower;
  std::vector<CertifiedMaximum> maxima;
  for (int n : {5, 10, 20}) maxima.push_back({n, Enclosure::exactly(constant * (1 + Rational(1, 4 * n)) / n)});
  const auto limit = limit_comparison(1, maxima);
  REQUIRE(limit);
  CHECK(*limit->constant.upper - *limit->constant.lower < power(Rational(10), -24));
  CHECK(to_decimal(*limit->constant.lower, 20, Rounding::down) == "0.40443676798398528146");
  for (std::size_t i = 0; i < maxima.size(); ++i)
    CHECK(limit->deviation[i].value.contains(Rational(1, 4 * maxima[i].n)));
  CHECK(limit->rate_from == 10);
  REQUIRE(limit->exponent);
  CHECK(limit->exponent->contains(1));
  CHECK(*limit->exponent->upper - *limit->exponent->lower < Rational(1, 1'000'000));
  // A rate is told where two maxima bound it.
  const auto told = [](const std::vector<CertifiedMaximum>& of) { return limit_comparison(1, of)->sentence(); };
  CHECK_THAT(told(maxima), Catch::EndsWith(" - 1 is 0.0125 at n = 20 and falls like n^-r with r = 1 from n = 10 on."));
  CHECK_THAT(told({{3, Enclosure::exactly(1)}}), Catch::EndsWith(" at n = 3."));
  CHECK_THAT(told({{10, Enclosure::at_least(1)}, {20, Enclosure::exactly(1)}}), Catch::EndsWith(" at n = 20."));
  CHECK_FALSE(limit_comparison(1, {{3, Enclosure::exactly(1)}})->exponent);
  CHECK_FALSE(limit_comparison(101, maxima));
}

TEST_CASE("both conjectures hold for the first schemes") {
  const PrimalSchemes first = distinct_primal_schemes({1, 2}, {1});
  const auto rates = check_conjecture_7(first, {}, {});
  REQUIRE(rates);
  CHECK(rates->rows.size() == 2);
  CHECK(rates->rows.front().sup.contains(1));
  CHECK(rates->limits.count(1) == 1);
  const auto order = check_conjecture_8(first, {}, {});
  REQUIRE(order);
  CHECK(order->verdict == Truth::yes);
  CHECK(order->count(Truth::yes) == 1);
  CHECK(order->count(Truth::no) == 0);
}
