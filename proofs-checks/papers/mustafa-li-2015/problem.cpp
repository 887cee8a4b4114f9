// Section 2.1 to 2.3: the l1 problem, its smoothing and the reweighted line.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/data/l1/least_absolute.hpp>

#include <algorithm>
#include <cstdlib>

namespace subcert::statements::mustafa_li_2015 {
namespace {

/// The sum of moduli of the residuals for data on -1, ..., 2.
Rational moduli(const Formula& residual, const std::vector<Rational>& data, const Rational& b1, const Rational& b2) {
  Rational sum = 0;
  for (long r = -1; r <= 2; ++r)
    sum += abs(residual({{"f", data[static_cast<std::size_t>(r + 1)]}, {"beta1", b1}, {"beta2", b2}, {"r", r}}));
  return sum;
}

Outcome l1_problem(const Context& context) {
  const Formula printed = context.formula("l1-problem"), equation = context.formula("eq-1");
  Trial trial = summation_range(context.formula("sum-first"), context.formula("sum-last"), true);
  trial.follow(identity(printed, f("f - (beta1 + beta2*r)"), line_names));
  trial.follow(identity(printed, equation, line_names));
  const Rational smallest = context.formula("line-n")({});
  for (long n = 0; n <= 3; ++n) {
    const RationalMatrix normal = normal_matrix(window(1 - n, n, 1), {f("1"), f("r")});
    trial.require(kernel(normal).empty() == (n > smallest), at("n", n) + ": whether the data determine a line");
  }
  // Two minimisers: the dual vector (-1, 1, 1, -1) annihilates lines and shows that no sum is below 2.
  const std::vector<Rational> data{0, 1, 1, 0};
  trial.equal(moduli(equation, data, 0, 0), 2, "n = 2, data 0, 1, 1, 0, line 0");
  trial.equal(moduli(equation, data, 1, 0), 2, "n = 2, data 0, 1, 1, 0, line 1");
  for (int n = 1; n <= context.reach(5, 7); ++n)
    trial.require(data::least_absolute_rule(2 * n, 1)->is_function() == (n % 2 == 1),
                  at("n", n) + ": whether every datum has one minimiser");
  Outcome outcome = trial.for_all("all n >= 1", "");
  outcome.argument =
      "both displays are one problem; its objective is convex, as a sum of moduli of affine functions, and grows "
      "without bound, so that minimisers exist. For odd n, as in D_6, there is one for all data. For even n, as in "
      "D_8, and for D_7, there are several for some, though 'arg min' suggests one: the data 0, 1, 1, 0 (n = 2) have "
      "the minimisers 0 and 1 (docs/l1.md, Theorem 1)";
  return outcome;
}

Outcome smoothed(const Context& context) {
  const Formula bracket = context.formula("eq-2");
  const Formula residual = f("f - beta1 - beta2*r");
  Trial trial = weights_of_modulus(bracket, context.formula("eq-2-exponent")({}), residual, line_names);
  trial.follow(smoothed_above_modulus(bracket, residual, root_names));
  return trial.for_all(
      "all n, data and delta > 0",
      "t^2 <= t^2 + delta = (|t| + delta^(1/2))^2 - 2 |t| delta^(1/2), so F <= F_delta <= F + 2n delta^(1/2): "
      "a minimiser of F_delta has F within 2n delta^(1/2) of the smallest value");
}

Outcome iteration(const Context& context) {
  const Formula objective = context.formula("eq-3-objective");
  const Formula residual = f("f - beta1 - r*beta2");
  Trial trial = weights_of_modulus(context.formula("eq-3-weight"), context.formula("eq-3-weight-exponent")({}),
                                   residual, line_names);
  trial.follow(
      identity(objective, f("w") * residual * residual, {{"w", 1}, {"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}}));
  Outcome outcome = trial.for_all(
      "all n, data and delta > 0",
      "a fixed point of the iteration has sum of w t = sum of r w t = 0, which is the vanishing gradient "
      "of the convex F_delta");
  return outcome;
}

/// (3) about a point with zero derivatives: the middle sums vanish, the last ones are positive.
Outcome global_optimum(const Context& context) {
  const Formula objective = context.formula("eq-3-objective"), step = f("h1 + r*h2");
  const Formula moved = objective.replaced("beta1", f("beta1 + h1")).replaced("beta2", f("beta2 + h2"));
  Trial trial = identity(moved, objective - f("2*w*(f - beta1 - r*beta2)") * step + f("w") * step * step,
                         {{"w", 1}, {"f", 1}, {"beta1", 2}, {"beta2", 3}, {"h1", 1}, {"h2", 1}, {"r", 5}});
  return trial.for_all("all n >= 1 and all positive weights",
                       "the objective at beta + h is that at beta, plus a sum that vanishes with the derivatives, plus "
                       "the sum of w (h_1 + r h_2)^2, which is positive for h other than 0");
}

Outcome starting_value(const Context& context) {
  const Formula bracket = context.formula("eq-2");
  Trial trial = fits_go_down(bracket, f("f - beta1 - beta2*r"), line_names);
  trial.follow(identity(context.formula("eq-3-weight"), bracket, line_names));
  return trial;
}

/// The residual at i of the starting line (9) for the data 1 at k and 0 elsewhere.
Formula residual_of_start(const Context& context, const std::string& i, const std::string& k) {
  const Formula slope = context.formula("eq-9-beta-2");
  const Formula line = context.formula("eq-9-beta-1") - context.formula("eq-9-factor") * slope + f("x") * slope;
  return f(i == k ? "1" : "0") - line.replaced("r", f("(" + k + ")")).replaced("x", f("(" + i + ")"));
}

/// The residual at the outlier k is larger than that at i, whatever its sign, for n = smallest + x.
Trial outlier_is_farther(const Context& context, const std::string& i, const std::string& k, long smallest) {
  const Formula own = residual_of_start(context, k, k), other = residual_of_start(context, i, k);
  Trial trial;
  for (const Formula& difference : {own - other, own + other})
    trial.follow(positive(difference, {{"n", std::to_string(smallest) + " + x"}}));
  return trial;
}

/// Residuals are linear in i, and the one at the outlier, less the modulus of another, is concave in k.
Outcome outlier_weight(const Context& context) {
  const auto smallest = static_cast<long>(numerator(context.formula("advice-n")({})));
  Trial trial = weights_of_modulus(context.formula("eq-6"), context.formula("eq-6-exponent")({}),
                                   f("f - beta1 - r*beta2"), line_names);
  for (const char* k : {"n - 1", "2 - n"})
    for (const char* i : {"n", "1 - n"}) trial.follow(outlier_is_farther(context, i, k, smallest));
  for (const char* i : {"n - 1", "1 - n"}) trial.follow(outlier_is_farther(context, i, "n", smallest));
  for (const char* i : {"2 - n", "n"}) trial.follow(outlier_is_farther(context, i, "1 - n", smallest));
  const auto own = [&](const char* k) { return residual_of_start(context, k, k); };
  trial.follow(positive(f("2") * own("r") - own("r + 1") - own("r - 1"), {{"n", "1 + x"}, {"r", "y"}}));
  const Values below{{"n", smallest - 1}};
  trial.require(own("n")(below) <= abs(residual_of_start(context, "n - 1", "n")(below)),
                "for a smaller n the outlier has the largest residual, too");
  return trial.for_all("all n >= 3, data of a line but for one",
                       "w falls as the residual grows, and the residual of the starting line is largest at the "
                       "outlier, at every place: it is linear in the other place and concave in that of the outlier, "
                       "so that the ends decide. For n = 2 it is not: an outlier at the end leaves 3/10 of its height "
                       "there and 4/10 beside it");
}

/// The sum over 2n nodes of the modulus of a line that vanishes at node p, less twice that at node k.
Rational margin(long n, long p, long k) {
  Rational sum = 0;
  for (long j = 1; j <= 2 * n; ++j) sum += std::abs(j - p);
  return sum - 2 * std::abs(k - p);
}

Rational smallest_margin(long n) {
  Rational smallest = margin(n, 1, 1);
  for (long p = 1; p <= 2 * n; ++p)
    for (long k = 1; k <= 2 * n; ++k) smallest = std::min(smallest, margin(n, p, k));
  return smallest;
}

/// The line 0 is the only l1 line of one datum at k and zeros, whatever its height, if |l(k)| is below the sum of the
/// other |l(j)| for every line l that is not 0; both sides are linear between lines that vanish at neighbouring nodes.
Outcome smallest_advised_n(const Context& context) {
  const auto smallest = static_cast<long>(numerator(context.formula("advice-n")({})));
  Trial trial;
  for (long n = smallest; n <= context.reach(8, 20); ++n)
    trial.require(smallest_margin(n) > 0, at("n", n) + ": an outlier may stay");
  trial.require(smallest_margin(smallest - 1) <= 0, "for a smaller n no outlier stays, either");
  // p - 1 nodes on one side and q = 2n - p on the other, where k is, q >= p: q >= 4 or n = p = q = 3.
  trial.follow(positive(f("p*(p - 1)/2 + q*(q + 1)/2 - 2*q"), {{"p", "1 + x"}, {"q", "4 + y"}}));
  return trial.for_all("all n >= 3, one outlier at any place and of any height",
                       "the data of a line but for one have that line as their only l1 line. For n = 2 they need not: "
                       "the data 0, 0, 0, 1 at r = -1, ..., 2 have the sum 1 with the line 0 and with (r + 1)/3");
}

}  // namespace

Checks problem() {
  return {{"eq-1", l1_problem},
          {"eq-2", smoothed},
          {"eq-3", iteration},
          {"global-optimum", global_optimum},
          {"starting-value", starting_value},
          {"outlier-weight", outlier_weight},
          {"advice-n", smallest_advised_n}};
}

}  // namespace subcert::statements::mustafa_li_2015
