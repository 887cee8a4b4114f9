// What the theorems on l1 fits (docs/l1.md) say of outliers, of the number of fits, of delta and of limits.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/computed.hpp>
#include <subcert/schemes/data/l1/basin_entry.hpp>
#include <subcert/schemes/data/l1/l1_basin.hpp>
#include <subcert/schemes/data/l1/least_absolute_limit.hpp>
#include <subcert/schemes/data/l1/robustness.hpp>
#include <subcert/schemes/outlier_remainder.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace subcert::statements::mustafa_li_2015 {
namespace {

const std::vector<int> complexities{6, 7, 8};  // D_6, D_7, D_8

std::string scheme_name(int points) { return fmt::format("D_{}", points); }

/// F <= F_delta <= F + 2n delta^(1/2), and F grows by `sharpness` times what a value moves.
Outcome small_delta(const Context& context) {
  Trial trial = smoothed_above_modulus(context.formula("eq-2"), f("f - beta1 - beta2*r"), root_names);
  std::vector<std::string> found;
  for (const int points : {6, 10}) {
    const Rational sharpness = data::least_absolute_robustness(points, 1).sharpness.value();
    trial.require(sharpness > 0, scheme_name(points) + ": no sharpness");
    found.push_back(fmt::format("{} delta^(1/2) for {}", Rational(points) / sharpness, scheme_name(points)));
  }
  return trial.for_all("all n >= 1, data and delta > 0",
                       fmt::format("a minimiser of F_delta has a sum of moduli within 2n delta^(1/2) of the smallest; "
                                   "its new points are within {} of those of the l1 line. delta has the unit of "
                                   "squared data: what is small is a matter of their scale",
                                   fmt::join(found, ", ")));
}

/// F_delta falls from fit to fit, and so does what is left of an outlier.
Outcome many_fits(const Context& context) {
  Trial trial = fits_go_down(context.formula("eq-2"), f("f - beta1 - beta2*r"), line_names);
  std::vector<std::string> factors;
  for (const int points : complexities) {
    const Rational factor = outlier_factor(points, 1);
    trial.require(factor < 1, scheme_name(points) + ": more fits leave as much");
    factors.push_back(fmt::format("{} for {}", factor, scheme_name(points)));
  }
  return trial.for_all("all n >= 1, data and delta > 0",
                       fmt::format("each fit makes F_delta smaller, until its minimiser is met; what is left of an "
                                   "outlier falls like the power m of {}",
                                   fmt::join(factors, ", ")));
}

Outcome five_or_six(const Context& context) {
  Trial trial = advised_fits(context.list("advice-m"), {{6, 1}, {7, 1}, {8, 1}});
  Outcome outcome = trial.over("D_6, D_7, D_8, one outlier at any place, delta to 0");
  outcome.argument = fmt::format(
      "read as: what is left of the outlier at the new points is small. It is at most 1/50 of its height with m = 5 "
      "and 1/100 with m = 6, and for D_6 no smaller m will do. A fixed part stays with every m, of an outlier of any "
      "height: for 10^-6 D_6 needs m = {}",
      iterations_for_remainder(6, 1, Rational(1, 1'000'000)).value() - 1);
  return outcome;
}

/// The largest value of an output where one datum is arbitrary and the others are in [-1, 1].
std::optional<Rational> largest_by_one(int points) {
  Rational largest = 0;
  for (const auto& bound : data::least_absolute_robustness(points, 1).one) {
    if (!bound) return std::nullopt;
    largest = std::max(largest, *bound);
  }
  return largest;
}

Outcome outliers_removed(const Context&) {
  Trial trial;
  std::vector<std::string> found, two;
  for (const int points : complexities) {
    const std::optional<Rational> largest = largest_by_one(points);
    if (!trial.require(largest.has_value(), scheme_name(points) + ": an outlier of any height moves the curve")) break;
    found.push_back(fmt::format("{} for {}", *largest, scheme_name(points)));
    const std::size_t pairs = data::least_absolute_robustness(points, 1).two_break.size();
    two.push_back(fmt::format("{} of {} for {}", pairs, points * (points - 1) / 2, scheme_name(points)));
  }
  Outcome outcome = trial.over("l1 lines of D_6, D_7, D_8, one outlier in a window, at any place and of any height");
  outcome.argument = fmt::format(
      "no height, place or number of outliers is asked for. New points stay within {} times the largest other datum. "
      "Two outliers in one window are not removed at these numbers of pairs of places: {}",
      fmt::join(found, ", "), fmt::join(two, ", "));
  return outcome;
}

/// Least squares has a weight other than 0 for an outlier; that l1 lines leave it out is `advice-n`.
Outcome more_robust(const Context& context) {
  Trial trial;
  for (const char* rule : {"s-2n-even", "s-2n-odd"})
    for (const char* place : {"1 - n", "n"})
      trial.follow(positive(context.formula(rule).replaced("j", f(place)), {{"n", "1 + x"}}));
  for (const int points : {6, 8, 10, 12})
    trial.require(largest_by_one(points).has_value(), scheme_name(points) + ": no bound");
  trial.require(!largest_by_one(4), "n = 2 has a bound, too");
  return trial.for_all("all n >= 3, one outlier",
                       "the weights of S_2n are positive, as those at the ends are and they are linear in the place, "
                       "so that an outlier moves its new points by a part of its height, whatever that is. The l1 "
                       "lines stay bounded, as the modulus of a line at a node is below the sum of the others "
                       "(advice-n). For n = 2 they do not: an outlier at an end may be interpolated");
}

Outcome response_of_l1(const Context& context) {
  const int most = context.reach(7, 20);
  Trial trial;
  std::vector<std::string> found;
  for (std::size_t k = 0; k < complexities.size(); ++k) {
    const int points = complexities[k];
    for (int fits = 0; k > 0 && fits <= most; ++fits)
      trial.require(*outlier_remainder(points, 1, fits).value().upper <
                        *outlier_remainder(complexities[k - 1], 1, fits).value().lower,
                    fmt::format("{} against {}, {} fits", scheme_name(points), scheme_name(complexities[k - 1]), fits));
    if (k > 0)
      trial.require(largest_by_one(points) < largest_by_one(complexities[k - 1]),
                    scheme_name(points) + ", the l1 lines");
    found.push_back(fmt::format("{} {}", scheme_name(points), largest_by_one(points).value()));
  }
  Outcome outcome = trial.over(fmt::format("D_6, D_7, D_8, 0 to {} fits, delta to 0, and the l1 lines", most));
  outcome.argument = fmt::format(
      "what is left of one outlier at the new points, enclosed, falls from D_6 to D_7 to D_8 with each number of fits; "
      "the largest value of the l1 lines with one outlier and other data in [-1, 1]: {}",
      fmt::join(found, ", "));
  return outcome;
}

/// The data 1 at 0 and 0 elsewhere come near to least squares after some levels (docs/l1.md, Theorem 4).
Outcome basic_limits_smooth(const Context& context) {
  Trial trial;
  int latest = 0;
  const int most = context.reach(7, 12);
  for (const int points : complexities) {
    // Limits have each exponent below log2(1/linear^3) that those of least squares have.
    const Rational linear = data::l1_basin(points, 1).value().linear;
    const std::string by_least_squares = specification(points % 2 == 0 ? "dual" : "dual-odd", points / 2);
    trial.require(4 * linear * linear * linear < 1 && *holder_bound_of(by_least_squares).exponent.lower > 2,
                  scheme_name(points) + ": least squares");
  }
  for (const int points : complexities)
    for (const double delta : {1e-2, 1e-4, 1e-8})
      for (int fits = 1; fits <= most; ++fits) {
        const auto level = data::basin_entry({{points}, 1, {.delta = delta, .iterations = fits}}, {1}, 10);
        trial.require(level.has_value(), fmt::format("{}, {} fits, delta = {}", scheme_name(points), fits, delta));
        latest = std::max(latest, level.value_or(0));
      }
  Outcome outcome = trial.over(
      fmt::format("D_6, D_7, D_8; 1 to {} fits; delta = 1e-2, 1e-4, 1e-8 (those of the figure were not "
                  "published)",
                  most));
  outcome.argument = fmt::format(
      "after {} levels or fewer all second differences are so small against delta^(1/2), in balls, that the limit "
      "exists and is as smooth as that of S_6, S_7, S_8: twice continuously differentiable (docs/l1.md, Theorem 4)",
      latest);
  return outcome;
}

/// Differences of the l1 lines contract.
Outcome curves_converge(const Context& context) {
  Trial trial;
  std::vector<std::string> found;
  for (const int points : complexities) {
    if (points > context.reach(7, 8)) break;
    const data::LeastAbsoluteLimit limit = data::least_absolute_limit(
        points, 1, {.enough = points == 6 ? Rational(0) : Rational(9, 10)});
    if (!trial.require(limit.converges.is_yes(), scheme_name(points))) break;
    found.push_back(fmt::format("{} in {} step{} for {}", limit.contraction->bound, limit.contraction->steps,
                                limit.contraction->steps == 1 ? "" : "s", scheme_name(points)));
  }
  Outcome outcome = trial.over("the l1 lines, all data");
  outcome.argument = fmt::format(
      "differences shrink at least by these factors: {}. With delta > 0 that is open for data far above delta^(1/2), "
      "and limits-smooth shows it for one datum among zeros (docs/l1.md, sections 8 and 10)",
      fmt::join(found, ", "));
  return outcome;
}

}  // namespace

Checks robustness() {
  return {{"advice-delta", small_delta},
          {"advice-many-fits", many_fits},
          {"advice-m", five_or_six},
          {"removes-outliers", outliers_removed},
          {"more-robust", more_robust},
          {"response-of-l1", response_of_l1},
          {"limits-smooth", basic_limits_smooth},
          {"refined-until-smooth", curves_converge}};
}

}  // namespace subcert::statements::mustafa_li_2015
