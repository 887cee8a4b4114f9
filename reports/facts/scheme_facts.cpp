#include "scheme_facts.hpp"

#include "exponents.hpp"
#include "regularity_facts.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::facts {
namespace {

constexpr double regularity_share = 0.5, regularity_seconds = 2;  // of the time that is left, at most
constexpr int exponent_digits = 12;                               // at least, where it is closed
constexpr double exact_grace = 0.5;                               // seconds more for exact values

void add_values(Analysis& known, const Mask& mask, const AnalysisOptions& options) {
  try {
    const Deadline exact = options.limits.deadline.later(exact_grace);
    known.integers = limit_values(mask, 0, 0, exact);
    known.grid = variance_grid(mask, options.grid_level, known.smoothness->order >= 1, exact);
    known.mean = squared_l2_norm(mask, exact);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size && error.kind() != ErrorKind::undecided) throw;
    known.skipped = error.what();
  }
}

/// Why there are no limits that are so smooth, where that is proved.
std::optional<std::string> refutation_of(const Regularity& regularity, int order) {
  if (regularity.curve && has_derivatives(*regularity.curve, order) == Truth::no)
    return refutation(*regularity.curve, order);
  const Enclosure exponent = regularity.exponent();
  if (exponent.upper && *exponent.upper < order) return fmt::format("the exponent is below {}", order);
  return std::nullopt;
}

/// C^k from positive coefficients or norms, or from the exponent where that tells more, and whether C^(k+1) is refuted.
Fact smoothness_fact(const SmoothnessProof& proof, const Regularity& regularity, bool by_factors) {
  const Enclosure exponent = regularity.exponent();
  const auto below = static_cast<int>(exponent.lower ? ceil_index(*exponent.lower) - 1 : 0);
  const bool by_exponent = below > proof.order;
  const int order = std::max(proof.order, below);
  const auto refuted = refutation_of(regularity, order + 1);
  const std::string evidence = by_exponent ? fmt::format("the exponent is above {}", order) : proof.evidence;
  const std::string obstacle = refuted       ? *refuted
                               : by_exponent ? fmt::format("the exponent is not proved to be above {}", order + 1)
                                             : proof.obstacle;
  const std::string next = fmt::format("C^{} {}: {}", order + 1, refuted ? "refuted" : "not proved", obstacle);
  const bool told = by_exponent || !by_factors;
  Json json{{"proved", order}};
  if (told) json["evidence"] = evidence;
  json["refuted"] = refuted ? Json(order + 1) : Json(nullptr);
  json["obstacle"] = obstacle;
  return {"smoothness", "smoothness",
          told ? fmt::format("C^{} proved: {}\n{}", order, evidence, next)
               : fmt::format("C^{} proved, by the factors; {}", order, next),
          "", std::move(json)};
}

/// Exactly, or where that would not be read, rounded.
std::string integers_text(const LimitValues& integers) {
  constexpr std::size_t longest_text = 40;
  const bool exact = std::ranges::all_of(integers.values,
                                         [](const Rational& value) { return to_text(value).size() <= longest_text; });
  std::string text;
  for (std::size_t i = 0; i < integers.values.size(); ++i)
    text += fmt::format("{}phi({}) = {}", i ? ", " : "", to_text(integers.point(i)),
                        exact ? to_text(integers.values[i]) : to_decimal(integers.values[i], 9, Rounding::nearest));
  return exact ? text : text + "; rounded, exact with --json";
}

Fact variance_fact(const Mask& mask, const VarianceGrid& grid, const Rational& mean) {
  return {"variance",
          "variance",
          fmt::format("psi on the grid of level {}: maximum >= {}, minimum <= {}, max |psi'| >= {}\n"
                      "mean = squared L2 norm of phi = {} = {}",
                      grid.level, to_decimal(grid.largest(), 9, Rounding::down),
                      to_decimal(grid.smallest(), 9, Rounding::up), to_decimal(grid.steepest(), 9, Rounding::down),
                      to_decimal(mean, 15, Rounding::nearest), to_text(mean)),
          "",
          {{"level", grid.level},
           {"sup", enclosure_json(Enclosure{grid.largest(), variance_ceiling(mask)})},
           {"inf", enclosure_json(Enclosure{variance_floor(mask), grid.smallest()})},
           {"derivative_sup", enclosure_json(Enclosure::at_least(grid.steepest()))},
           {"mean", to_text(mean)}}};
}

