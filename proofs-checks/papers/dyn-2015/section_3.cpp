// Section 3: noise, the variance curve, approximation order.

#include "checks.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::dyn_2015 {
namespace {

/// (16), with errors of -s and s of equal chance: the mean over all choices of signs is exact.
Outcome bias_and_variance(const Context&) {
  Trial trial;
  const Rational s(2, 3), truth(5, 7);
  for (int n = 1; n <= 3; ++n) {
    const LimitValues phi = limit_values(s_n(n), 2);
    for (long i = 0; i < 4; ++i) {
      std::vector<Rational> weights;
      for (long j = -2 * n; j <= 2 * n; ++j)
        if (phi.at(i - 4 * j) != 0) weights.push_back(phi.at(i - 4 * j));
      Rational bias = -truth, squares = 0, mean = 0;
      for (std::size_t j = 0; j < weights.size(); ++j) {
        bias += weights[j] * static_cast<long>(j * j);
        squares += weights[j] * weights[j];
      }
      const std::size_t choices = std::size_t{1} << weights.size();
      for (std::size_t signs = 0; signs < choices; ++signs) {
        Rational error = bias;
        for (std::size_t j = 0; j < weights.size(); ++j) error += ((signs >> j) & 1 ? s : Rational(-s)) * weights[j];
        mean += error * error;
      }
      trial.equal(s * s * squares + bias * bias, mean / static_cast<long>(choices),
                  at("n", n) + ", " + at("x", Rational(i, 4)));
    }
  }
  return trial.for_all("all n, x and h",
                       "the error is the bias plus the sum of weights times independent errors of mean 0, whose mixed "
                       "products have mean 0; compared for n = 1..3, x = 0, 1/4, 1/2, 3/4, errors -2/3 and 2/3");
}

Outcome equation_18(const Context& context) {
  const Rational bound = context.formula("eq-18")({});
  const int most = context.reach(8, 20);
  Trial trial;
  trial.equal(bound, variance_at(s_n(1), 0, 0), "n = 1, x = 0, where the bound is attained");
  for (int n = 1; n <= most; ++n) {
    trial.require(*variance_ceiling(s_n(n)) <= bound, at("n", n));
    if (n > 1)
      trial.require(*variance_of(specification("primal", n)).maximum.upper < bound, at("n", n) + ": not strict");
  }
  return trial.for_all(
      "all n >= 1",
      "the shifts of phi_n are non-negative, at most 1/(2n-1) by (11), and sum to 1, so psi_n <= 1/(2n-1); "
      "certified maxima compared for " +
          range(1, most));
}

Outcome interpolation_keeps_noise(const Context&) {
  Trial trial;
  for (long x : {0, 1}) trial.equal(1, variance_at(s_n(1), x, 0), at("x", x));
  return trial.over("n = 1");
}

Outcome shape_of_psi(const Context& context) {
  const int most = context.reach(10, 30);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const VarianceGrid grid = variance_grid(s_n(n), 5, false);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      trial.require(grid.values[i] > 0, at("n", n) + ": not positive");
      trial.equal(grid.values[i], grid.values[grid.values.size() - 1 - i],
                  at("n", n) + ", " + at("x", Rational(i) * grid.step()));
    }
  }
  return trial.for_all(
      "all n >= 1",
      "a sum of squares of functions that sum to 1, over all integer shifts of a symmetric function, so that it is "
      "symmetric about 1/2, too; exact values compared at dyadic points of level 5 for " +
          range(1, most));
}

Outcome psi_like_1_over_n(const Context&) {
  return proved_theorem("conjecture-7")
      .for_all("all n >= 1",
               "|(n - 1/4) psi_n(x)/c - 1| < 0.855/n^2 for all x, with c = 0.40443..., every inequality of the proof "
               "certified (docs/theorems/README.md, conjecture-7)");
}

/// The order of the bound that the proof ends in, and the theorem for all n. The paper calls both halves bounds, and
/// writes `<= ... ~ 1/n^2` itself; that the largest slope falls faster does not touch them.
Outcome psi_slope_bounded_by_1_over_n2(const Context& context) {
  const Formula rate = context.formula("theorem-6-slope-rate");
  // 2 * 2/(2n-1) times the sum of 4n-2 values of |phi'|, each at most 2/n^2 (theorem-5-slope).
  const Degrees degrees = (f("4/(2*n - 1)*(4*n - 2)*2/n^2") / rate).degrees("n");
  Trial trial = proved_theorem("conjecture-7");
  trial.require(degrees.numerator == degrees.denominator, "the bound of the proof is not of the printed order");
  const int most = context.reach(7, 15);
  const auto scaled = [&](int n) { return *variance_of(specification("primal", n)).slope->upper / rate({{"n", n}}); };
  for (int n = 2; n <= most; ++n) trial.require(scaled(n) < Rational(139, 1000), at("n", n));
  return trial.for_all("all n >= 2",
                       "n^2 max |psi_n'| < 0.139 for n >= 2, every inequality certified (docs/theorems/README.md, "
                       "conjecture-7). The order is that of a bound, as the paper says: at n = " +
                           std::to_string(most) + " n^2 max |psi_n'| is at most " +
                           to_decimal(scaled(most), 4, Rounding::up) + ", and it tends to 0");
}

/// A smaller support answers more to the variance of the noise.
Outcome smaller_supports_are_more_sensitive(const Context&) {
  Trial trial;
  for (const auto& [less, more] : {std::pair{5, 3}, {7, 5}}) {
    const VarianceOrder& order = variance_order_of(specification("primal", less), specification("primal", more));
    trial.require(order.below == Truth::yes, "S_" + std::to_string(less) + " against S_" + std::to_string(more));
  }
  return trial.over("psi_7 < psi_5 < psi_3 at every x");
}

