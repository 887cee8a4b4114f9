// Lists of masks of matrices: one mask, masks of numbers in pairs, Merrien's schemes, Hermite lists.

#include <subcert/analysis/family/mask_list.hpp>
#include <subcert/analysis/family/named_exponent.hpp>
#include <subcert/analysis/family/property_of_levels.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/parametric_specification.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

using namespace subcert;

namespace {

const Budget a_minute{Deadline::in(60)};

LatticeMask vector_mask(const std::string& text) { return make_refinable_scheme(text).mask; }
LatticeMask merrien(const Rational& mu) { return vector_mask(fmt::format("merrien:lambda=-1/8,mu={}", to_text(mu))); }
MaskList hermite_list(std::vector<LatticeMask> masks) { return {std::move(masks), {}, {}, {}, true}; }

/// A scheme of numbers of arity a on pairs of neighbours.
LatticeMask on_pairs(const LatticeMask& numbers) {
  const LaurentPolynomial& symbol = numbers.curve().symbol();
  std::vector<LatticeMask::Term> terms;
  for (long k = symbol.lowest() - 3; k <= symbol.highest() + 3; ++k)
    for (long to = 0; to < 2; ++to)
      for (long from = 0; from < 2; ++from)
        if (const Rational x = symbol.coefficient(2 * k + to - numbers.arity() * from); x != 0)
          terms.push_back({{k}, static_cast<std::size_t>(from), static_cast<std::size_t>(to), x});
  return matrix_mask(terms, 2, numbers.dilation());
}

bool are_near(const std::optional<Rational>& x, const std::optional<Rational>& y, const char* width = "1e-9") {
  return x && y && abs(*x - *y) < Rational(parse_number(width).value());
}

RangeProperty property(const char* text) { return *parse_range_property(text); }

}  // namespace

TEST_CASE("lists of matrices: one mask, or the same one twice, has the exponent of its functions") {
  for (const char* one : {"merrien:lambda=-1/8,mu=1/2", "merrien:lambda=-1/8,mu=-3/4", "hermite-dd:points=4,order=2",
                          "ghm", "bspline:degree=3,multiplicity=2", "hermite-dd:points=2,order=3"}) {
    INFO(one);
    const LatticeMask mask = vector_mask(one);
    const MultivariateRegularity alone = vector_regularity(mask, a_minute);
    for (const MaskList& list : {MaskList{{mask}},
                                 {{mask, mask}},
                                 {{mask}, {0, 0}, {}},
                                 {{mask, mask}, {1, 0}, {}},
                                 {{mask, mask}, {}, {{0, 1}, {1, 0}}}}) {
      const ExponentOfList found = exponent_of(list, a_minute);
      CHECK(found.exact.is_yes() == alone.exact.is_yes());
      CHECK(are_near(found.exponent.lower, alone.exponent.lower));
      CHECK(are_near(found.exponent.upper, alone.exponent.upper));
    }
  }
}

TEST_CASE("lists of matrices: levels as one are the levels one after the other") {
  subcert::testing::Random random;
  for (int round = 0; round < 10; ++round) {
    const int arity = round % 2 == 0 ? 2 : 3;
    std::vector<LatticeMask> levels;
    for (int level = 0; level < 2; ++level) {
      std::vector<LatticeMask::Term> terms;
      for (long k = -1; k <= 2; ++k)
        for (std::size_t i = 0; i < 4; ++i) terms.push_back({{k}, i / 2, i % 2, Rational(random.integer(-5, 6), 3)});
      terms.push_back({{0}, 0, 0, Rational(100)});
      levels.push_back(matrix_mask(terms, 2, Dilation::multiple(1, arity)));
    }
    // f'_i = sum over j of P_{i-aj} f_j with P transposed, on a unit datum.
    std::map<LatticePoint, Rational> data{{{0, 1}, 1}};
    for (const LatticeMask& mask : levels) {
      std::map<LatticePoint, Rational> next;
      for (const auto& [point, value] : data)
        for (const LatticeMask::Term& term : mask.terms())
          if (static_cast<long>(term.row) == point[1])
            next[{arity * point[0] + term.exponents[0], static_cast<long>(term.column)}] += term.coefficient * value;
      data = std::move(next);
    }
    std::erase_if(data, [](const auto& entry) { return entry.second == 0; });
    std::map<LatticePoint, Rational> row;
    for (const LatticeMask::Term& term : levels_as_one(levels).terms())
      if (term.row == 1) row[{term.exponents[0], static_cast<long>(term.column)}] = term.coefficient;
    CHECK(row == data);
  }
}

