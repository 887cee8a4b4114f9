// Section 2.4 and 2.5: basic limit functions, experiments.

#include "checks.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <fmt/format.h>

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
    const Rational shift = polynomial_reproduction(mask).parametrization.front();
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
  trial.follow(positive(context.formula("s-2n-even").replaced("j", f("n")), {{"n", "1 + x"}}));
  trial.follow(positive(context.formula("s-2n-odd").replaced("j", f("1 - n")), {{"n", "1 + x"}}));
  return trial.for_all(
      "all n >= 1",
      "a window of zeros has the fit 0 whatever its weights, and the datum 0 is in the windows of f'_{2i}, "
      "f'_{2i+1} for i = -n..n-1 only; with all weights 1 the ends are reached, as the outermost weights of S_2n are "
      "positive; compared for n = "
      "1.." +
          std::to_string(most) +
          ". The interval is the one in which the datum f_j stands at j and the rules are symmetric; with the "
          "new points at i/2^k, as in the proof, it is [-2n, 2n-1]");
}

/// The sum is said to be reached in the limit, so that its upper end k-1 goes to infinity.
Outcome geometric_sum(const Context& context) {
  const Formula term = context.formula("proposition-1-term"), total = context.formula("proposition-1-total"),
                width = context.formula("proposition-1-width");
  Trial trial;
  Rational sum = 0, halves = 0;
  for (long k = 1; k <= context.reach(40, 200); ++k) {
    sum += term({{"j", k - 1}});
    halves += power(Rational(1, 2), k);
    // Both displays before: c (1/2 + ... + 1/2^k) = c/2 sum.
    trial.equal(sum / 2, halves, at("k", k));
    trial.equal(sum, 2 - power(Rational(1, 2), k - 1), at("k", k));
  }
  trial.follow(identity(total.replaced("S", f("2")), width, {{"n", 1}}));
  return trial.for_all("all n",
                       "each finite sum is 2 - 2^(1-k), with the limit 2; read with 'in the limit', as the "
                       "sentence says, though the display keeps the upper end k-1");
}

/// The printed error of a scheme.
Rational printed_error(const Context& context, const std::string& table, const std::string& scheme) {
  for (const PublishedCell& cell : context.table(table).cells)
    if (cell.column == scheme) return read_decimal(cell.printed).value;
  fail(ErrorKind::domain, "no scheme '{}' in {}", scheme, table);
}

/// In the printed table each scheme has a smaller error than the next.
Trial grow(const Context& context, const std::string& table, const std::vector<std::string>& schemes) {
  Trial trial;
  for (std::size_t i = 1; i < schemes.size(); ++i)
    trial.require(printed_error(context, table, schemes[i - 1]) < printed_error(context, table, schemes[i]),
                  context.table(table).place + ": " + schemes[i - 1] + " against " + schemes[i]);
  return trial;
}

Outcome d_6_is_best(const Context& context) {
  Trial trial;
  for (const char* table : {"table1", "table2", "table3"})
    for (const char* other : {"S_6", "S_7", "S_8", "D_7", "D_8"}) trial.follow(grow(context, table, {"D_6", other}));
  return trial.over("the printed Tables 1, 2 and 3");
}

Outcome l1_is_better(const Context& context) {
  Trial trial;
  for (const char* table : {"table1", "table2", "table3"})
    for (const std::string points : {"6", "7", "8"}) trial.follow(grow(context, table, {"D_" + points, "S_" + points}));
  return trial.over("the printed Tables 1, 2 and 3, schemes of as many points");
}

/// Of the two reasons that the paper gives for larger errors, Table 1 shows the one, Tables 2 and 3 the other.
Outcome errors_over_complexity(const Context& context) {
  Trial trial = grow(context, "table1", {"S_8", "S_7", "S_6"});
  for (const char* table : {"table2", "table3"}) {
    trial.follow(grow(context, table, {"S_6", "S_7", "S_8"}));
    trial.follow(grow(context, table, {"D_6", "D_7", "D_8"}));
  }
  Outcome outcome = trial.over(
      "the printed tables: S_6 > S_7 > S_8 in Table 1; S_6 < S_7 < S_8 and D_6 < D_7 < D_8 "
      "in Tables 2 and 3");
  outcome.argument = "in Table 1 D_6 < D_8 < D_7";
  return outcome;
}

/// A scheme of constant weights is linear: a datum that is moved by H moves the curve by H phi.
Outcome response_of_least_squares(const Context&) {
  const std::vector<std::pair<const char*, const char*>> schemes{
      {"S_6", "dual:n=3"}, {"S_7", "dual-odd:n=3"}, {"S_8", "dual:n=4"}};
  Trial trial;
  std::string found;
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const Enclosure& largest = limit_range_of(schemes[k].second).sup_norm;
    found += fmt::format("{}{}: {}", k == 0 ? "" : ", ", schemes[k].first, enclosure_text(largest, 4));
    if (k > 0)
      trial.require(*largest.upper < *limit_range_of(schemes[k - 1].second).sup_norm.lower,
                    fmt::format("{} against {}", schemes[k].first, schemes[k - 1].first));
  }
  Outcome outcome = trial.over("S_6, S_7, S_8");
  outcome.argument =
      "the schemes are linear, so that an outlier moves the curve by its height times the basic limit "
      "function; the largest values, certified: " +
      found;
  return outcome;
}

}  // namespace

Checks support() {
  return {{"proposition-1", proposition_1},
          {"proposition-1-sum", geometric_sum},
          {"printed-d-6", d_6_is_best},
          {"printed-l1", l1_is_better},
          {"printed-complexity", errors_over_complexity},
          {"response-of-least-squares", response_of_least_squares}};
}

}  // namespace subcert::statements::mustafa_li_2015
