// Sections 2.1 to 2.3: the reweighted cubic and its rules, derived.

#include "mustafa_hameed.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/data/l1/l1_regression.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <array>

namespace subcert::statements::mustafa_hameed {
namespace {

constexpr std::size_t terms = 4;

const std::vector<Formula> cubics{f("1"), f("r"), f("r^2"), f("r^3")};

/// lambda_k in row i, column j of the adjoint, which is symmetric.
constexpr std::array<std::array<int, terms>, terms> place{{{1, 2, 3, 4}, {2, 5, 6, 7}, {3, 6, 8, 9}, {4, 7, 9, 10}}};

std::string numbered(const std::string& name, std::size_t k) { return name + std::to_string(k); }

std::vector<Variable> variables(const std::string& name, int count) {
  std::vector<Variable> result;
  for (int k = 1; k <= count; ++k) result.push_back({name + std::to_string(k), k});
  return result;
}

Formula lambda(const Context& context, int k) { return context.formula(key_prefix + "eq-2.18-" + std::to_string(k)); }

/// tau, lambda, kappa and chi of a window.
Values computed(const Context& context, const WeightedWindow& window, long first, long last) {
  Values values;
  for (std::size_t k = 1; k <= 7; ++k)
    values.emplace_back(numbered("tau", k),
                        sum_over(window, context.formula(key_prefix + numbered("eq-2.19-", k)), first, last));
  std::vector<Rational> entries;
  for (int k = 1; k <= 10; ++k) entries.push_back(lambda(context, k)(values));
  const Rational kappa = context.formula(key_prefix + "eq-2.17")(values);
  for (std::size_t k = 0; k < entries.size(); ++k) values.emplace_back(numbered("lambda", k + 1), entries[k]);
  values.emplace_back("kappa", kappa);
  for (std::size_t k = 1; k <= terms; ++k)
    values.emplace_back(numbered("chi", k),
                        sum_over(window, context.formula(key_prefix + numbered("eq-2.20-", k)), first, last));
  return values;
}

std::vector<std::string> names_of(const std::string& name, int count) {
  std::vector<std::string> result;
  for (const Variable& variable : variables(name, count)) result.push_back(variable.name);
  return result;
}

/// 0 and the unit vectors of the names.
std::vector<Values> corners(const std::vector<std::string>& names) {
  std::vector<Values> result;
  for (std::size_t one = 0; one <= names.size(); ++one) {
    Values corner;
    for (std::size_t k = 0; k < names.size(); ++k) corner.emplace_back(names[k], k == one ? 1 : 0);
    result.push_back(corner);
  }
  return result;
}

/// Of total degree at most 1 in the names, which a polynomial shows by its values at the corners.
bool is_linear_in(const Formula& formula, const std::vector<std::string>& names) {
  const Degrees degrees = formula.degrees(names);
  return degrees.numerator <= 1 && degrees.denominator == 0;
}

/// Windows of 2n data, n >= 2, with random weights.
Trial on_windows(int most, const std::function<Trial(long, const WeightedWindow&, const std::string&)>& visit) {
  Trial trial;
  for (long n = 2; n <= most; ++n)
    for (unsigned seed = 1; seed <= 2; ++seed)
      if (!trial.follow(visit(n, random_window(1 - n, n, 1, seed), weighted_case(n, seed)))) return trial;
  return trial;
}

/// Row i of the adjoint times a column.
Formula row_times(std::size_t i, const std::vector<Formula>& column) {
  Formula sum = f("0");
  for (std::size_t j = 0; j < terms; ++j)
    sum = sum + f(numbered("lambda", static_cast<std::size_t>(place[i][j]))) * column[j];
  return sum;
}

Outcome derived(Outcome outcome) {
  outcome.argument = "the printed formulas are lost; of the derived ones: " + outcome.argument;
  return outcome;
}

Outcome weights(const Context& context) {
  return derived(
      weights_of_modulus(context.formula(key_prefix + "eq-2.6"), context.formula(key_prefix + "eq-2.6-exponent")({}),
                         f("f - beta0 - beta1*r - beta2*r^2 - beta3*r^3"),
                         {{"f", 1}, {"beta0", 2}, {"beta1", 3}, {"beta2", 4}, {"beta3", 5}, {"r", 2}, {"delta", 7}})
          .outcome());
}

Outcome sums(const Context& context) {
  std::vector<Formula> entries;
  for (std::size_t k = 1; k <= 7; ++k) entries.push_back(context.formula(key_prefix + numbered("eq-2.19-", k)));
  for (std::size_t k = 1; k <= terms; ++k) entries.push_back(context.formula(key_prefix + numbered("eq-2.20-", k)));
  return derived(entries_of_normal_equations(entries, {"w", "r*w", "r^2*w", "r^3*w", "r^4*w", "r^5*w", "r^6*w", "w*f",
                                                       "r*w*f", "r^2*w*f", "r^3*w*f"})
                     .outcome());
}

Outcome adjoint(const Context& context) {
  std::vector<std::vector<Formula>> matrix, entries;
  for (std::size_t i = 0; i < terms; ++i) {
    matrix.emplace_back();
    entries.emplace_back();
    for (std::size_t j = 0; j < terms; ++j) {
      matrix[i].push_back(f(numbered("tau", i + j + 1)));
      entries[i].push_back(lambda(context, place[i][j]));
    }
  }
  const Formula kappa = context.formula(key_prefix + "eq-2.17");
  // One point for all entries first: it finds nearly every error at once.
  Trial trial;
  const Values point{{"tau1", 3}, {"tau2", 5}, {"tau3", 7}, {"tau4", 11}, {"tau5", 13}, {"tau6", 17}, {"tau7", 19}};
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; j < terms; ++j) {
      Rational sum = 0;
      for (std::size_t k = 0; k < terms; ++k) sum += matrix[i][k](point) * entries[k][j](point);
      trial.equal(sum, i == j ? kappa(point) : Rational(0), "entry " + std::to_string(i) + ", " + std::to_string(j));
    }
  if (!trial.failed()) trial.follow(adjoint_identity(matrix, entries, kappa, variables("tau", 7)));
  return derived(
      trial
          .for_all("all n >= 2 and all positive weights",
                   "matrix times adjoint is kappa times the identity, entry by entry, as polynomials in tau_1, "
                   "..., tau_7; the matrix is positive definite, so kappa > 0")
          .outcome());
}

Outcome coefficients(const Context& context) {
  Trial trial = on_windows(context.reach(4, 6), [&](long n, const WeightedWindow& window, const std::string& where) {
    const std::vector<Rational> beta = weighted_coefficients(window, cubics);
    const Values values = computed(context, window, 1 - n, n);
    Trial one;
    for (std::size_t k = 0; k < terms; ++k)
      one.equal(context.formula(key_prefix + "eq-2." + std::to_string(13 + k))(values), beta[k],
                where + ", " + numbered("beta_", k));
    return one;
  });
  const std::vector<std::string> lambdas = names_of("lambda", 10), chis = names_of("chi", 4);
  for (std::size_t k = 0; k < terms && !trial.failed(); ++k) {
    const Formula beta = context.formula(key_prefix + "eq-2." + std::to_string(13 + k));
    const Formula expected = row_times(k, {f("chi1"), f("chi2"), f("chi3"), f("chi4")});
    const Degrees in_kappa = beta.degrees("kappa");
    trial.require(
        is_linear_in(beta, lambdas) && is_linear_in(beta, chis) && in_kappa.numerator == 0 && in_kappa.denominator == 1,
        numbered("beta_", k) + " is not shown to be linear in lambda and in chi, over kappa");
    for (const Values& one : corners(lambdas))
      for (const Values& other : corners(chis))
        for (long kappa : {1, 2}) {
          Values values = one;
          values.insert(values.end(), other.begin(), other.end());
          values.emplace_back("kappa", kappa);
          trial.equal(beta(values) * kappa, expected(values), numbered("beta_", k) + ", " + to_text(values));
        }
  }
  return derived(trial
                     .for_all("all n >= 2 and all positive weights",
                              "bilinear in lambda and chi, and equal on a basis to rows of the adjoint times the "
                              "right-hand sides over kappa; compared with the normal equations for n = 2.." +
                                  std::to_string(context.reach(4, 6)) + " with random weights")
                     .outcome());
}

Rational library_value(const WeightedWindow& window, const Rational& x) {
  std::vector<data::LatticePoint> nodes;
  for (const auto& node : window.nodes) nodes.push_back({node.first, 0});
  return data::weighted_fit(data::RegressionWindow(nodes, 3, {{x, 0}}), window.weights, window.data).front();
}

/// psi_k is row k of the adjoint times (1, r, r^2, r^3), and the rules are (psi_1 + x psi_2 + x^2 psi_3 + x^3
/// psi_4)/kappa.
Outcome rules(const Context& context) {
  const std::vector<Formula> positions = context.list(key_prefix + "positions");
  std::vector<Formula> rule;
  for (const char* name : {"even", "odd"}) rule.push_back(context.formula(key_prefix + "eq-2.25-" + name));
  for (Formula& one : rule)
    for (std::size_t k = 1; k <= terms; ++k)
      one = one.replaced(numbered("psi", k), context.formula(key_prefix + "eq-2." + std::to_string(25 + k)));
  Trial trial = on_windows(context.reach(4, 6), [&](long n, const WeightedWindow& window, const std::string& where) {
    const Values values = computed(context, window, 1 - n, n);
    Trial one;
    for (std::size_t k = 0; k < 2; ++k)
      one.equal(sum_over(window, rule[k], 1 - n, n, values), library_value(window, positions.at(k)({})),
                where + ", rule " + std::to_string(k));
    return one;
  });
  if (!trial.failed())
    for (std::size_t k = 0; k < 2; ++k) {
      const Formula& x = positions.at(k);
      trial.follow(identity(
          context.formula(key_prefix + std::string("eq-2.25-") + (k == 0 ? "even" : "odd")),
          (f("psi1") + x * f("psi2") + x * x * f("psi3") + x * x * x * f("psi4")) / f("kappa") * f("w") * f("f"),
          {{"psi1", 1}, {"psi2", 2}, {"psi3", 3}, {"psi4", 5}, {"kappa", 1}, {"w", 1}, {"f", 1}}));
    }
  for (std::size_t k = 0; k < terms && !trial.failed(); ++k) {
    const Formula psi = context.formula(key_prefix + "eq-2." + std::to_string(26 + k));
    const Formula expected = row_times(k, cubics);
    const Degrees in_node = psi.degrees("r");
    trial.require(is_linear_in(psi, names_of("lambda", 10)) && in_node.numerator <= 3 && in_node.denominator == 0,
                  numbered("psi_", k + 1) + " is not shown to be linear in lambda and cubic in r");
    for (const Values& corner : corners(names_of("lambda", 10)))
      for (long r = 0; r <= 3; ++r) {
        Values values = corner;
        values.emplace_back("r", r);
        trial.equal(psi(values), expected(values), numbered("psi_", k + 1) + ", " + to_text(values));
      }
  }
  return derived(trial
                     .for_all("all n >= 2 and all positive weights",
                              "psi_1, ..., psi_4 are linear in lambda and cubic in r and agree on a basis: rows of the "
                              "adjoint times (1, r, r^2, r^3); compared with the library for n = 2.." +
                                  std::to_string(context.reach(4, 6)) + " with random weights")
                     .outcome());
}

/// All weights 1: the dual 2n-point scheme of degree 3.
Outcome ordinary(const Context& context) {
  Trial trial;
  for (int n = 2; n <= context.reach(5, 10); ++n)
    for (int degree = 1; degree <= 3; ++degree)
      for (bool even : {true, false}) {
        const LocalRegression scheme = even ? dual(n, degree) : dual_odd(n, degree);
        const Mask mask = regression_mask(scheme);
        const long first = even ? 1 - n : -n;
        std::vector<Formula> basis;
        for (int k = 0; k <= degree; ++k) basis.push_back(cubics[static_cast<std::size_t>(k)]);
        for (long r = first; r <= n; ++r) {
          WeightedWindow unit = window(first, n, 1);
          unit.data[static_cast<std::size_t>(r - first)] = 1;
          const std::vector<Rational> beta = weighted_coefficients(unit, basis);
          for (long k = 0; k < 2; ++k) {
            const Rational x = Rational(even ? 1 + 2 * k : 2 * k - 1, 4);
            Rational value = 0;
            for (std::size_t b = beta.size(); b-- > 0;) value = value * x + beta[b];
            trial.equal(mask.symbol().coefficient(scheme.first_output + k - 2 * r), value,
                        at("n", n) + ", degree " + std::to_string(degree) + ", " + at("r", r));
          }
        }
      }
  return trial.over("n = 2.." + std::to_string(context.reach(5, 10)) + ", degrees 1, 2, 3, 2n and 2n+1 points")
      .outcome();
}

}  // namespace

