// Section 3 and Appendix B.1: the scheme D_2n for surfaces.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>

namespace subcert::statements::mustafa_li_2015 {

Values sums_of_surface(const Context& context, const WeightedWindow& window, long first, long last) {
  Values values;
  add_sums(values, "tau", numbered_formulas(context, "eq-14-tau-", 6), window, first, last);
  for (const Variable& k : numbered("", 6))
    values.emplace_back("lambda" + k.name, context.formula("eq-13-lambda-" + k.name)(values));
  values.emplace_back("kappa", context.formula("eq-12")(values));
  add_sums(values, "chi", numbered_formulas(context, "eq-19-chi-", 3), window, first, last);
  return values;
}

namespace {

/// The rule as printed, psi_k of (11) put in.
Formula rule(const Context& context, const std::string& name) {
  Formula term = context.formula("eq-10-" + name);
  for (const std::string k : {"1", "2", "3"}) term = term.replaced("psi" + k, context.formula("eq-11-psi-" + k));
  return term;
}

/// The rules are (psi_1 + x psi_2 + y psi_3)/kappa w f: rows of the inverse of the normal equations. The quotients
/// psi_2/psi_1 and psi_3/psi_1 are multiplied by psi_1, so that a psi_1 = 0 can be removed.
Outcome equation_10(const Context& context) {
  const std::vector<Formula> xs = context.list("surface-x"), ys = context.list("surface-y");
  Trial trial;
  for (std::size_t k = 0; k < 4; ++k) {
    const Rational x = xs.at(k)({}), y = ys.at(k)({});
    trial.follow(identity(context.formula("eq-10-" + rule_names[k]),
                          (f("psi1") + xs.at(k) * f("psi2") + ys.at(k) * f("psi3")) / f("kappa") * f("w") * f("f"),
                          {{"psi1", 1}, {"psi2", 2}, {"psi3", 3}, {"kappa", 5}, {"w", 1}, {"f", 1}}));
    for (long n = 1; n <= context.reach(2, 4) && !trial.failed(); ++n)
      for (unsigned seed = 1; seed <= 2; ++seed) {
        const WeightedWindow data = random_window(1 - n, n, 2, seed);
        const std::vector<Rational> beta = weighted_coefficients(data, plane);
        const Rational printed = sum_over(data, rule(context, rule_names[k]), 1 - n, n,
                                          sums_of_surface(context, data, 1 - n, n));
        const std::string where = "rule " + rule_names[k] + ", " + weighted_case(n, seed);
        trial.equal(printed, beta[0] + x * beta[1] + y * beta[2], where);
        trial.equal(printed, library_value(data, 1, x, y), where + ", against the library");
      }
  }
  return trial.for_all("all n >= 1 and all positive weights",
                       "with (11) to (14) the rules are rows of the inverse of the normal equations, as identities in "
                       "tau_1, ..., tau_6. Where psi_1 = 0 the factor is to be multiplied out first; such weights "
                       "exist (n = 2, all 1 but 5 at r = s = 1)");
}

std::vector<std::vector<Formula>> lambda_matrix() {
  return {{f("lambda1"), f("-lambda2"), f("lambda3")},
          {f("-lambda2"), f("lambda4"), f("-lambda5")},
          {f("lambda3"), f("-lambda5"), f("lambda6")}};
}

/// psi_k is row k of the adjoint times (1, r, s).
Outcome equation_11(const Context& context) {
  const auto rows = lambda_matrix();
  std::vector<Variable> names = numbered("lambda", 6);
  names.push_back({"r", 1});
  names.push_back({"s", 1});
  Trial trial;
  for (std::size_t k = 0; k < 3; ++k)
    trial.follow(identity(context.formula("eq-11-psi-" + std::to_string(k + 1)),
                          rows[k][0] + rows[k][1] * f("r") + rows[k][2] * f("s"), names));
  return trial.for_all("all n and all weights", "rows of the adjoint of the normal equations times (1, r, s)");
}

Outcome equations_12_13(const Context& context) {
  const std::vector<Formula> lambda = numbered_formulas(context, "eq-13-lambda-", 6);
  const Formula zero = f("0");
  const std::vector<std::vector<Formula>> matrix{
      {f("tau1"), f("tau2"), f("tau3")}, {f("tau2"), f("tau4"), f("tau5")}, {f("tau3"), f("tau5"), f("tau6")}},
      adjoint{{lambda[0], zero - lambda[1], lambda[2]},
              {zero - lambda[1], lambda[3], zero - lambda[4]},
              {lambda[2], zero - lambda[4], lambda[5]}};
  Trial trial = adjoint_identity(matrix, adjoint, context.formula("eq-12"), numbered("tau", 6));
  return trial.for_all(
      "all n >= 1 and all positive weights",
      "matrix times adjoint is kappa times the identity, entry by entry, as polynomials in tau_1, ..., tau_6; the "
      "matrix is positive definite, so kappa > 0");
}

Outcome equation_14(const Context& context) {
  Trial trial = entries_of_normal_equations(numbered_formulas(context, "eq-14-tau-", 6),
                                            {"w", "r*w", "s*w", "r^2*w", "r*s*w", "s^2*w"});
  trial.follow(summation_range(context.formula("surface-first"), context.formula("surface-last"), true));
  return trial;
}

Outcome equation_15(const Context& context, const std::string& id) {
  return weights_of_modulus(context.formula(id), context.formula(id + "-exponent")({}),
                            f("f - beta1 - r*beta2 - s*beta3"),
                            {{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"beta3", 4}, {"r", 5}, {"s", 6}, {"delta", 7}});
}

Outcome equations_16_18(const Context& context) {
  const auto rows = lambda_matrix();
  std::vector<Variable> names = numbered("lambda", 6);
  for (const Variable& chi : numbered("chi", 3)) names.push_back(chi);
  names.push_back({"kappa", 1});
  Trial trial;
  for (std::size_t k = 0; k < 3; ++k) {
    const Formula beta = context.formula("eq-" + std::to_string(16 + k));
    for (long n = 1; n <= context.reach(2, 4); ++n) {
      const WeightedWindow data = random_window(1 - n, n, 2, 3);
      trial.equal(beta(sums_of_surface(context, data, 1 - n, n)), weighted_coefficients(data, plane)[k],
                  weighted_case(n, 3) + ", beta_" + std::to_string(k + 1));
    }
    trial.follow(
        identity(beta, (rows[k][0] * f("chi1") + rows[k][1] * f("chi2") + rows[k][2] * f("chi3")) / f("kappa"), names));
  }
  return trial.for_all(
      "all n >= 1 and all positive weights",
      "rows of the adjoint (13) times the right-hand sides (19) over kappa; also compared with the normal "
      "equations for random weights");
}

Outcome equation_19(const Context& context) {
  return entries_of_normal_equations(numbered_formulas(context, "eq-19-chi-", 3), {"w*f", "r*w*f", "s*w*f"});
}

Outcome equation_20(const Context& context) {
  const Formula xi = context.formula("xi");
  const auto beta = [&](const std::string& k) { return context.formula("eq-20-beta-" + k).replaced("xi", xi); };
  const GridFit ordinary{
      beta("1") + f("x") * beta("2") + f("y") * beta("3"), {-1, 1}, {1, 0}, f("x"), f("y"), 1, 1, {{"x", 0}, {"y", 0}}};
  return grid_fit(ordinary, context.reach(4, 10));
}

/// The smallest value of the objective over the coefficients named, the others 0, for data 1 + 2r + 4s.
Rational minimum_over(const Formula& objective, const std::vector<std::string>& names) {
  WeightedWindow data = window(0, 1, 2);
  std::vector<Formula> basis;
  for (const std::string& name : names)
    basis.push_back(name == "beta1" ? f("1") : name == "beta2" ? f("r") : name == "beta3" ? f("s") : f("r*s"));
  for (std::size_t i = 0; i < data.nodes.size(); ++i)
    data.data[i] = 1 + 2 * data.nodes[i].first + 4 * data.nodes[i].second;
  const std::vector<Rational> solution = weighted_coefficients(data, basis);
  Values values{{"beta1", 0}, {"beta2", 0}, {"beta3", 0}};
  for (std::size_t k = 0; k < names.size(); ++k)
    for (auto& [name, value] : values)
      if (name == names[k]) value = solution[k];
  return sum_over(data, objective, 0, 1, values);
}

Outcome surface_problem(const Context& context) {
  const Formula objective = context.formula("surface-objective");
  return in_both_forms([&](Form form) {
    Trial trial;
    trial.follow(identity(objective, f("w*(f - beta1 - r*beta2 - s*beta3)^2"),
                          {{"w", 1}, {"f", 1}, {"beta1", 2}, {"beta2", 3}, {"beta3", 4}, {"r", 5}, {"s", 6}}));
    trial.equal(minimum_over(objective, context.words("surface-unknowns", form)), 0,
                "n = 1, data 1 + 2r + 4s, weights 1, minimum over " +
                    std::string(form == Form::printed ? "the coefficients printed, the others 0" : "all coefficients"));
    return trial.for_all("all n >= 1", "the normal equations have as many unknowns as the plane");
  });
}

}  // namespace

Checks surfaces() {
  return {{"surface-problem", surface_problem},
          {"surface-weights", [](const Context& c) { return equation_15(c, "surface-weight"); }},
          {"eq-10", equation_10},
          {"eq-11", equation_11},
          {"eq-12-13", equations_12_13},
          {"eq-14", equation_14},
          {"eq-15", [](const Context& c) { return equation_15(c, "eq-15"); }},
          {"eq-16-18", equations_16_18},
          {"eq-19", equation_19},
          {"eq-20", equation_20}};
}

}  // namespace subcert::statements::mustafa_li_2015
