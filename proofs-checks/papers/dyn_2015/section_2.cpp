// Sections 2 and 2.1: the primal schemes of degree 1, their convergence and smoothness.

#include "dyn_2015.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>
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
  return trial.over("m = 1.." + std::to_string(most) + ", d = 0..m-1, nodes (i^2 + 1)/2").outcome();
}

Outcome value_at_centre(const Context& context) {
  const Fit fit_at_centre{context.formula("dyn-2015/centre"), "i", {0, 1}, {1, 0}, {1, 0}, f("(n + 1)/2"), 1, 2, {}};
  return fit(fit_at_centre, context.reach(10, 40)).outcome();
}

Outcome equation_2(const Context& context) {
  const Fit even{context.formula("dyn-2015/eq-2-even"), "j", {-1, 1}, {1, -1}, {1, 0}, f("0"), 1, 1, {}};
  const Fit odd{context.formula("dyn-2015/eq-2-odd"), "j", {-1, 1}, {1, 0}, {1, 0}, f("1/2"), 1, 1, {}};
  const int most = context.reach(8, 40);
  Trial trial = fit(even, most);
  trial.follow(fit(odd, most));
  return trial.outcome();
}

std::vector<SymbolPart> symbol_3(const Context& context) {
  return {{context.formula("dyn-2015/eq-3-odd"), "j", {-1, 1}, {1, 0}, {2, -1}},
          {context.formula("dyn-2015/eq-3-even"), "j", {-1, 1}, {1, -1}, {2, 0}}};
}

Outcome equation_3(const Context& context) {
  const int most = context.reach(10, 60);
  Trial trial = symbol_family(
      symbol_3(context), [](long n) { return s_n(n).symbol(); }, 1, most);
  // a_{2i+1-2(i+l)} = a_{1-2l} weighs the datum i+l: the exponent 2j-1 belongs to l = 1-j, the exponent 2j to l = -j.
  trial.follow(fit({context.formula("dyn-2015/eq-3-odd"), "j", {-1, 1}, {1, 0}, {-1, 1}, f("1/2"), 1, 1, {}}, most));
  trial.follow(fit({context.formula("dyn-2015/eq-3-even"), "j", {-1, 1}, {1, -1}, {-1, 0}, f("0"), 1, 1, {}}, most));
  return trial
      .for_all("all n >= 1", "each coefficient is a weight of a local fit; compared with the masks for " + up_to(most))
      .outcome();
}

Outcome odd_symmetry(const Context& context) {
  const int most = context.reach(20, 100);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    trial.require(s_n(n).symbol() == s_n(n).symbol().reversed() && assembled(symbol_3(context), n) == s_n(n).symbol(),
                  at("n", n));
  return trial
      .for_all("all n >= 1",
               "the coefficients of (3) do not depend on j, and the exponents come in pairs; tried for " + up_to(most))
      .outcome();
}

Outcome primal_2n_point(const Context& context) {
  const int most = context.reach(20, 100);
  Trial trial;
  for (int n = 1; n <= most; ++n) {
    trial.equal(2 * n, s_n(n).symbol().coset(2, 1).length(), at("n", n) + ", data of the odd rule");
    trial.equal(2 * n - 1, s_n(n).symbol().coset(2, 0).length(), at("n", n) + ", data of the even rule");
  }
  return trial.over(up_to(most)).outcome();
}

Outcome printed_masks(const Context& context) {
  Trial trial;
  for (int n = 1; n <= 3; ++n) {
    const std::string name = "a_" + std::to_string(n);
    trial.follow(mask_list(context.list("dyn-2015/" + name), s_n(n), name));
  }
  return trial.over("n = 1..3").outcome();
}

Outcome interpolating_2_point(const Context&) {
  Trial trial;
  trial.require(s_n(1).symbol().coset(2, 0) == LaurentPolynomial(1), "the even rule is not f_{2i} = f_i");
  trial.require(s_n(1) == mask_of("bspline:degree=1"), "the mask is not the one of piecewise linear functions");
  return trial.over("n = 1").outcome();
}

/// Coset sums 1 for all n, and positive coefficients.
Trial positive_symbol(const Formula& odd, const Line& odd_last, const Formula& even, const Line& even_last) {
  Trial trial = sum_identity({odd, "j", {-1, 1}, odd_last}, f("1"), {{"n", 2}});
  trial.follow(sum_identity({even, "j", {-1, 1}, even_last}, f("1"), {{"n", 2}}));
  return trial;
}

