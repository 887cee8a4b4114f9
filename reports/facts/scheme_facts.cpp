#include "scheme_facts.hpp"

#include "exponents.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <fmt/format.h>

namespace subcert::facts {
namespace {

constexpr double norm_share = 0.5;   // of the time that is left, at most
constexpr double exact_grace = 0.5;  // seconds more for exact values

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

Fact smoothness_fact(const SmoothnessProof& proof, bool by_factors) {
  const std::string open = fmt::format("C^{} not proved: {}", proof.order + 1, proof.obstacle);
  Json json{{"proved", proof.order}};
  if (!by_factors) json["evidence"] = proof.evidence;
  json["obstacle"] = proof.obstacle;
  return {"smoothness", "smoothness",
          by_factors ? fmt::format("C^{} proved, by the factors; {}", proof.order, open)
                     : fmt::format("C^{} proved: {}\n{}", proof.order, proof.evidence, open),
          "", std::move(json)};
}

std::string integers_text(const LimitValues& integers) {
  std::string text;
  for (std::size_t i = 0; i < integers.values.size(); ++i)
    text += fmt::format("{}phi({}) = {}", i ? ", " : "", to_text(integers.point(i)), to_text(integers.values[i]));
  return text;
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
  const auto next = [&](const char* what) {
    if (options.progress) options.progress(what);
  };
  Analysis known;
  next("convergence");
  if (!mask.has_factors() && !mask.dilation().isotropic_subspaces().empty()) {
    const MultivariateRegularity regularity = multivariate_regularity(mask, {options.limits.deadline});
    known.convergence = regularity.converges;
    known.stable = regularity.stable;
    known.exponent = regularity.exponent;
    known.surface_sobolev = regularity.sobolev;
    return known;
  }
  known.convergence = converges(mask, options.limits);
  if (!known.convergence.is_yes() || !mask.has_factors()) return known;
  known.smoothness = proved_smoothness(mask, options.limits);
  if (mask.dimension() > 1) return known;
  next("norms of the difference scheme");
  const Mask& curve = mask.curve();
  const Deadline& deadline = options.limits.deadline;
  known.bound = holder_bounds(curve, options.limits.levels, deadline.after(norm_share)).last();
  known.stable = has_stable_shifts(curve);
  known.sobolev = sobolev_if_small(curve, deadline);
  next("limit values");
  add_values(known, curve, options);
  return known;
}

Facts scheme_facts(const Scheme& scheme, const Analysis& known) {
  const bool curve = scheme.mask.dimension() == 1;
  const bool converges = known.convergence.is_yes();
  Facts list = mask_facts(scheme);
  list.push_back(decided("convergence", "convergence", known.convergence));
  if (known.smoothness && converges) list.push_back(smoothness_fact(*known.smoothness, !curve));
  if (known.bound) list.push_back(bound_fact("Hoelder", *known.bound));
  if (known.exponent)
    list.push_back({"holder", converges ? "exponent" : "", enclosure_text(*known.exponent, 12),
                    "Hoelder, as far as subcert regularity gets in the time", enclosure_json(known.exponent)});
  if (known.stable) {
    if (curve)
      list.push_back(sobolev_fact(known.sobolev, *known.stable));
    else
      list.push_back({"sobolev", known.surface_sobolev ? "Sobolev" : "",
                      enclosure_text(known.surface_sobolev.value_or(Enclosure{}), 12), "",
                      enclosure_json(known.surface_sobolev)});
    list.push_back(decided("stable", converges ? "stable" : "", *known.stable));
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
