// Abstract, section 1 and remarks: claims about the families.

#include "checks.hpp"

#include <subcert/analysis/piecewise/contraction.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/data/l1/least_absolute.hpp>
#include <subcert/schemes/local_regression.hpp>
#include <subcert/schemes/outlier_remainder.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace subcert::statements::mustafa_hameed {
namespace {

/// Polynomial data with random weights come back, in one and two variables.
Outcome reproduction(const Context& context) {
  const int largest = static_cast<int>(numerator(context.formula("degree")({})));
  Trial trial;
  for (int variables : {1, 2})
    for (int degree = 1; degree <= (variables == 1 ? largest : 2); ++degree)
      for (long n = 2; n <= context.reach(4, 6); ++n)
        for (long first : {1 - n, -n}) {
          WeightedWindow data = random_window(first, n, variables, static_cast<unsigned>(n));
          const Formula polynomial = f(degree == 1   ? "3 - 2*r + 5*s"
                                       : degree == 2 ? "1 + r^2 - 3*r*s + 2*s^2"
                                                     : "r^3 - 2*r^2 + 7");
          for (std::size_t i = 0; i < data.nodes.size(); ++i)
            data.data[i] = polynomial({{"r", data.nodes[i].first}, {"s", data.nodes[i].second}});
          const Rational x(1, 4), y(variables == 1 ? 0 : 3, 4);
          trial.equal(
              library_value(data, degree, x, y), polynomial({{"r", x}, {"s", y}}),
              at("n", n) + ", degree " + std::to_string(degree) + ", " + std::to_string(variables) + " variables");
        }
  return trial.for_all(
      "all n >= 2, all weights, degrees 1 to 3 on curves and 1, 2 on surfaces",
      "for data of a polynomial of that degree the weighted sum of squares is 0 at this polynomial and, as the "
      "nodes determine it, nowhere else: every step and every output are exact, with the datum f_j at j and the "
      "outputs at the positions of the fit. Also tried with random weights");
}

/// If a line met the parabola at both outputs, the residual (r - 1/4)(r - 3/4) would be positive at all data.
Outcome lines_do_not_reproduce(const Context& context) {
  const Formula even = context.formula("residual-even"), odd = context.formula("residual-odd");
  Trial trial;
  trial.follow(identity(even, f("(r - 1/4)*(r - 3/4)"), {{"r", 0}}));
  trial.follow(identity(odd, f("(r + 1/4)*(r - 1/4)"), {{"r", 0}}));
  trial.follow(positive(even, {{"r", "1 + x"}}));
  trial.follow(positive(even, {{"r", "-x"}}));
  trial.follow(positive(odd, {{"r", "1 + x"}}));
  trial.follow(positive(odd, {{"r", "-1 - x"}}));
  trial.follow(sum_identity({f("r^2"), "r", {-1, 0}, {1, 0}}, f("(2*n + 1)*n*(n + 1)/3"), {{"n", 1}}));
  return trial.for_all(
      "all n >= 1, all positive weights, data r^2, 2n points",
      "a line through the parabola at both outputs 1/4, 3/4 leaves residuals r^2 - r + 3/16 > 0 at all integers, "
      "but weighted residuals of a fit have the sum 0. For 2n+1 points the residual r^2 - 1/16 is negative at "
      "r = 0 alone: there the ordinary fit has the constant n(n+1)/3, not 1/16");
}

/// What can be compared with the families whose construction is in the text at hand: it breaks off before the variants.
Outcome special_cases(const Context& context) {
  Trial trial;
  for (int n = 2; n <= context.reach(5, 10); ++n) {
    trial.require(regression_mask(ary(2, 2 * n, 3)) == regression_mask(dual(n, 3)), at("n", n) + ", [MB16], 2n points");
    trial.require(regression_mask(ary(2, 2 * n + 1, 3)) == regression_mask(dual_odd(n, 3)),
                  at("n", n) + ", [MB16], 2n+1 points");
  }
  if (trial.failed()) return trial;
  return {StatementVerdict::not_checkable, "", "",
          "the text at hand breaks off in section 2.3, before the variants. True of the dual schemes of [DHHS15] (all "
          "weights 1), of the binary ones of [MB16] (all weights 1, degree 3) and of [MLZD15] (degree 1), as the "
          "checks of all-weights-1 and of [MLZD15] show; whether the primal and the a-ary schemes are reached by "
          "other points of evaluation, as in [MLZD15, A.2], is not known"};
}

/// A rule that copies f_r reproduces x there alone, so that it stands at r.
Outcome not_interpolatory(const Context& context) {
  Trial trial;
  for (const Formula& position : context.list("positions"))
    trial.require(denominator(position({})) != 1, at("x", position({})) + " is the place of a datum");
  const int most = context.reach(6, 12);
  for (int n = 2; n <= most; ++n)
    for (int degree = 1; degree <= 3; ++degree)
      for (bool even : {true, false}) {
        const Mask mask = regression_mask(even ? dual(n, degree) : dual_odd(n, degree));
        for (long parity : {0, 1}) {
          long used = 0;
          for (long k = mask.symbol().lowest(); k <= mask.symbol().highest(); ++k)
            used += (k - parity) % 2 == 0 && mask.symbol().coefficient(k) != 0 ? 1 : 0;
          trial.require(used > 1, at("n", n) + ", degree " + std::to_string(degree) + ": a rule copies a datum");
        }
      }
  return trial.for_all(
      "all n >= 2, degrees >= 1 and positive weights",
      "the fits reproduce x, so that a rule that copies f_r stands at r; but the rules stand at 1/4 and "
      "3/4, or at -1/4 and 1/4. Compared with the masks of weights 1 for n = 2.." +
          std::to_string(most) + ", degrees 1, 2, 3");
}

/// Data that show that monotone (order 1) or convex (2) data need not stay so, of least absolute deviations.
std::string not_kept(int points, int degree, int order) {
  const auto found = piecewise::keeps_sign(*data::least_absolute_rule(points, degree), order);
  if (!found.kept.is_no()) return "none found";
  std::vector<std::string> data;
  for (const Rational& datum : found.data) data.push_back(to_text(datum));
  return fmt::format("{}", fmt::join(data, ", "));
}

Outcome shape(const Context& context) {
  Outcome outcome = reproduction(context);
  outcome.argument = fmt::format(
      "read as: data without noise are those of a polynomial of the degree. They come back, and with them every shape "
      "(reproduction). Of other data l1 fits keep shapes no better than least squares: 6 points and degree 1 do not "
      "keep "
      "the monotone data {} and the convex data {}, 6 points and degree 3 not the convex data {}",
      not_kept(6, 1, 1), not_kept(6, 1, 2), not_kept(6, 3, 2));
  return outcome;
}

/// Whether one outlier is left out, whatever its place and height.
bool leaves_out(int points, int degree) { return outlier_factor(points, degree) < 1; }

Outcome outliers_removed(const Context& context) {
  Trial trial;
  std::vector<std::string> found;
  const int most = context.reach(16, 24);
  for (int degree = 1; degree <= 3; ++degree) {
    int points = degree + 2;
    while (points < most && !leaves_out(points, degree)) ++points;
    for (int more = points; more <= most; ++more)
      trial.require(leaves_out(more, degree), fmt::format("{} points, degree {}", more, degree));
    found.push_back(fmt::format("{} points for degree {}", points, degree));
  }
  Outcome outcome = trial.over(fmt::format("up to {} points, one outlier in a window", most));
  outcome.argument = fmt::format(
      "for data of a polynomial of the degree but for one the l1 fit is that polynomial alone, from {} on. With fewer "
      "there is a place at which an outlier may stay, however many fits are made (docs/l1.md, section 3)",
      fmt::join(found, ", "));
  return outcome;
}

Outcome five_or_six(const Context& context) {
  Trial trial = advised_fits(context.list("iterations"), {{6, 1}, {7, 1}, {8, 1}, {9, 2}, {10, 2}, {14, 3}, {15, 3}});
  std::vector<std::string> found;
  for (const auto& [points, degree] : std::vector<std::pair<int, int>>{{8, 2}, {6, 3}, {8, 3}, {10, 3}, {12, 3}})
    found.push_back(fmt::format("{} for {} points and degree {}",
                                enclosure_text(outlier_remainder(points, degree, 6).value(), 2), points, degree));
  Outcome outcome = trial.over(
      "one outlier at any place, delta to 0; degree 1 and 6 points, degree 2 and 9, degree 3 "
      "and 14, and one or two more");
  outcome.argument = fmt::format(
      "read as: what is left of the outlier at the new points is small. It is at most 1/50 of its height with m = 5 "
      "and 1/100 with m = 6. Of smaller windows of higher degree more is left with m = 5: {}",
      fmt::join(found, ", "));
  return outcome;
}

/// Of a convex function that grows without bound.
Outcome optimum(const Context& context) {
  Trial trial;
  const int most = context.reach(9, 11);
  for (int degree = 0; degree <= 3; ++degree)
    for (int points = degree + 1; points <= most; ++points) {
      const bool one = degree == 0   ? points % 2 == 1
                       : degree == 1 ? points <= 3 || points % 4 == 2
                       : degree == 2 ? points == 3 || points == 5
                                     : points <= 6;
      trial.require(data::least_absolute_rule(points, degree)->is_function() == one,
                    fmt::format("{} points, degree {}: whether every datum has one minimiser", points, degree));
    }
  Outcome outcome = trial.over(fmt::format("up to {} points", most));
  outcome.argument =
      "the objective is convex and grows without bound, so that there are minimisers. There is one for all data for "
      "degree 0 and odd numbers of points, degree 1 and 2, 3 or 2 mod 4 points, degree 2 and 3 or 5 points, degree 3 "
      "and 4, 5 or 6 points; else there are several for some data (docs/l1.md, Theorem 1)";
  return outcome;
}

}  // namespace

Checks claims() {
  return {{"not-interpolatory", not_interpolatory},
          {"reproduction", reproduction},
          {"linear-schemes", lines_do_not_reproduce},
          {"special-cases", special_cases},
          {"shape", shape},
          {"removes-outliers", outliers_removed},
          {"remark-2.1", five_or_six},
          {"optimum", optimum}};
}

}  // namespace subcert::statements::mustafa_hameed