Outcome theorem_1(const Context& context) {
  const Formula odd = context.formula("dyn-2015/eq-3-odd"), even = context.formula("dyn-2015/eq-3-even");
  const int most = context.reach(10, 40);
  Trial trial = positive_symbol(odd, {1, 0}, even, {1, -1});
  trial.follow(positive(odd, {{"n", "1 + x"}}));
  trial.follow(positive(even, {{"n", "1 + x"}}));
  for (int n = 1; n <= most; ++n) {
    trial.require(converges(s_n(n)).is_yes(), at("n", n) + ": convergence is not proved");
    trial.require(has_positive_mask(s_n(n)), at("n", n) + ": the mask is not positive");
  }
  return trial
      .for_all("all n >= 1",
               "both coset sums are 1 and all 4n-1 coefficients are positive for every n, so that the positive mask "
               "theorem applies; convergence also proved scheme by scheme for " +
                   up_to(most))
      .outcome();
}

std::vector<SymbolPart> symbol_4(const Context& context) {
  return {{context.formula("dyn-2015/eq-4-odd"), "j", {-1, 1}, {1, -1}, {2, -1}},
          {context.formula("dyn-2015/eq-4-even"), "j", {-1, 1}, {1, -1}, {2, 0}}};
}

Outcome equation_4(const Context& context) {
  const Formula odd = context.formula("dyn-2015/eq-4-odd"), even = context.formula("dyn-2015/eq-4-even");
  const int most = context.reach(10, 60);
  Trial trial = symbol_family(
      symbol_4(context),
      [](long n) { return LaurentPolynomial(Rational(1, 2)) * divided_difference_scheme(s_n(n), 1).symbol(); }, 1,
      most);
  // (1+z) q: the coefficient of z^(2j) is even(j) + odd(j), the one of z^(2j-1) is odd(j) + even(j-1).
  trial.follow(identity(even + odd, context.formula("dyn-2015/eq-3-even"), {{"n", 1}, {"j", 0}}));
  trial.follow(
      identity(odd + even.replaced("j", f("j - 1")), context.formula("dyn-2015/eq-3-odd"), {{"n", 1}, {"j", 0}}));
  trial.follow(identity(odd.replaced("j", f("n")), f("0"), {{"n", 1}}));
  trial.follow(identity(even.replaced("j", f("-n")), f("0"), {{"n", 1}}));
  return trial
      .for_all("all n >= 1",
               "(1+z) q_n = a_n coefficient by coefficient; both forms vanish where their sums end; divided out for " +
                   up_to(most))
      .outcome();
}

Outcome norm_of_q(const Context& context) {
  const Formula odd = context.formula("dyn-2015/eq-4-odd"), even = context.formula("dyn-2015/eq-4-even");
  const Formula value = context.formula("dyn-2015/norm-of-q");
  const int most = context.reach(10, 60);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    trial.equal(value({}), operator_norm({assembled(symbol_4(context), n), 2}), at("n", n));
  trial.follow(sum_identity({odd, "j", {-1, 1}, {1, -1}}, value, {{"n", 1}}));
  trial.follow(sum_identity({even, "j", {-1, 1}, {1, -1}}, value, {{"n", 1}}));
  trial.follow(sum_identity({context.formula("dyn-2015/norm-of-q-term"), "j", {0, 1}, {2, -1}}, value, {{"n", 1}}));
  trial.follow(positive(odd, {{"n", "1 + x + y"}, {"j", "x"}}));
  trial.follow(positive(odd, {{"n", "1 + x + y"}, {"j", "-x"}}));
  trial.follow(positive(even, {{"n", "1 + x + y"}, {"j", "x"}}));
  trial.follow(positive(even, {{"n", "1 + x + y"}, {"j", "-x"}}));
  return trial
      .for_all("all n >= 1",
               "all coefficients are positive and both sums are 1/2 for every n; norms computed for " + up_to(most))
      .outcome();
}

Outcome theorem_2(const Context& context) {
  const Formula odd = f("2") * context.formula("dyn-2015/eq-4-odd"),
                even = f("2") * context.formula("dyn-2015/eq-4-even");
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
  return trial
      .for_all("all n >= 2",
               "2 q_n has coset sums 1 and 4n-2 positive coefficients for every n, so that the positive mask theorem "
               "applies to it; proved scheme by scheme for n = 2.." +
                   std::to_string(most))
      .outcome();
}

