// Section 3 and Appendix B.1: the scheme D_2n for surfaces.

#include "mustafa_li_2015.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/data/l1/l1_regression.hpp>

namespace subcert::statements::mustafa_li_2015 {
namespace {

std::vector<Variable> variables(const std::string& name, int count) {
  std::vector<Variable> result;
  for (int k = 1; k <= count; ++k) result.push_back({name + std::to_string(k), k});
  return result;
}

/// Everything that the printed (11) to (14) and (16) to (19) give for a window: tau, kappa, lambda, chi, beta.
Values computed(const Context& context, const WeightedWindow& window, long first, long last) {
  Values values;
  for (int k = 1; k <= 6; ++k)
    values.emplace_back("tau" + std::to_string(k),
                        sum_over(window, context.formula(key_prefix + "eq-14-tau-" + std::to_string(k)), first, last));
  for (int k = 1; k <= 6; ++k)
    values.emplace_back("lambda" + std::to_string(k),
                        context.formula(key_prefix + "eq-13-lambda-" + std::to_string(k))(values));
  values.emplace_back("kappa", context.formula(key_prefix + "eq-12")(values));
  for (int k = 1; k <= 3; ++k)
    values.emplace_back("chi" + std::to_string(k),
                        sum_over(window, context.formula(key_prefix + "eq-19-chi-" + std::to_string(k)), first, last));
  return values;
}

/// The rule as printed, psi_k of (11) put in.
Formula rule(const Context& context, const std::string& name, Form form) {
  Formula term = context.formula(key_prefix + "eq-10-" + name, form);
  for (const char* k : {"1", "2", "3"})
    term = term.replaced("psi" + std::string(k), context.formula(key_prefix + "eq-11-psi-" + k));
  return term;
}

Rational library_value(const WeightedWindow& window, const Rational& x, const Rational& y) {
  std::vector<data::LatticePoint> nodes;
  for (const auto& [r, s] : window.nodes) nodes.push_back({r, s});
  return data::weighted_fit(data::RegressionWindow(nodes, 1, {{x, y}}), window.weights, window.data).front();
}

/// The printed rules with random weights; then the weights at which psi_1 vanishes.
Trial rules_10(const Context& context, Form form) {
  const std::vector<Formula> xs = context.list(key_prefix + "surface-x"), ys = context.list(key_prefix + "surface-y");
  Trial trial;
  for (std::size_t k = 0; k < 4; ++k) {
    const Formula term = rule(context, rule_names[k], form);
    const Rational x = xs.at(k)({}), y = ys.at(k)({});
    for (long n = 1; n <= context.reach(2, 4); ++n)
      for (unsigned seed = 1; seed <= 2; ++seed) {
        const WeightedWindow data = random_window(1 - n, n, 2, seed);
        const std::vector<Rational> beta = weighted_coefficients(data, plane);
        const Rational printed = sum_over(data, term, 1 - n, n, computed(context, data, 1 - n, n));
        const std::string where = "rule " + rule_names[k] + ", " + weighted_case(n, seed);
        trial.equal(printed, beta[0] + x * beta[1] + y * beta[2], where);
        if (!trial.equal(printed, library_value(data, x, y), where + ", against the library")) return trial;
      }
  }
  for (std::size_t k = 0; k < 4; ++k) {
    WeightedWindow data = window(-1, 2, 2);
    data.weights[10] = 5;  // at (1, 1)
    data.data[14] = 1;     // at (1, 2)
    const Rational x = xs.at(k)({}), y = ys.at(k)({});
    try {
      trial.equal(sum_over(data, rule(context, rule_names[k], form), -1, 2, computed(context, data, -1, 2)),
                  library_value(data, x, y), "rule " + rule_names[k] + ", n = 2");
    } catch (const Undefined&) {
      trial.require(false,
                    "rule " + rule_names[k] +
                        ", n = 2, weights 1, but 5 at r = s = 1: psi_1 = 0 at r = 1, s = 2, and the rule divides "
                        "by it");
    }
  }
  return trial;
}

/// The rule is (psi_1 + x psi_2 + y psi_3)/kappa w f wherever psi_1 is not zero.
Trial rule_identities(const Context& context, Form form) {
  const std::vector<Formula> xs = context.list(key_prefix + "surface-x"), ys = context.list(key_prefix + "surface-y");
  Trial trial;
  for (std::size_t k = 0; k < 4; ++k)
    trial.follow(identity(context.formula(key_prefix + "eq-10-" + rule_names[k], form),
                          (f("psi1") + xs.at(k) * f("psi2") + ys.at(k) * f("psi3")) / f("kappa") * f("w") * f("f"),
                          {{"psi1", 1}, {"psi2", 2}, {"psi3", 3}, {"kappa", 5}, {"w", 1}, {"f", 1}}));
  return trial;
}

Outcome equation_10(const Context& context) {
  Trial printed = rule_identities(context, Form::printed);
  printed.follow(rules_10(context, Form::printed));
  Trial corrected = rule_identities(context, Form::corrected);
  corrected.follow(rules_10(context, Form::corrected));
  Outcome outcome = printed.outcome(corrected.for_all(
      "all n >= 1 and all positive weights",
      "with (11) to (14) the corrected rules are rows of the inverse of the normal equations, as identities in tau_1, "
      "..., tau_6"));
  if (outcome.verdict == Verdict::misprint)
    outcome.argument = "where psi_1 is not zero, the printed rules have the right values; " + outcome.argument;
  return outcome;
}

std::vector<std::vector<Formula>> lambda_matrix() {
  return {{f("lambda1"), f("-lambda2"), f("lambda3")},
          {f("-lambda2"), f("lambda4"), f("-lambda5")},
          {f("lambda3"), f("-lambda5"), f("lambda6")}};
}

/// psi_k is row k of the adjoint times (1, r, s).
Outcome equation_11(const Context& context) {
  const auto rows = lambda_matrix();
  std::vector<Variable> names = variables("lambda", 6);
  names.push_back({"r", 1});
  names.push_back({"s", 1});
  Trial trial;
  for (std::size_t k = 0; k < 3; ++k)
    trial.follow(identity(context.formula(key_prefix + "eq-11-psi-" + std::to_string(k + 1)),
                          rows[k][0] + rows[k][1] * f("r") + rows[k][2] * f("s"), names));
  return trial.for_all("all n and all weights", "rows of the adjoint of the normal equations times (1, r, s)")
      .outcome();
}

Outcome equations_12_13(const Context& context) {
  std::vector<Formula> lambda;
  for (int k = 1; k <= 6; ++k) lambda.push_back(context.formula(key_prefix + "eq-13-lambda-" + std::to_string(k)));
  const Formula zero = f("0");
  const std::vector<std::vector<Formula>> matrix{
      {f("tau1"), f("tau2"), f("tau3")}, {f("tau2"), f("tau4"), f("tau5")}, {f("tau3"), f("tau5"), f("tau6")}},
      adjoint{{lambda[0], zero - lambda[1], lambda[2]},
              {zero - lambda[1], lambda[3], zero - lambda[4]},
              {lambda[2], zero - lambda[4], lambda[5]}};
  Trial trial = adjoint_identity(matrix, adjoint, context.formula(key_prefix + "eq-12"), variables("tau", 6));
  return trial
      .for_all(
          "all n >= 1 and all positive weights",
          "matrix times adjoint is kappa times the identity, entry by entry, as polynomials in tau_1, ..., tau_6; the "
          "matrix is positive definite, so kappa > 0")
      .outcome();
}

Outcome equation_14(const Context& context) {
  std::vector<Formula> terms;
  for (int k = 1; k <= 6; ++k) terms.push_back(context.formula(key_prefix + "eq-14-tau-" + std::to_string(k)));
  Trial trial = entries_of_normal_equations(terms, {"w", "r*w", "s*w", "r^2*w", "r*s*w", "s^2*w"});
  trial.follow(summation_range(context.formula(key_prefix + "surface-first"),
                               context.formula(key_prefix + "surface-last"), true));
  return trial.outcome();
}

Outcome equation_15(const Context& context, const std::string& id) {
  return weights_of_modulus(context.formula(key_prefix + id), context.formula(key_prefix + id + "-exponent")({}),
                            f("f - beta1 - r*beta2 - s*beta3"),
                            {{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"beta3", 4}, {"r", 5}, {"s", 6}, {"delta", 7}})
      .outcome();
}

Outcome equations_16_18(const Context& context) {
  const auto rows = lambda_matrix();
  std::vector<Variable> names = variables("lambda", 6);
  for (const Variable& chi : variables("chi", 3)) names.push_back(chi);
  names.push_back({"kappa", 1});
  Trial trial;
  for (std::size_t k = 0; k < 3; ++k) {
    const Formula beta = context.formula(key_prefix + "eq-" + std::to_string(16 + k));
    for (long n = 1; n <= context.reach(2, 4); ++n) {
      const WeightedWindow data = random_window(1 - n, n, 2, 3);
      trial.equal(beta(computed(context, data, 1 - n, n)), weighted_coefficients(data, plane)[k],
                  weighted_case(n, 3) + ", beta_" + std::to_string(k + 1));
    }
    trial.follow(
        identity(beta, (rows[k][0] * f("chi1") + rows[k][1] * f("chi2") + rows[k][2] * f("chi3")) / f("kappa"), names));
  }
  return trial
      .for_all("all n >= 1 and all positive weights",
               "rows of the adjoint (13) times the right-hand sides (19) over kappa; also compared with the normal "
               "equations for random weights")
      .outcome();
}

Outcome equation_19(const Context& context) {
  std::vector<Formula> terms;
  for (int k = 1; k <= 3; ++k) terms.push_back(context.formula(key_prefix + "eq-19-chi-" + std::to_string(k)));
  return entries_of_normal_equations(terms, {"w*f", "r*w*f", "s*w*f"}).outcome();
}

Outcome equation_20(const Context& context) {
  const Formula xi = context.formula(key_prefix + "xi");
  const auto beta = [&](const char* k) { return context.formula(key_prefix + "eq-20-beta-" + k).replaced("xi", xi); };
  const GridFit ordinary{
      beta("1") + f("x") * beta("2") + f("y") * beta("3"), {-1, 1}, {1, 0}, f("x"), f("y"), 1, 1, {{"x", 0}, {"y", 0}}};
  return grid_fit(ordinary, context.reach(4, 10)).outcome();
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
  const Formula objective = context.formula(key_prefix + "surface-objective");
  Trial printed, corrected;
  for (Form form : {Form::printed, Form::corrected}) {
    Trial& trial = form == Form::printed ? printed : corrected;
    trial.follow(identity(objective, f("w*(f - beta1 - r*beta2 - s*beta3)^2"),
                          {{"w", 1}, {"f", 1}, {"beta1", 2}, {"beta2", 3}, {"beta3", 4}, {"r", 5}, {"s", 6}}));
    trial.equal(minimum_over(objective, context.words(key_prefix + "surface-unknowns", form)), 0,
                "n = 1, data 1 + 2r + 4s, weights 1, minimum over " +
                    std::string(form == Form::printed ? "the coefficients printed, the others 0" : "all coefficients"));
  }
  return printed.outcome(corrected.for_all("all n >= 1", "the normal equations have as many unknowns as the plane"));
}

}  // namespace

void add_surfaces(PaperStatements& to) {
  to.transcriptions.insert(
      to.transcriptions.end(),
      {
          {key_prefix + "surface-unknowns", "beta1 beta2 {=> beta3}"},
          {key_prefix + "surface-objective", "w*(f - beta1 - r*beta2 - s*beta3)^2"},
          {key_prefix + "surface-weight", "(f - beta1 - r*beta2 - s*beta3)^2 + delta"},
          {key_prefix + "surface-weight-exponent", "1/2"},
          {key_prefix + "surface-x", "[1/4, 3/4, 1/4, 3/4]"},
          {key_prefix + "surface-y", "[1/4, 1/4, 3/4, 3/4]"},
          {key_prefix + "surface-first", "-n + 1"},
          {key_prefix + "surface-last", "n"},
          {key_prefix + "eq-10-00",
           "{psi1/kappa*(1 + psi2/(4*psi1) + psi3/(4*psi1)) => (psi1 + psi2/4 + psi3/4)/kappa}*w*f"},
          {key_prefix + "eq-10-10",
           "{psi1/kappa*(1 + 3*psi2/(4*psi1) + psi3/(4*psi1)) => (psi1 + 3*psi2/4 + psi3/4)/kappa}*w*f"},
          {key_prefix + "eq-10-01",
           "{psi1/kappa*(1 + psi2/(4*psi1) + 3*psi3/(4*psi1)) => (psi1 + psi2/4 + 3*psi3/4)/kappa}*w*f"},
          {key_prefix + "eq-10-11",
           "{psi1/kappa*(1 + 3*psi2/(4*psi1) + 3*psi3/(4*psi1)) => (psi1 + 3*psi2/4 + 3*psi3/4)/kappa}*w*f"},
          {key_prefix + "eq-11-psi-1", "lambda1 - lambda2*r + lambda3*s"},
          {key_prefix + "eq-11-psi-2", "-lambda2 + lambda4*r - lambda5*s"},
          {key_prefix + "eq-11-psi-3", "lambda3 - lambda5*r + lambda6*s"},
          {key_prefix + "eq-12", "tau1*tau4*tau6 - tau1*tau5^2 - tau2^2*tau6 + 2*tau2*tau3*tau5 - tau3^2*tau4"},
          {key_prefix + "eq-13-lambda-1", "tau4*tau6 - tau5^2"},
          {key_prefix + "eq-13-lambda-2", "tau2*tau6 - tau3*tau5"},
          {key_prefix + "eq-13-lambda-3", "tau2*tau5 - tau3*tau4"},
          {key_prefix + "eq-13-lambda-4", "tau1*tau6 - tau3^2"},
          {key_prefix + "eq-13-lambda-5", "tau1*tau5 - tau2*tau3"},
          {key_prefix + "eq-13-lambda-6", "tau1*tau4 - tau2^2"},
          {key_prefix + "eq-14-tau-1", "w"},
          {key_prefix + "eq-14-tau-2", "r*w"},
          {key_prefix + "eq-14-tau-3", "s*w"},
          {key_prefix + "eq-14-tau-4", "r^2*w"},
          {key_prefix + "eq-14-tau-5", "r*s*w"},
          {key_prefix + "eq-14-tau-6", "s^2*w"},
          {key_prefix + "eq-15", "(f - (beta1 + r*beta2 + s*beta3))^2 + delta"},
          {key_prefix + "eq-15-exponent", "1/2"},
          {key_prefix + "eq-16", "1/kappa*(lambda1*chi1 - lambda2*chi2 + lambda3*chi3)"},
          {key_prefix + "eq-17", "1/kappa*(-lambda2*chi1 + lambda4*chi2 - lambda5*chi3)"},
          {key_prefix + "eq-18", "1/kappa*(lambda3*chi1 - lambda5*chi2 + lambda6*chi3)"},
          {key_prefix + "eq-19-chi-1", "w*f"},
          {key_prefix + "eq-19-chi-2", "r*w*f"},
          {key_prefix + "eq-19-chi-3", "s*w*f"},
          {key_prefix + "xi", "1/(2*n^2*(4*n^2 - 1))"},
          {key_prefix + "eq-20-beta-1", "1/2*xi*(4*n^2 + 5 - 6*r - 6*s)"},
          {key_prefix + "eq-20-beta-2", "3*xi*(2*r - 1)"},
          {key_prefix + "eq-20-beta-3", "3*xi*(2*s - 1)"},
      });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  const auto listed = [](const std::string& symbol, const std::string& id, int count) {
    std::string text;
    for (int k = 1; k <= count; ++k)
      text += (k == 1 ? "\\" : ", \\quad \\") + symbol + "_" + std::to_string(k) + " = <<mustafa-li-2015/" + id + "-" +
              std::to_string(k) + ">>";
    return text;
  };
  add({key_prefix + "surface-problem", "section 3, display", "The weighted problem of the plane.",
       "the smallest value over the coefficients that are named",
       R"(\arg\min_{\beta_1, \beta_2} \sum_{r,s} <<mustafa-li-2015/surface-objective>>)",
       R"(\arg\min_{\beta_1, \beta_2, \beta_3} \sum_{r,s} <<mustafa-li-2015/surface-objective>>)", Verdict::misprint,
       surface_problem});
  add({key_prefix + "surface-weights", "section 3, after the display", "The dynamic weights of surfaces.",
       "that they are h'(t)/t, as identities",
       R"(w = 1/[<<mustafa-li-2015/surface-weight>>]^{<<mustafa-li-2015/surface-weight-exponent>>})", "",
       Verdict::holds_for_all, [](const Context& c) { return equation_15(c, "surface-weight"); }});
  std::string printed;
  for (const std::string& name : rule_names)
    printed += (printed.empty() ? "" : ", \\quad ") + std::string("<<mustafa-li-2015/eq-10-") + name + ">>";
  add({key_prefix + "eq-10", "Appendix B.1, equation (10)", "The four rules of D_2n.",
       "identities in psi and kappa; values against normal equations and library for random weights, and where psi_1 = "
       "0",
       printed, printed, Verdict::misprint, equation_10});
  add({key_prefix + "eq-11", "Appendix B.1, equation (11)", "psi_1, psi_2, psi_3.",
       "rows of the adjoint, as identities", listed("psi", "eq-11-psi", 3), "", Verdict::holds_for_all, equation_11});
  add({key_prefix + "eq-12-13", "Appendix B.1, equations (12) and (13)",
       "Determinant and adjoint of the normal equations.", "matrix times adjoint, entry by entry",
       R"(\kappa = <<mustafa-li-2015/eq-12>>, \quad )" + listed("lambda", "eq-13-lambda", 6), "",
       Verdict::holds_for_all, equations_12_13});
  add({key_prefix + "eq-14", "Appendix B.1, equation (14)", "The sums tau_1, ..., tau_6.",
       "the entries of the normal equations", R"(\tau_k = \sum_{r,s}: \; )" + listed("tau", "eq-14-tau", 6), "",
       Verdict::holds_for_all, equation_14});
  add({key_prefix + "eq-15", "Appendix B.1, equation (15)", "The dynamic weights of surfaces.",
       "that they are h'(t)/t, as identities",
       R"(w = 1/[<<mustafa-li-2015/eq-15>>]^{<<mustafa-li-2015/eq-15-exponent>>})", "", Verdict::holds_for_all,
       [](const Context& c) { return equation_15(c, "eq-15"); }});
  add({key_prefix + "eq-16-18", "Appendix B.1, equations (16), (17) and (18)", "The coefficients of the next plane.",
       "as identities, and against the normal equations for random weights",
       R"(\beta_1 = <<mustafa-li-2015/eq-16>>, \quad \beta_2 = <<mustafa-li-2015/eq-17>>, \quad \beta_3 = )"
       R"(<<mustafa-li-2015/eq-18>>)",
       "", Verdict::holds_for_all, equations_16_18});
  add({key_prefix + "eq-19", "Appendix B.1, equation (19)", "The right-hand sides chi.",
       "those of the normal equations", R"(\chi_k = \sum_{r,s}: \; )" + listed("chi", "eq-19-chi", 3), "",
       Verdict::holds_for_all, equation_19});
  add({key_prefix + "eq-20", "Appendix B.1, equation (20)", "The starting values are the least squares plane.",
       "value and slopes against the normal equations, at all x and y",
       R"(\xi_n = <<mustafa-li-2015/xi>>, \quad )" + listed("beta", "eq-20-beta", 3), "", Verdict::holds_for_all,
       equation_20});
}

}  // namespace subcert::statements::mustafa_li_2015
