#include <subcert/analysis/family/limit_of_levels.hpp>
#include <subcert/analysis/family/local_levels.hpp>
#include <subcert/analysis/family/property_of_levels.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/parametric_specification.hpp>

using namespace subcert;
using subcert::testing::Random;
using subcert::testing::rounds;

namespace {

constexpr const char* conic = "mask:[-1,0,1+4*v+4*v^2,8*v+8*v^2,1+4*v+4*v^2,0,-1]/(8*v+8*v^2)";
// With w = 0 and with w = 1, its mirror image, it converges; in turn they do not.
constexpr const char* mirrored = "mask:[-1/2+7/5*w,1/10+7/5*w,3/2-7/5*w,9/10-7/5*w]";

PropertyOfLevels levels_of(const char* scheme, const char* property, const Rational& low, const Rational& high) {
  return property_of_levels(make_parametric_scheme(scheme).mask, *parse_range_property(property), {{low}, {high}},
                            {Deadline::in(30)});
}

Interval interval(const Rational& low, const Rational& high) { return {low, high}; }

}  // namespace

TEST_CASE("levels: intervals all of whose sequences have a property") {
  struct Known {
    const char *scheme, *property;
    Rational low, high;
  };
  for (const Known& known : {Known{"four-point:w", "C1", Rational(1, 1000), Rational(19, 100)},
                             {"ternary-four-point:w", "C2", Rational(67, 1000), Rational(111, 1000)},
                             {"dual-four-point:w", "C2", Rational(1, 1000), Rational(21, 1000)},
                             {"six-point:w", "C2", Rational(1, 200), Rational(44, 1000)},
                             {conic, "C1", Rational(9, 20), 1000}}) {
    INFO(known.scheme);
    const PropertyOfLevels levels = levels_of(known.scheme, known.property, known.low, known.high);
    CHECK(levels.holds == Truth::yes);
    REQUIRE(levels.above);
    CHECK(levels.period.empty());
    CHECK(levels.reason.empty());
  }
  // Each half has the property, the whole is not proved to have it.
  const PropertyOfLevels open = levels_of("six-point:w", "C3", Rational(13, 1000), Rational(16, 1000));
  CHECK(open.holds == Truth::unknown);
  CHECK_FALSE(open.reason.empty());
  CHECK_FALSE(open.above);
}

TEST_CASE("levels: a sequence without the property") {
  const PropertyOfLevels constant = levels_of("four-point:w", "C1", Rational(1, 100), Rational(1, 4));
  CHECK(constant.holds == Truth::no);
  CHECK(constant.period == std::vector<Values>{{Rational(1, 4)}});
  // At the threshold itself: the hat function.
  const PropertyOfLevels hat = levels_of("four-point:w", "C1", 0, Rational(1, 8));
  CHECK(hat.holds == Truth::no);
  CHECK(hat.period == std::vector<Values>{{0}});
  const PropertyOfLevels in_turn = levels_of(mirrored, "convergent", 0, 1);
  CHECK(in_turn.holds == Truth::no);
  CHECK(in_turn.period == std::vector<Values>{{0}, {1}});
  CHECK(levels_of(mirrored, "convergent", 0, Rational(1, 10)).holds == Truth::yes);
  // As many derivatives as sum rules: none of the masks has them.
  CHECK(levels_of("four-point:w", "C2", Rational(1, 32), Rational(1, 16)).holds == Truth::no);
  CHECK(levels_of("four-point:w", "C4", Rational(1, 32), Rational(3, 32)).holds == Truth::no);
}

TEST_CASE("levels: each value has what all sequences have") {
  Random random;
  int proved = 0;
  for (int round = 0; round < 12; ++round) {
    const Rational low(random.integer(-20, 30), 100), high = low + Rational(random.integer(1, 12), 100);
    const PropertyOfLevels levels = levels_of("four-point:w", "C1", low, high);
    const ParametricMask mask = make_parametric_scheme("four-point:w").mask;
    for (const Rational& share : {Rational(0), Rational(2, 7), Rational(1)}) {
      const auto at = holder_regularity(mask.at(low + share * (high - low)), 8, {Deadline::in(10)});
      if (levels.holds == Truth::yes) CHECK(*at.proved_exponent().lower > 1);
    }
    if (levels.holds == Truth::no)
      CHECK(*holder_regularity(mask.at(levels.period.front()), 8, {Deadline::in(10)}).exponent.upper <= 1);
    proved += levels.holds == Truth::yes;
  }
  CHECK(proved > 0);
}

