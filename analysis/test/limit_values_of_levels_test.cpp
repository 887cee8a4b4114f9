#include <subcert/analysis/family/limit_values_of_levels.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/cmake/random.hpp>
#include <subcert/schemes/parametric_specification.hpp>

#include <cmath>
#include <numbers>

using namespace subcert;
using subcert::testing::Random;

namespace {

constexpr const char* halved_angle = "v=sqrt((1+v)/2)";

Recurrence recurrence_of(const char* written, char letter = 'v') {
  return Recurrence::parse(written, std::string_view(written).substr(0, 1), letter);
}

ParametricMask family_mask(const char* specification) { return make_parametric_scheme(specification).mask; }
LatticeMask lattice_mask(const char* specification) { return make_scheme(specification).mask; }

Rational limit_at(const LimitValues& values, const Rational& x) {
  const Rational index = x * power(Rational(values.arity), values.level);
  REQUIRE(denominator(index) == 1);
  return values.at(numerator(index).convert_to<long>());
}

Interval limit_at(const EnclosedLimitValues& values, long index) {
  const long place = index - values.first_index;
  if (place < 0 || place >= static_cast<long>(values.values.size())) return Interval::exactly(0);
  return values.values[static_cast<std::size_t>(place)];
}

double middle_of(const Interval& value) { return Rational((value.lower + value.upper) / 2).convert_to<double>(); }

/// Sum over j of cos(theta j) phi((index / 2^level) - j), in doubles.
double generated_at(const EnclosedLimitValues& values, double theta, long index) {
  double sum = 0;
  for (long j = -20; j <= 20; ++j)
    sum += std::cos(theta * static_cast<double>(j)) * middle_of(limit_at(values, index - (j << values.level)));
  return sum;
}

}  // namespace

TEST_CASE("recurrences: their values") {
  const auto exact = recurrence_of("w=w/2+1/32", 'w').values(Rational(1, 20), 3);
  REQUIRE(exact.size() == 3);
  CHECK(exact[0] == Interval::exactly(Rational(1, 20)));
  CHECK(exact[2] == Interval::exactly(Rational(19, 320)));
  const auto cosines = recurrence_of(halved_angle).values(Rational(1, 2), 40);
  for (std::size_t k = 0; k < cosines.size(); ++k) {
    const double expected = std::cos(std::numbers::pi / 3 * std::pow(0.5, k));
    CHECK(middle_of(cosines[k]) == Approx(expected).epsilon(1e-15));
    CHECK(cosines[k].width() < Rational(1, Integer(1) << 120));
    if (k > 0)
      CHECK((2 * cosines[k].lower * cosines[k].lower - 1 <= cosines[k - 1].upper &&
             2 * cosines[k].upper * cosines[k].upper - 1 >= cosines[k - 1].lower));
  }
  CHECK_FAILS(recurrence_of("w=1/w", 'w').values(0, 2), domain);
  CHECK_FAILS(recurrence_of(halved_angle).values(-2, 2), domain);
  CHECK_FAILS(recurrence_of("v=v^2").values(2, 64), undecided);
  CHECK_FAILS(recurrence_of("v=2*v^2-1").values(Rational(1, 3), 5000), undecided);
  CHECK(recurrence_of(halved_angle).values(-2, 1).size() == 1);
  CHECK(recurrence_of(halved_angle).values(-2, 0).empty());
}

TEST_CASE("recurrences: an interval that holds all later values") {
  for (const char* one : {halved_angle, "v=1-v/2", "v=v", "v=v/2+1/32", "v=9*v/10", "v=1/(1+v)", "v=1/3"}) {
    const Recurrence step = recurrence_of(one);
    for (const Rational& start : {Rational(1, 2), Rational(3), Rational(1)}) {
      CAPTURE(one, start);
      const auto all = step.all_from(Interval::exactly(start));
      REQUIRE(all);
      for (const Interval& value : step.values(start, 60)) {
        CHECK(all->lower <= value.lower);
        CHECK(value.upper <= all->upper);
      }
      CHECK(step.image(*all)->lower >= all->lower);
      CHECK(step.image(*all)->upper <= all->upper);
    }
  }
  CHECK_FALSE(recurrence_of("v=2*v").all_from(Interval::exactly(1)));
  CHECK_FALSE(recurrence_of("v=v+1").all_from(Interval::exactly(1)));
  CHECK_FALSE(recurrence_of("v=1/v").all_from(Interval::exactly(0)));
}

