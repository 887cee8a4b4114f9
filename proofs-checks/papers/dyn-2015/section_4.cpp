// Sections 4.1 and 4.2: dual schemes and variants, degree 1.

#include "checks.hpp"

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
  Trial trial = fit({context.formula("eq-19-even"), "j", {-1, 1}, {1, 0}, {1, 0}, f("1/4"), 1, 1, {}}, most);
  trial.follow(fit({context.formula("eq-19-odd"), "j", {-1, 1}, {1, 0}, {1, 0}, f("3/4"), 1, 1, {}}, most));
  return trial;
}

/// 1 + z + g (1 - z) = (1 + g) + (1 - g) z.
std::vector<SymbolPart> symbol_20(const Context& context) {
  const Formula outer = context.formula("eq-20-outer"), inner = context.formula("eq-20-inner");
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
  return trial.for_all("all n >= 1",
                       "each coefficient is a weight of a local fit; compared with the masks for " + range(1, most));
}

Outcome even_symmetry(const Context& context) {
  const int most = context.reach(20, 60);
  const auto parts = symbol_20(context);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    trial.require(assembled(parts, n).shifted(1) == assembled(parts, n).reversed(), at("n", n));
  trial.follow(identity(parts[0].coefficient, parts[1].coefficient.replaced("j", f("-j - 1")), {{"n", 1}, {"j", 0}}));
  return trial.for_all(
      "all n >= 1",
      "the coefficient of z^(2j) is the one of z^(-2j-1), an identity in n and j; tried for " + range(1, most));
}

Outcome support_of(const Context& context, const std::string& id, Mask (*mask)(long), const std::string& argument) {
  const int most = context.reach(20, 60);
  Trial trial = limit_supports(context.formula(id + "-lower"), context.formula(id + "-upper"), mask, 1, most);
  return trial.for_all("all n >= 1", argument + "; compared for " + range(1, most));
}

const std::string outer_weights =
    "the outermost data of both rules have non-zero weights for every n, as the closed forms show";

Outcome printed_masks(const Context& context, const std::string& prefix, Mask (*mask)(long),
                      const std::vector<int>& sizes) {
  return in_both_forms([&](Form form) {
    Trial trial;
    for (int n : sizes) trial.follow(mask_list(context.list(prefix + std::to_string(n), form), mask(n), at("n", n)));
    return trial.over(range(sizes.front(), sizes.back()));
  });
}

Outcome chaikin(const Context&) {
  Trial trial;
  trial.require(dual_mask(1) == mask_of("bspline:degree=2"), "the mask is not the one of quadratic B-splines");
  trial.follow(mask_list({f("1/4"), f("3/4"), f("3/4"), f("1/4")}, dual_mask(1), "n = 1"));
  return trial.over("n = 1");
}

Outcome dual_converges(const Context& context) {
  const int most = context.reach(10, 40);
  Trial trial;
  // j = n - y <= n in the even rule; the odd rule mirrors it.
  trial.follow(positive(context.formula("eq-19-even"), {{"n", "1 + x"}, {"j", "1 + x - y"}}));
  trial.follow(positive(context.formula("eq-19-odd"), {{"n", "1 + x"}, {"j", "y - x"}}));
  trial.follow(sum_identity({context.formula("eq-19-even"), "j", {-1, 1}, {1, 0}}, f("1"), {{"n", 1}}));
  trial.follow(sum_identity({context.formula("eq-19-odd"), "j", {-1, 1}, {1, 0}}, f("1"), {{"n", 1}}));
  for (int n = 1; n <= most; ++n) trial.require(converges(dual_mask(n)).is_yes(), at("n", n));
  return trial.for_all(
      "all n >= 1",
      "coset sums 1 and positive coefficients for every n; convergence also proved for " + range(1, most));
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
  return trial.for_all("all n >= 1", quotient_argument);
}