Outcome number_of_terms(const Context& context) {
  const Formula count = context.formula("theorem-6-terms");
  const int most = context.reach(10, 30);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const LimitValues phi = limit_values(s_n(n), 2);
    for (long i = 0; i < 4; ++i) {
      long terms = 0;
      for (long j = -2 * n; j <= 2 * n; ++j) terms += phi.at(i - 4 * j) != 0 ? 1 : 0;
      if (i == 0)
        trial.require(terms < count({{"n", n}}), at("n", n) + ", x = 0");
      else
        trial.equal(count({{"n", n}}), terms, at("n", n) + ", " + at("x", Rational(i, 4)));
    }
  }
  trial.follow(identity(count, context.formula("support-upper") - context.formula("support-lower"), {{"n", 1}}));
  return trial.for_all("all n >= 1",
                       "phi_n is positive inside its support (phi-positive), whose width is 4n-2: exactly 4n-2 terms "
                       "where x is no integer, one less at the integers; counted for " +
                           range(1, most));
}

/// What the rules add to the data j^2, beside the squares of the new points.
Formula raised_by_even_rule() { return f("n*(n - 1)/3"); }
Formula raised_by_odd_rule() { return f("(4*n^2 - 1)/12"); }

Trial raised_squares(const Context& context) {
  Trial trial = sum_identity({context.formula("eq-2-even") * f("j^2"), "j", {-1, 1}, {1, -1}}, raised_by_even_rule(),
                             {{"n", 1}});
  trial.follow(sum_identity({context.formula("eq-2-odd") * f("(j - 1/2)^2"), "j", {-1, 1}, {1, 0}},
                            raised_by_odd_rule(), {{"n", 1}}));
  return trial;
}

/// The noise by psi, the deterministic error by x^2, which gives its leading term: each step adds what the rules add,
/// a quarter of it in the next one, and averages stay between. So it is 4/3 of the two numbers at least and at most.
Outcome trade_off(const Context& context) {
  const int most = context.reach(8, 20);
  constexpr int level = 3;
  const Formula least = f("4/3") * raised_by_even_rule(), largest = f("4/3") * raised_by_odd_rule();
  Trial trial = raised_squares(context);
  trial.follow(positive(largest - least, {{"n", "1 + x"}}));
  trial.follow(positive(least.replaced("n", f("n + 1")) - largest, {{"n", "1 + x"}}));
  for (int n = 1; n <= most; ++n) {
    const LimitValues phi = limit_values(s_n(n), level);
    for (long i = 0; i < 8; ++i) {
      Rational error = 0;
      for (long j = -2 * n; j <= 2 * n; ++j) error += (j - Rational(i, 8)) * (j - Rational(i, 8)) * phi.at(i - 8 * j);
      trial.require(least({{"n", n}}) <= error && error <= largest({{"n", n}}),
                    at("n", n) + ", " + at("x", Rational(i, 8)) + ": the error of x^2 is " + subcert::to_text(error));
    }
  }
  trial.follow(proved_theorem("conjecture-8-n"));
  return trial.for_all("all n >= 1",
                       "psi_{n+1} < psi_n (docs/theorems/README.md, conjecture-8-n); the error of x^2 lies between "
                       "4n(n-1)/9 and (4n^2-1)/9 times h^2 at every x, which is below the least one for n+1; exact "
                       "values compared for " +
                           range(1, most) + " at dyadic x of level 3");
}

Outcome approximation_order(const Context& context) {
  const int most = context.reach(20, 60);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    trial.equal(context.formula("approximation-order")({}), polynomial_reproduction(s_n(n)).approximation_order(),
                at("n", n) + ", order");
    trial.equal(0, polynomial_reproduction(s_n(n)).parametrization.front(), at("n", n) + ", shift of the parameters");
  }
  trial.follow(raised_squares(context));
  trial.follow(positive(raised_by_odd_rule(), {{"n", "1 + x"}}));
  return trial.for_all("all n >= 1",
                       "linear data are kept, by symmetry, and squares are not: the odd rule raises j^2 by (4n^2-1)/12 "
                       "(trade-off); degrees compared for " +
                           range(1, most));
}

Outcome figure_2(const Context&) {
  Trial trial;
  for (int n = 1; n < 5; ++n)
    trial.require(*variance_of(specification("primal", n + 1)).maximum.upper <
                      *variance_of(specification("primal", n)).minimum.lower,
                  at("n", n));
  trial.follow(proved_theorem("conjecture-8-n"));
  return trial.for_all(
      "all n >= 1",
      "max psi_{n+1} < min psi_n (docs/theorems/README.md, conjecture-8-n), certified maxima and minima for n "
      "= 1..5");
}

}  // namespace

Checks section_3() {
  return {{"fig-2", figure_2},
          {"eq-16", bias_and_variance},
          {"eq-18", equation_18},
          {"psi-1", interpolation_keeps_noise},
          {"theorem-6-shape", shape_of_psi},
          {"theorem-6", psi_like_1_over_n},
          {"theorem-6-slope", psi_slope_bounded_by_1_over_n2},
          {"theorem-6-terms", number_of_terms},
          {"approximation-order", approximation_order},
          {"trade-off", trade_off},
          {"sensitive", smaller_supports_are_more_sensitive}};
}

}  // namespace subcert::statements::dyn_2015
