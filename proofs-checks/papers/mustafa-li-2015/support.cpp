// Section 2.4 and 2.5: basic limit functions, experiments.

#include "checks.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::mustafa_li_2015 {
namespace {

Outcome proposition_1(const Context& context) {
  const Formula width = context.formula("proposition-1-width"), end = context.formula("proposition-1-end"),
                length = context.formula("proposition-1-length"), left = context.formula("proposition-1-left"),
                right = context.formula("proposition-1-right");
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
  return trial.for_all(
      "all n >= 1",
      "a window of zeros has the fit 0 whatever its weights, and the datum 0 is in the windows of f'_{2i}, "
      "f'_{2i+1} for i = -n..n-1 only; with all weights 1 the ends are reached for n = 1.." +
          std::to_string(most) +
          ". The interval is the one in which the datum f_j stands at j and the rules are symmetric; with the "
          "new points at i/2^k, as in the proof, it is [-2n, 2n-1]");
}

Outcome geometric_sum(const Context& context) {
  const Formula term = context.formula("proposition-1-term"), total = context.formula("proposition-1-total"),
                width = context.formula("proposition-1-width");
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

}  // namespace

Checks support() { return {{"proposition-1", proposition_1}, {"proposition-1-sum", geometric_sum}}; }

}  // namespace subcert::statements::mustafa_li_2015
