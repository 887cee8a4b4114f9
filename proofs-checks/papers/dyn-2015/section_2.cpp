// Sections 2 and 2.1: the primal schemes of degree 1, their convergence and smoothness.

#include "checks.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::dyn_2015 {
namespace {

std::string up_to(int n) { return "n = 1.." + std::to_string(n); }

Outcome unique_solution(const Context& context) {
  Trial trial;
  const int most = context.reach(8, 14);
  for (int m = 1; m <= most; ++m)
    for (int d = 0; d < m; ++d) {
      RationalMatrix vandermonde(static_cast<std::size_t>(m), static_cast<std::size_t>(d) + 1);
      for (std::size_t i = 0; i < vandermonde.rows(); ++i)
        for (std::size_t k = 0; k < vandermonde.columns(); ++k)
          vandermonde(i, k) = power(Rational(static_cast<long>(i * i + 1), 2), static_cast<long>(k));
      trial.require(kernel(vandermonde).empty(), at("m", m) + ", " + at("d", d) + ": two minimisers");
    }
  return trial.for_all("all m > d >= 0 and distinct nodes",
                       few_zeros + "tried for m = 1.." + std::to_string(most) + ", d = 0..m-1, nodes (i^2 + 1)/2");
}

Outcome value_at_centre(const Context& context) {
  const Fit fit_at_centre{context.formula("centre"), "i", {0, 1}, {1, 0}, {1, 0}, f("(n + 1)/2"), 1, 2, {}};
  return fit(fit_at_centre, context.reach(10, 40));
}

Outcome equation_2(const Context& context) {
  const Fit even{context.formula("eq-2-even"), "j", {-1, 1}, {1, -1}, {1, 0}, f("0"), 1, 1, {}};
  const Fit odd{context.formula("eq-2-odd"), "j", {-1, 1}, {1, 0}, {1, 0}, f("1/2"), 1, 1, {}};
  const int most = context.reach(8, 40);
  Trial trial = fit(even, most);
  trial.follow(fit(odd, most));
  return trial;
}

std::vector<SymbolPart> symbol_3(const Context& context) {
  return {{context.formula("eq-3-odd"), "j", {-1, 1}, {1, 0}, {2, -1}},
          {context.formula("eq-3-even"), "j", {-1, 1}, {1, -1}, {2, 0}}};
}

Outcome equation_3(const Context& context) {
  const int most = context.reach(10, 60);
  Trial trial = symbol_family(
      symbol_3(context), [](long n) { return s_n(n).symbol(); }, 1, most);
  // a_{2i+1-2(i+l)} = a_{1-2l} weighs the datum i+l: the exponent 2j-1 belongs to l = 1-j, the exponent 2j to l = -j.
  trial.follow(fit({context.formula("eq-3-odd"), "j", {-1, 1}, {1, 0}, {-1, 1}, f("1/2"), 1, 1, {}}, most));
  trial.follow(fit({context.formula("eq-3-even"), "j", {-1, 1}, {1, -1}, {-1, 0}, f("0"), 1, 1, {}}, most));
  return trial.for_all("all n >= 1",
                       "each coefficient is a weight of a local fit; compared with the masks for " + up_to(most));
}

Outcome odd_symmetry(const Context& context) {
  const int most = context.reach(20, 100);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    trial.require(s_n(n).symbol() == s_n(n).symbol().reversed() && assembled(symbol_3(context), n) == s_n(n).symbol(),
                  at("n", n));
  return trial.for_all(
      "all n >= 1",
      "the coefficients of (3) do not depend on j, and the exponents come in pairs; tried for " + up_to(most));
}

Outcome primal_2n_point(const Context& context) {
  const int most = context.reach(20, 100);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    trial.equal(2 * n, s_n(n).symbol().coset(2, 1).length(), at("n", n) + ", data of the odd rule");
    trial.equal(2 * n - 1, s_n(n).symbol().coset(2, 0).length(), at("n", n) + ", data of the even rule");
  }
  for (const char* part : {"eq-3-odd", "eq-3-even"}) trial.follow(positive(context.formula(part), {{"n", "1 + x"}}));
  return trial.for_all("all n >= 1",
                       "the sums in (3) have 2n and 2n-1 terms, none of them 0; counted for " + up_to(most));
}

Outcome printed_masks(const Context& context) {
  Trial trial;
  for (int n = 1; n <= 3; ++n) {
    const std::string name = "a_" + std::to_string(n);
    trial.follow(mask_list(context.list("" + name), s_n(n), name));
  }
  return trial.over("n = 1..3");
}

Outcome interpolating_2_point(const Context&) {
  Trial trial;
  trial.require(s_n(1).symbol().coset(2, 0) == LaurentPolynomial(1), "the even rule is not f_{2i} = f_i");
  trial.require(s_n(1) == mask_of("bspline:degree=1"), "the mask is not the one of piecewise linear functions");
  return trial.over("n = 1");
}

