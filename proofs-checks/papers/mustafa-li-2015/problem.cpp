// Section 2.1 to 2.3: the l1 problem, its smoothing and the reweighted line.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>

namespace subcert::statements::mustafa_li_2015 {
namespace {

const std::vector<Variable> line_names{{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}, {"delta", 7}};

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
  // Two minimisers: the dual vector (-1, 1, 1, -1) annihilates lines and shows that no sum is below 2.
  const std::vector<Rational> data{0, 1, 1, 0};
  trial.equal(moduli(equation, data, 0, 0), 2, "n = 2, data 0, 1, 1, 0, line 0");
  trial.equal(moduli(equation, data, 1, 0), 2, "n = 2, data 0, 1, 1, 0, line 1");
  Outcome outcome = trial.for_all("all n >= 1", "");
  outcome.argument =
      "both displays are one problem; its objective is convex, as a sum of moduli of affine functions, and grows "
      "without "
      "bound, so that minimisers exist. They need not be unique, as 'arg min' suggests: the data 0, 1, 1, 0 (n = 2) "
      "have the minimisers 0 and 1";
  return outcome;
}

Outcome smoothed(const Context& context) {
  const Formula bracket = context.formula("eq-2");
  const Formula residual = f("f - beta1 - beta2*r");
  Trial trial = weights_of_modulus(bracket, context.formula("eq-2-exponent")({}), residual, line_names);
  // delta = e^2: t^2 <= t^2 + e^2 = (|t| + e)^2 - 2 |t| e.
  const Formula h_squared = bracket.replaced("delta", f("e^2"));
  const std::vector<Variable> names{{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}, {"e", 7}};
  trial.follow(identity((residual + f("e")) * (residual + f("e")) - h_squared, f("2*e") * residual, names));
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

}  // namespace

Checks problem() { return {{"eq-1", l1_problem}, {"eq-2", smoothed}, {"eq-3", iteration}}; }

}  // namespace subcert::statements::mustafa_li_2015
