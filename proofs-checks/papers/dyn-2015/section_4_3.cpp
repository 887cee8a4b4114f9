// Sections 4.3 and 4.4: higher degrees, Table 3, the conjectures.

#include "checks.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/proofs-checks/statements/normal_equations.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <map>

namespace subcert::statements::dyn_2015 {
namespace {

Mask primal_mask(int n, int d) { return regression_mask(primal(n, d)); }
Mask dual_mask(int n, int d) { return regression_mask(dual(n, d)); }

/// Weights of f_{i+first}, f_{i+first+1}, ... in the output with this residue.
std::vector<Rational> rule_of(const Mask& mask, long residue, long first, int count) {
  std::vector<Rational> weights;
  for (long l = first; l < first + count; ++l) weights.push_back(mask.symbol().coefficient(residue - 2 * l));
  return weights;
}

Outcome well_defined(const Context& context) {
  const int most = context.reach(5, 9);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    for (int d = 0; d < 2 * n + 1; ++d) {
      const bool even = kernel(design_matrix(equidistant(-n + 1, 1, 2 * n - 1), monomials(d))).empty();
      const bool odd = kernel(design_matrix(equidistant(-n + 1, 1, 2 * n), monomials(d))).empty();
      trial.require(even == (d < 2 * n - 1), at_n_d(n, d) + ": the fit to 2n-1 data");
      trial.require(odd == (d < 2 * n), at_n_d(n, d) + ": the fit to 2n data");
    }
  return trial.for_all("all n and d", few_zeros + "d >= m has one; tried for " + range(1, most) + ", d = 0..2n");
}

Outcome equation_21(const Context& context) {
  const int most = context.reach(5, 8);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    for (int d = 1; d < 2 * n; ++d) {
      const Mask mask = primal_mask(n, d);
      if (d < 2 * n - 1)
        trial.require(rule_of(mask, 0, -n + 1, 2 * n - 1) ==
                          weights_by_normal_equations(equidistant(-n + 1, 1, 2 * n - 1), monomials(d), 0),
                      at_n_d(n, d) + ": the even rule");
      trial.require(rule_of(mask, 1, -n + 1, 2 * n) ==
                        weights_by_normal_equations(equidistant(-n + 1, 1, 2 * n), monomials(d), Rational(1, 2)),
                    at_n_d(n, d) + ": the odd rule");
    }
  return trial.over(range(1, most) + ", d = 1..2n-1");
}

Outcome equation_22(const Context& context) {
  const int most = context.reach(5, 8);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    for (int d = 1; d < 2 * n; ++d)
      for (long k : {0, 1})
        trial.require(
            rule_of(dual_mask(n, d), k, -n + 1, 2 * n) ==
                weights_by_normal_equations(equidistant(-n + 1, 1, 2 * n), monomials(d), Rational(2 * k + 1, 4)),
            at_n_d(n, d) + ": rule " + std::to_string(k));
  return trial.over(range(1, most) + ", d = 1..2n-1");
}

/// The degree d is reproduced and the order is h^(d+1) at least; exact values of the degree where it is more.
Outcome reproduces(const Context& context, Mask (*mask)(int, int), bool odd_for_free) {
  const int most = context.reach(8, 14);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    for (int d = 1; d < 2 * n; ++d) {
      const int degree = polynomial_reproduction(mask(n, d)).reproduction_degree;
      trial.equal(odd_for_free && d % 2 == 0 ? d + 1 : d, degree, at_n_d(n, d) + ", reproduction degree");
    }
  return trial.for_all(
      "all n and d < 2n",
      std::string("fits of degree d keep polynomials of degree d") +
          (odd_for_free ? ", and the schemes of even degree are those of the next one (even-degrees)" : "") +
          "; the exact degree compared for " + range(1, most));
}

Outcome interpolates(const Context& context, Mask (*mask)(int, int), bool is_dual) {
  const int most = context.reach(8, 16);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const Mask derived = mask(n, 2 * n - 1);
    const auto nodes = equidistant(-n + 1, 1, 2 * n);
    const auto inserted = [&](const Rational& x) {
      return weights_by_normal_equations(nodes, monomials(2 * n - 1), x);
    };
    if (is_dual)
      trial.require(rule_of(derived, 0, -n + 1, 2 * n) == inserted(Rational(1, 4)), at("n", n) + ": the even rule");
    else
      trial.require(derived.symbol().coset(2, 0) == LaurentPolynomial(1), at("n", n) + ": f_{2i} is not f_i");
    trial.require(rule_of(derived, 1, -n + 1, 2 * n) == inserted(is_dual ? Rational(3, 4) : Rational(1, 2)),
                  at("n", n) + ": the odd rule");
  }
  return trial.for_all("all n >= 1", std::string("the fit of degree 2n-1 to 2n data interpolates them") +
                                         (is_dual ? "" : ", and so does the one to 2n-1 data, of which t_i is one") +
                                         "; compared with interpolation by a Vandermonde matrix for " + range(1, most));
}

Outcome even_degrees(const Context& context) {
  const int most = context.reach(12, 30);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    for (int d = 0; 2 * d + 1 < 2 * n; ++d)
      trial.require(primal_mask(n, 2 * d) == primal_mask(n, 2 * d + 1), at_n_d(n, 2 * d));
  return trial.for_all(
      "all n and 2d < 2n-1",
      "the polynomial of odd degree that a fit adds vanishes in the middle (remark-12), and for 2d+1 = "
      "2n-1 both even rules are f_i; compared for " +
          range(1, most));
}

Outcome four_point_rule(const Context&) {
  Trial trial;
  const auto nodes = equidistant(-1, 1, 4);
  trial.require(weights_by_normal_equations(nodes, monomials(2), Rational(1, 2)) ==
                    weights_by_normal_equations(nodes, monomials(3), Rational(1, 2)),
                "quadratic and cubic differ");
  trial.require(rule_of(mask_of("four-point:w=1/16"), 1, -1, 4) ==
                    weights_by_normal_equations(nodes, monomials(2), Rational(1, 2)),
                "not the 4-point rule");
  return trial.over("n = 2");
}

/// The odd rule keeps (x - 1/2)^2, which is positive at its nodes and 0 where it is evaluated: not all weights are
/// positive.
Outcome no_positive_mask(const Context& context) {
  const int most = context.reach(8, 16);
  Trial trial;
  for (int n = 2; n <= most; ++n)
    for (int d = 2; d < 2 * n; ++d) {
      const std::vector<Rational> odd_rule = rule_of(primal_mask(n, d), 1, -n + 1, 2 * n);
      trial.require(*std::ranges::min_element(odd_rule) < 0, at_n_d(n, d));
    }
  return trial.for_all("all n and 1 < d < 2n",
                       "the odd rule keeps (x - 1/2)^2, which is positive at its nodes and 0 where it is evaluated, so "
                       "that a weight is negative; tried for " +
                           range(2, most));
}

/// Degree 3 against degree 1 in all four families, from n = 5 on: proved exponents. Below, a remark says where the
/// cubic scheme is the rougher one.
Outcome higher_smoothness(const Context& context) {
  constexpr int first = 5;
  const auto exponent = [](const std::string& family, int n, int d) -> const Enclosure& {
    return holder_regularity_of(specification(family, n, d)).exponent;
  };
  const int most = context.reach(5, 6);
  Trial trial = proved_theorem("smoothness-all", 5);
  std::string rougher;
  for (const std::string family : {"primal", "dual", "primal-odd", "dual-odd"})
    for (int n = 3; n <= most; ++n) {
      const std::string where = family + ", " + at("n", n);
      if (n >= first)
        trial.require(*exponent(family, n, 3).lower > *exponent(family, n, 1).upper, where);
      else if (*exponent(family, n, 3).upper < *exponent(family, n, 1).lower)
        rougher += (rougher.empty() ? "" : "; ") + where;
    }
  Outcome outcome = trial.over(range(first, most) + ", d = 3 against d = 1 in the four families: proved exponents");
  outcome.argument =
      "of the primal 2n-point schemes, for all odd d < d' and all n >= 4^d', a theorem: the exponent is above d' for "
      "degree d' and at most d + 1 for degree d (docs/theorems/README.md, smoothness-all)";
  if (!rougher.empty()) outcome.argument += "; a tendency: the cubic scheme is less smooth for " + rougher;
  return outcome;
}

/// The exponent decides: above 3 it proves C^3, below 3 with stable shifts it refutes it.
Trial dual_cubic_c3(const std::vector<int>& sizes) {
  Trial trial;
  std::string range;
  for (int n : sizes) {
    const HolderRegularity& regularity = holder_regularity_of(specification("dual", n, 3));
    const Enclosure& exponent = regularity.exponent;
    trial.require(exponent.lower && *exponent.lower > 3,
                  at("n", n) + ": the Hoelder exponent lies in [" + exponent.lower_text(12) + ", " +
                      exponent.upper_text(12) + "]; " + std::to_string(regularity.bounds.sum_rules) +
                      " sum rules, stable shifts, and a transition matrix of the difference scheme of that order with "
                      "spectral radius " +
                      regularity.radius.radius.lower_text(12) + "... > 4");
    range += (range.empty() ? "n = " : ", ") + std::to_string(n);
  }
  return trial.over(range);
}

Outcome dual_cubic(const Context&) {
  Outcome outcome = not_a_slip(dual_cubic_c3({4, 5}).outcome(dual_cubic_c3({5})));
  outcome.argument = "for n = 5 the proved exponent exceeds 3";
  // Whichever family the tilde may mean.
  for (const char* family : {"dual-odd", "primal", "primal-odd"}) {
    const Enclosure& other = holder_regularity_of(specification(family, 4, 3)).exponent;
    if (other.upper && *other.upper < 3)
      outcome.argument += std::string("; for n = 4 that of ") + family + " is " + other.upper_text(4);
    else
      outcome.verdict = StatementVerdict::undecided;
  }
  return outcome;
}

Outcome scaled_maxima(const Context& context) {
  const int most = context.reach(9, 15);
  Trial trial;
  std::string spread;
  for (int d : {1, 3, 5}) {
    const auto scaled = [&](int n) { return Rational(n * *variance_of(specification("primal", n, d)).maximum.upper); };
    const Rational limit = *theorems::limit_constant(d, 10).lower;
    Rational before = 1000;
    for (int n = (d + 1) / 2; n <= most; n += 2) {
      const Rational now = scaled(n) / limit;
      trial.require(now > 1 && now < before,
                    at("d", d) + ", " + at("n", n) + ": n max psi / C_d is " + to_decimal(now, 6, Rounding::nearest));
      before = now;
    }
    trial.require(before < Rational(11, 10),
                  at("d", d) + ": " + to_decimal(before, 6, Rounding::nearest) + " times the limit at the end");
  }
  return trial.over("d = 1, 3, 5, every second n up to " + std::to_string(most) +
                    ": n max psi falls towards C_d and ends within a tenth of it");
}

/// Whether the values over n flatten out: over the upper half of the range they change by less than a twentieth of the
/// largest value drawn.
Trial flattens(int degree, int most, bool slope) {
  std::vector<Enclosure> values;
  Rational largest = 0;
  for (int n = (degree + 1) / 2; n <= most; ++n) {
    const VarianceRange& range = variance_of(specification("primal", n, degree));
    values.push_back(scaled(slope ? *range.slope : range.maximum, power(Rational(n), slope ? 2 : 1)));
    largest = std::max(largest, *values.back().lower);
  }
  const Enclosure& half = values[values.size() / 2];
  const Rational change = std::max(*half.upper - *values.back().lower, *values.back().upper - *half.lower);
  Trial trial;
  trial.require(20 * change < largest, at("d", degree) + ": the upper half changes by " +
                                           to_decimal(change, 4, Rounding::up) + ", the largest value is " +
                                           to_decimal(largest, 4, Rounding::down));
  return trial;
}

Outcome figure_8_right(const Context& context) {
  const int most = context.reach(9, 15);
  Trial trial;
  for (int d : {1, 3, 5}) trial.follow(flattens(d, most, true));
  Outcome outcome = trial.over("d = 1, 3, 5, n up to " + std::to_string(most) +
                               ": over the upper half of the n the values change by less than a twentieth of the "
                               "largest one drawn");
  outcome.argument =
      "the constant that they come near to is 0, so this is no sign of the rate 1/n^2 "
      "(conjecture-7-slope)";
  return outcome;
}

/// n max psi over the n of Table 3 that do not interpolate: the values differ by less than a sixth.
Outcome table_3_rates(const Context& context) {
  std::map<int, std::vector<Enclosure>> values;
  for (const PublishedCell& cell : context.cells("table-3-n-sup"))
    if (2 * *cell.n > *cell.d + 1)
      values[*cell.d].push_back(scaled(variance_of(make_scheme(cell.scheme).specification).maximum, *cell.n));
  Trial trial;
  std::string ratios;
  for (const auto& [d, all] : values) {
    const Rational ratio = *all.front().upper / *all.back().lower;
    trial.require(ratio < Rational(7, 6),
                  at("d", d) + ": the first is " + to_decimal(ratio, 4, Rounding::up) + " times the last");
    ratios += (ratios.empty() ? "" : ", ") + at("d", d) + " by a factor of " + to_decimal(ratio, 4, Rounding::up);
  }
  trial.require(values.size() == 3, "three degrees");
  return trial.over(
      "Table 3 without its interpolating schemes (for which max psi = 1): from the least to the "
      "largest n it falls for " +
      ratios);
}

/// n^2 max |psi'| of one degree at a smaller and a larger n: as a rate it would keep its order.
struct ScaledSlopes {
  int degree, first_n, last_n;