TEST_CASE("levels: exponents over boxes that grow") {
  const ParametricMask mask = make_parametric_scheme("four-point:w").mask;
  const auto growing = exponents_of_levels(mask, {{Rational(1, 32)}, {Rational(1, 8)}}, {Rational(5, 64)}, {4, 2, {}});
  REQUIRE(growing.size() == 4);
  CHECK(growing.back().box.low[0] == Rational(1, 32));
  for (std::size_t k = 0; k < growing.size(); ++k) {
    const Enclosure& exponent = growing[k].exponent;
    REQUIRE(exponent.is_bounded());
    CHECK(*exponent.lower <= *exponent.upper);
    CHECK(*exponent.upper - *exponent.lower < Rational(1, 100));
    if (k > 0) CHECK(*exponent.upper < *growing[k - 1].exponent.upper);
  }
  // No box with a point where the scheme diverges is said to converge.
  for (const auto& one : exponents_of_levels(mask, {{0}, {2}}, {Rational(1, 16)}, {3, 1, {}}))
    CHECK((*one.box.high.begin() < Rational(1, 2) || !one.exponent.lower || *one.exponent.lower <= 0));
}

TEST_CASE("levels: what is refused") {
  const ParametricMask mask = make_parametric_scheme("four-point:w").mask;
  const auto ask = [&](const char* property, const Box& box) {
    return property_of_levels(mask, *parse_range_property(property), box, {Deadline::in(1)});
  };
  CHECK_THROWS_AS(ask("stable", {{0}, {1}}), Error);
  CHECK_THROWS_AS(ask("sobolev>=1", {{0}, {1}}), Error);
  CHECK_THROWS_AS(ask("C1", {{1}, {1}}), Error);
  CHECK_THROWS_AS(ask("C1", {{0, 0}, {1, 1}}), Error);
  CHECK_THROWS_AS(exponents_of_levels(mask, {{0}, {1}}, {2}, {}), Error);
  CHECK_THROWS_AS(exponents_of_levels(mask, {{0}, {1}}, {0}, {0, 1, {}}), Error);
  // Where the denominator vanishes nothing is proved.
  CHECK(levels_of(conic, "C1", Rational(-1, 2), 1).holds != Truth::yes);
}

TEST_CASE("recurrences: images") {
  const Recurrence halves = Recurrence::parse("w=w/2+1", "w", 'w'), square = Recurrence::parse("w=2*w^2-1", "w", 'w'),
                   root = Recurrence::parse("w=sqrt((1+w)/2)", "w", 'w'),
                   quotient = Recurrence::parse("w=1/w", "w", 'w');
  const auto is = [](const std::optional<Interval>& found, const Rational& low, const Rational& high) {
    return found && found->lower == low && found->upper == high;
  };
  CHECK(is(halves.image(interval(-2, 4)), 0, 3));
  CHECK(is(halves.image(interval(5, 5)), Rational(7, 2), Rational(7, 2)));
  CHECK(is(root.image(interval(-1, 7)), 0, 2));
  CHECK_FALSE(root.image(interval(-2, 7)));
  CHECK(is(Recurrence::parse("w=0*w", "w", 'w').image(interval(2, 4)), 0, 0));
  CHECK(is(Recurrence::parse("w=1/16", "w", 'w').image(interval(2, 4)), Rational(1, 16), Rational(1, 16)));
  CHECK(is(quotient.image(interval(2, 4)), Rational(1, 4), Rational(1, 2)));
  CHECK_FALSE(quotient.image(interval(-1, 4)));
  CHECK_FALSE(quotient.image(interval(0, 0)));
  const auto parabola = square.image(interval(-1, 1));
  REQUIRE(parabola);
  CHECK(parabola->lower <= -1);
  CHECK(parabola->lower > Rational(-101, 100));
  CHECK(parabola->upper == 1);
  for (const char* bad : {"", "w", "v=w", "w=", "w=sqrt(", "w=sqrt()", "w=sin(w)", "w=w+v", "w=sqrt(sqrt(w))"})
    CHECK_THROWS_AS(Recurrence::parse(bad, "w", 'w'), ParseError);
}

