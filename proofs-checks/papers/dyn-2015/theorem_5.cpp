// Theorem 5, the derivative of the basic limit function, and (11) to (14).
#include "checks.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::dyn_2015 {
namespace {

/// Each bound over the rate lies between two positive numbers for large n.
void require_rate(Trial& trial, const std::vector<Formula>& bounds, const Formula& rate) {
  for (const Formula& bound : bounds) {
    const Degrees degrees = (bound / rate).degrees("n");
    trial.require(degrees.numerator == degrees.denominator,
                  "the ratio of a bound and the rate is not bounded from both sides");
  }
}

Outcome theorem_5(const Context& context) {
  const Formula rate = context.formula("theorem-5-rate");
  const Formula lower = context.formula("eq-10-lower"), upper = context.formula("eq-11");
  const int most = context.reach(6, 12);
  Trial trial;
  require_rate(trial, {lower, upper}, rate);
  for (int n = 2; n <= most; ++n) {
    const Enclosure& sup = limit_range_of(specification("primal", n)).sup_norm;
    trial.require(lower({{"n", n}}) <= *sup.lower && *sup.upper <= upper({{"n", n}}),
                  at("n", n) + ": the maximum is outside of the bounds");
  }
  return trial.for_all(
      "all n >= 2",
      "1/(3n-2) < max phi_n <= 1/(2n-1), by Corollary 4 and (11); certified maxima compared for " + range(2, most));
}

Outcome theorem_5_slope(const Context& context) {
  const Formula rate = context.formula("theorem-5-slope-rate");
  const Formula lower = context.formula("eq-10-lower") * f("1/(2*n - 1)"), upper = f("2/n^2");
  const int most = context.reach(6, 12);
  Trial trial;
  require_rate(trial, {lower, upper}, rate);
  // Second power of the difference scheme: weights that sum to 1 times at most 1/(n(2n-1)), and one summand of at most
  // 1/n times 1/n.
  trial.follow(positive(upper - f("1/(n*(2*n - 1)) + 1/n^2"), {{"n", "2 + x"}}));
  for (int n = 2; n <= most; ++n) {
    const auto& slope = limit_range_of(specification("primal", n)).slope;
    trial.require(slope && lower({{"n", n}}) <= *slope->upper && *slope->lower <= upper({{"n", n}}),
                  at("n", n) + ": the slope is outside of the bounds");
  }
  return trial.for_all(
      "all n >= 2",
      "1/((3n-2)(2n-1)) <= max |phi_n'| <= 2/n^2: from below by phi(0) over the half support, from above by (13) "
      "and (14); certified slopes compared for " +
          range(2, most));
}

/// The sequence S^level delta.
LaurentPolynomial iterated(const Mask& mask, int level, LaurentPolynomial data) {
  for (int i = 0; i < level; ++i) data = mask.symbol() * data.dilated(2);
  return data;
}

Rational largest(const LaurentPolynomial& data) {
  Rational most = 0;
  for (const Rational& value : data.coefficients()) most = std::max(most, Rational(abs(value)));
  return most;
}

Outcome equation_11(const Context& context) {
  const Formula bound = context.formula("eq-11");
  const int most = context.reach(8, 20), levels = context.reach(4, 6);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const LaurentPolynomial delta(1);
    Rational before = largest(iterated(s_n(n), 1, delta));
    trial.equal(bound({{"n", n}}), before, at("n", n) + ", the maximum after one step");
    for (int level = 2; level <= levels; ++level) {
      const Rational now = largest(iterated(s_n(n), level, delta));
      trial.require(now <= before, at("n", n) + ", the maximum grows at level " + std::to_string(level));
      before = now;
    }
  }
  trial.follow(identity(context.formula("eq-3-even"), bound, {{"n", 1}}));
  trial.follow(positive(context.formula("eq-3-even") - context.formula("eq-3-odd"), {{"n", "1 + x"}}));
  return trial.for_all("all n >= 1",
                       "one step on delta gives the mask, whose largest entry is 1/(2n-1), and averages do not exceed "
                       "the largest datum; compared for " +
                           range(1, most) + ", levels 1.." + std::to_string(levels));
}

Outcome improved_bound(const Context& context) {
  return positive(context.formula("eq-10-upper") - context.formula("eq-11"), {{"n", "2 + x"}})
      .for_all("all n >= 2", "1/(n-1) - 1/(2n-1) is positive, by the signs of its coefficients at n = 2 + x");
}

/// phi'(x) against the limit of 2 q_n for first differences of delta, at dyadic points; x is moved by `shift`.
Trial derivative_from_differences(int most, long shift) {
  constexpr int level = 2;
  Trial trial;
  for (int n = 2; n <= most && !trial.failed(); ++n) {
    const LimitValues slope = limit_values(s_n(n), level, 1);
    const Mask twice = divided_difference_scheme(s_n(n), 1);
    const LimitValues phi = limit_values(twice, level);
    for (long i = 4 * (-2 * n); i <= 4 * 2 * n; ++i)
      if (!trial.equal(phi.at(i + 4 + 4 * shift) - phi.at(i + 4 * shift), slope.at(i),
                       at("n", n) + ", " + at("x", Rational(i, 4))))
        break;
  }
  return trial.over(range(2, most) + ", dyadic x of level 2");
}

