#include "l1_facts.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/schemes/data/l1/basin_entry.hpp>
#include <subcert/schemes/data/l1/l1_basin.hpp>
#include <subcert/schemes/data/l1/reweighted_contraction.hpp>
#include <subcert/schemes/data/l1/robustness.hpp>
#include <subcert/schemes/outlier_remainder.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace subcert::facts {
namespace {

constexpr int most_points = 12;  // of windows for which corners and pairs are tried

Fact unique_fact(const Decision& unique) {
  Fact fact{"unique", "minimiser",
            unique.is_yes()  ? "unique for every datum"
            : unique.is_no() ? "not unique for some data"
                             : "unknown whether it is unique",
            unique.reason};
  if (unique.truth != Truth::unknown) fact.json = unique.is_yes();
  return fact;
}

Fact pieces_fact(const std::optional<std::size_t>& pieces) {
  if (!pieces) return {"pieces", "pieces", "too many to be listed", "", Json()};
  return plain("pieces", "pieces", *pieces);
}

Facts range_facts(const data::LeastAbsoluteLimit& limit) {
  Fact fact{"stays_in_range", "values", "unknown whether they leave the range of the data", limit.range.reason};
  if (limit.range.is_yes()) fact.text = "never leave the range of the data";
  if (limit.range.is_no())
    fact.text = fmt::format("at most {} in one step where no datum exceeds 1", *limit.largest_output);
  if (limit.range.truth != Truth::unknown) fact.json = limit.range.is_yes();
  Fact largest = member("largest_value", Json());
  if (limit.range.is_yes()) largest.json = "1";
  if (limit.largest_output) largest.json = to_text(*limit.largest_output);
  return {fact, largest};
}

/// Whether monotone and convex data stay so in one step, and hence in all.
Facts shape_facts(const std::vector<piecewise::SignOfDifferences>& keeps) {
  Facts list;
  for (std::size_t k = 0; k < keeps.size(); ++k) {
    const std::string what = k == 0 ? "monotone" : "convex";
    const Decision& kept = keeps[k].kept;
    std::vector<std::string> data;
    for (const Rational& datum : keeps[k].data) data.push_back(to_text(datum));
    Fact fact{"keeps_" + what, what,
              kept.is_yes()  ? fmt::format("data that are {0} stay {0}", what)
              : kept.is_no() ? fmt::format("some data do not stay {}: {}", what, fmt::join(data, ", "))
                             : fmt::format("unknown whether {0} data stay {0}", what),
              kept.is_no() ? "" : kept.reason};
    if (kept.truth != Truth::unknown) fact.json = kept.is_yes();
    list.push_back(fact);
  }
  return list;
}

Fact lipschitz_fact(const std::optional<Rational>& lipschitz) {
  if (!lipschitz) return member("lipschitz", Json());
  return {"lipschitz", "Lipschitz", to_text(*lipschitz), "of one step, in the maximum norm; no smaller one",
          to_text(*lipschitz)};
}

/// What is known of a contraction that time did not suffice for, and what it would need.
std::string unfinished_text(const data::UnfinishedContraction& unfinished) {
  const auto& [steps, order, search] = unfinished;
  std::string text = fmt::format("{} step{}, differences of order {}: {} of {} differences bounded", steps,
                                 steps == 1 ? "" : "s", order, search.finished, search.starts);
  if (search.attained > 0) text += fmt::format(", no bound below {}", search.attained);
  return text + "; more --budget, or a --bound that is enough";
}

Fact contraction_fact(const data::LeastAbsoluteLimit& limit) {
  const std::optional<piecewise::Contraction>& found = limit.contraction;
  if (!found)
    return {"contraction", "contraction", "none proved",
            limit.unfinished ? unfinished_text(*limit.unfinished) : "too many pieces to be listed", Json()};
  const std::string difference = found->order == 1 ? "D" : fmt::format("D^{}", found->order);
  const std::string steps = found->steps == 1 ? "S" : fmt::format("S^{}", found->steps);
  std::vector<std::string> data;
  for (const Rational& datum : found->data) data.push_back(to_text(datum));
  return {"contraction",
          "contraction",
          fmt::format("|{0} {1} f| <= {2} |{0} f|", difference, steps, found->bound),
          data.empty() ? "" : fmt::format("attained by the data {}", fmt::join(data, ", ")),
          {{"steps", found->steps}, {"order", found->order}, {"bound", to_text(found->bound)}, {"data", data}}};
}

Fact limits_fact(const Decision& converges) {
  Fact fact{"converges", "limits",
            converges.is_yes()  ? "the exact rule converges"
            : converges.is_no() ? "the exact rule does not converge"
                                : "unknown whether the exact rule converges",
            converges.reason, to_text(converges.truth)};
  return fact;
}

Fact edge_fact(const std::optional<piecewise::EdgeOrbit>& edge) {
  if (!edge) return member("edge", Json());
  std::vector<std::string> values;
  for (const Rational& value : edge->values) values.push_back(to_text(value));
  return {"edge",
          "edge",
          fmt::format("0, ..., 0, {}, ...", fmt::join(values, ", ")),
          fmt::format("at the next level the same times {}", edge->factor),
          {{"factor", to_text(edge->factor)}, {"values", values}}};
}

Fact one_outlier_fact(const std::vector<std::optional<Rational>>& bounds) {
  std::vector<std::string> texts;
  Json json = Json::array();
  for (const std::optional<Rational>& bound : bounds) {
    texts.push_back(bound ? to_text(*bound) : "no bound");
    json.push_back(bound ? Json(to_text(*bound)) : Json());
  }
  return {"one_outlier", "one outlier", fmt::format("{}", fmt::join(texts, ", ")),
          "by its place: the largest value where it is arbitrary and the others are in [-1, 1]", json};
}

Facts two_outliers_facts(const data::LeastAbsoluteRobustness& known) {
  std::vector<std::string> pairs;
  Json json = Json::array();
  for (const auto& [first, second] : known.two_break) {
    pairs.push_back(fmt::format("{}+{}", first + 1, second + 1));
    json.push_back({first + 1, second + 1});
  }
  std::string text = pairs.empty() ? "" : fmt::format("no bound at the places {}", fmt::join(pairs, ", "));
  if (known.two) text += fmt::format("{}{}", pairs.empty() ? "at most " : "; elsewhere at most ", *known.two);
  return {{"two_outliers",
           "two outliers",
           text,
           "the same for two",
           {{"unbounded", json}, {"bound", known.two ? Json(to_text(*known.two)) : Json()}}}};
}

/// What outliers do to the exact rule, and what fits leave of them. Nothing where the fit interpolates.
Facts robustness_facts(int points, int degree, int arity) {
  if (points < degree + 2 || points > most_points) return {};
  const data::LeastAbsoluteRobustness known = data::least_absolute_robustness(points, degree, arity);
  Facts list{one_outlier_fact(known.one)};
  append(list, two_outliers_facts(known));
  if (known.sharpness)
    list.push_back({"sharpness", "sharpness", to_text(*known.sharpness),
                    "the sum of moduli grows at least by this times what a value moves", to_text(*known.sharpness)});
  const Rational factor = outlier_factor(points, degree), part(1, 1'000'000);
  list.push_back({"outlier_factor", "left over", to_text(factor),
                  factor < 1 ? "m fits leave at most a constant times the power m of this of an outlier"
                             : "not below 1: no number of fits leaves out every outlier",
                  to_text(factor)});
  if (factor >= 1) return list;
  const std::optional<int> fits = iterations_for_remainder(points, degree, part, arity);
  list.push_back({"iterations_1e-6", "fits", fits ? std::to_string(*fits) : "unknown",
                  "that leave at most 1e-6 of an outlier (iterations=auto)", fits ? Json(*fits) : Json()});
  return list;
}

/// With delta > 0 and any number of fits. Nothing where least squares does not contract differences in one step.
Facts basin_facts(int points, int degree, int arity) {
  if (points < degree + 2 || points > most_points) return {};
  const auto basin = data::l1_basin(points, degree, arity);
  if (!basin) return {};
  const std::string difference = degree == 0 ? "D" : fmt::format("D^{}", degree + 1);
  return {{"basin",
           "small data",
           fmt::format("|{0} S f| <= {1} |{0} f| where |{0} f| <= {2} delta^(1/2)", difference, basin->contraction,
                       basin->radius),
           "with delta > 0 and any number of fits: S is nearly least squares there",
           {{"radius", to_text(basin->radius)}, {"bound", to_text(basin->contraction)}}}};
}

constexpr int most_levels = 9;                   // until an impulse is near to least squares
constexpr double share_of_impulse = 0.5;         // of the time that is left
constexpr int most_covered = 6, most_fits = 20;  // points and fits of rules that are covered by boxes
constexpr std::uint64_t few_boxes = 130'000, many_boxes = 20'000'000;

/// Whether second differences shrink for all data.
Fact rule_fact(const L1Scheme& rules, const std::string& smooth, const RuleLimits& limits) {
  const int points = rules.points[0], fits = rules.options.iterations;
  Fact fact{"rule", "this rule", "unknown whether it converges for all data", ""};
  if (rules.degree != 1 || rules.arity != 2 || rules.options.tolerance != 0 || points > most_covered ||
      fits > most_fits) {
    fact.remark = fmt::format("tried for lines on up to {} points, two outputs, up to {} fits and no tolerance alone",
                              most_covered, most_fits);
    return fact;
  }
  const std::uint64_t boxes = limits.thorough ? many_boxes : few_boxes;
  const auto found = data::reweighted_contraction(points, fits, {.most_boxes = boxes, .deadline = limits.deadline});
  if (!found) {
    fact.remark = limits.deadline.expired()
                      ? "the budget does not suffice"
                      : fmt::format("{} boxes do not suffice{}", boxes, limits.thorough ? "" : "; --rule tries more");
    return fact;
  }
  return {"rule",
          "this rule",
          fmt::format("|D^2 S f| <= {} |D^2 f|, so that it converges for all data", found->bound),
          fmt::format("any delta > 0 and up to {} fits; limits are continuous{}", fits, smooth),
          {{"bound", to_text(found->bound)}, {"fits", fits}}};
}

/// Whether the basic limit function exists.
Fact impulse_fact(const L1Scheme& rules, const std::string& smooth, const Deadline& deadline) {
  const auto level = data::basin_entry(rules, {1}, most_levels, deadline);
  if (level)
    return {"impulse_level", "impulse", "the limit of 1 among zeros is continuous" + smooth,
            fmt::format("small data are reached at level {}", *level), *level};
  return {"impulse_level", "impulse", "unknown whether 1 among zeros has a limit",
          deadline.expired() ? "the budget does not suffice"
                             : fmt::format("no level up to {} is proved to have small data", most_levels)};
}

/// Of the rule itself, with delta > 0 and its own number of fits; where there are none or all interpolate, it is
/// linear.
Facts rule_facts(const L1Scheme& rules, const RuleLimits& limits) {
  const int points = rules.points[0], fits = rules.options.iterations;
  if (points < rules.degree + 2) return {};
  const std::string smooth = points < 4 || points > 8 ? "" : " and as smooth as by least squares";  // Theorem 4
  Facts impulse;
  if (rules.degree == 1 && rules.arity == 2 && rules.options.tolerance == 0 && points <= most_points &&
      fits <= most_fits)
    impulse.push_back(impulse_fact(rules, smooth, limits.deadline.after(share_of_impulse)));
  Facts list;
  if (fits > 0) list.push_back(rule_fact(rules, smooth, limits));
  append(list, impulse);
  return list;
}

/// Of what rule the facts are.
std::string subject_text(const L1Options& options) {
  if (options.exact) return "holds for every choice of minimisers; where there are several the middle one is taken";
  if (options.iterations == 0)
    return "holds for least absolute deviations; without iterations the scheme is linear, that of least squares: "
           "analyze dual: or dual-odd:";
  return "holds for least absolute deviations, which the fits come near to with many iterations and a small delta, but "
         "for small data, this rule and impulse";
}

}  // namespace

