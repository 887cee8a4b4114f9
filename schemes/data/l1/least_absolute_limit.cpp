#include "least_absolute_limit.hpp"

#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::data {
namespace {

using piecewise::Contraction;
using piecewise::Rule;

constexpr int norm_levels = 16;  // of the bounds by norms of a linear rule

Decision stays_in_range(int degree, const std::optional<Rational>& largest) {
  if (degree == 1) return {Truth::yes, "lines of least absolute deviations, any number of points"};
  if (degree == 0) return {Truth::yes, "medians lie between the data"};
  if (!largest) return {Truth::unknown, "the largest value was not found"};
  return {*largest > 1 ? Truth::no : Truth::yes, "by the pieces"};
}

/// The best of the orders asked for, and what was found of the last one that was not finished.
void try_orders(const Rule& rule, int steps, const LimitOptions& options, LeastAbsoluteLimit& result) {
  const int first = options.order == 0 ? 1 : options.order;
  const int last = options.order == 0 ? rule.degree + 1 : options.order;
  for (int order = first; order <= last; ++order) {
    auto found = contraction(rule, {steps, order, options.enough, options.deadline, options.keep_trees});
    if (!found.proved)
      result.unfinished = UnfinishedContraction{steps, order, std::move(found)};
    else if (!result.contraction || found.proved->bound < result.contraction->bound)
      result.contraction = std::move(found.proved);
  }
}

void find_contraction(const Rule& rule, const LimitOptions& options, LeastAbsoluteLimit& result) {
  if (options.steps > 0 || rule.degree == 0) return try_orders(rule, std::max(options.steps, 1), options, result);
  for (int steps = 1; steps <= piecewise::most_steps(rule.arity()) && !result.unfinished; ++steps) {
    try_orders(rule, steps, options, result);
    if (result.contraction && result.contraction->bound < 1) return;
  }
}

/// Degree 0: a step from 0 to 1 is a step again, with a choice of medians where they are not unique.
Decision medians(int points) {
  return {Truth::no, points % 2 == 1 ? "the data 0 for i < 0, 1 for i >= 0 keep their jump at every level"
                                     : "with medians taken at an end, the data 0 for i < 0, 1 for i >= 0 keep their "
                                       "jump at every level"};
}

Decision by_contraction(const std::optional<Contraction>& found) {
  if (!found) return {Truth::unknown, "no contraction was found within the budget"};
  const std::string what = found->order == 1   ? "first"
                           : found->order == 2 ? "second"
                           : found->order == 3 ? "third"
                                               : "fourth";
  if (found->bound < 1) return {Truth::yes, fmt::format("{} differences contract, for all data", what)};
  return {Truth::unknown,
          fmt::format("differences do not contract in {} step{}", found->steps, found->steps == 1 ? "" : "s")};
}

}  // namespace

std::optional<Enclosure> proved_exponent(const Contraction& contraction, int arity) {
  if (contraction.bound >= 1 || contraction.bound <= 0) return std::nullopt;
  Enclosure logarithm = log_ratio(1 / contraction.bound, arity);
  return Enclosure{*logarithm.lower / contraction.steps, *logarithm.upper / contraction.steps};
}

LeastAbsoluteLimit least_absolute_limit(int points, int degree, const LimitOptions& options, int arity) {
  require(arity >= 2, "l1 limit: need arity >= 2, got {}", arity);
  const int most_steps = piecewise::most_steps(arity);
  require(options.steps >= 0 && options.steps <= most_steps, "l1 limit: need 0 <= steps <= {}, got {}", most_steps,
          options.steps);
  require(options.order >= 0 && options.order <= degree + 1, "l1 limit: need 0 <= order <= {}, got {}", degree + 1,
          options.order);
  require(options.enough >= 0, "l1 limit: need enough >= 0, got {}", options.enough);
  LeastAbsoluteLimit result;
  result.points = points;
  result.degree = degree;
  result.arity = arity;
  const std::optional<Rule> rule = least_absolute_rule(points, degree, arity);
  result.unique = unique_minimiser(points, degree, rule);
  if (rule) {
    result.pieces = rule->pieces.size();
    if (degree > 1) result.largest_output = largest_output(*rule, options.deadline);
    if (rule->is_function()) result.lipschitz = lipschitz_constant(*rule);
    for (int order = 1; order <= std::min(degree + 1, 2) && degree > 0; ++order)
      result.keeps.push_back(piecewise::keeps_sign(*rule, order, options.deadline));
    result.mask = linear_mask(*rule, points % 2 == 0 ? 1 - points / 2 : -(points / 2));
    find_contraction(*rule, options, result);
  }
  result.range = stays_in_range(degree, result.largest_output);
  if (degree == 0) {
    result.converges = medians(points);
  } else if (result.mask) {
    const HolderRegularity regularity = holder_regularity(*result.mask, norm_levels, {options.deadline});
    result.converges = regularity.converges;
    result.exponent = regularity.proved_exponent();
  } else {
    result.converges = by_contraction(result.contraction);
    if (!rule) result.converges.reason = "there are too many pieces";
    if (result.converges.is_yes())
      if (const auto exponent = proved_exponent(*result.contraction, arity)) result.exponent.lower = exponent->lower;
    if (degree == 1 && arity == 2 && result.converges.is_yes() && rule->is_function()) result.edge = edge_orbit(*rule);
    if (result.edge) result.exponent.upper = log_ratio(1 / result.edge->factor, 2).upper;
  }
  return result;
}

}  // namespace subcert::data