TEST_CASE("lists of matrices: masks of numbers on pairs tell what the masks tell, wherever they stand") {
  subcert::testing::Random random;
  for (int round = 0; round < 12; ++round) {
    const int arity = round % 3 == 2 ? 3 : 2;
    std::vector<LatticeMask> numbers, pairs;
    for (int k = 0; k < 2; ++k) {
      // Two or three sum rules, and another factor; shifts do not matter.
      const LaurentPolynomial smoothing = arity == 2
                                              ? LaurentPolynomial({Rational(1, 2), Rational(1, 2)}, 0)
                                              : LaurentPolynomial({Rational(1, 3), Rational(1, 3), Rational(1, 3)}, 0);
      const Rational t(random.integer(-3, 5), 8);
      LaurentPolynomial symbol = LaurentPolynomial({arity * (1 - t), arity * t}, random.integer(-2, 2));
      for (long m = random.integer(2, 3); m > 0; --m) symbol *= smoothing;
      numbers.emplace_back(Mask(symbol, arity));
      pairs.push_back(on_pairs(numbers.back()));
    }
    const MaskList orders[] = {{numbers}, {numbers, {0, 1}, {}}, {numbers, {}, {{0, 1}, {1, 0}, {1, 1}}}};
    for (const MaskList& list : orders) {
      INFO(list.masks.front().curve().symbol().to_mask_text()
           << " " << list.masks.back().curve().symbol().to_mask_text() << " " << list.period.size()
           << list.follows.size());
      const ExponentOfList of_numbers = exponent_of(list, a_minute),
                           of_pairs = exponent_of({pairs, list.period, list.follows}, a_minute);
      CHECK(of_pairs.sum_rules == of_numbers.sum_rules);
      CHECK(of_pairs.exponent.lower.has_value() == of_numbers.exponent.lower.has_value());
      if (!of_numbers.exponent.lower) continue;
      if (of_numbers.exact.is_yes() || list.period.empty())
        CHECK(are_near(of_pairs.exponent.lower, of_numbers.exponent.lower));
      if (of_numbers.exponent.upper && of_pairs.exponent.upper) {
        CHECK(*of_pairs.exponent.upper >= *of_numbers.exponent.lower);
        CHECK(*of_numbers.exponent.upper >= *of_pairs.exponent.lower);
      }
      if (of_numbers.exact.is_yes() && of_pairs.exact.is_yes())
        CHECK(are_near(of_pairs.exponent.upper, of_numbers.exponent.upper));
    }
  }
}

TEST_CASE("lists of matrices: Merrien's schemes at the ends of a range bound what all between them do") {
  subcert::testing::Random random;
  const ParametricMask family = make_parametric_scheme("merrien:lambda=-1/8,mu").mask;
  for (int round = 0; round < 6; ++round) {
    const Rational low(random.integer(-20, 4), 9), high = low + Rational(random.integer(1, 9), 7);
    INFO(to_text(low) << " " << to_text(high));
    const MaskList ends = hermite_list({merrien(low), merrien(high)});
    const ExponentOfList found = exponent_of(ends, a_minute);
    if (found.sum_rules != sum_rules(family)) continue;  // a value with one more at both ends
    const Box box{{low}, {high}};
    const auto range = exponents_of_levels(family, box, {low}, {1, 1, a_minute}).front();
    CHECK(range.exponent.lower.has_value() == (found.exponent.lower && *found.exponent.lower > 0));
    if (range.exponent.lower && found.exponent.lower)
      CHECK(are_near(range.exponent.lower, found.vectors->decay, "1e-5"));
    const PropertyOfLevels all = property_of_levels(family, property("HC1"), box, a_minute);
    if (all.holds == Truth::yes) CHECK(holds(found, property("HC1")) == Truth::yes);
    if (holds(found, property("HC1")) == Truth::no) CHECK(all.holds != Truth::yes);
  }
}

