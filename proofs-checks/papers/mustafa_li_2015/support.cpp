// Section 2.4 and 2.5: basic limit functions, experiments.

#include "mustafa_li_2015.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::mustafa_li_2015 {
namespace {

Outcome proposition_1(const Context& context) {
  const Formula width = context.formula(key_prefix + "proposition-1-width"),
                end = context.formula(key_prefix + "proposition-1-end"),
                length = context.formula(key_prefix + "proposition-1-length"),
                left = context.formula(key_prefix + "proposition-1-left"),
                right = context.formula(key_prefix + "proposition-1-right");
  const int most = context.reach(12, 40);
  Trial trial;
  for (int n = 1; n <= most && !trial.failed(); ++n) {
    const Mask mask = regression_mask(dual(n, 1));
    const Interval derived = limit_support(mask);
    const Rational shift = polynomial_reproduction(mask).parametrization;
    const Values where{{"n", n}};
    trial.equal(length(where), mask.symbol().length(), at("n", n) + ", length of the mask");
    trial.equal(left(where), -support(mask).first, at("n", n) + ", left of the vertex");
    trial.equal(right(where), support(mask).last, at("n", n) + ", right of the vertex");
    trial.equal(width(where), derived.upper - derived.lower, at("n", n) + ", width");
    trial.equal(-end(where), derived.lower - shift, at("n", n) + ", left end");
    trial.equal(end(where), derived.upper - shift, at("n", n) + ", right end");
  }
  // The window -n+1..n of f'_{2i} and f'_{2i+1} holds the datum 0 for i = -n, ..., n-1.
  trial.follow(identity(left + right + f("1"), length, {{"n", 1}}));
  trial.follow(identity(left, f("2*n"), {{"n", 1}}));
  trial.follow(identity(left + right, width, {{"n", 1}}));
  trial.follow(identity(f("2") * end, width, {{"n", 1}}));
  return trial
      .for_all("all n >= 1",
               "a window of zeros has the fit 0 whatever its weights, and the datum 0 is in the windows of f'_{2i}, "
               "f'_{2i+1} for i = -n..n-1 only; with all weights 1 the ends are reached for n = 1.." +
                   std::to_string(most) +
                   ". The interval is the one in which the datum f_j stands at j and the rules are symmetric; with the "
                   "new points at i/2^k, as in the proof, it is [-2n, 2n-1]")
      .outcome();
}

Outcome geometric_sum(const Context& context) {
  const Formula term = context.formula(key_prefix + "proposition-1-term"),
                total = context.formula(key_prefix + "proposition-1-total"),
                width = context.formula(key_prefix + "proposition-1-width");
  Trial printed, corrected;
  Rational sum = 0, halves = 0;
  for (long k = 1; k <= context.reach(40, 200); ++k) {
    sum += term({{"j", k - 1}});
    halves += power(Rational(1, 2), k);
    for (long n = 1; n <= 3; ++n) {
      const std::string where = at("n", n) + ", " + at("k", k);
      printed.equal(width({{"n", n}}), total({{"n", n}, {"S", sum}}), where);
      // Both displays before: c (1/2 + ... + 1/2^k) = c/2 sum.
      corrected.equal(sum / 2, halves, where);
    }
    corrected.equal(sum, 2 - power(Rational(1, 2), k - 1), at("k", k));
  }
  corrected.follow(identity(total.replaced("S", f("2")), width, {{"n", 1}}));
  return printed.outcome(corrected.for_all("all n", "the sums have the limit 2"));
}

Outcome unpublished(const std::string& reason) { return not_checkable(reason); }

}  // namespace

void add_support(PaperStatements& to) {
  to.transcriptions.insert(to.transcriptions.end(), {
                                                        {key_prefix + "proposition-1-width", "4*n - 1"},
                                                        {key_prefix + "proposition-1-end", "(4*n - 1)/2"},
                                                        {key_prefix + "proposition-1-length", "4*n"},
                                                        {key_prefix + "proposition-1-left", "2*n"},
                                                        {key_prefix + "proposition-1-right", "2*n - 1"},
                                                        {key_prefix + "proposition-1-term", "1/2^j"},
                                                        {key_prefix + "proposition-1-total", "2*n/2*S + (2*n - 1)/2*S"},
                                                    });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  add({key_prefix + "proposition-1", "Proposition 1", "Support of the basic limit functions of D_2n.",
       "length and ends of the mask, width and both ends of the support",
       R"(<<mustafa-li-2015/proposition-1-width>>, \quad \pm <<mustafa-li-2015/proposition-1-end>>)", "",
       Verdict::holds_for_all, proposition_1});
  add({key_prefix + "proposition-1-sum", "Proof of Proposition 1, last display", "The sum of the influences.",
       "the finite sums as printed, and their limit",
       R"(\frac{2n}{2} \sum_{j=0}^{k-1} \frac{1}{2^j} + \frac{2n-1}{2} \sum_{j=0}^{k-1} \frac{1}{2^j} = )"
       R"(<<mustafa-li-2015/proposition-1-width>>)",
       R"(\frac{2n}{2} \sum_{j=0}^{\infty} \frac{1}{2^j} + \frac{2n-1}{2} \sum_{j=0}^{\infty} \frac{1}{2^j} = )"
       R"(<<mustafa-li-2015/proposition-1-width>>)",
       Verdict::misprint, geometric_sum});
  add({key_prefix + "fig-2", "section 2.4, Fig. 2", "The basic limit functions have two peaks and a valley.", "",
       R"(\phi_6, \phi_7, \phi_8)", "", Verdict::not_checkable, [](const Context&) {
         return unpublished(
             "delta and the number of iterations of the figure were not published, and the height depends on them "
             "alone: "
             "the exact l1 fit of a window with one 1 and zeros is 0 (docs/l1.md, section 4)");
       }});
  for (const char* table : {"1", "2", "3"})
    add({key_prefix + "table-" + table, "Table " + std::string(table),
         "Errors of the fits by S_6, S_7, S_8 and D_6, D_7, D_8.", "", R"(\text{errors})", "", Verdict::not_checkable,
         [](const Context&) {
           return unpublished(
               "the noise, the outliers, the sampling and the parameters delta, m and k of the fits were not "
               "published");
         }});
  add({key_prefix + "figs-3-9", "sections 2.5 and 3.1, Figs. 1 and 3-9", "Curves and surfaces fitted to noisy data.",
       "", R"(f_1(x) = \sin(3x) e^{-x/3}, \; \dots)", "", Verdict::not_checkable,
       [](const Context&) { return unpublished("the functions are given, but neither the noise nor the outliers"); }});
}

}  // namespace subcert::statements::mustafa_li_2015