int points_of_curve(const DataDependentScheme& scheme) {
  if (scheme.rules.points.size() != 1 || scheme.rules.options.joint_residuals)
    fail(ErrorKind::usage, "{}: need a scheme of curves with separate residuals, as l1:points=6,d=1",
         scheme.specification);
  return scheme.rules.points[0];
}

Facts l1_facts(const DataDependentScheme& scheme, const data::LeastAbsoluteLimit& limit, const RuleLimits& limits) {
  Facts list = named(scheme.specification, scheme.title);
  list.push_back({"", "what follows", subject_text(scheme.rules.options)});
  list.push_back(unique_fact(limit.unique));
  list.push_back(pieces_fact(limit.pieces));
  append(list, range_facts(limit));
  append(list, shape_facts(limit.keeps));
  list.push_back(lipschitz_fact(limit.lipschitz));
  if (limit.mask)
    list.push_back({"mask", "linear", limit.mask->symbol().to_mask_text(), "the rule has this mask",
                    limit.mask->symbol().to_mask_text()});
  else
    list.push_back(member("mask", Json()));
  list.push_back(contraction_fact(limit));
  list.push_back(limits_fact(limit.converges));
  list.push_back(edge_fact(limit.edge));
  append(list, robustness_facts(limit.points, limit.degree, limit.arity));
  if (!scheme.rules.options.exact) {
    append(list, basin_facts(limit.points, limit.degree, limit.arity));
    append(list, rule_facts(scheme.rules, limits));
  }
  const bool known = limit.exponent.lower || limit.exponent.upper;
  list.push_back({"exponent", "exponent", known ? enclosure_text(limit.exponent, 14) : "unknown",
                  !known                 ? ""
                  : limit.edge           ? "enclosed with proof: from below by the contraction, from above by the edge"
                  : limit.exponent.upper ? "enclosed with proof"
                                         : "of all limits, for every choice of minimisers; a proved lower bound",
                  enclosure_json(limit.exponent)});
  return list;
}

}  // namespace subcert::facts