TEST_CASE("masks of levels follow the recurrence") {
  const LevelMasks masks = masks_of_levels(family_mask("four-point:w"), recurrence_of("w=w/2", 'w'), Rational(1, 8), 3);
  REQUIRE(masks.first.size() == 3);
  CHECK(masks.again.empty());
  CHECK(masks.at(1) == lattice_mask("four-point:w=1/16"));
  CHECK_THROWS_AS(masks.at(3), Error);
  const ParametricMask conic = family_mask("conic-four-point:v");
  CHECK_FAILS(masks_of_levels(conic, recurrence_of("v=v-1/2"), 1, 4), domain);  // no mask for v = 0
  CHECK(masks_of_levels(conic, recurrence_of("v=v-1/2"), 1, 2).first.size() == 2);
  CHECK_FAILS(masks_of_levels(conic, recurrence_of("v=2*v^2-1"), Rational(1, 3), 5000), undecided);
}

TEST_CASE("limits of masks that come again: one mask, and several as one") {
  for (const char* one : {"dd:n=2", "dual:n=2", "bspline:degree=3,a=3", "mask:[1,3,3,1]/4@2", "primal-odd:n=2,d=2"}) {
    CAPTURE(one);
    const LatticeMask m = lattice_mask(one);
    for (const int level : {0, 1, 3}) {
      const LimitValues alone = limit_values(m.curve(), level);
      for (const LevelMasks& masks : {LevelMasks{{}, {m}}, LevelMasks{{}, {m, m}}, LevelMasks{{m, m, m, m, m}, {m}},
                                      LevelMasks{{m}, {m, m, m}}}) {
        const LimitValues found = limit_values(masks, level);
        CHECK(found.first_index == alone.first_index);
        CHECK(found.values == alone.values);
      }
    }
  }
  const LatticeMask a = lattice_mask("dd:n=2"), b = lattice_mask("bspline:degree=3");
  const LimitValues in_turn = limit_values(LevelMasks{{}, {a, b}}, 4),
                    as_one = limit_values(levels_as_one({a, b}).curve(), 2);
  for (long i = -60; i <= 60; ++i) CHECK(in_turn.at(i) == as_one.at(i));
  // phi_0(x) = sum over j of a_j phi_1(2x - j), whichever masks follow.
  const LevelMasks whole{{a, b, b}, {b, a}}, rest{{b, b}, {b, a}};
  const LimitValues finer = limit_values(whole, 2), coarser = limit_values(rest, 1);
  for (long i = finer.first_index; i < finer.first_index + static_cast<long>(finer.values.size()); ++i) {
    Rational sum = 0;
    for (const LatticeMask::Term& term : a.terms())
      sum += term.coefficient * limit_at(coarser, Rational(i, 2) - Rational(term.exponents[0]));
    CHECK(finer.at(i) == sum);
  }
  CHECK_THROWS_AS(limit_values(LevelMasks{{a}, {}}, 2), Error);
  CHECK_THROWS_AS(limit_values(LevelMasks{{a}, {lattice_mask("bspline:degree=3,a=3")}}, 2), Error);
  CHECK_FAILS(limit_values(LevelMasks{{a}, {b}}, 40), size);
}