/// Of a scheme that converges.
Fact bias_fact(const Mask& mask) {
  const auto [order, constant] = mean_bias(mask);
  return {"bias",
          "bias",
          fmt::format("{0} h^{1} f^({1})", to_text(constant), order),
          "in the mean, of samples of f at spacing h",
          {{"order", order}, {"constant", to_text(constant)}}};
}

}  // namespace

Analysis analysis(const Scheme& scheme, const AnalysisOptions& options) {
  const LatticeMask& mask = scheme.mask;
  const Deadline& deadline = options.limits.deadline;
  const auto next = [&](const char* what) {
    if (options.progress) options.progress(what);
  };
  Analysis known;
  const bool curve = mask.dimension() == 1;
  const auto add_regularity = [&](const Deadline& time) {
    next("exponent");
    known.regularity = regularity_of(
        mask, {time}, {.levels = options.limits.levels, .rounding = scheme.rounding, .quadratic = scheme.quadratic});
  };
  next("convergence");
  if (!mask.has_factors() && !mask.dilation().isotropic_subspaces().empty()) {
    add_regularity(deadline);
    known.convergence = known.regularity->converges();
    return known;
  }
  known.convergence = converges(mask, options.limits);
  if (known.convergence.truth == Truth::unknown && mask.has_factors())  // by the exponent
    known.convergence = has_derivative(mask, LatticePoint(mask.dilation().variables(), 0), options.limits).decision;
  if (!known.convergence.is_yes() || !mask.has_factors()) return known;
  known.smoothness = proved_smoothness(mask, options.limits);
  add_regularity(deadline.after(regularity_share).at_most(regularity_seconds));
  if (!curve) return known;
  known.sobolev = sobolev_if_small(mask.curve(), deadline);
  next("limit values");
  add_values(known, mask.curve(), options);
  return known;
}

Facts scheme_facts(const Scheme& scheme, const Analysis& known) {
  const bool curve = scheme.mask.dimension() == 1;
  const bool converges = known.convergence.is_yes();
  Facts list = mask_facts(scheme);
  list.push_back(decided("convergence", "convergence", known.convergence));
  if (const auto& regularity = known.regularity) {
    if (known.smoothness) list.push_back(smoothness_fact(*known.smoothness, *regularity, !curve));
    if (regularity->curve) list.push_back(bound_fact("Hoelder", regularity->curve->bounds.last()));
    Fact exponent = exponent_fact(scheme, *regularity, exponent_digits),
         sobolev = curve ? sobolev_fact(known.sobolev, regularity->stable())
                         : sobolev_fact(regularity->surface->sobolev, regularity->stable());
    if (!converges) exponent.label = "";
    if (!curve && !converges) sobolev.label = "";
    list.push_back(exponent);
    append(list, formula_facts(exponent_formula(scheme, *regularity)));
    list.push_back(sobolev);
    list.push_back(decided("stable", converges ? "stable" : "", regularity->stable()));
  }
  if (!known.skipped.empty()) list.push_back({"skipped", "values", "skipped: " + known.skipped, "", known.skipped});
  if (const auto& integers = known.integers)
    list.push_back(
        {"limit",
         "at integers",
         integers_text(*integers),
         "",
         {{"level", 0}, {"first_index", integers->first_index}, {"values", numbers_json(integers->values)}}});
  if (curve && converges) list.push_back(bias_fact(scheme.mask.curve()));
  if (curve && known.grid && known.mean) list.push_back(variance_fact(scheme.mask.curve(), *known.grid, *known.mean));
  return list;
}

}  // namespace subcert::facts