  Enclosure at_n(int n) const { return scaled(*variance_of(specification("primal", n, degree)).slope, n * n); }
  Trial keep_their_order() const {
    const Rational before = *at_n(first_n).lower, after = *at_n(last_n).upper;
    Trial trial;
    trial.require(2 * after > before,
                  at("d", degree) + ": n^2 max |psi'| is at least " + to_decimal(before, 4, Rounding::down) + " at " +
                      at("n", first_n) + " and at most " + to_decimal(after, 4, Rounding::up) + " at " +
                      at("n", last_n) + ", less by a factor of " + to_decimal(before / after, 3, Rounding::down));
    return trial;
  }
  Trial fall() const {
    Trial trial;
    trial.require(*at_n(last_n).upper < *at_n(first_n).lower, at("d", degree));
    return trial;
  }
};

Outcome scaled_slopes(const std::vector<ScaledSlopes>& all, const std::string& range) {
  Trial printed, corrected;
  for (const ScaledSlopes& one : all) {
    printed.follow(one.keep_their_order());
    corrected.follow(one.fall());
  }
  Outcome outcome = not_a_slip(printed.outcome(corrected.over(range)));
  outcome.argument = "max |psi'| falls faster than every power of n, for every d (docs/limit-constants.md, theorem 7)";
  return outcome;
}

/// From the first scheme that does not interpolate on.
Outcome slopes_as_a_rate(const Context& context) {
  const int most = context.reach(9, 15);
  return scaled_slopes({{1, 2, most}, {3, 3, most}, {5, 4, most}}, "d = 1, 3, 5, n up to " + std::to_string(most));
}

/// At the n of Table 3 whose schemes do not interpolate.
Outcome slopes_of_table_3(const Context& context) {
  std::map<int, std::vector<int>> sizes;
  for (const PublishedCell& cell : context.cells("table-3-n2-slope"))
    if (2 * *cell.n > *cell.d + 1) sizes[*cell.d].push_back(*cell.n);
  std::vector<ScaledSlopes> all;
  for (const auto& [d, n] : sizes) all.push_back({d, n.front(), n.back()});
  return scaled_slopes(all, "Table 3 without its interpolating schemes");
}

/// The text before the conjecture: the bounds of Theorem 6 hold for d > 1, too.
Outcome slopes_are_bounded(const Context&) {
  Trial trial;
  for (const int d : {1, 3, 5}) trial.follow(proved_theorem("conjecture-7", d));
  return trial.for_all(
      "every d, n large; d = 1, 3, 5, all n >= (d+1)/2",
      "max |psi'| falls faster than every power of n for every d (docs/limit-constants.md, theorem 7); "
      "explicit bounds for d = 1, 3, 5, every inequality certified (docs/theorems/README.md, "
      "conjecture-7)");
}

Outcome conjecture_7(const Context& context) {
  const int most = context.reach(8, 15);
  Trial trial;
  for (int d : {1, 3, 5}) {
    const Enclosure limit = theorems::limit_constant(d, 10);
    for (int n = (d + 1) / 2; n <= most; ++n) {
      const Enclosure& maximum = variance_of(specification("primal", n, d)).maximum;
      trial.require(*limit.lower < n * *maximum.lower && n * *maximum.upper < 3 * *limit.upper,
                    at_n_d(n, d) + ": n max psi is not between C_d and 3 C_d");
    }
  }
  trial.follow(proved_theorem("conjecture-7"));
  return trial.for_all(
      "every d, n large; d = 1, all n >= 1",
      "n max psi tends to C_d > 0 for every d (docs/limit-constants.md, theorem 7); for d = 1 explicit bounds "
      "for all "
      "n; C_d < n max psi < 3 C_d certified for d = 1, 3, 5, n up to " +
          std::to_string(most));
}

Outcome conjecture_8(const Context& context, bool over_degrees) {
  const int most = context.reach(5, 10);
  Trial trial;
  std::string undecided;
  const auto compare = [&](int n_small, int d_small, int n_large, int d_large) {
    const VarianceOrder& order = variance_order_of(specification("primal", n_small, d_small),
                                                   specification("primal", n_large, d_large));
    if (order.below == Truth::unknown) undecided += at_n_d(n_large, d_large) + "; ";
    trial.require(order.below != Truth::no || order.difference == 0, at_n_d(n_small, d_small) + " against " +
                                                                         at_n_d(n_large, d_large) +
                                                                         " at x = " + subcert::to_text(order.witness));
  };
  for (int n = 1; n <= most; ++n)
    for (int d = 1; d <= 2 * n - 1 && d <= 5; d += 2)
      if (over_degrees) {
        if (d + 2 <= 2 * n - 1 && d + 2 <= 5) compare(n, d, n, d + 2);
      } else if (n > 1 && d <= 2 * n - 3) {
        compare(n, d, n - 1, d);
      }
  const std::string theorem = over_degrees ? "conjecture-8-d-all" : "conjecture-8-n";
  for (const int d : {1, 3, 5}) trial.follow(proved_theorem(theorem, d));
  Outcome outcome = trial.over(
      range(1, most) + ", d = 1, 3, 5, neighbours; the others follow by transitivity. For every n: " +
      (over_degrees ? "the smaller degree" : "d") + " = 1, 3, 5 (docs/theorems/README.md, " + theorem + ")");
  if (outcome.verdict == StatementVerdict::holds && !undecided.empty())
    return {StatementVerdict::undecided, outcome.range, "", "not decided: " + undecided};
  return outcome;
}

Outcome conjecture_8_degree_one(const Context&) {
  return proved_theorem("conjecture-8-n")
      .for_all("d = 1, all n >= 1",
               "psi_{n+1} < psi_n everywhere, every inequality of the proof certified (docs/theorems/README.md, "
               "conjecture-8-n)");
}

}  // namespace

