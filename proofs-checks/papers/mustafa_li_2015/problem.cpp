// Section 2.1 to 2.3: the l1 problem, its smoothing and the reweighted line.

#include "mustafa_li_2015.hpp"

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
  const Formula printed = context.formula(key_prefix + "l1-problem"), equation = context.formula(key_prefix + "eq-1");
  Trial trial = summation_range(context.formula(key_prefix + "sum-first"), context.formula(key_prefix + "sum-last"),
                                true);
  trial.follow(identity(printed, f("f - (beta1 + beta2*r)"), line_names));
  trial.follow(identity(printed, equation, line_names));
  // Two minimisers: the dual vector (-1, 1, 1, -1) annihilates lines and shows that no sum is below 2.
  const std::vector<Rational> data{0, 1, 1, 0};
  trial.equal(moduli(equation, data, 0, 0), 2, "n = 2, data 0, 1, 1, 0, line 0");
  trial.equal(moduli(equation, data, 1, 0), 2, "n = 2, data 0, 1, 1, 0, line 1");
  Outcome outcome = trial.for_all("all n >= 1", "").outcome();
  outcome.argument =
      "both displays are one problem; its objective is convex, as a sum of moduli of affine functions, and grows "
      "without "
      "bound, so that minimisers exist. They need not be unique, as 'arg min' suggests: the data 0, 1, 1, 0 (n = 2) "
      "have the minimisers 0 and 1";
  return outcome;
}

Outcome smoothed(const Context& context) {
  const Formula bracket = context.formula(key_prefix + "eq-2");
  const Formula residual = f("f - beta1 - beta2*r");
  Trial trial = weights_of_modulus(bracket, context.formula(key_prefix + "eq-2-exponent")({}), residual, line_names);
  // delta = e^2: t^2 <= t^2 + e^2 = (|t| + e)^2 - 2 |t| e.
  const Formula h_squared = bracket.replaced("delta", f("e^2"));
  const std::vector<Variable> names{{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}, {"e", 7}};
  trial.follow(identity((residual + f("e")) * (residual + f("e")) - h_squared, f("2*e") * residual, names));
  return trial
      .for_all("all n, data and delta > 0",
               "t^2 <= t^2 + delta = (|t| + delta^(1/2))^2 - 2 |t| delta^(1/2), so F <= F_delta <= F + 2n delta^(1/2): "
               "a minimiser of F_delta has F within 2n delta^(1/2) of the smallest value")
      .outcome();
}

Outcome iteration(const Context& context) {
  const Formula objective = context.formula(key_prefix + "eq-3-objective");
  const Formula residual = f("f - beta1 - r*beta2");
  Trial trial = weights_of_modulus(context.formula(key_prefix + "eq-3-weight"),
                                   context.formula(key_prefix + "eq-3-weight-exponent")({}), residual, line_names);
  trial.follow(
      identity(objective, f("w") * residual * residual, {{"w", 1}, {"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}}));
  Outcome outcome =
      trial
          .for_all("all n, data and delta > 0",
                   "a fixed point of the iteration has sum of w t = sum of r w t = 0, which is the vanishing gradient "
                   "of the convex F_delta")
          .outcome();
  return outcome;
}

}  // namespace

void add_problem(PaperStatements& to) {
  to.transcriptions.insert(to.transcriptions.end(), {
                                                        {key_prefix + "sum-first", "-n + 1"},
                                                        {key_prefix + "sum-last", "n"},
                                                        {key_prefix + "l1-problem", "f - (beta1 + beta2*r)"},
                                                        {key_prefix + "eq-1", "f - beta1 - beta2*r"},
                                                        {key_prefix + "eq-2", "(f - beta1 - beta2*r)^2 + delta"},
                                                        {key_prefix + "eq-2-exponent", "1/2"},
                                                        {key_prefix + "eq-3-objective", "w*(f - beta1 - r*beta2)^2"},
                                                        {key_prefix + "eq-3-weight", "(f - beta1 - r*beta2)^2 + delta"},
                                                        {key_prefix + "eq-3-weight-exponent", "1/2"},
                                                    });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  add({key_prefix + "eq-1", "section 2.2, first display and equation (1)", "The l1 problem of the line.",
       "that both displays agree; whether the minimiser is unique",
       R"(\beta_1, \beta_2 = \arg\min \sum_{r=<<mustafa-li-2015/sum-first>>}^{<<mustafa-li-2015/sum-last>>} )"
       R"(|<<mustafa-li-2015/eq-1>>|)",
       "", Verdict::holds_for_all, l1_problem});
  add({key_prefix + "eq-2", "section 2.2, equation (2)", "The smoothed problem approximates the l1 problem.",
       "bounds for the difference and the derivative, as identities",
       R"(h_\delta = [<<mustafa-li-2015/eq-2>>]^{<<mustafa-li-2015/eq-2-exponent>>})", "", Verdict::holds_for_all,
       smoothed});
  add({key_prefix + "eq-3", "section 2.2, equation (3)", "The reweighted iteration for the smoothed problem.",
       "that the weights are h'(t)/t, so that fixed points are minimisers",
       R"(\arg\min \sum_r <<mustafa-li-2015/eq-3-objective>>, \quad w = )"
       R"(1/[<<mustafa-li-2015/eq-3-weight>>]^{<<mustafa-li-2015/eq-3-weight-exponent>>})",
       "", Verdict::holds_for_all, iteration});
  add({key_prefix + "advice", "sections 2.3 and A.1",
       "n >= 3 gives better results; a small delta and m = 5 or 6 are good choices.", "",
       R"(n \geq 3, \quad \delta \text{ small}, \quad m = 5, 6)", "", Verdict::not_checkable, [](const Context&) {
         return not_checkable(
             "advice from experiments whose data were not published; how many iterations suffice depends on the size "
             "of "
             "the outliers (docs/l1.md, section 3)");
       }});
}

}  // namespace subcert::statements::mustafa_li_2015
