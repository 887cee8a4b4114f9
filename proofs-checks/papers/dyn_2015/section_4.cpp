// Sections 4.1 and 4.2: dual schemes and variants, degree 1.

#include "dyn_2015.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <algorithm>

namespace subcert::statements::dyn_2015 {
namespace {

Mask dual_mask(long n) { return regression_mask(dual(static_cast<int>(n), 1)); }
Mask dual_odd_mask(long n) { return regression_mask(dual_odd(static_cast<int>(n), 1)); }
Mask primal_odd_mask(long n) { return regression_mask(primal_odd(static_cast<int>(n), 1)); }

Outcome equation_19(const Context& context) {
  const int most = context.reach(8, 40);
  Trial trial = fit({context.formula("dyn-2015/eq-19-even"), "j", {-1, 1}, {1, 0}, {1, 0}, f("1/4"), 1, 1, {}}, most);
  trial.follow(fit({context.formula("dyn-2015/eq-19-odd"), "j", {-1, 1}, {1, 0}, {1, 0}, f("3/4"), 1, 1, {}}, most));
  return trial.outcome();
}

/// 1 + z + g (1 - z) = (1 + g) + (1 - g) z.
std::vector<SymbolPart> symbol_20(const Context& context) {
  const Formula outer = context.formula("dyn-2015/eq-20-outer"), inner = context.formula("dyn-2015/eq-20-inner");
  return {{outer * (f("1") + inner), "j", {-1, 0}, {1, -1}, {2, 0}},
          {outer * (f("1") - inner), "j", {-1, 0}, {1, -1}, {2, 1}}};
}

Outcome equation_20(const Context& context) {
  const int most = context.reach(10, 60);
  const auto parts = symbol_20(context);
  Trial trial = symbol_family(
      parts, [](long n) { return dual_mask(n).symbol(); }, 1, most);
  // The exponents 2j and 2j+1 belong to the datum at -j.
  trial.follow(fit({parts[0].coefficient, "j", {-1, 0}, {1, -1}, {-1, 0}, f("1/4"), 1, 1, {}}, most));
  trial.follow(fit({parts[1].coefficient, "j", {-1, 0}, {1, -1}, {-1, 0}, f("3/4"), 1, 1, {}}, most));
  return trial
      .for_all("all n >= 1",
               "each coefficient is a weight of a local fit; compared with the masks for " + range(1, most))
      .outcome();
}

Outcome even_symmetry(const Context& context) {
  const int most = context.reach(20, 60);
  const auto parts = symbol_20(context);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    trial.require(assembled(parts, n).shifted(1) == assembled(parts, n).reversed(), at("n", n));
  trial.follow(identity(parts[0].coefficient, parts[1].coefficient.replaced("j", f("-j - 1")), {{"n", 1}, {"j", 0}}));
  return trial
      .for_all("all n >= 1",
               "the coefficient of z^(2j) is the one of z^(-2j-1), an identity in n and j; tried for " + range(1, most))
      .outcome();
}

Outcome support_of(const Context& context, const std::string& id, Mask (*mask)(long), const std::string& argument) {
  const int most = context.reach(20, 60);
  Trial trial = limit_supports(context.formula(id + "-lower"), context.formula(id + "-upper"), mask, 1, most);
  return trial.for_all("all n >= 1", argument + "; compared for " + range(1, most)).outcome();
}

const std::string outer_weights =
    "the outermost data of both rules have non-zero weights for every n, as the closed forms show";

Outcome printed_masks(const Context& context, const std::string& prefix, Mask (*mask)(long),
                      const std::vector<int>& sizes) {
  Trial printed, corrected;
  for (int n : sizes) {
    const std::string id = prefix + std::to_string(n);
    printed.follow(mask_list(context.list(id, Form::printed), mask(n), at("n", n)));
    corrected.follow(mask_list(context.list(id, Form::corrected), mask(n), at("n", n)));
  }
  return printed.over(range(sizes.front(), sizes.back())).outcome(corrected.over(range(sizes.front(), sizes.back())));
}

Outcome chaikin(const Context&) {
  Trial trial;
  trial.require(dual_mask(1) == mask_of("bspline:degree=2"), "the mask is not the one of quadratic B-splines");
  trial.follow(mask_list({f("1/4"), f("3/4"), f("3/4"), f("1/4")}, dual_mask(1), "n = 1"));
  return trial.over("n = 1").outcome();
}

Outcome dual_converges(const Context& context) {
  const int most = context.reach(10, 40);
  Trial trial;
  // j = n - y <= n in the even rule; the odd rule mirrors it.
  trial.follow(positive(context.formula("dyn-2015/eq-19-even"), {{"n", "1 + x"}, {"j", "1 + x - y"}}));
  trial.follow(positive(context.formula("dyn-2015/eq-19-odd"), {{"n", "1 + x"}, {"j", "y - x"}}));
  trial.follow(sum_identity({context.formula("dyn-2015/eq-19-even"), "j", {-1, 1}, {1, 0}}, f("1"), {{"n", 1}}));
  trial.follow(sum_identity({context.formula("dyn-2015/eq-19-odd"), "j", {-1, 1}, {1, 0}}, f("1"), {{"n", 1}}));
  for (int n = 1; n <= most; ++n) trial.require(converges(dual_mask(n)).is_yes(), at("n", n));
  return trial
      .for_all("all n >= 1",
               "coset sums 1 and positive coefficients for every n; convergence also proved for " + range(1, most))
      .outcome();
}

/// a(z)/(1+z) by a closed form. a has the coefficients `first`(j) at the exponents 2j + offset and `second`(j) at the
/// ones that follow; the quotient has `quotient_first` and `quotient_second` there, for j in the ranges given.
struct Quotient {
  Formula first, second;
  Formula quotient_first, quotient_second;
  Line from, first_to, second_to;
  long offset;
};

/// The positive mask theorem for 2a(z)/(1+z) and every n: C^1 limits. The closed form is ours, the division proves it.
Trial positive_quotient(const Quotient& q, Mask (*mask)(long), int most) {
  const std::vector<SymbolPart> parts{{f("2") * q.quotient_first, "j", q.from, q.first_to, {2, q.offset}},
                                      {f("2") * q.quotient_second, "j", q.from, q.second_to, {2, q.offset + 1}}};
  Trial trial = symbol_family(
      parts, [&](long n) { return divided_difference_scheme(mask(n), 1).symbol(); }, 1, most);
  trial.follow(identity(q.quotient_first + q.quotient_second.replaced("j", f("j - 1")), q.first, {{"n", 1}, {"j", 0}}));
  trial.follow(identity(q.quotient_first + q.quotient_second, q.second, {{"n", 1}, {"j", 0}}));
  trial.follow(identity(q.quotient_second.replaced("j", f("-n - 1")), f("0"), {{"n", 1}}));
  trial.follow(sum_identity({f("2") * q.quotient_first, "j", q.from, q.first_to}, f("1"), {{"n", 1}}));
  trial.follow(sum_identity({f("2") * q.quotient_second, "j", q.from, q.second_to}, f("1"), {{"n", 1}}));
  for (int n = 1; n <= most; ++n)
    trial.require(has_positive_mask(divided_difference_scheme(mask(n), 1)),
                  at("n", n) + ": the quotient is not positive");
  for (int n = 1; n <= 4; ++n) trial.require(proved_smoothness(mask(n)).order >= 1, at("n", n) + ": C^1 is not proved");
  return trial;
}

const std::string quotient_argument =
    "the quotient by 1+z has a closed form, positive for every n, and coset sums 1 after doubling: the positive mask "
    "theorem";

Outcome dual_c1(const Context& context) {
  const auto parts = symbol_20(context);
  const Formula even = f("(2*n^2 + 1 + 6*j*(j + 1))/(2*n*(8*n^2 - 2))"), odd = f("3*(n^2 - (j + 1)^2)/(n*(8*n^2 - 2))");
  Trial trial = positive_quotient({parts[0].coefficient, parts[1].coefficient, even, odd, {-1, 0}, {1, -1}, {1, -2}, 0},
                                  dual_mask, context.reach(10, 30));
  for (const char* j : {"x", "-1 - x"}) trial.follow(positive(even, {{"n", "1 + y"}, {"j", j}}));
  for (const char* j : {"x - 1", "-1 - x"}) trial.follow(positive(odd, {{"n", "1 + x + y"}, {"j", j}}));
  return trial.for_all("all n >= 1", quotient_argument).outcome();
}

Outcome variants_c1(const Context& context) {
  const int most = context.reach(10, 30);
  const Formula left = context.formula("dyn-2015/dual-odd-left"), right = context.formula("dyn-2015/dual-odd-right");
  // The datum at j has the weight left(j) at the exponent -1-2j and right(j) at -2j.
  const Formula dual_first = f("(n*(n + 1) + 3*j^2)/((2*n + 1)*4*n*(n + 1))");
  const Formula dual_second = f("3*(n*(n + 1) - j*(j + 1))/((2*n + 1)*4*n*(n + 1))");
  Trial trial = positive_quotient({left.replaced("j", f("-j")),
                                   right.replaced("j", f("-j")),
                                   dual_first,
                                   dual_second,
                                   {-1, 0},
                                   {1, 0},
                                   {1, -1},
                                   -1},
                                  dual_odd_mask, most);
  for (const char* j : {"x", "-x"}) trial.follow(positive(dual_first, {{"n", "1 + y"}, {"j", j}}));
  for (const char* j : {"x", "-1 - x"}) trial.follow(positive(dual_second, {{"n", "1 + x + y"}, {"j", j}}));
  const Formula primal_first = f("(n - j)/(2*n*(2*n + 1))"), primal_second = f("(n + j + 1)/(2*n*(2*n + 1))");
  trial.follow(positive_quotient({context.formula("dyn-2015/primal-odd-even"),
                                  context.formula("dyn-2015/eq-2-odd"),
                                  primal_first,
                                  primal_second,
                                  {-1, 0},
                                  {1, -1},
                                  {1, -1},
                                  0},
                                 primal_odd_mask, most));
  for (const char* j : {"x", "-1 - x"}) {
    trial.follow(positive(primal_first, {{"n", "1 + x + y"}, {"j", j}}));
    trial.follow(positive(primal_second, {{"n", "1 + x + y"}, {"j", j}}));
  }
  return trial.for_all("all n >= 1", quotient_argument).outcome();
}

/// (1+z)^3 divides the symbol: the symbol and its first two derivatives vanish at -1.
Outcome three_factors(const Context& context) {
  const auto parts = symbol_20(context);
  const Formula &even = parts[0].coefficient, &odd = parts[1].coefficient;
  const int most = context.reach(10, 40);
  Trial trial = sum_identity({even - odd, "j", {-1, 0}, {1, -1}}, f("0"), {{"n", 1}});
  trial.follow(sum_identity({f("2*j + 1") * odd - f("2*j") * even, "j", {-1, 0}, {1, -1}}, f("0"), {{"n", 1}}));
  trial.follow(
      sum_identity({f("2*j*(2*j - 1)") * even - f("(2*j + 1)*2*j") * odd, "j", {-1, 0}, {1, -1}}, f("0"), {{"n", 1}}));
  for (int n = 1; n <= most; ++n) trial.require(sum_rules(dual_mask(n)) >= 3, at("n", n));
  return trial
      .for_all("all n >= 1",
               "the symbol and its first two derivatives vanish at -1, as sums over j that are identities in n")
      .outcome();
}

Outcome negative_coefficients(const Context& context) {
  const int most = context.reach(12, 40);
  Trial trial;
  for (int n = 2; n <= most; ++n) {
    const auto coefficients = divided_difference_scheme(dual_mask(n), 2).symbol().coefficients();
    trial.require(std::any_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c < 0; }),
                  at("n", n));
  }
  Outcome outcome = trial.over(range(2, most)).outcome();
  outcome.argument = "for n = 1 the quotient is 1 + z up to a power of z and has none";
  return outcome;
}