TEST_CASE("recurrences: the way of values into an interval where they stay") {
  const Recurrence root = Recurrence::parse("w=sqrt((1+w)/2)", "w", 'w'), same = Recurrence::parse("w=w", "w", 'w');
  const Interval kept{Rational(9, 20), 1000};
  const auto levels = [&](const Recurrence& recurrence, const FirstValues& start, int most) {
    const auto way = recurrence.way_into(kept, start, most);
    return way ? static_cast<int>(way->size()) : -1;
  };
  CHECK(levels(root, {interval(-1, 1000000)}, 100) == 2);
  CHECK(levels(root, {interval(1, 1)}, 0) == 0);
  CHECK(levels(root, {interval(0, 0)}, 100) == 1);
  CHECK(levels(root, {interval(0, 0)}, 0) == -1);
  CHECK(levels(root, {interval(-2, 1)}, 100) == -1);
  // It leads out of the interval, or never into it.
  CHECK(levels(Recurrence::parse("w=2*w^2-1", "w", 'w'), {interval(1, 2)}, 100) == -1);
  CHECK(levels(same, {interval(0, 1)}, 100) == -1);
  CHECK(levels(same, {interval(1, 2)}, 100) == 0);
  // Each interval holds what the one before leads to.
  const auto way = root.way_into(kept, {interval(-1, 1000000)}, 100);
  const double first = way->front().upper.convert_to<double>(), last = way->back().lower.convert_to<double>();
  CHECK((first > 707.1 && first < 707.2 && last > 0.7071 && last < 0.70711));
  CHECK(way->back().upper * way->back().upper >= (1 + way->front().upper) / 2);
}

TEST_CASE("recurrences: first values without an end") {
  const Interval kept{Rational(9, 20), 1000};
  const auto arrives = [&](const char* rule, int low) {
    return Recurrence::parse(rule, "w", 'w').way_into(kept, {interval(low, low), true}, 100).has_value();
  };
  CHECK(arrives("w=sqrt((1+w)/2)", -1));
  CHECK(arrives("w=(1+w)/2", 0));
  CHECK(arrives("w=(1+w^2)/(2+w+w^2)", 0));
  // Too slowly, not at all, below the interval, past a pole, from above the interval alone.
  CHECK_FALSE(arrives("w=w*19/20+1", 1));
  CHECK_FALSE(arrives("w=w", 1));
  CHECK_FALSE(arrives("w=600-w/2", 1));
  CHECK_FALSE(arrives("w=2000/(2001-w)", 1));
  CHECK_FALSE(arrives("w=sqrt((1+w)/2)", 1001));
  CHECK_FALSE(arrives("w=sqrt(w^2*82/100+1)", 1));
}

TEST_CASE("recurrences: in the form of certificates") {
  const auto text = [](const char* rule) { return Recurrence::parse(rule, "w", 'w').to_text('w'); };
  CHECK(text("w=sqrt((1+w)/2)") == "sqrt[1/2+1/2*w]");
  CHECK(text("w=w") == "[w]");
  CHECK(text("w=(1+w^2)/(2+w)") == "[1+w^2]/(2+w)");
}

TEST_CASE("recurrences: the number to which values tend") {
  const auto limit = [](const char* text, const Rational& low, const Rational& high) {
    const auto found = Recurrence::parse(text, "w", 'w').limit_in({low, high});
    return found ? std::optional(found->value) : std::nullopt;
  };
  CHECK(limit("w=sqrt((1+w)/2)", Rational(9, 20), 1000) == 1);
  CHECK(limit("w=sqrt((1+w)/2)", -1, 1) == 1);  // not steeper than 1 after some steps
  CHECK(limit("w=w/2+1", -9, 5) == 2);
  CHECK(limit("w=w/3", -1, 1) == 0);
  CHECK(limit("w=-w/2", -1, 1) == 0);
  CHECK(limit("w=1/16", 0, 1) == Rational(1, 16));
  CHECK(limit("w=sqrt(w)", Rational(1, 4), 4) == 1);
  CHECK(limit("w=(w+2/w)/2", 1, 2) == std::nullopt);  // the root of 2
  CHECK(limit("w=w", 0, 1) == std::nullopt);
  CHECK(limit("w=1-w", 0, 1) == std::nullopt);      // 0, 1, 0, 1, ...
  CHECK(limit("w=w^2", 0, 1) == std::nullopt);      // 1 stays 1
  CHECK(limit("w=sqrt(w)", 0, 4) == std::nullopt);  // 0 stays 0
  CHECK(limit("w=2*w", 1, 2) == std::nullopt);      // not into itself
  CHECK(Recurrence::parse("w=sqrt((1+w)/2)", "w", 'w').halves_angles());
  CHECK(Recurrence::parse("mu=sqrt(1/2+mu/2)", "mu", 'm').halves_angles());
  for (const char* other : {"w=(1+w)/2", "w=sqrt((1+w)/3)", "w=sqrt((2+w)/2)"})
    CHECK_FALSE(Recurrence::parse(other, "w", 'w').halves_angles());
}