TEST_CASE("limits of a recurrence that stays where it is are those of the one mask") {
  struct Known {
    const char* family;
    Rational value;
    int order;
  };
  for (const Known& known :
       {Known{"four-point:w", Rational(1, 16), 2}, Known{"conic-four-point:v", Rational(2, 3), 2},
        Known{"exponential-bspline:v", Rational(1, 2), 2}, Known{"dual-four-point:w", Rational(1, 64), 2},
        Known{"ternary-four-point:w", Rational(1, 11), 3}, Known{"mask:[1-w,1+w,1+w,1-w]/2@-1", Rational(1, 3), 1}}) {
    CAPTURE(known.family);
    const ParametricScheme scheme = make_parametric_scheme(known.family);
    const Recurrence stays = Recurrence::parse(scheme.name + "=" + scheme.name, scheme.name, scheme.letter);
    const LimitValues exact = limit_values(scheme.mask.at(known.value), 3);
    const EnclosedLimitValues found = limit_values(scheme.mask, stays, known.value, 3);
    CHECK(found.arity == exact.arity);
    CHECK(found.order >= known.order);
    for (long i = found.first_index; i < found.first_index + static_cast<long>(found.values.size()); ++i) {
      const Interval value = limit_at(found, i);
      CHECK(value.contains(exact.at(i)));
      CHECK(value.width() < Rational(1, 1'000'000'000'000));
    }
    CHECK(found.first_index <= exact.first_index);
  }
}

TEST_CASE("limits of a recurrence generate what the masks do, and lie about late data") {
  // v_0 = cos(theta/2).
  for (const auto& [start, theta] :
       {std::pair(Rational(1, 2), 2 * std::numbers::pi / 3), std::pair(Rational(0), std::numbers::pi),
        std::pair(Rational(4, 5), 2 * std::acos(0.8)), std::pair(Rational(1), 0.0)}) {
    for (const char* name : {"exponential-bspline:v", "conic-four-point:v", "exponential-six-point:v"}) {
      if (start == 0 && std::string_view(name) != "exponential-bspline:v") continue;
      CAPTURE(name, start);
      const EnclosedLimitValues values = limit_values(family_mask(name), recurrence_of(halved_angle), start, 2);
      const double whole = generated_at(values, theta, 0);
      for (long i = -4; i <= 4; ++i)
        CHECK(generated_at(values, theta, i) ==
              Approx(whole * std::cos(theta * static_cast<double>(i) / 4)).margin(1e-12));
    }
  }
  Random random;
  const ParametricMask four = family_mask("four-point:w");
  for (int round = 0; round < 6; ++round) {
    // To 1/16 from both sides, slowly and fast.
    const Rational start = Rational(1, 16) + Rational(random.integer(-40, 40), 1000), rate(random.integer(-9, 9), 10);
    const Recurrence step = Recurrence::parse("w=1/16+(" + to_text(rate) + ")*(w-1/16)", "w", 'w');
    CAPTURE(start, rate);
    const EnclosedLimitValues found = limit_values(four, step, start, 1);
    const LevelMasks late = masks_of_levels(four, step, start, 30);
    const LimitValues near = limit_values(LevelMasks{late.first, {lattice_mask("four-point:w=1/16")}}, 1);
    for (long i = found.first_index; i <= -found.first_index; ++i) {
      CHECK(std::abs(middle_of(limit_at(found, i)) - near.at(i).convert_to<double>()) < 1e-9);
      CHECK(limit_at(found, i).width() < Rational(1, 1'000'000'000'000));
    }
  }
}

TEST_CASE("limits of a recurrence: what is refused") {
  const ParametricMask four = family_mask("four-point:w");
  CHECK_FAILS(limit_values(four, recurrence_of("w=w/2+1/2", 'w'), Rational(1, 20), 1), undecided);  // to w = 1
  CHECK_FAILS(limit_values(four, recurrence_of("w=2*w", 'w'), Rational(1, 20), 1), undecided);
  CHECK_FAILS(limit_values(four, recurrence_of("w=1/w", 'w'), 0, 1), domain);
  CHECK_FAILS(limit_values(family_mask("conic-four-point:v"), recurrence_of(halved_angle), 0, 1), domain);
  CHECK_FAILS(limit_values(four, recurrence_of("w=w", 'w'), Rational(1, 16), 40), size);
  CHECK_FAILS(limit_values(four, recurrence_of("w=w", 'w'), Rational(1, 16), -1), domain);
}

namespace {

LatticeMask matrices(const char* specification) { return make_refinable_scheme(specification).mask; }

/// Values of the only solution of the equation of these levels as one.
LatticeSequence at_integers(const std::vector<LatticeMask>& levels) { return limit_values(levels_as_one(levels), 0); }

}  // namespace