Outcome table_2(const Context& context) {
  std::vector<std::string> labels;
  for (int n = 2; n <= 10; ++n) labels.push_back(at("n", n));
  return table_row(
             context.words("dyn-2015/table-2"), labels,
             [](std::size_t i) { return holder_bound_of(specification("dual", static_cast<int>(i) + 2)).exponent; })
      .outcome();
}

Outcome twice_differentiable(const std::string& family, int first) {
  Trial trial;
  for (int n = first; n <= 10; ++n) {
    const Rational bound = *holder_bound_of(specification(family, n)).exponent.lower;
    trial.require(bound > 2, at("n", n) + ": the bound after 16 levels is " + to_decimal(bound, 5, Rounding::down));
  }
  return trial.over(range(first, 10) + ": the proved lower bounds of the exponents exceed 2").outcome();
}

Outcome dual_odd_rules(const Context& context) {
  const int most = context.reach(8, 40);
  Trial trial = fit({context.formula("dyn-2015/dual-odd-left"), "j", {-1, 0}, {1, 0}, {1, 0}, f("-1/4"), 1, 1, {}},
                    most);
  trial.follow(
      fit({context.formula("dyn-2015/dual-odd-right"), "j", {-1, 0}, {1, 0}, {1, 0}, f("1/4"), 1, 1, {}}, most));
  return trial.outcome();
}