namespace {

ExponentialSumRules rules_of(const char* scheme) { return exponential_sum_rules(make_parametric_scheme(scheme).mask); }

LimitOfLevels limit_of(const char* scheme, const char* recurrence = "w=sqrt((1+w)/2)") {
  const auto found = limit_of_levels(make_parametric_scheme(scheme).mask, Recurrence::parse(recurrence, "w", 'w'),
                                     {Rational(1, 2), 2}, {Deadline::in(60)});
  REQUIRE(found);
  return *found;
}

}  // namespace

TEST_CASE("levels: exponentials that a symbol generates") {
  CHECK(rules_of("four-point:w") == ExponentialSumRules{2, {}});
  CHECK(rules_of("conic-four-point:w") == ExponentialSumRules{2, {1}});
  CHECK(rules_of("exponential-six-point:w") == ExponentialSumRules{2, {2}});
  CHECK(rules_of("exponential-bspline:w") == ExponentialSumRules{2, {1}});
  CHECK(rules_of("exponential-six-point:w").order() == 6);
  // The double angle: cos(2t) = 2 w^2 - 1.
  CHECK(rules_of("symbol:2*((1+z)/2)*((1+2*w*z+z^2)/(2+2*w))^3*((1+2*(2*w^2-1)*z+z^2)/(4*w^2))") ==
        ExponentialSumRules{1, {3, 1}});
  CHECK(rules_of("symbol:(1+z)*((1+2*(2*w^2-1)*z+z^2)/(4*w^2))") == ExponentialSumRules{1, {0, 1}});
  CHECK(rules_of("symbol:(1+z)*((1-2*w*z+z^2)/(2-2*w))") == ExponentialSumRules{1, {}});
  CHECK_THROWS_AS(rules_of("ternary-four-point:w"), Error);
  CHECK_THROWS_AS(rules_of("merrien:lambda=-1/8,mu"), Error);
}

TEST_CASE("levels: the exponent where values tend to a number") {
  const LimitOfLevels conic_limit = limit_of("conic-four-point:w");
  CHECK(conic_limit.value == 1);
  CHECK(conic_limit.exponent.sum_rules == 4);
  CHECK(conic_limit.exponent.exact.is_yes());
  CHECK(conic_limit.exponent.exponent.contains(2));
  // [CCGP17]: without the exponentials no more than 2 would be proved.
  const LimitOfLevels six = limit_of("exponential-six-point:w");
  CHECK(six.exponent.sum_rules == 6);
  CHECK(six.exponent.exact.is_yes());
  CHECK(*six.exponent.exponent.lower > Rational(283007, 100000));
  CHECK(*six.exponent.exponent.upper < Rational(283008, 100000));
  const Enclosure stationary = holder_regularity(make_scheme("dd:n=3").mask.curve(), 8, {Deadline::in(60)})
                                   .proved_exponent();
  CHECK(*six.exponent.exponent.lower <= *stationary.upper);
  CHECK(*stationary.lower <= *six.exponent.exponent.upper);
  // The spline of order 4 has the exponent 3 of the cubic one; with another recurrence its two sum rules prove 2.
  CHECK(limit_of("exponential-bspline:w").exponent.exponent.contains(3));
  const LimitOfLevels other = limit_of("exponential-bspline:w", "w=(1+2*w)/3");
  CHECK(other.exponent.sum_rules == 2);
  CHECK(other.exponent.exponent.lower == Rational(2));
  CHECK_FALSE(other.exponent.exponent.upper);
  CHECK_FALSE(other.exponent.exact.is_yes());
  // It tends to a mask that does not converge: nothing is claimed.
  CHECK_FALSE(limit_of("four-point:w", "w=(w+1)/2").exponent.exponent.lower);
  CHECK_FALSE(limit_of_levels(make_parametric_scheme("four-point:w").mask, Recurrence::parse("w=w", "w", 'w'), {0, 1},
                              {Deadline::in(60)}));
}