Outcome derivative_relation(const Context& context) {
  const int most = context.reach(5, 10);
  return derivative_from_differences(most, 0).outcome(derivative_from_differences(most, -1));
}

Outcome equation_12(const Context& context) {
  const Formula odd = context.formula("eq-12-odd"), even = context.formula("eq-12-even");
  Trial trial = identity(odd, f("2") * context.formula("eq-4-odd"), {{"n", 1}, {"j", 0}});
  trial.follow(identity(even, f("2") * context.formula("eq-4-even"), {{"n", 1}, {"j", 0}}));
  return trial.for_all("all n >= 1 and j", "an identity of rational functions, given (4)");
}

Outcome equation_13(const Context& context) {
  const Formula inside = context.formula("eq-13-inside"), ends = context.formula("eq-13-ends");
  const Formula odd = context.formula("eq-12-odd"), even = context.formula("eq-12-even");
  const Formula first = context.formula("eq-13-first"), last = context.formula("eq-13-last");
  const int most = context.reach(12, 60);
  Trial trial;
  for (int n = 1; n <= most && !trial.failed(); ++n) {
    const Mask twice = divided_difference_scheme(s_n(n), 1);
    const LaurentPolynomial difference = LaurentPolynomial::monomial(1, -1) - LaurentPolynomial(1);
    const LaurentPolynomial once = iterated(twice, 1, difference);
    const Rational low = first({{"n", n}}), high = last({{"n", n}});
    for (long j = -2 * n - 4; j <= 2 * n + 2; ++j) {
      const Rational printed = j == low || j == high ? ends({{"n", n}})
                               : low < j && j < high ? inside({{"n", n}})
                                                     : Rational(0);
      trial.equal(printed, abs(once.coefficient(j)), at("n", n) + ", " + at("j", j));
    }
  }
  // c_{j+2} - c_j for neighbours in a class, and the first and last coefficients.
  trial.follow(identity(odd - odd.replaced("j", f("j + 1")), inside, {{"n", 1}, {"j", 0}}));
  trial.follow(identity(even.replaced("j", f("j + 1")) - even, inside, {{"n", 1}, {"j", 0}}));
  trial.follow(identity(odd.replaced("j", f("-n + 1")), ends, {{"n", 1}}));
  trial.follow(identity(even.replaced("j", f("n - 1")), ends, {{"n", 1}}));
  trial.follow(identity(even.replaced("j", f("-n + 1")), inside, {{"n", 1}}));
  trial.follow(identity(odd.replaced("j", f("n - 1")), inside, {{"n", 1}}));
  return trial.for_all("all n >= 1",
                       "differences of (12) and its first and last coefficients; compared for " + range(1, most));
}

Outcome equation_14(const Context& context) {
  const Formula small = context.formula("eq-13-inside") * f("1/n"), large = f("1/n^2");
  const int most = context.reach(10, 30);
  Trial trial;
  for (int n = 2; n <= most && !trial.failed(); ++n) {
    const Mask twice = divided_difference_scheme(s_n(n), 1);
    const LaurentPolynomial difference = LaurentPolynomial::monomial(1, -1) - LaurentPolynomial(1);
    const LaurentPolynomial once = iterated(twice, 1, difference);
    for (long j = -8 * n; j <= 8 * n; ++j) {
      int terms = 0, big = 0;
      for (long i = once.lowest(); i <= once.highest(); ++i) {
        const Rational summand = abs(twice.symbol().coefficient(j - 2 * i) * once.coefficient(i));
        terms += summand != 0 ? 1 : 0;
        big += summand > small({{"n", n}}) ? 1 : 0;
        trial.require(summand <= large({{"n", n}}), at("n", n) + ", " + at("j", j) + ", " + at("i", i));
      }
      trial.require(big <= 1 && terms <= 2 * n - 1, at("n", n) + ", " + at("j", j) + ": " + std::to_string(terms) +
                                                        " summands, " + std::to_string(big) + " large");
    }
  }
  return trial.for_all(
      "all n >= 2",
      "every summand is at most 1/(n^2 (2n-1)), but for one of at most 1/n^2, of at most 2n-1: by (12) and (13) the "
      "factors are at most 1/n and 1/(n(2n-1)), at the two ends 1/n; each class of indices of (12) has 2n-1 "
      "coefficients, and the ends, 4n-1 apart, do not meet in one sum; tried for " +
          range(2, most));
}

}  // namespace

Checks section_2_2_theorem_5() {
  return {{"theorem-5", theorem_5},
          {"theorem-5-slope", theorem_5_slope},
          {"eq-11", equation_11},
          {"improved-bound", improved_bound},
          {"theorem-5-derivative", derivative_relation},
          {"eq-12", equation_12},
          {"eq-13", equation_13},
          {"eq-14", equation_14}};
}

}  // namespace subcert::statements::dyn_2015