void add_iteration(PaperStatements& to) {
  const std::vector<std::string> lambdas{
      "tau3*tau5*tau7 - tau3*tau6^2 - tau4^2*tau7 + 2*tau4*tau5*tau6 - tau5^3",
      "-tau2*tau5*tau7 + tau2*tau6^2 + tau3*tau4*tau7 - tau3*tau5*tau6 - tau4^2*tau6 + tau4*tau5^2",
      "tau2*tau4*tau7 - tau2*tau5*tau6 - tau3^2*tau7 + tau3*tau4*tau6 + tau3*tau5^2 - tau4^2*tau5",
      "-tau2*tau4*tau6 + tau2*tau5^2 + tau3^2*tau6 - 2*tau3*tau4*tau5 + tau4^3",
      "tau1*tau5*tau7 - tau1*tau6^2 - tau3^2*tau7 + 2*tau3*tau4*tau6 - tau4^2*tau5",
      "-tau1*tau4*tau7 + tau1*tau5*tau6 + tau2*tau3*tau7 - tau2*tau4*tau6 - tau3*tau4*tau5 + tau4^3",
      "tau1*tau4*tau6 - tau1*tau5^2 - tau2*tau3*tau6 + tau2*tau4*tau5 + tau3^2*tau5 - tau3*tau4^2",
      "tau1*tau3*tau7 - tau1*tau5^2 - tau2^2*tau7 + 2*tau2*tau4*tau5 - tau3*tau4^2",
      "-tau1*tau3*tau6 + tau1*tau4*tau5 + tau2^2*tau6 - tau2*tau3*tau5 - tau2*tau4^2 + tau3^2*tau4",
      "tau1*tau3*tau5 - tau1*tau4^2 - tau2^2*tau5 + 2*tau2*tau3*tau4 - tau3^3"};
  for (std::size_t k = 0; k < lambdas.size(); ++k)
    to.transcriptions.push_back({key_prefix + numbered("eq-2.18-", k + 1), lambdas[k]});
  to.transcriptions.insert(
      to.transcriptions.end(),
      {
          {key_prefix + "positions", "[1/4, 3/4]"},
          {key_prefix + "eq-2.6", "(f - (beta0 + beta1*r + beta2*r^2 + beta3*r^3))^2 + delta"},
          {key_prefix + "eq-2.6-exponent", "1/2"},
          {key_prefix + "eq-2.13", "1/kappa*(lambda1*chi1 + lambda2*chi2 + lambda3*chi3 + lambda4*chi4)"},
          {key_prefix + "eq-2.14", "1/kappa*(lambda2*chi1 + lambda5*chi2 + lambda6*chi3 + lambda7*chi4)"},
          {key_prefix + "eq-2.15", "1/kappa*(lambda3*chi1 + lambda6*chi2 + lambda8*chi3 + lambda9*chi4)"},
          {key_prefix + "eq-2.16", "1/kappa*(lambda4*chi1 + lambda7*chi2 + lambda9*chi3 + lambda10*chi4)"},
          {key_prefix + "eq-2.17",
           "tau1*tau3*tau5*tau7 - tau1*tau3*tau6^2 - tau1*tau4^2*tau7 + 2*tau1*tau4*tau5*tau6 - tau1*tau5^3 - "
           "tau2^2*tau5*tau7 + tau2^2*tau6^2 + 2*tau2*tau3*tau4*tau7 - 2*tau2*tau3*tau5*tau6 - 2*tau2*tau4^2*tau6 + "
           "2*tau2*tau4*tau5^2 - tau3^3*tau7 + 2*tau3^2*tau4*tau6 + tau3^2*tau5^2 - 3*tau3*tau4^2*tau5 + tau4^4"},
          {key_prefix + "eq-2.19-1", "w"},
          {key_prefix + "eq-2.19-2", "r*w"},
          {key_prefix + "eq-2.19-3", "r^2*w"},
          {key_prefix + "eq-2.19-4", "r^3*w"},
          {key_prefix + "eq-2.19-5", "r^4*w"},
          {key_prefix + "eq-2.19-6", "r^5*w"},
          {key_prefix + "eq-2.19-7", "r^6*w"},
          {key_prefix + "eq-2.20-1", "w*f"},
          {key_prefix + "eq-2.20-2", "r*w*f"},
          {key_prefix + "eq-2.20-3", "r^2*w*f"},
          {key_prefix + "eq-2.20-4", "r^3*w*f"},
          {key_prefix + "eq-2.25-even", "1/kappa*(psi1 + psi2/4 + psi3/16 + psi4/64)*w*f"},
          {key_prefix + "eq-2.25-odd", "1/kappa*(psi1 + 3*psi2/4 + 9*psi3/16 + 27*psi4/64)*w*f"},
          {key_prefix + "eq-2.26", "lambda1 + lambda2*r + lambda3*r^2 + lambda4*r^3"},
          {key_prefix + "eq-2.27", "lambda2 + lambda5*r + lambda6*r^2 + lambda7*r^3"},
          {key_prefix + "eq-2.28", "lambda3 + lambda6*r + lambda8*r^2 + lambda9*r^3"},
          {key_prefix + "eq-2.29", "lambda4 + lambda7*r + lambda9*r^2 + lambda10*r^3"},
      });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  const auto listed = [](const std::string& symbol, const std::string& id, int first, int count) {
    std::string text;
    for (int k = 0; k < count; ++k)
      text += (k == 0 ? "\\" : ", \\quad \\") + symbol + "_{" + std::to_string(first + k) + "} = <<mustafa-hameed/" +
              id + std::to_string(first + k) + ">>";
    return text;
  };
  const std::string lost = R"(\text{lost; derived: } )";
  add({key_prefix + "eq-2.1-2.6", "section 2.1, equations (2.1) to (2.6)", "The reweighted iteration for the cubic.",
       "that the weights are h'(t)/t, as identities",
       lost + R"(w = 1/[<<mustafa-hameed/eq-2.6>>]^{<<mustafa-hameed/eq-2.6-exponent>>})", "", Verdict::holds_for_all,
       weights});
  add({key_prefix + "all-weights-1", "section 2.1, after equation (2.6)",
       "With all weights 1 the l1 problem becomes the least squares problem.",
       "rules with all weights 1 against the masks of the dual schemes", R"(w = 1)", "", Verdict::holds, ordinary});
  add({key_prefix + "proposition-2.2", "Proposition 2.2, equations (2.13) to (2.16)",
       "The coefficients of the next cubic.", "derived forms against the normal equations for random weights",
       lost + R"(\beta_0 = <<mustafa-hameed/eq-2.13>>, \quad \beta_1 = <<mustafa-hameed/eq-2.14>>, \quad \beta_2 = )"
              R"(<<mustafa-hameed/eq-2.15>>, \quad \beta_3 = <<mustafa-hameed/eq-2.16>>)",
       "", Verdict::holds_for_all, coefficients});
  add({key_prefix + "eq-2.17-2.18", "Proposition 2.2, equations (2.17) and (2.18)",
       "Determinant and adjoint of the normal equations of the cubic.", "matrix times adjoint, entry by entry",
       lost + R"(\kappa = <<mustafa-hameed/eq-2.17>>, \quad )" + listed("lambda", "eq-2.18-", 1, 10), "",
       Verdict::holds_for_all, adjoint});
  add({key_prefix + "eq-2.19-2.20", "Proposition 2.2, equations (2.19) and (2.20)", "The sums tau and chi.",
       "the entries of the normal equations",
       lost + R"(\tau_k = \sum_r: \; )" + listed("tau", "eq-2.19-", 1, 7) + R"(; \quad \chi_k = \sum_r: \; )" +
           listed("chi", "eq-2.20-", 1, 4),
       "", Verdict::holds_for_all, sums});
  add({key_prefix + "eq-2.25-2.29", "section 2.3, equations (2.25) to (2.29)",
       "The rules of the 2n-point schemes of degree 3.",
       "derived forms as identities, and against the library for random weights",
       lost + R"(f_{2i} = \sum_r <<mustafa-hameed/eq-2.25-even>>, \quad f_{2i+1} = \sum_r )"
              R"(<<mustafa-hameed/eq-2.25-odd>>, \quad \psi_1 = <<mustafa-hameed/eq-2.26>>, \quad \psi_2 = )"
              R"(<<mustafa-hameed/eq-2.27>>, \quad \psi_3 = <<mustafa-hameed/eq-2.28>>, \quad \psi_4 = )"
              R"(<<mustafa-hameed/eq-2.29>>)",
       "", Verdict::holds_for_all, rules});
}

}  // namespace subcert::statements::mustafa_hameed