Outcome table_1(const Context& context) {
  std::vector<std::string> labels;
  for (int n = 2; n <= 10; ++n) labels.push_back(at("n", n));
  return table_row(
             context.words("dyn-2015/table-1"), labels,
             [](std::size_t i) { return holder_bound_of(specification("primal", static_cast<int>(i) + 2)).exponent; })
      .outcome();
}

Outcome derivative_of_q(const Context& context) {
  const Formula odd = context.formula("dyn-2015/eq-4-odd"), even = context.formula("dyn-2015/eq-4-even");
  const Formula value = f("-(4*n - 1)/6");  // ours: the paper only prints the sign
  const int most = context.reach(10, 60);
  Trial trial = sum_identity({f("2*j - 1") * odd - f("2*j") * even, "j", {-1, 1}, {1, -1}}, value, {{"n", 1}});
  trial.follow(positive(f("0") - value, {{"n", "1 + x"}}));
  for (int n = 1; n <= most; ++n) {
    trial.equal(value({{"n", n}}), assembled(symbol_4(context), n).derivative()(-1), at("n", n) + ", q_n'(-1)");
    trial.require(sum_rules(s_n(n)) == 2, at("n", n) + ": not exactly two factors 1+z");
  }
  return trial.for_all("all n >= 1", "q_n'(-1) = -(4n-1)/6 for every n; a_n has exactly two factors 1+z").outcome();
}

Outcome not_c2(const Context& context) {
  const int most = context.reach(8, 16);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    trial.require(sum_rules(s_n(n)) == 2 && has_stable_shifts(s_n(n)).is_yes(), at("n", n));
  return trial.over(up_to(most) + ": two sum rules and stable integer shifts, so no C^2 limit but for degenerate data")
      .outcome();
}

}  // namespace