Outcome variants_c1(const Context& context) {
  const int most = context.reach(10, 30);
  const Formula left = context.formula("dual-odd-left"), right = context.formula("dual-odd-right");
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
  trial.follow(positive_quotient({context.formula("primal-odd-even"),
                                  context.formula("eq-2-odd"),
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
  return trial.for_all("all n >= 1", quotient_argument);
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
  return trial.for_all(
      "all n >= 1", "the symbol and its first two derivatives vanish at -1, as sums over j that are identities in n");
}

Trial negative_coefficients(int first, int last) {
  Trial trial;
  for (int n = first; n <= last; ++n) {
    const auto coefficients = divided_difference_scheme(dual_mask(n), 2).symbol().coefficients();
    trial.require(std::any_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c < 0; }),
                  at("n", n) + ": " + divided_difference_scheme(dual_mask(n), 2).symbol().to_mask_text() +
                      " has no negative coefficient");
  }
  return trial;
}

Outcome negative_coefficients(const Context& context) {
  const int most = context.reach(12, 40);
  // The first two coefficients of the symbol are the weights of the last datum; the quotient has c_1 - 2c_0.
  const Formula even = context.formula("eq-19-even").replaced("j", f("n")),
                odd = context.formula("eq-19-odd").replaced("j", f("n"));
  Trial trial = negative_coefficients(2, most);
  trial.follow(positive(f("2") * even - odd, {{"n", "2 + x"}}));
  for (int n = 2; n <= most; ++n) {
    const LaurentPolynomial quotient = divided_difference_scheme(dual_mask(n), 2).symbol();
    trial.equal(4 * (odd - f("2") * even)({{"n", n}}), quotient.coefficient(quotient.lowest() + 1),
                at("n", n) + ", the second coefficient");
  }
  trial.for_all("all n >= 2",
                "the second coefficient is negative, by the signs of its coefficients at n = 2 + x; compared for " +
                    range(2, most));
  return trial.but_not("n = 1", negative_coefficients(1, 1));
}

/// The paper's n by the paper's method; and every n by a theorem, of which the paper's are a part.
Outcome twice_differentiable(const std::string& family, int first) {
  Trial trial = proved_theorem("smoothness", 1, family);
  for (int n = first; n <= 10; ++n) {
    const Rational bound = *holder_bound_of(specification(family, n)).exponent.lower;
    trial.require(bound > 2, at("n", n) + ": the bound after 16 levels is " + to_decimal(bound, 5, Rounding::down));
  }
  return trial.for_all("all n >= " + std::to_string(first),
                       "C^2 limits not only for n <= 10 but for every n, by Theorem V; for n <= 10 also by the bounds "
                       "after 16 levels");
}

Outcome dual_odd_rules(const Context& context) {
  const int most = context.reach(8, 40);
  Trial trial = fit({context.formula("dual-odd-left"), "j", {-1, 0}, {1, 0}, {1, 0}, f("-1/4"), 1, 1, {}}, most);
  trial.follow(fit({context.formula("dual-odd-right"), "j", {-1, 0}, {1, 0}, {1, 0}, f("1/4"), 1, 1, {}}, most));
  return trial;
}

Outcome primal_odd_rule(const Context& context) {
  return fit({context.formula("primal-odd-even"), "j", {-1, 0}, {1, 0}, {1, 0}, f("0"), 1, 1, {}},
             context.reach(8, 40));
}

}  // namespace

Checks section_4() {
  return {
      {"eq-19", equation_19},
      {"eq-20", equation_20},
      {"even-symmetry", even_symmetry},
      {"support-dual", [](const Context& c) { return support_of(c, "support-dual", dual_mask, outer_weights); }},
      {"masks-dual",
       [](const Context& c) {
         return printed_masks(c, "dual-", dual_mask, {1, 2, 3});
       }},
      {"chaikin", chaikin},
      {"dual-converges", dual_converges},
      {"dual-c1", dual_c1},
      {"dual-three-factors", three_factors},
      {"dual-negative", [](const Context& c) { return negative_coefficients(c); }},
      {"table-2", [](const Context& c) { return table_words(c, "table-2"); }},
      {"dual-c2", [](const Context&) { return twice_differentiable("dual", 2); }},
      {"dual-odd-rules", dual_odd_rules},
      {"support-dual-odd",
       [](const Context& c) { return support_of(c, "support-dual-odd", dual_odd_mask, outer_weights); }},
      {"masks-dual-odd",
       [](const Context& c) {
         return printed_masks(c, "dual-odd-", dual_odd_mask, {1, 2, 3});
       }},
      {"primal-odd-rule", primal_odd_rule},
      {"support-primal-odd",
       [](const Context& c) { return support_of(c, "support-primal-odd", primal_odd_mask, outer_weights); }},
      {"masks-primal-odd",
       [](const Context& c) {
         return printed_masks(c, "primal-odd-", primal_odd_mask, {1, 2});
       }},
      {"mask-primal-7-point", [](const Context& c) { return printed_masks(c, "primal-odd-", primal_odd_mask, {3}); }},
      {"variants-c1", variants_c1},
      {"dual-odd-c2", [](const Context&) { return twice_differentiable("dual-odd", 1); }}};
}

}  // namespace subcert::statements::dyn_2015