Checks section_4_3() {
  return {{"well-defined", well_defined},
          {"eq-21", equation_21},
          {"reproduction-primal", [](const Context& c) { return reproduces(c, primal_mask, true); }},
          {"dubuc-deslauriers", [](const Context& c) { return interpolates(c, primal_mask, false); }},
          {"even-degrees", even_degrees},
          {"four-point", four_point_rule},
          {"eq-22", equation_22},
          {"reproduction-dual", [](const Context& c) { return reproduces(c, dual_mask, false); }},
          {"dual-interpolates", [](const Context& c) { return interpolates(c, dual_mask, true); }},
          {"higher-smoothness", higher_smoothness},
          {"mask-not-positive", no_positive_mask},
          {"dual-cubic-c3", dual_cubic},
          {"table-3-sup", [](const Context& c) { return table_words(c, "table-3-sup"); }},
          {"table-3-n-sup", [](const Context& c) { return table_words(c, "table-3-n-sup"); }},
          {"table-3-slope", [](const Context& c) { return table_words(c, "table-3-slope"); }},
          {"table-3-n2-slope", [](const Context& c) { return table_words(c, "table-3-n2-slope"); }},
          {"fig-8-left", scaled_maxima},
          {"fig-8-right", figure_8_right},
          {"table-3-rates", table_3_rates},
          {"table-3-rates-slope", slopes_of_table_3},
          {"conjecture-7", conjecture_7},
          {"conjecture-7-bound", slopes_are_bounded},
          {"conjecture-7-slope", slopes_as_a_rate},
          {"conjecture-8-degree", [](const Context& c) { return conjecture_8(c, true); }},
          {"conjecture-8-size", [](const Context& c) { return conjecture_8(c, false); }},
          {"conjecture-8-degree-1", conjecture_8_degree_one}};
}

}  // namespace subcert::statements::dyn_2015