void add_section_2(PaperStatements& to) {
  to.transcriptions.insert(to.transcriptions.end(),
                           {
                               {"dyn-2015/centre", "1/n"},
                               {"dyn-2015/eq-2-even", "1/(2*n - 1)"},
                               {"dyn-2015/eq-2-odd", "1/(2*n)"},
                               {"dyn-2015/eq-3-odd", "1/(2*n)"},
                               {"dyn-2015/eq-3-even", "1/(2*n - 1)"},
                               {"dyn-2015/a_1", "[1, 2, 1]/2"},
                               {"dyn-2015/a_2", "[3, 4, 3, 4, 3, 4, 3]/12"},
                               {"dyn-2015/a_3", "[5, 6, 5, 6, 5, 6, 5, 6, 5, 6, 5]/30"},
                               {"dyn-2015/eq-4-odd", "1/(2*n*(2*n - 1))*(n - j)"},
                               {"dyn-2015/eq-4-even", "1/(2*n*(2*n - 1))*(n + j)"},
                               {"dyn-2015/norm-of-q-term", "1/(2*n*(2*n - 1))*j"},
                               {"dyn-2015/norm-of-q", "1/2"},
                               {"dyn-2015/table-1", "1.649 1.777 1.816 1.794 1.786 1.776 1.771 1.761 1.753"},
                           });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  add({"dyn-2015/eq-1", "section 2, equation (1)", "For d < m the least squares problem has a unique solution.",
       "the Vandermonde matrix of m nodes and d+1 columns has no kernel",
       R"(\sum_{i=1}^m (p_d(x_i) - y_i)^2, \quad d < m)", "", Verdict::holds, unique_solution});
  add({"dyn-2015/centre", "section 2, before equation (2)",
       "At the centre of m equidistant nodes the linear fit is the mean of the data.",
       "weights 1/m against the fits; n stands for m",
       R"(p_1^*(c) = (y_1 + \dots + y_m)/m, \quad c = (x_1 + \dots + x_m)/m)", "", Verdict::holds_for_all,
       value_at_centre});
  add({"dyn-2015/eq-2", "section 2, equation (2)", "The refinement rules of S_n are averages of 2n-1 and of 2n data.",
       "the weights against the local linear least squares fits",
       R"(f_{2i}^{k+1} = <<dyn-2015/eq-2-even>> \sum_{j=-n+1}^{n-1} f_{i+j}^k, \quad f_{2i+1}^{k+1} = )"
       R"(<<dyn-2015/eq-2-odd>> \sum_{j=-n+1}^{n} f_{i+j}^k)",
       "", Verdict::holds_for_all, equation_2});
  add({"dyn-2015/eq-3", "section 2, equation (3)", "The symbol of S_n.", "every coefficient against the derived mask",
       R"(a_n(z) = \sum_{j=-n+1}^n <<dyn-2015/eq-3-odd>> z^{2j-1} + \sum_{j=-n+1}^{n-1} <<dyn-2015/eq-3-even>> z^{2j})",
       "", Verdict::holds_for_all, equation_3});
  add({"dyn-2015/odd-symmetry", "section 2, after equation (3)", "The scheme is odd symmetric.",
       "the symbol against its reversal", R"(a_n(z) = a_n(1/z))", "", Verdict::holds_for_all, odd_symmetry});
  add({"dyn-2015/primal-2n-point", "section 2, after equation (3)", "S_n is a primal 2n-point scheme.",
       "the rules use 2n-1 and 2n data",
       R"(\text{the data at level } k+1 \text{ depend on at most } 2n \text{ values at level } k)", "", Verdict::holds,
       primal_2n_point});
  add({"dyn-2015/masks-primal", "section 2, printed masks", "The masks of S_1, S_2, S_3.",
       "every entry against the derived mask",
       R"(\mathbf{a}_1 = <<dyn-2015/a_1>>, \quad \mathbf{a}_2 = <<dyn-2015/a_2>>, \quad \mathbf{a}_3 = )"
       R"(<<dyn-2015/a_3>>)",
       "", Verdict::holds, printed_masks});
  add({"dyn-2015/s-1-interpolates", "section 2, end",
       "S_1 is the interpolating 2-point scheme with piecewise linear limits.",
       "the mask is the one of linear B-splines", R"(S_1)", "", Verdict::holds, interpolating_2_point});
  add({"dyn-2015/theorem-1", "Theorem 1", "S_n converges for n >= 1.",
       "a_n(1) = 2, a_n(-1) = 0, positive coefficients; convergence by the library",
       R"(S_n \text{ is convergent for } n \geq 1)", "", Verdict::holds_for_all, theorem_1});
  add({"dyn-2015/eq-4", "section 2.1, equation (4)", "The symbol of the difference scheme.", "(1+z) q_n = a_n",
       R"(q_n(z) = \sum_{j=-n+1}^{n-1} <<dyn-2015/eq-4-odd>> z^{2j-1} + \sum_{j=-n+1}^{n-1} <<dyn-2015/eq-4-even>> )"
       R"(z^{2j})",
       "", Verdict::holds_for_all, equation_4});
  add({"dyn-2015/norm-of-q", "section 2.1, after equation (4)", "The difference scheme has norm 1/2.",
       "both sums of the maximum, and operator norms",
       R"(\|S_{[q_n]}\|_\infty = \sum_{j=1}^{2n-1} <<dyn-2015/norm-of-q-term>> = <<dyn-2015/norm-of-q>>)", "",
       Verdict::holds_for_all, norm_of_q});
  add({"dyn-2015/theorem-2", "Theorem 2 and its proof", "S_n has C^1 limits for n >= 2.",
       "2q_n(1) = 2, 2q_n(-1) = 0, positive coefficients; C^1 by the library",
       R"(S_n \text{ generates } C^1 \text{ limit functions for } n \geq 2)", "", Verdict::holds_for_all, theorem_2});
  add({"dyn-2015/table-1", "Table 1", "Lower bounds of the Hoelder exponents of S_n, n = 2..10.",
       "exact norms after 16 levels, to one unit of the last place", R"(\rho_n: <<dyn-2015/table-1>>)", "",
       Verdict::holds, table_1});
  add({"dyn-2015/q-derivative", "section 2.1, end", "q_n'(-1) < 0, so (1+z)^3 is not a factor of a_n.",
       "the exact value of q_n'(-1)", R"(q_n'(-1) < 0)", "", Verdict::holds_for_all, derivative_of_q});
  add({"dyn-2015/not-c2", "section 2.1, end", "S_n does not generate C^2 limits.",
       "exactly two sum rules and stable shifts", R"(S_n \text{ does not generate } C^2 \text{ limits})", "",
       Verdict::holds, not_c2});
}

}  // namespace subcert::statements::dyn_2015