TEST_CASE("lists of matrices: orders of levels, and what is exact") {
  const ExponentOfList any = exponent_of(hermite_list({merrien(Rational(1, 2)), merrien(Rational(-1, 2))}), a_minute);
  CHECK(any.exact.is_yes());
  CHECK(any.vectors->alone == std::vector<int>{3, 4});
  CHECK(any.sum_rules == 3);
  CHECK(any.exponent.lower->convert_to<double>() == Approx(1.4150374993));
  CHECK(holds(any, property("HC1")) == Truth::yes);
  CHECK(holds(any, property("HC2")) == Truth::no);
  CHECK(holds(any, property("holder>=7/5")) == Truth::yes);
  // The one that is not HC1 alone never twice in a row.
  MaskList graph = hermite_list({merrien(Rational(3, 2)), merrien(Rational(-1, 2))});
  graph.follows = {{0, 1}, {1, 0}, {1, 1}};
  const ExponentOfList found = exponent_of(graph, a_minute);
  CHECK(found.exact.is_yes());
  CHECK(found.sequence == std::vector<std::size_t>{0, 1});
  CHECK(found.exponent.lower->convert_to<double>() == Approx(3 - std::log2(5) / 2));
  CHECK(holds(found, property("HC1")) == Truth::yes);
  const auto named = named_exponent(found);
  REQUIRE(named);
  CHECK(named->rules == 3);
  graph.follows.clear();
  CHECK(holds(exponent_of(graph, a_minute), property("HC1")) == Truth::no);
  graph.period = {0, 1};
  const ExponentOfList turn = exponent_of(graph, a_minute);
  CHECK(turn.exponent.lower->convert_to<double>() == Approx(3 - std::log2(5) / 2));
  CHECK(holds(turn, property("HC1")) == Truth::yes);
  CHECK(holds(turn, property("HC2")) == Truth::no);
  // Schemes that are no mirror images: the cycle as a graph and as a period, and the other way round.
  const LatticeMask moved = on_pairs(Mask(LaurentPolynomial({Rational(27, 40), 1, Rational(13, 40)}, 0) *
                                              LaurentPolynomial({Rational(1, 2), Rational(1, 2)}, 0),
                                          2)),
                    dd = on_pairs(make_scheme("dd:n=2").mask), spline = on_pairs(make_scheme("bspline:degree=3").mask);
  const auto lower = [&](const MaskList& list) { return exponent_of(list, a_minute).exponent.lower; };
  const std::vector<LatticeMask> masks{moved, dd, spline};
  CHECK(are_near(lower({masks, {0, 1, 2}, {}}), lower({masks, {}, {{0, 1}, {1, 2}, {2, 0}}}), "1e-6"));
  CHECK(are_near(lower({masks, {0, 2, 1}, {}}), lower({masks, {}, {{1, 0}, {2, 1}, {0, 2}}}), "1e-6"));
}

TEST_CASE("lists of matrices: data in common, and what is refused") {
  // Both keep constants, ghm two polynomials and the spline four, with other data for x.
  const ExponentOfList differ = exponent_of({{vector_mask("ghm"), vector_mask("bspline:degree=3,multiplicity=2")}},
                                            a_minute);
  CHECK(differ.sum_rules == 1);
  CHECK(differ.vectors->alone == std::vector<int>{2, 4});
  CHECK_FALSE(differ.vectors->keeps_derivatives);
  CHECK(holds(differ, property("HC1")) == Truth::unknown);
  const LatticeMask hermite = merrien(0);
  for (const MaskList& list :
       {MaskList{{hermite, make_scheme("dd:n=2").mask}},
        {{hermite, vector_mask("hermite-dd:points=2,order=3")}},
        {{hermite, vector_mask("refinable:[[[1,0],[0,1]],[[1,0],[0,1]],[[1,0],[0,1]]]@0,arity=3")}},
        {{hermite, vector_mask("vector:[[[1/2,0],[0,1]],[[1/2,0],[0,1]]]@0")}},
        {{hermite}, {1}, {}},
        {{hermite}, std::vector<std::size_t>(7, 0), {}},
        {{make_linear_scheme("loop").mask}}})
    CHECK_THROWS_AS(exponent_of(list, a_minute), Error);
  CHECK_THROWS_AS(require_property({{make_scheme("dd:n=2").mask}}, property("HC1")), Error);
  CHECK_THROWS_AS(require_property({{hermite}}, property("HC1")), Error);
  CHECK_THROWS_AS(require_property(hermite_list({vector_mask("hermite-dd:points=2,order=3")}), property("HC1")), Error);
  CHECK_NOTHROW(require_property(hermite_list({hermite}), property("HC1")));
  // One that diverges: no end is proved, and HC1 is refuted where it is the one that leads.
  const ExponentOfList diverges = exponent_of(hermite_list({merrien(9), merrien(0)}), a_minute);
  CHECK_FALSE(diverges.exponent.lower);
  CHECK(holds(diverges, property("convergent")) != Truth::yes);
}