TEST_CASE("levels: matrices of a value for each new point are what the rules do") {
  Random random;
  for (const char* name : {"four-point:w", "corner-cutting:w", "ternary-four-point:w", "mask:[w,1/2,1-w,1/2]",
                           "mask:[w,0,1-w,1]@-3", "mask:[w,1/3,1/3,1-w,2/3,2/3]@-2,arity=3"}) {
    const ParametricMask mask = make_parametric_scheme(name).mask;
    const Rational low(random.integer(-5, 5), 20), high = low + Rational(random.integer(1, 5), 20);
    const LocalLevels found = local_levels(mask, {{low}, {high}}, {Deadline::in(0.2)});
    const Mask ends[] = {mask.at({low}), mask.at({high})};
    const long arity = mask.arity(), order = found.order, first = mask.support().first;
    const auto width = static_cast<long>(found.family.size());
    std::vector<Rational> data;
    for (long j = 0; j < 4 * width + 8 * order + 60; ++j) data.emplace_back(random.integer(-9, 9));
    const auto old = [&](long j) { return data[static_cast<std::size_t>(j + static_cast<long>(data.size()) / 2)]; };
    const auto at = [](const Mask& a, long i) { return a.symbol().coefficient(i); };
    const auto difference = [&](const auto& values, long n) {
      Rational sum = 0, factor = 1;
      for (long j = 0; j <= order; factor *= Rational(j - order, j + 1), ++j) sum += factor * values(n - j);
      return sum;
    };
    std::size_t count = 0;
    for (long t = 0; t < arity; ++t) {
      std::vector<long> free;
      for (long q = 0; q < width + order; ++q)
        for (long i = mask.support().first, class_of = modulo(first + t - q, arity); i <= mask.support().last; ++i)
          if (modulo(i, arity) == class_of && at(ends[0], i) != at(ends[1], i)) {
            free.push_back(q);
            break;
          }
      for (std::size_t choice = 0; choice < std::size_t{1} << free.size(); ++choice, ++count) {
        const RationalMatrix& matrix = found.family[count];
        const auto fresh = [&](long m) {  // of the level after it, with the end that is chosen there
          const auto digit = static_cast<std::size_t>(std::ranges::find(free, t - m) - free.begin());
          const Mask& a = ends[digit < free.size() ? choice >> digit & 1 : 0];
          Rational sum = 0;
          for (long i = mask.support().first; i <= mask.support().last; ++i)
            if (modulo(first + m - i, arity) == 0) sum += at(a, i) * old((first + m - i) / arity);
          return sum;
        };
        for (long k = 0; k < width; ++k) {
          Rational sum = 0;
          for (long i = 0; i < width; ++i) {
            const auto row = static_cast<std::size_t>(found.transposed ? width - 1 - k : i),
                       column = static_cast<std::size_t>(found.transposed ? width - 1 - i : k);
            sum += difference(old, -i) * matrix(row, column);
          }
          REQUIRE(sum == power(Rational(arity), static_cast<int>(order)) * difference(fresh, t - k));
        }
      }
    }
    CHECK(count == found.family.count());
  }
}

TEST_CASE("levels: a value for each new point") {
  const auto local = [](const char* scheme, const Rational& low, const Rational& high, double seconds = 60) {
    return local_levels(make_parametric_scheme(scheme).mask, {{low}, {high}}, {Deadline::in(seconds)});
  };
  const LocalLevels four = local("four-point:w", Rational(1, 1000), Rational(3, 20));
  CHECK(four.order == 2);
  CHECK(four.family.count() == 16);
  CHECK(four.family.size() == 4);
  CHECK(*four.exponent.lower > Rational(10058, 10000));
  CHECK(*four.exponent.upper < Rational(10059, 10000));
  CHECK(local("six-point:w", Rational(1, 100), Rational(1, 99), 0.1).order == 4);
  CHECK(local("corner-cutting:w", Rational(1, 5), Rational(1, 4), 0.1).order == 1);
  CHECK(local("ternary-four-point:w", Rational(1, 12), Rational(1, 11), 0.1).order == 3);
  // By columns a polytope closes at once, by rows it has many vertices.
  const LocalLevels corner = local("corner-cutting:w", Rational(1, 5), Rational(3, 10), 30);
  CHECK(*corner.exponent.lower > Rational(73696, 100000));
  CHECK_FALSE(corner.transposed);
  CHECK(corner.radius.vertices() <= 4);
  // Where all values are alike it is the exponent of that scheme, as the matrices are. Here a polytope is by rows.
  const LocalLevels alike = local("four-point:w", Rational(1, 16), Rational(1, 16) + power(Rational(2), -40), 2);
  CHECK(*alike.exponent.lower > Rational(19, 10));
  // One value everywhere is among the choices.
  Random random;
  for ([[maybe_unused]] const auto round : rounds(4)) {
    const Rational low(random.integer(-10, 10), 40), high = low + Rational(random.integer(1, 10), 40);
    const LocalLevels found = local("four-point:w", low, high, 1);
    if (found.exponent.lower && found.exponent.upper) CHECK(*found.exponent.lower <= *found.exponent.upper);
  }
  CHECK_THROWS_AS(local("conic-four-point:w", 1, 2), Error);
  CHECK_THROWS_AS(local("mask:[w^2,1-w^2,1-w^2,w^2]", 0, 1), Error);
}
