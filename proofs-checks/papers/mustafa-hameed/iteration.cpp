// Sections 2.1 to 2.3: the reweighted cubic and its rules, derived.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <array>

namespace subcert::statements::mustafa_hameed {
namespace {

constexpr std::size_t terms = 4;

const std::vector<Formula> cubics{f("1"), f("r"), f("r^2"), f("r^3")};

/// lambda_k in row i, column j of the adjoint, which is symmetric.
constexpr std::array<std::array<int, terms>, terms> place{{{1, 2, 3, 4}, {2, 5, 6, 7}, {3, 6, 8, 9}, {4, 7, 9, 10}}};

std::string with_index(const std::string& name, std::size_t k) { return name + std::to_string(k); }

Formula lambda(const Context& context, int k) { return context.formula("eq-2.18-" + std::to_string(k)); }

/// tau, lambda, kappa and chi of a window.
Values computed(const Context& context, const WeightedWindow& window, long first, long last) {
  Values values, entries;
  add_sums(values, "tau", numbered_formulas(context, "eq-2.19-", 7), window, first, last);
  for (int k = 1; k <= 10; ++k) entries.emplace_back("lambda" + std::to_string(k), lambda(context, k)(values));
  entries.emplace_back("kappa", context.formula("eq-2.17")(values));
  values.insert(values.end(), entries.begin(), entries.end());
  add_sums(values, "chi", numbered_formulas(context, "eq-2.20-", terms), window, first, last);
  return values;
}

std::vector<std::string> names_of(const std::string& name, int count) {
  std::vector<std::string> result;
  for (const Variable& variable : numbered(name, count)) result.push_back(variable.name);
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

/// Row i of the adjoint times a column.
Formula row_times(std::size_t i, const std::vector<Formula>& column) {
  Formula sum = f("0");
  for (std::size_t j = 0; j < terms; ++j)
    sum = sum + f(with_index("lambda", static_cast<std::size_t>(place[i][j]))) * column[j];
  return sum;
}

Outcome derived(Outcome outcome) {
  outcome.argument = "the printed formulas are lost; of the derived ones: " + outcome.argument;
  return outcome;
}

const Formula residual = f("f - beta0 - beta1*r - beta2*r^2 - beta3*r^3");

/// What the residual is a function of, and another one.
std::vector<Variable> names_with(const std::string& last) {
  return {{"f", 1}, {"beta0", 2}, {"beta1", 3}, {"beta2", 4}, {"beta3", 5}, {"r", 2}, {last, 7}};
}

/// h(t)^2 = t^2 + delta for the residual t, and w = h'(t)/t.
Trial smoothed_modulus(const Context& context) {
  return weights_of_modulus(context.formula("eq-2.6"), context.formula("eq-2.6-exponent")({}), residual,
                            names_with("delta"));
}

Outcome small_delta(const Context& context) {
  Trial trial = smoothed_above_modulus(context.formula("eq-2.6"), residual, names_with("e"));
  return derived(trial.for_all("all N, degrees up to 3, data and delta > 0",
                               "a minimiser of F_delta has a sum of moduli within N delta^(1/2) of the smallest. delta "
                               "has the unit of squared data: what is small is a matter of their scale"));
}

Outcome stopping(const Context& context) {
  return derived(fits_go_down(context.formula("eq-2.6"), residual, names_with("delta")));
}

Outcome weights(const Context& context) { return derived(smoothed_modulus(context)); }

Outcome smoothed(const Context& context) {
  return derived(smoothed_modulus(context).for_all(
      "all n, data and delta > 0",
      "h^2 = t^2 + delta lies between t^2 and (|t| + delta^(1/2))^2, so that for N data F <= F_delta <= F + N "
      "delta^(1/2), and a minimiser of F_delta has F within N delta^(1/2) of the smallest value; h h'' = 1 - h'^2 = "
      "delta/h^2 > 0, so that F_delta is convex, and h is smooth, as it has no zero"));
}

Outcome sums(const Context& context) {
  std::vector<Formula> entries = numbered_formulas(context, "eq-2.19-", 7);
  for (const Formula& chi : numbered_formulas(context, "eq-2.20-", terms)) entries.push_back(chi);
  return derived(entries_of_normal_equations(
      entries, {"w", "r*w", "r^2*w", "r^3*w", "r^4*w", "r^5*w", "r^6*w", "w*f", "r*w*f", "r^2*w*f", "r^3*w*f"}));
}

Outcome adjoint(const Context& context) {
  std::vector<std::vector<Formula>> matrix, entries;
  for (std::size_t i = 0; i < terms; ++i) {
    matrix.emplace_back();
    entries.emplace_back();
    for (std::size_t j = 0; j < terms; ++j) {
      matrix[i].push_back(f(with_index("tau", i + j + 1)));
      entries[i].push_back(lambda(context, place[i][j]));
    }
  }
  const Formula kappa = context.formula("eq-2.17");
  // One point for all entries first: it finds nearly every error at once.
  Trial trial;
  const Values point{{"tau1", 3}, {"tau2", 5}, {"tau3", 7}, {"tau4", 11}, {"tau5", 13}, {"tau6", 17}, {"tau7", 19}};
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; j < terms; ++j) {
      Rational sum = 0;
      for (std::size_t k = 0; k < terms; ++k) sum += matrix[i][k](point) * entries[k][j](point);
      trial.equal(sum, i == j ? kappa(point) : Rational(0), "entry " + std::to_string(i) + ", " + std::to_string(j));
    }
  if (!trial.failed()) trial.follow(adjoint_identity(matrix, entries, kappa, numbered("tau", 7)));
  return derived(
      trial.for_all("all n >= 2 and all positive weights",
                    "matrix times adjoint is kappa times the identity, entry by entry, as polynomials in tau_1, "
                    "..., tau_7; the matrix is positive definite, so kappa > 0"));
}

Outcome coefficients(const Context& context) {
  Trial trial = on_random_windows(2, context.reach(4, 6), true, 2,
                                  [&](long n, const WeightedWindow& window, const std::string& where) {
                                    const std::vector<Rational> beta = weighted_coefficients(window, cubics);
                                    const Values values = computed(context, window, 1 - n, n);
                                    Trial one;
                                    for (std::size_t k = 0; k < terms; ++k)
                                      one.equal(context.formula("eq-2." + std::to_string(13 + k))(values), beta[k],
                                                where + ", " + with_index("beta_", k));
                                    return one;
                                  });
  const std::vector<std::string> lambdas = names_of("lambda", 10), chis = names_of("chi", 4);
  for (std::size_t k = 0; k < terms && !trial.failed(); ++k) {
    const Formula beta = context.formula("eq-2." + std::to_string(13 + k));
    const Formula expected = row_times(k, {f("chi1"), f("chi2"), f("chi3"), f("chi4")});
    const Degrees in_kappa = beta.degrees("kappa");
    trial.require(
        is_linear_in(beta, lambdas) && is_linear_in(beta, chis) && in_kappa.numerator == 0 && in_kappa.denominator == 1,
        with_index("beta_", k) + " is not shown to be linear in lambda and in chi, over kappa");
    for (const Values& one : corners(lambdas))
      for (const Values& other : corners(chis))
        for (long kappa : {1, 2}) {
          Values values = one;
          values.insert(values.end(), other.begin(), other.end());
          values.emplace_back("kappa", kappa);
          trial.equal(beta(values) * kappa, expected(values), with_index("beta_", k) + ", " + to_text(values));
        }
  }
  return derived(trial.for_all("all n >= 2 and all positive weights",
                               "bilinear in lambda and chi, and equal on a basis to rows of the adjoint times the "
                               "right-hand sides over kappa; compared with the normal equations for n = 2.." +
                                   std::to_string(context.reach(4, 6)) + " with random weights"));
}

/// psi_k is row k of the adjoint times (1, r, r^2, r^3), and the rules are (psi_1 + x psi_2 + x^2 psi_3 + x^3
/// psi_4)/kappa.
Outcome rules(const Context& context) {
  const std::vector<Formula> positions = context.list("positions");
  std::vector<Formula> rule;
  for (const std::string name : {"even", "odd"}) rule.push_back(context.formula("eq-2.25-" + name));
  for (Formula& one : rule)
    for (std::size_t k = 1; k <= terms; ++k)
      one = one.replaced(with_index("psi", k), context.formula("eq-2." + std::to_string(25 + k)));
  Trial trial = on_random_windows(
      2, context.reach(4, 6), true, 2, [&](long n, const WeightedWindow& window, const std::string& where) {
        const Values values = computed(context, window, 1 - n, n);
        Trial one;
        for (std::size_t k = 0; k < 2; ++k)
          one.equal(sum_over(window, rule[k], 1 - n, n, values), library_value(window, 3, positions.at(k)({})),
                    where + ", rule " + std::to_string(k));
        return one;
      });
  if (!trial.failed())
    for (std::size_t k = 0; k < 2; ++k) {
      const Formula& x = positions.at(k);
      trial.follow(identity(
          context.formula(std::string("eq-2.25-") + (k == 0 ? "even" : "odd")),
          (f("psi1") + x * f("psi2") + x * x * f("psi3") + x * x * x * f("psi4")) / f("kappa") * f("w") * f("f"),
          {{"psi1", 1}, {"psi2", 2}, {"psi3", 3}, {"psi4", 5}, {"kappa", 1}, {"w", 1}, {"f", 1}}));
    }
  for (std::size_t k = 0; k < terms && !trial.failed(); ++k) {
    const Formula psi = context.formula("eq-2." + std::to_string(26 + k));
    const Formula expected = row_times(k, cubics);
    const Degrees in_node = psi.degrees("r");
    trial.require(is_linear_in(psi, names_of("lambda", 10)) && in_node.numerator <= 3 && in_node.denominator == 0,
                  with_index("psi_", k + 1) + " is not shown to be linear in lambda and cubic in r");
    for (const Values& corner : corners(names_of("lambda", 10)))
      for (long r = 0; r <= 3; ++r) {
        Values values = corner;
        values.emplace_back("r", r);
        trial.equal(psi(values), expected(values), with_index("psi_", k + 1) + ", " + to_text(values));
      }
  }
  return derived(
      trial.for_all("all n >= 2 and all positive weights",
                    "psi_1, ..., psi_4 are linear in lambda and cubic in r and agree on a basis: rows of the "
                    "adjoint times (1, r, r^2, r^3); compared with the library for n = 2.." +
                        std::to_string(context.reach(4, 6)) + " with random weights"));
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
  return trial.for_all("all n",
                       "the sum of w t^2 with all w = 1 is that of ordinary least squares (2.7); compared with the "
                       "masks of the dual schemes of [DHHS15] for n = 2.." +
                           std::to_string(context.reach(5, 10)) + ", degrees 1, 2, 3, 2n and 2n+1 points");
}

}  // namespace

Checks iteration() {
  return {{"remark-2.1-delta", small_delta},
          {"stopping", stopping},
          {"eq-2.1-2.6", weights},
          {"eq-2.4", smoothed},
          {"all-weights-1", ordinary},
          {"proposition-2.2", coefficients},
          {"eq-2.17-2.18", adjoint},
          {"eq-2.19-2.20", sums},
          {"eq-2.25-2.29", rules}};
}

}  // namespace subcert::statements::mustafa_hameed