Outcome primal_odd_rule(const Context& context) {
  return fit({context.formula("dyn-2015/primal-odd-even"), "j", {-1, 0}, {1, 0}, {1, 0}, f("0"), 1, 1, {}},
             context.reach(8, 40))
      .outcome();
}

}  // namespace

void add_section_4(PaperStatements& to) {
  to.transcriptions.insert(to.transcriptions.end(),
                           {
                               {"dyn-2015/eq-19-even", "1/(2*n)*(1 - (6*j - 3)/(8*n^2 - 2))"},
                               {"dyn-2015/eq-19-odd", "1/(2*n)*(1 + (6*j - 3)/(8*n^2 - 2))"},
                               {"dyn-2015/eq-20-outer", "1/(2*n)"},
                               {"dyn-2015/eq-20-inner", "(6*j + 3)/(8*n^2 - 2)"},
                               {"dyn-2015/support-dual-lower", "-2*n"},
                               {"dyn-2015/support-dual-upper", "2*n - 1"},
                               {"dyn-2015/dual-1", "[1, 3, 3, 1]/4"},
                               {"dyn-2015/dual-2", "[7, 13, 9, 11, 11, 9, 13, 7]/40"},
                               {"dyn-2015/dual-3", "[55, 85, 61, 79, 67, 73, 73, 67, 79, 61, 85, 55]/420"},
                               {"dyn-2015/table-2", "2.285 2.647 2.729 2.677 2.664 2.633 2.616 2.594 2.577"},
                               {"dyn-2015/dual-odd-left", "1/(2*n + 1)*(1 - 3*j/(4*n*(n + 1)))"},
                               {"dyn-2015/dual-odd-right", "1/(2*n + 1)*(1 + 3*j/(4*n*(n + 1)))"},
                               {"dyn-2015/support-dual-odd-lower", "-2*n - 1"},
                               {"dyn-2015/support-dual-odd-upper", "2*n"},
                               {"dyn-2015/dual-odd-1", "[5, 11, 8, 8, 11, 5]/24"},
                               {"dyn-2015/dual-odd-2", "[6, 10, 7, 9, 8, 8, 9, 7, 10, 6]/40"},
                               {"dyn-2015/dual-odd-3", "[13, 19, 14, 18, 15, 17, 16, 16, 17, 15, 18, 14, 19, 13]/112"},
                               {"dyn-2015/primal-odd-even", "1/(2*n + 1)"},
                               {"dyn-2015/support-primal-odd-lower", "-2*n"},
                               {"dyn-2015/support-primal-odd-upper", "2*n"},
                               {"dyn-2015/primal-odd-1", "[2, 3, 2, 3, 2]/6"},
                               {"dyn-2015/primal-odd-2", "[4, 5, 4, 5, 4, 5, 4, 5, 4]/20"},
                               {"dyn-2015/primal-odd-3", "[6, 7, 6, 7, 6, 7, 6, 7, 6, 7, 6, 7, 6{, 7, 6 => }]/42"},
                           });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  add({"dyn-2015/eq-19", "section 4.1, equation (19)", "The refinement rules of the dual schemes.",
       "the weights against the local fits at 1/4 and 3/4",
       R"(f_{2i}^{k+1} = \sum_{j=-n+1}^{n} <<dyn-2015/eq-19-even>> f_{i+j}^k, \quad f_{2i+1}^{k+1} = )"
       R"(\sum_{j=-n+1}^{n} <<dyn-2015/eq-19-odd>> f_{i+j}^k)",
       "", Verdict::holds_for_all, equation_19});
  add({"dyn-2015/eq-20", "section 4.1, equation (20)", "The symbol of the dual schemes.",
       "every coefficient against the derived mask",
       R"(\bar a_n(z) = <<dyn-2015/eq-20-outer>> \sum_{j=-n}^{n-1} \left(1 + z + <<dyn-2015/eq-20-inner>> (1 - )"
       R"(z)\right) z^{2j})",
       "", Verdict::holds_for_all, equation_20});
  add({"dyn-2015/even-symmetry", "section 4.1, after equation (20)", "The dual schemes are even symmetric.",
       "the symbol (20) against its reversal", R"(\bar a_n(z) z = \bar a_n(1/z))", "", Verdict::holds_for_all,
       even_symmetry});
  add({"dyn-2015/support-dual", "section 4.1", "The support of the dual basic limit function.",
       "both ends against the derived support", R"([<<dyn-2015/support-dual-lower>>, <<dyn-2015/support-dual-upper>>])",
       "", Verdict::holds_for_all,
       [](const Context& c) { return support_of(c, "dyn-2015/support-dual", dual_mask, outer_weights); }});
  add({"dyn-2015/masks-dual", "section 4.1, printed masks", "The masks of the first three dual schemes.",
       "every entry against the derived mask",
       R"(\bar{\mathbf{a}}_1 = <<dyn-2015/dual-1>>, \quad \bar{\mathbf{a}}_2 = <<dyn-2015/dual-2>>, \quad )"
       R"(\bar{\mathbf{a}}_3 = <<dyn-2015/dual-3>>)",
       "", Verdict::holds, [](const Context& c) {
         return printed_masks(c, "dyn-2015/dual-", dual_mask, {1, 2, 3});
       }});
  add({"dyn-2015/chaikin", "section 4.1", "The first dual scheme is Chaikin's.",
       "its mask is [1, 3, 3, 1]/4, the one of quadratic B-splines",
       R"(\bar S_1 \text{ is Chaikin's corner cutting scheme})", "", Verdict::holds, chaikin});
  add({"dyn-2015/dual-converges", "section 4.1, 'the proof of Theorem 1 carries over'", "The dual schemes converge.",
       "coset sums 1 and positive coefficients", R"(\bar S_n \text{ is convergent for } n \geq 1)", "",
       Verdict::holds_for_all, dual_converges});
  add({"dyn-2015/dual-c1", "section 4.1, 'the proof of Theorem 2 carries over'",
       "The dual schemes have C^1 limits for n >= 1.", "the quotient by 1+z in closed form, its signs and sums",
       R"(\bar S_n \text{ generates } C^1 \text{ limits for } n \geq 1)", "", Verdict::holds_for_all, dual_c1});
  add({"dyn-2015/dual-three-factors", "section 4.1", "The symbols of the dual schemes are divisible by (1+z)^3.",
       "value and two derivatives at -1", R"((1+z)^3 \mid \bar a_n(z))", "", Verdict::holds_for_all, three_factors});
  add({"dyn-2015/dual-negative", "section 4.1", "4a_n(z)/(1+z)^2 has negative coefficients.",
       "signs of the coefficients, for n >= 2", R"(4 \bar a_n(z)/(1+z)^2 \text{ has negative coefficients})", "",
       Verdict::holds, negative_coefficients});
  add({"dyn-2015/table-2", "Table 2", "Lower bounds of the Hoelder exponents of the dual schemes, n = 2..10.",
       "exact norms after 16 levels, to one unit of the last place", R"(\bar\rho_n: <<dyn-2015/table-2>>)", "",
       Verdict::holds, table_2});
  add({"dyn-2015/dual-c2", "section 4.1, end", "The dual schemes have C^2 limits for 2 <= n <= 10.",
       "proved lower bounds of the exponents",
       R"(\bar S_n \text{ generates } C^2 \text{ limits for } 2 \leq n \leq 10)", "", Verdict::holds,
       [](const Context&) { return twice_differentiable("dual", 2); }});
  add({"dyn-2015/dual-odd-rules", "section 4.2, first display", "The rules of the dual (2n+1)-point schemes.",
       "the weights against the local fits at -1/4 and 1/4",
       R"(f_{2i-1}^{k+1} = \sum_{j=-n}^n <<dyn-2015/dual-odd-left>> f_{i+j}^k, \quad f_{2i}^{k+1} = \sum_{j=-n}^n )"
       R"(<<dyn-2015/dual-odd-right>> f_{i+j}^k)",
       "", Verdict::holds_for_all, dual_odd_rules});
  add({"dyn-2015/support-dual-odd", "section 4.2", "The support for the dual (2n+1)-point schemes.",
       "both ends against the derived support",
       R"([<<dyn-2015/support-dual-odd-lower>>, <<dyn-2015/support-dual-odd-upper>>])", "", Verdict::holds_for_all,
       [](const Context& c) { return support_of(c, "dyn-2015/support-dual-odd", dual_odd_mask, outer_weights); }});
  add({"dyn-2015/masks-dual-odd", "section 4.2, printed masks",
       "The masks of the first three dual (2n+1)-point schemes.", "every entry against the derived mask",
       R"(<<dyn-2015/dual-odd-1>>, \quad <<dyn-2015/dual-odd-2>>, \quad <<dyn-2015/dual-odd-3>>)", "", Verdict::holds,
       [](const Context& c) {
         return printed_masks(c, "dyn-2015/dual-odd-", dual_odd_mask, {1, 2, 3});
       }});
  add({"dyn-2015/primal-odd-rule", "section 4.2, second display", "The even rule of the primal (2n+1)-point schemes.",
       "the weights against the local fit", R"(f_{2i}^{k+1} = <<dyn-2015/primal-odd-even>> \sum_{j=-n}^n f_{i+j}^k)",
       "", Verdict::holds_for_all, primal_odd_rule});
  add({"dyn-2015/support-primal-odd", "section 4.2", "The support for the primal (2n+1)-point schemes.",
       "both ends against the derived support",
       R"([<<dyn-2015/support-primal-odd-lower>>, <<dyn-2015/support-primal-odd-upper>>])", "", Verdict::holds_for_all,
       [](const Context& c) { return support_of(c, "dyn-2015/support-primal-odd", primal_odd_mask, outer_weights); }});
  add({"dyn-2015/masks-primal-odd", "section 4.2, printed masks, n = 1 and 2",
       "The masks of the primal 3-point and 5-point schemes.", "every entry against the derived mask",
       R"(<<dyn-2015/primal-odd-1>>, \quad <<dyn-2015/primal-odd-2>>)", "", Verdict::holds, [](const Context& c) {
         return printed_masks(c, "dyn-2015/primal-odd-", primal_odd_mask, {1, 2});
       }});
  add({"dyn-2015/mask-primal-7-point", "section 4.2, printed masks, n = 3", "The mask of the primal 7-point scheme.",
       "number and values of the entries", R"(<<dyn-2015/primal-odd-3>>)", R"(<<dyn-2015/primal-odd-3>>)",
       Verdict::misprint,
       [](const Context& c) { return printed_masks(c, "dyn-2015/primal-odd-", primal_odd_mask, {3}); }});
  add({"dyn-2015/variants-c1", "section 4.2", "Both variants have C^1 limits.",
       "the quotients by 1+z in closed form, their signs and sums",
       R"(\text{both variants generate } C^1 \text{ limit functions})", "", Verdict::holds_for_all, variants_c1});
  add({"dyn-2015/dual-odd-c2", "section 4.2, end", "The dual (2n+1)-point schemes have C^2 limits for 1 <= n <= 10.",
       "proved lower bounds of the exponents",
       R"(\text{the dual } (2n+1)\text{-point schemes are } C^2 \text{ for } 1 \leq n \leq 10)", "", Verdict::holds,
       [](const Context&) { return twice_differentiable("dual-odd", 1); }});
}

}  // namespace subcert::statements::dyn_2015
