// Propositions 2.1 and 2.3: least squares cubics to 2n and to 2n+1 data, derived.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/identities.hpp>

namespace subcert::statements::mustafa_hameed {
namespace {

/// beta_0 + beta_1 x + beta_2 x^2 + beta_3 x^3 is the ordinary cubic, for all x.
Outcome starting_values(const Context& context, const std::vector<std::string>& equations, bool even) {
  Formula value = context.formula(equations[0]);
  for (std::size_t k = 1; k < equations.size(); ++k)
    value = value + context.formula(equations[k]) * f("x^" + std::to_string(k));
  value = value / context.formula((even ? "divisor-2n" : "divisor-odd"));
  const Fit cubic{value, "r", {-1, even ? 1 : 0}, {1, 0}, {1, 0}, f("x"), 3, 2, {{"x", 0}}};
  Outcome outcome = fit(cubic, context.reach(5, 12), [](long) {
    return std::vector<Values>{{{"x", 0}}, {{"x", 1}}, {{"x", Rational(1, 4)}}, {{"x", -2}}};
  });
  outcome.argument = "the printed formulas are lost; of the derived ones: " + outcome.argument;
  return outcome;
}

}  // namespace

Checks starting_values() {
  return {{"proposition-2.1",
           [](const Context& c) {
             return starting_values(c, {"eq-2.9", "eq-2.10", "eq-2.11", "eq-2.12"}, true);
           }},
          {"proposition-2.3", [](const Context& c) {
             return starting_values(c, {"eq-2.21", "eq-2.22", "eq-2.23", "eq-2.24"}, false);
           }}};
}

}  // namespace subcert::statements::mustafa_hameed