TEST_CASE("limits of levels of matrices: one mask, and masks of numbers on the diagonal") {
  for (const char* one : {"merrien:lambda=-1/8,mu=1/2", "ghm", "hermite-dd:points=4,order=2,a=3"}) {
    CAPTURE(one);
    const LatticeMask mask = matrices(one);
    const LatticeSequence alone = limit_values(mask, 0);
    for (int level = 0; level <= 3; ++level) {
      const LatticeSequence expected = limit_values(mask, level);
      CHECK(limit_values(LevelMasks{{}, {mask}}, alone, level) == expected);
      CHECK(limit_values(LevelMasks{{mask}, {mask, mask}}, alone, level) == expected);
    }
  }
  // (phi, phi) for numbers, with phi that of their levels.
  const std::vector<LatticeMask> numbers{lattice_mask("dd:n=2"), lattice_mask("bspline:degree=3")};
  std::vector<LatticeMask> twice;
  for (const LatticeMask& mask : numbers) {
    std::vector<LatticeMask::Term> terms;
    for (const LatticeMask::Term& term : mask.terms())
      for (std::size_t c = 0; c < 2; ++c) terms.push_back({term.exponents, c, c, term.coefficient});
    twice.push_back(matrix_mask(terms, 2, mask.dilation()));
  }
  const LimitValues integers = limit_values(LevelMasks{{}, {numbers[1], numbers[0]}}, 0);
  LatticeSequence start;
  for (std::size_t i = 0; i < integers.values.size(); ++i)
    for (long c = 0; c < 2; ++c)
      if (integers.values[i] != 0) start[{integers.first_index + static_cast<long>(i), c}] = integers.values[i];
  for (int level = 0; level <= 3; ++level) {
    const LimitValues expected = limit_values(LevelMasks{{numbers[0]}, {numbers[1], numbers[0]}}, level);
    const LatticeSequence found = limit_values(LevelMasks{{twice[0]}, {twice[1], twice[0]}}, start, level);
    for (std::size_t i = 0; i < expected.values.size(); ++i)
      for (long c = 0; c < 2; ++c) {
        const auto entry = found.find({expected.first_index + static_cast<long>(i), c});
        CHECK((entry == found.end() ? Rational(0) : entry->second) == expected.values[i]);
      }
  }
}

TEST_CASE("limits of levels of matrices obey the equation of each level, and keep what all masks keep") {
  const LatticeMask first = matrices("merrien:lambda=-1/8,mu=3/2"), second = matrices("merrien:lambda=-1/8,mu=-1/2");
  const LevelMasks even{{}, {first, second}}, odd{{}, {second, first}};
  const LatticeSequence values = at_integers(even.again);
  for (int level = 0; level <= 4; ++level) {
    const LatticeSequence coarse = limit_values(even, values, level),
                          later = limit_values({{}, {second, first}}, at_integers(odd.again), level),
                          fine = limit_values(even, values, level + 1);
    // phi(x) = sum over k of A_k psi(2x - k), at x = i / 2^(level + 1).
    LatticeSequence expected;
    for (const LatticeMask::Term& term : first.terms())
      for (const auto& [point, value] : later)
        if (static_cast<long>(term.column) == point[1])
          expected[{point[0] + (term.exponents[0] << level), static_cast<long>(term.row)}] += term.coefficient * value;
    std::erase_if(expected, [](const auto& entry) { return entry.second == 0; });
    CHECK(fine == expected);
    // x^2 from its values and slopes at the integers, which both masks keep.
    Rational sum = 0;
    for (const auto& [point, value] : coarse) {
      const long shift = point[0] >> level, at = point[0] - (shift << level);
      if (at != (level > 0 ? 1 : 0)) continue;
      const long datum = -shift;
      sum += value * (point[1] == 0 ? datum * datum : 2 * datum);
    }
    CHECK(sum == (level > 0 ? power(Rational(1, 4), level) : Rational(0)));
  }
  CHECK_FAILS(limit_values(LevelMasks{{first}, {}}, values, 1), domain);
  CHECK_FAILS(limit_values(LevelMasks{{matrices("hermite-dd:points=2,order=3")}, {first}}, values, 1), domain);
  CHECK_FAILS(limit_values(even, values, -1), domain);
  CHECK_FAILS(limit_values(even, values, 24), size);
}
