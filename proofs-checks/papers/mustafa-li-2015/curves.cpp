// Section 2.2, last displays, and Appendix A: the schemes D_2n, D_2n+1 for curves and their reductions to S_2n, S_2n+1.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::mustafa_li_2015 {
namespace {

const std::vector<Formula> line{f("1"), f("r")};

/// No divisor vanishes on the points tried: tau1 tau3 > tau2^2.
const std::vector<Variable> taus{{"tau1", 1}, {"tau2", 1}, {"tau3", 1000}};

/// The sums (5) of a window.
Values sums_5(const Context& context, const std::string& id, const WeightedWindow& window, long first, long last) {
  Values values;
  add_sums(values, "tau", numbered_formulas(context, id + "-tau-", 3), window, first, last);
  return values;
}

/// A printed rule of (4) at its position: all weights and all n at once, and windows with random weights.
Trial rule_4(const Context& context, const std::string& id, const Rational& position, bool even) {
  const Formula term = context.formula(id);
  const long first_offset = even ? 1 : 0;
  const int most = context.reach(4, 8);
  Trial trial = on_random_windows(
      1, most, even, 3, [&](long n, const WeightedWindow& window, const std::string& where) {
        const Values sums = sums_5(context, "eq-5", window, first_offset - n, n);
        const std::vector<Rational> beta = weighted_coefficients(window, line);
        const Rational printed = sum_over(window, term, first_offset - n, n, sums);
        Trial one;
        one.equal(printed, beta[0] + position * beta[1], where);
        one.equal(printed, library_value(window, 1, position), where + ", against the library");
        return one;
      });
  if (trial.failed()) return trial;
  trial.follow(is_weighted_datum(term, {{"r", 1}, {"tau1", 1}, {"tau2", 1}, {"tau3", 1000}}));
  trial.follow(weighted_moments(coefficient_of_datum(term), 1, {f("1"), f(subcert::to_text(position))}, taus));
  return trial.for_all(
      "all n >= 1 and all positive weights",
      "each rule is w_r times a linear function of r with the moments 1 and x, as identities in tau_1, "
      "tau_2, tau_3; also compared for n = 1.." +
          std::to_string(most) + " with random weights");
}

Outcome equation_4(const Context& context) {
  const std::vector<Formula> positions = context.list("positions");
  Trial trial = rule_4(context, "eq-4-even", positions.at(0)({}), true);
  trial.follow(rule_4(context, "eq-4-odd", positions.at(1)({}), true));
  return trial;
}

Outcome equation_5(const Context& context, const std::string& id) {
  Trial trial = entries_of_normal_equations(
      {context.formula(id + "-tau-1"), context.formula(id + "-tau-2"), context.formula(id + "-tau-3")},
      {"w", "r*w", "r^2*w"});
  return trial;
}

Outcome equation_6(const Context& context) {
  return weights_of_modulus(context.formula("eq-6"), context.formula("eq-6-exponent")({}), f("f - beta1 - r*beta2"),
                            {{"f", 1}, {"beta1", 2}, {"beta2", 3}, {"r", 5}, {"delta", 7}});
}

/// The coefficients beta_2 and beta_1 as printed, with sums by eq. (5) of the same place.
Outcome solution(const Context& context, const std::string& sums, const std::string& slope,
                 const std::string& constant) {
  const Formula beta2 = context.formula(slope), mean = context.formula(constant + "-sum"),
                rest = context.formula(constant + "-rest");
  const int most = context.reach(4, 8);
  Trial trial = on_random_windows(1, most, true, 3,
                                  [&](long n, const WeightedWindow& window, const std::string& where) {
                                    Values values = sums_5(context, sums, window, 1 - n, n);
                                    const std::vector<Rational> beta = weighted_coefficients(window, line);
                                    const Rational b2 = sum_over(window, beta2, 1 - n, n, values);
                                    Trial one;
                                    one.equal(b2, beta[1], where + ", beta_2");
                                    const Rational average = sum_over(window, mean, 1 - n, n, values);
                                    values.emplace_back("beta2", b2);
                                    one.equal(average - rest(values), beta[0], where + ", beta_1");
                                    return one;
                                  });
  if (trial.failed()) return trial;
  const std::vector<Variable> names{{"r", 1}, {"tau1", 1}, {"tau2", 1}, {"tau3", 1000}};
  trial.follow(is_weighted_datum(beta2, names));
  trial.follow(is_weighted_datum(mean, names));
  const Formula slope_rule = coefficient_of_datum(beta2);
  trial.follow(weighted_moments(slope_rule, 1, {f("0"), f("1")}, taus));
  // beta_1 is linear in beta_2, so that the rule of beta_2 may stand for it.
  trial.follow(
      weighted_moments(coefficient_of_datum(mean) - rest.replaced("beta2", slope_rule), 1, {f("1"), f("0")}, taus));
  return trial.for_all(
      "all n >= 1 and all positive weights",
      "the rules are w_r times linear functions of r with the moments of the slope and of the value at 0; also "
      "compared for n = 1.." +
          std::to_string(most) + " with random weights");
}

/// beta_1 + x beta_2 of the ordinary line, for all x.
Outcome starting_values(const Context& context, const std::string& id, bool even) {
  Formula beta1 = context.formula(id + "-beta-1");
  const Formula beta2 = context.formula(id + "-beta-2");
  if (even) beta1 = beta1 - context.formula(id + "-factor") * beta2;
  const Fit ordinary{beta1 + f("x") * beta2, "r", {-1, even ? 1 : 0}, {1, 0}, {1, 0}, f("x"), 1, 1, {{"x", 0}}};
  return fit(ordinary, context.reach(6, 20), [](long) {
    return std::vector<Values>{{{"x", 0}}, {{"x", 1}}, {{"x", Rational(1, 4)}}};
  });
}

/// The rules of S_2n or S_2n+1 and the mask of the scheme they are.
Outcome least_squares_rules(const Context& context, const std::string& id, const std::string& index, bool even) {
  const std::vector<Formula> positions = context.list((even ? "positions" : "positions-odd"));
  const int most = context.reach(8, 24);
  Trial trial;
  for (std::size_t rule = 0; rule < 2; ++rule) {
    const Formula weight = context.formula(id + (rule == 0 ? "-even" : "-odd"));
    trial.follow(fit({weight, index, {-1, even ? 1 : 0}, {1, 0}, {1, 0}, positions.at(rule), 1, 1, {}}, most));
    for (int n = 1; n <= most && !trial.failed(); ++n) {
      const LocalRegression scheme = even ? dual(n, 1) : dual_odd(n, 1);
      const Mask mask = regression_mask(scheme);
      const long output = scheme.first_output + static_cast<long>(rule);
      for (long r = even ? 1 - n : -n; r <= n; ++r)
        trial.equal(weight({{"n", n}, {index, r}}), mask.symbol().coefficient(output - 2 * r),
                    at("n", n) + ", " + at(index, r) + ", mask");
    }
    // All weights 1 in (4): tau_1, tau_2, tau_3 are the power sums.
    Formula reduced = coefficient_of_datum(context.formula((rule == 0 ? "eq-4-even" : "eq-4-odd")));
    if (!even) reduced = coefficient_of_datum(context.formula((rule == 0 ? "variant-even" : "variant-odd")));
    reduced = reduced.replaced("tau1", f(even ? "2*n" : "2*n + 1"))
                  .replaced("tau2", f(even ? "n" : "0"))
                  .replaced("tau3", f(even ? "n*(2*n^2 + 1)/3" : "n*(n + 1)*(2*n + 1)/3"));
    trial.follow(identity(weight, reduced.replaced("r", f(index)), {{"n", 2}, {index, 0}}));
  }
  return trial.for_all(
      "all n >= 1",
      "the printed rules are the linear fits and the rules (4) with all weights 1, as identities in n; the masks "
      "are those of the " +
          std::string(even ? "dual 2n-point" : "dual (2n+1)-point") + " scheme of [DHHS15], compared for n = 1.." +
          std::to_string(most));
}

Outcome odd_variant(const Context& context) {
  const std::vector<Formula> positions = context.list("positions-odd");
  Trial trial = summation_range(context.formula("variant-first"), context.formula("variant-last"), false);
  // The replacements as printed, made in (4).
  for (std::size_t rule = 0; rule < 2; ++rule) {
    const std::string id = rule == 0 ? "variant-even" : "variant-odd";
    trial.follow(rule_4(context, id, positions.at(rule)({}), false));
  }
  trial.equal(positions.at(0)({}) + positions.at(1)({}), 0, "positions about the middle datum");
  return trial.for_all("all n >= 1 and all positive weights", "as for (4), with -1/4 and 1/4 for 1/4 and 3/4");
}

/// (4) with two data: the weights cancel.
Outcome chaikin(const Context& context) {
  Trial trial;
  const std::vector<Formula> corner = context.list("chaikin");
  for (std::size_t rule = 0; rule < 2; ++rule)
    for (long r : {0, 1}) {
      const Formula term = context.formula((rule == 0 ? "eq-4-even" : "eq-4-odd"));
      const Formula coefficient = coefficient_of_datum(term)
                                      .replaced("r", f(std::to_string(r)))
                                      .replaced("tau1", f("u + v"))
                                      .replaced("tau2", f("v"))
                                      .replaced("tau3", f("v")) *
                                  f(r == 0 ? "u" : "v");
      trial.follow(identity(coefficient, corner.at(rule == static_cast<std::size_t>(r) ? 0 : 1), {{"u", 1}, {"v", 1}}));
    }
  const Mask mask = regression_mask(dual(1, 1));
  trial.require(
      mask.symbol() == LaurentPolynomial({Rational(1, 4), Rational(3, 4), Rational(3, 4), Rational(1, 4)}, -2),
      "the mask for n = 1 is not Chaikin's");
  return trial.for_all("n = 1, all positive weights and all m",
                       "identities in both weights: a line through two points");
}

/// The rules (4) with the weights 1, but 2 at r = 0: coefficients at r = n and at its mirror image 1 - n.
Trial ends_differ(const Formula& even, const Formula& odd) {
  const auto coefficient = [](const Formula& term, const char* r) {
    return coefficient_of_datum(term)
        .replaced("r", f(r))
        .replaced("tau1", f("2*n + 1"))
        .replaced("tau2", f("n"))
        .replaced("tau3", f("n*(2*n^2 + 1)/3"));
  };
  const Formula difference = f("3*(4*n - 3)/(4*n*(n + 1)*(4*n^2 - 2*n + 1))");
  Trial trial = identity(coefficient(even, "n") - coefficient(odd, "1 - n"), difference, {{"n", 2}});
  trial.follow(positive(difference, {{"n", "2 + x"}}));
  return trial;
}

Outcome not_symmetric(const Context& context) {
  const Formula even = context.formula("eq-4-even"), odd = context.formula("eq-4-odd");
  const Rational smallest = context.formula("not-symmetric-n")({});
  Trial trial;
  for (long n = 1; n <= context.reach(6, 12); ++n) {
    WeightedWindow uneven = window(1 - n, n, 1);
    uneven.weights[static_cast<std::size_t>(n - 1)] = 2;  // of the datum at 0
    WeightedWindow mirrored = window(1 - n, n, 1);
    mirrored.weights[static_cast<std::size_t>(n)] = 2;
    const auto rule = [&](const Formula& term, WeightedWindow data, long r) {
      data.data[static_cast<std::size_t>(r + n - 1)] = 1;
      return sum_over(data, term, 1 - n, n, sums_5(context, "eq-5", data, 1 - n, n));
    };
    bool same = true;
    for (long r = 1 - n; r <= n; ++r) {
      same = same && rule(even, uneven, r) == rule(odd, uneven, 1 - r);
      trial.equal(rule(even, uneven, r), rule(odd, mirrored, 1 - r),
                  at("n", n) + ", " + at("r", r) + ", mirrored weights");
    }
    trial.require(same == (n < smallest),
                  at("n", n) + ": whether the rules with weights 1, but 2 at r = 0, are mirror images");
  }
  trial.follow(ends_differ(even, odd));
  return trial.for_all("all n >= 2",
                       "with the weights 1, but 2 at r = 0, the two rules are no mirror images: their coefficients at "
                       "r = n and at 1 - n differ, as an identity in n. But mirrored data have mirrored weights, so "
                       "that the scheme as a map commutes with reflection");
}

/// For any basis: Q(beta + h) = Q(beta) + sum of w (A h)^2 at the solution of the normal equations.
Outcome general_basis(const Context& context) {
  const std::vector<std::vector<Formula>> bases{
      {f("1")}, {f("1"), f("r"), f("r^2")}, {f("1"), f("1/(r^2 + 1)")}, {f("r"), f("r^3"), f("1/(r + 9)")}};
  Trial trial;
  for (long n = 2; n <= context.reach(4, 8); ++n)
    for (unsigned seed = 1; seed <= 3; ++seed)
      for (const auto& basis : bases) {
        const WeightedWindow data = random_window(1 - n, n, 1, seed);
        const std::vector<Rational> beta = weighted_coefficients(data, basis);
        for (const Formula& member : basis) {
          Formula fitted = f("0");
          Values names;
          for (std::size_t k = 0; k < basis.size(); ++k) {
            const std::string name = "beta" + std::to_string(k + 1);
            fitted = fitted + f(name) * basis[k];
            names.emplace_back(name, beta[k]);
          }
          trial.equal(0, sum_over(data, f("w") * member * (f("f") - fitted), 1 - n, n, names), weighted_case(n, seed));
        }
      }
  return trial.for_all(
      "all linear combinations of functions that the nodes determine",
      "the weighted objective is a quadratic form in the coefficients; the residual of the solved normal "
      "equations is orthogonal to every function of the basis, here also for bases that are no polynomials");
}

}  // namespace

Checks curves() {
  return {{"solution", [](const Context& c) { return solution(c, "solution", "solution-beta-2", "solution-beta-1"); }},
          {"solution-tau", [](const Context& c) { return equation_5(c, "solution"); }},
          {"eq-4", equation_4},
          {"eq-5", [](const Context& c) { return equation_5(c, "eq-5"); }},
          {"eq-6", equation_6},
          {"eq-7-8", [](const Context& c) { return solution(c, "eq-5", "eq-7", "eq-8"); }},
          {"eq-9", [](const Context& c) { return starting_values(c, "eq-9", true); }},
          {"general-basis", general_basis},
          {"d-2n-1", odd_variant},
          {"eq-9-odd", [](const Context& c) { return starting_values(c, "eq-9-odd", false); }},
          {"s-2n-1", [](const Context& c) { return least_squares_rules(c, "s-odd", "r", false); }},
          {"chaikin", chaikin},
          {"not-symmetric", not_symmetric},
          {"s-2n", [](const Context& c) { return least_squares_rules(c, "s-2n", "j", true); }}};
}

}  // namespace subcert::statements::mustafa_li_2015
