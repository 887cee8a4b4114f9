#include <subcert/cmake/catch.hpp>
#include <subcert/reports/story_sentences.hpp>

using namespace subcert;
using namespace subcert::reports;

namespace {

Rational thousandths(int count) { return Rational(count, 1000); }

/// Bounds as in a table, n = 2, 3, 4, 5, and exact exponents in thousandths.
BoundsAndExponents family(const std::vector<int>& exponents) {
  BoundsAndExponents result{"primal", 2, {"1.649", "1.777", "1.816", "1.794"}, {}};
  for (const int one : exponents) result.exponents.push_back(Enclosure::exactly(thousandths(one)));
  return result;
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// n^-power for n = 1, 2, 4, 8.
conjectures::DecayFinding falling(int claimed, int power_of_n) {
  std::vector<conjectures::CertifiedMaximum> values;
  for (const int n : {1, 2, 4, 8}) values.push_back({n, Enclosure::exactly(1 / power(Rational(n), power_of_n))});
  return conjectures::decay_finding(claimed, values);
}

}  // namespace

TEST_CASE("the sentence about Tables 1 and 2 follows the exponents") {
  const BoundsAndExponents above = family({1650, 1980, 1990, 1985});
  CHECK(above.largest_bound() == std::pair<std::string, int>("1.816", 4));
  CHECK(above.above() == std::vector<int>{3, 4, 5});
  CHECK(above.dip_from(3) == thousandths(5));
  CHECK(mentions(exponents_finding({above}), "the exponents do not follow them"));
  CHECK(mentions(exponents_finding({above}), "exceed 1.816, the largest printed bound, for n = 3..5"));
  CHECK(mentions(exponents_finding({above}), "falls by less than 0.005"));
  // One exponent at the bound, or not above it: the claim goes.
  for (const int last : {1816, 1817, 1700})
    CHECK(mentions(exponents_finding({above, family({1650, 1980, 1990, last})}), "is not decided for every n"));
  // Before the largest bound they may be where they are.
  CHECK(mentions(exponents_finding({family({1650, 1700, 1990, 1985})}), "do not follow them"));
  CHECK(mentions(exponents_finding({family({1650, 1700, 1800, 1700})}), "no exponent is proved to exceed 1.816"));
  // Whether the printed bounds fall is read off them.
  CHECK(mentions(exponents_finding({above}), "which fall from n = 4 on because 16 levels are too few"));
  BoundsAndExponents rising = above;
  rising.bounds.back() = "1.816";
  CHECK(exponents_finding({rising}).starts_with("Tables 1 and 2 print bounds; the exponents"));
  rising.bounds[2] = "1.776";
  CHECK_FALSE(mentions(exponents_finding({above, rising}), "fall from"));
}

TEST_CASE("the sentence about Conjecture 7 follows the rates") {
  const auto sentence = [](int maximum, int slope) {
    return conjecture_7_finding({{falling(1, maximum)}, {falling(2, slope)}});
  };
  CHECK(mentions(sentence(1, 4), "max psi ~ 1/n, holds"));
  CHECK(mentions(sentence(1, 4), "true as an upper bound, which is what Theorem 6 claims, and false as a rate"));
  CHECK(mentions(sentence(1, 2), "and true as a rate"));
  CHECK(mentions(sentence(1, 1), "not even true as an upper bound"));
  CHECK(mentions(sentence(3, 2), "is against what is certified"));
  CHECK(mentions(conjecture_7_finding({}), "is not decided by what is certified"));
  // One degree is enough to spoil it.
  CHECK(ConjectureDecay{{falling(1, 1), falling(1, 3)}, {}}.first_half() == Truth::no);
}

TEST_CASE("the sentence about the theorems counts those that are proved") {
  CHECK(mentions(theorems_sentence({{"a", Truth::yes}, {"b", Truth::yes}}), "All 2 theorems below are proved"));
  const std::string one_fails = theorems_sentence({{"a, d = 1", Truth::no}, {"b", Truth::yes}, {"c", Truth::unknown}});
  CHECK(mentions(one_fails, "Of 3 theorems 1 are proved; not so: a, d = 1 (an inequality fails), c (not decided)."));
}

TEST_CASE("the sentence about levels says what the bounds do") {
  const Rational unit(1, 1000);
  const std::string both = levels_sentence({Rational(1, 100), "primal:n=10", 3, 30}, unit);
  CHECK(mentions(both, "still rise by up to 0.0100 (primal:n=10)"));
  CHECK(mentions(both, "of 30 steps from one level to the next, 3 go down"));
  const std::string neither = levels_sentence({unit, "primal:n=10", 0, 30}, unit);
  CHECK(mentions(neither, "no bound of these schemes rises by more than a unit of the last printed place"));
  CHECK(mentions(neither, "None of 30 steps from one level to the next goes down"));
}

TEST_CASE("the sentences about a recipe say what it does") {
  CHECK(recipe_finding({42, 44, true, Truth::yes, Truth::yes}) ==
        "One truncated sum agrees with 42 of the 44 numbers of the table.");
  CHECK(mentions(recipe_finding({40, 44, false, Truth::yes, Truth::yes}), "One numerical recipe agrees with 40"));
  CHECK(mentions(truncation_sentence({42, 44, true, Truth::yes, Truth::yes}),
                 "does not raise the maxima of psi, and adds a slope that psi does not have"));
  CHECK(mentions(truncation_sentence({42, 44, true, Truth::no, Truth::no}),
                 "raises some of the maxima of psi, and adds no slope"));
  CHECK(truncation_sentence({42, 44, false, Truth::yes, Truth::yes}).empty());
}