/// Coset sums 1 for all n, and positive coefficients.
Trial positive_symbol(const Formula& odd, const Line& odd_last, const Formula& even, const Line& even_last) {
  Trial trial = sum_identity({odd, "j", {-1, 1}, odd_last}, f("1"), {{"n", 2}});
  trial.follow(sum_identity({even, "j", {-1, 1}, even_last}, f("1"), {{"n", 2}}));
  return trial;
}

Outcome theorem_1(const Context& context) {
  const Formula odd = context.formula("eq-3-odd"), even = context.formula("eq-3-even");
  const int most = context.reach(10, 40);
  Trial trial = positive_symbol(odd, {1, 0}, even, {1, -1});
  trial.follow(positive(odd, {{"n", "1 + x"}}));
  trial.follow(positive(even, {{"n", "1 + x"}}));
  for (int n = 1; n <= most; ++n) {
    trial.require(converges(s_n(n)).is_yes(), at("n", n) + ": convergence is not proved");
    trial.require(has_positive_mask(s_n(n)), at("n", n) + ": the mask is not positive");
  }
  return trial.for_all(
      "all n >= 1",
      "both coset sums are 1 and all 4n-1 coefficients are positive for every n, so that the positive mask "
      "theorem applies; convergence also proved scheme by scheme for " +
          up_to(most));
}

std::vector<SymbolPart> symbol_4(const Context& context) {
  return {{context.formula("eq-4-odd"), "j", {-1, 1}, {1, -1}, {2, -1}},
          {context.formula("eq-4-even"), "j", {-1, 1}, {1, -1}, {2, 0}}};
}

Outcome equation_4(const Context& context) {
  const Formula odd = context.formula("eq-4-odd"), even = context.formula("eq-4-even");
  const int most = context.reach(10, 60);
  Trial trial = symbol_family(
      symbol_4(context),
      [](long n) { return LaurentPolynomial(Rational(1, 2)) * divided_difference_scheme(s_n(n), 1).symbol(); }, 1,
      most);
  // (1+z) q: the coefficient of z^(2j) is even(j) + odd(j), the one of z^(2j-1) is odd(j) + even(j-1).
  trial.follow(identity(even + odd, context.formula("eq-3-even"), {{"n", 1}, {"j", 0}}));
  trial.follow(identity(odd + even.replaced("j", f("j - 1")), context.formula("eq-3-odd"), {{"n", 1}, {"j", 0}}));
  trial.follow(identity(odd.replaced("j", f("n")), f("0"), {{"n", 1}}));
  trial.follow(identity(even.replaced("j", f("-n")), f("0"), {{"n", 1}}));
  return trial.for_all(
      "all n >= 1",
      "(1+z) q_n = a_n coefficient by coefficient; both forms vanish where their sums end; divided out for " +
          up_to(most));
}

Outcome norm_of_q(const Context& context) {
  const Formula odd = context.formula("eq-4-odd"), even = context.formula("eq-4-even");
  const Formula value = context.formula("norm-of-q");
  const int most = context.reach(10, 60);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    trial.equal(value({}), operator_norm({assembled(symbol_4(context), n), 2}), at("n", n));
  trial.follow(sum_identity({odd, "j", {-1, 1}, {1, -1}}, value, {{"n", 1}}));
  trial.follow(sum_identity({even, "j", {-1, 1}, {1, -1}}, value, {{"n", 1}}));
  trial.follow(sum_identity({context.formula("norm-of-q-term"), "j", {0, 1}, {2, -1}}, value, {{"n", 1}}));
  trial.follow(positive(odd, {{"n", "1 + x + y"}, {"j", "x"}}));
  trial.follow(positive(odd, {{"n", "1 + x + y"}, {"j", "-x"}}));
  trial.follow(positive(even, {{"n", "1 + x + y"}, {"j", "x"}}));
  trial.follow(positive(even, {{"n", "1 + x + y"}, {"j", "-x"}}));
  return trial.for_all(
      "all n >= 1",
      "all coefficients are positive and both sums are 1/2 for every n; norms computed for " + up_to(most));
}

/// The sums over the even and over the odd indices of q_n add to q_n(1) = a_n(1)/2 = 1 for every convergent scheme, so
/// that one of them is 1/2 at least; the printed q_n attain it.
Outcome least_norm(const Context& context) {
  const Rational least = context.formula("norm-of-q")({});
  const int most = context.reach(10, 60);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    const LaurentPolynomial symbol = assembled(symbol_4(context), n);
    trial.equal(2 * least, symbol(1), at("n", n) + ", q_n(1)");
    trial.equal(least, operator_norm({symbol, 2}), at("n", n) + ", norm");
  }
  return trial.for_all("all n >= 1, and every convergent binary scheme",
                       "the two sums of |coefficients| of q = a/(1+z) add to |q(1)| = a(1)/2 = 1 at least, so the "
                       "larger one is 1/2 at least; S_n attains it (norm-of-q)");
}

