// Propositions 2.1 and 2.3: least squares cubics to 2n and to 2n+1 data, derived.

#include "mustafa_hameed.hpp"

#include <subcert/proofs-checks/statements/identities.hpp>

namespace subcert::statements::mustafa_hameed {
namespace {

/// beta_0 + beta_1 x + beta_2 x^2 + beta_3 x^3 is the ordinary cubic, for all x.
Outcome starting_values(const Context& context, const std::vector<std::string>& equations, bool even) {
  Formula value = context.formula(key_prefix + equations[0]);
  for (std::size_t k = 1; k < equations.size(); ++k)
    value = value + context.formula(key_prefix + equations[k]) * f("x^" + std::to_string(k));
  value = value / context.formula(key_prefix + (even ? "divisor-2n" : "divisor-odd"));
  const Fit cubic{value, "r", {-1, even ? 1 : 0}, {1, 0}, {1, 0}, f("x"), 3, 2, {{"x", 0}}};
  Outcome outcome = fit(cubic, context.reach(5, 12), [](long) {
                      return std::vector<Values>{{{"x", 0}}, {{"x", 1}}, {{"x", Rational(1, 4)}}, {{"x", -2}}};
                    }).outcome();
  outcome.argument = "the printed formulas are lost; of the derived ones: " + outcome.argument;
  return outcome;
}

}  // namespace

void add_starting_values(PaperStatements& to) {
  to.transcriptions.insert(
      to.transcriptions.end(),
      {
          {key_prefix + "divisor-2n", "n*(n^2 - 1)*(4*n^2 - 1)*(4*n^2 - 9)"},
          {key_prefix + "eq-2.9",
           "(n^2 - 1)*(105*r^3 - 30*(n^2 + 3)*r^2 - 15*(3*n^2 - 5)*r + 3*(2*n^2 - 3)*(3*n^2 + 2))"},
          {key_prefix + "eq-2.10",
           "-35*(6*n^2 - 11)*r^3 + 75*(3*n^2 - 5)*r^2 + 25*(6*n^4 - 18*n^2 + 11)*r - 15*(n^2 - 1)*(3*n^2 - 5)"},
          {key_prefix + "eq-2.11", "-525*r^3 + 45*(2*n^2 + 13)*r^2 + 75*(3*n^2 - 5)*r - 30*(n^2 - 1)*(n^2 + 3)"},
          {key_prefix + "eq-2.12", "350*r^3 - 525*r^2 - 35*(6*n^2 - 11)*r + 105*(n^2 - 1)"},
          {key_prefix + "divisor-odd", "n*(n - 1)*(n + 1)*(n + 2)*(2*n - 1)*(2*n + 1)*(2*n + 3)"},
          {key_prefix + "eq-2.21", "3*n*(n - 1)*(n + 1)*(n + 2)*(3*n^2 + 3*n - 1 - 5*r^2)"},
          {key_prefix + "eq-2.22", "25*(3*n^4 + 6*n^3 - 3*n + 1)*r - 35*(3*n^2 + 3*n - 1)*r^3"},
          {key_prefix + "eq-2.23", "15*(n - 1)*(n + 2)*(3*r^2 - n^2 - n)"},
          {key_prefix + "eq-2.24", "175*r^3 - 35*(3*n^2 + 3*n - 1)*r"},
      });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  const auto displays = [](int first, const std::string& divisor) {
    std::string text = R"(\text{lost; derived: } D = <<mustafa-hameed/)" + divisor + ">>";
    for (int k = 0; k < 4; ++k)
      text += R"(, \quad \beta_)" + std::to_string(k) + R"( = \frac1D \sum_r (<<mustafa-hameed/eq-2.)" +
              std::to_string(first + k) + ">>) f_{i+r}";
    return text;
  };
  add({key_prefix + "proposition-2.1", "Proposition 2.1, equations (2.9) to (2.12)",
       "The starting values of the cubic to 2n data.", "derived closed forms against the cubic fits, at all x",
       displays(9, "divisor-2n"), "", Verdict::holds_for_all, [](const Context& c) {
         return starting_values(c, {"eq-2.9", "eq-2.10", "eq-2.11", "eq-2.12"}, true);
       }});
  add({key_prefix + "proposition-2.3", "Proposition 2.3, equations (2.21) to (2.24)",
       "The starting values of the cubic to 2n+1 data.", "derived closed forms against the cubic fits, at all x",
       displays(21, "divisor-odd"), "", Verdict::holds_for_all, [](const Context& c) {
         return starting_values(c, {"eq-2.21", "eq-2.22", "eq-2.23", "eq-2.24"}, false);
       }});
}

}  // namespace subcert::statements::mustafa_hameed