/// q = ((1+z)/2)^m for the uniform B-splines of degree m >= 1.
Outcome norm_of_splines(const Context& context) {
  const Rational least = context.formula("norm-of-q")({});
  const int most = context.reach(10, 60);
  Trial trial;
  for (int m = 1; m <= most; ++m) {
    const Mask difference = divided_difference_scheme(mask_of("bspline:degree=" + std::to_string(m)), 1);
    trial.equal(2 * least, operator_norm(difference), at("degree", m) + ", norm of 2q");
    trial.equal(0, difference.symbol()(-1), at("degree", m) + ", q(-1)");
  }
  return trial.for_all("all degrees m >= 1",
                       "q = ((1+z)/2)^m has positive coefficients, of sum 1, and q(-1) = 0, so that both sums are 1/2; "
                       "computed for degrees up to " +
                           std::to_string(most));
}

/// Table 1 as printed, against the theorem that it illustrates.
Outcome table_1_shows_c1(const Context& context) {
  Trial trial;
  for (const PublishedCell& cell : context.cells("table-1"))
    trial.require(read_decimal(cell.printed).value > 1, at("n", cell.n.value()) + ": " + cell.printed);
  return trial.over("9 cells");
}

Outcome theorem_2(const Context& context) {
  const Formula odd = f("2") * context.formula("eq-4-odd"), even = f("2") * context.formula("eq-4-even");
  const int most = context.reach(10, 40);
  Trial trial = positive_symbol(odd, {1, -1}, even, {1, -1});
  for (const char* j : {"x", "-x"}) {
    trial.follow(positive(odd, {{"n", "1 + x + y"}, {"j", j}}));
    trial.follow(positive(even, {{"n", "1 + x + y"}, {"j", j}}));
  }
  for (int n = 2; n <= most; ++n) {
    const Mask difference = divided_difference_scheme(s_n(n), 1);
    trial.require(difference.symbol() == LaurentPolynomial(2) * assembled(symbol_4(context), n),
                  at("n", n) + ": 2 q_n is not the difference scheme");
    trial.require(has_positive_mask(difference), at("n", n) + ": 2 q_n is not positive");
    trial.require(proved_smoothness(s_n(n)).order >= 1, at("n", n) + ": C^1 is not proved");
  }
  return trial.for_all(
      "all n >= 2",
      "2 q_n has coset sums 1 and 4n-2 positive coefficients for every n, so that the positive mask theorem "
      "applies to it; proved scheme by scheme for n = 2.." +
          std::to_string(most));
}

Outcome derivative_of_q(const Context& context) {
  const Formula odd = context.formula("eq-4-odd"), even = context.formula("eq-4-even");
  const Formula value = f("-(4*n - 1)/6");  // ours: the paper only prints the sign
  const int most = context.reach(10, 60);
  Trial trial = sum_identity({f("2*j - 1") * odd - f("2*j") * even, "j", {-1, 1}, {1, -1}}, value, {{"n", 1}});
  trial.follow(positive(f("0") - value, {{"n", "1 + x"}}));
  for (int n = 1; n <= most; ++n) {
    trial.equal(value({{"n", n}}), assembled(symbol_4(context), n).derivative()(-1), at("n", n) + ", q_n'(-1)");
    trial.require(sum_rules(s_n(n)) == 2, at("n", n) + ": not exactly two factors 1+z");
  }
  return trial.for_all("all n >= 1", "q_n'(-1) = -(4n-1)/6 for every n; a_n has exactly two factors 1+z");
}

Outcome not_c2(const Context& context) {
  const int most = context.reach(8, 16);
  Trial trial = proved_theorem("smoothness", 1);
  for (int n = 1; n <= most; ++n)
    trial.require(sum_rules(s_n(n)) == 2 && has_stable_shifts(s_n(n)).is_yes(), at("n", n));
  return trial.for_all("all n >= 1",
                       "Theorem U: phi_n is not C^2, and its exponent tends to 2; two sum rules and stable integer "
                       "shifts, so no C^2 limit but for degenerate data, for n = 1.." +
                           std::to_string(most));
}

}  // namespace

Checks section_2() {
  return {{"eq-1", unique_solution},
          {"centre", value_at_centre},
          {"eq-2", equation_2},
          {"eq-3", equation_3},
          {"odd-symmetry", odd_symmetry},
          {"primal-2n-point", primal_2n_point},
          {"masks-primal", printed_masks},
          {"s-1-interpolates", interpolating_2_point},
          {"theorem-1", theorem_1},
          {"eq-4", equation_4},
          {"norm-of-q", norm_of_q},
          {"least-norm", least_norm},
          {"theorem-2", theorem_2},
          {"table-1", [](const Context& c) { return table_words(c, "table-1"); }},
          {"q-derivative", derivative_of_q},
          {"b-spline-norm", norm_of_splines},
          {"table-1-c1", table_1_shows_c1},
          {"not-c2", not_c2}};
}

}  // namespace subcert::statements::dyn_2015
