#include "surface_facts.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

constexpr int most_places = 8;
constexpr long most_unstable = 144;       // coefficients: beyond, the Sobolev exponent takes longer than a page may
constexpr double longest_stability = 60;  // seconds; all that are listed need less than 3

/// As many that a unit of the last is at least the width; one for a bound alone.
int places_of(const Enclosure& enclosure) {
  int places = 1;
  if (!enclosure.is_bounded()) return places;
  for (Rational unit(1, 100); places < most_places && unit >= *enclosure.upper - *enclosure.lower; unit /= 10) ++places;
  return places;
}

std::string exponent_text(const Enclosure& exponent, int places) {
  const bool whole = exponent.lower && denominator(*exponent.lower) == 1;
  if (whole && exponent.is_exact()) return to_text(*exponent.lower);
  return whole && !exponent.upper ? ">= " + to_text(*exponent.lower) : formats::fixed_text(exponent, places);
}

std::string support_text(const std::vector<Interval>& support) {
  std::vector<std::string> sides;
  for (const Interval& side : support)
    sides.push_back(fmt::format("[{}, {}]", to_text(side.lower), to_text(side.upper)));
  if (std::ranges::all_of(sides, [&](const std::string& side) { return side == sides.front(); }))
    return fmt::format("{}^{}", sides.front(), sides.size());
  return fmt::format("{}", fmt::join(sides, " x "));
}

/// The Sobolev exponent r, and the Hoelder exponent between r - s/2 and r (docs/surfaces.md, section 5). Where the
/// shifts are not stable and the mask is large, a lower end of r.
MultivariateRegularity sobolev_alone(const LatticeMask& mask) {
  MultivariateRegularity result;
  result.exact = {Truth::unknown, "not searched"};
  result.sum_rules = polynomial_reproduction(mask).sum_rules;
  result.converges = converges(mask);
  if (result.converges.is_yes()) result.gram = gram_function(mask);
  if (!result.gram) return result;
  result.stable = has_stable_shifts(*result.gram, {Deadline::in(longest_stability)});
  const bool stable = result.stable.is_yes(), exact = stable || mask.symbol().count() <= most_unstable;
  const auto sobolev = stable || !exact ? sobolev_regularity(mask, result.sum_rules)
                                        : sobolev_regularity(mask, *result.gram);
  if (!sobolev) return result;
  result.sobolev = exact ? sobolev->exponent : Enclosure::at_least(*sobolev->exponent.lower);
  const Rational lower = *sobolev->exponent.lower - Rational(mask.dimension(), 2);
  result.exponent = {std::max(Rational(0), lower), result.sobolev->upper};
  return result;
}

}  // namespace

std::vector<std::string> surface_facts_head(std::vector<std::string> before) {
  before.insert(before.end(), {"sum rules", "converges", "Hoelder", "Sobolev", "stable", "support"});
  return before;
}

std::string SurfaceFacts::holder_text() const {
  const bool open = regularity.radius && !regularity.is_closed();
  return exponent_text(regularity.exponent, open ? places_of(regularity.exponent) : most_places);
}

std::string SurfaceFacts::sobolev_text() const {
  return exponent_text(regularity.sobolev.value_or(Enclosure{}), most_places);
}

std::vector<std::string> SurfaceFacts::row(std::vector<std::string> before) const {
  before.insert(before.end(), {std::to_string(regularity.sum_rules), to_text(regularity.converges.truth), holder_text(),
                               sobolev_text(), to_text(regularity.stable.truth), support_text(support)});
  return before;
}

std::vector<SurfaceFacts> surface_facts(const std::vector<std::string>& specifications, const ReportOptions& options,
                                        double seconds, long most_searched) {
  std::vector<SurfaceFacts> result(specifications.size());
  parallel_tasks(result.size(), options.jobs, [&](std::size_t i) {
    if (options.progress) options.progress(specifications[i]);
    const auto scheme = make_linear_scheme(specifications[i]);
    const Budget budget{Deadline::in(options.budget.value_or(seconds))};
    const bool searched = options.budget || scheme.mask.symbol().count() <= most_searched;
    result[i] = {scheme.specification, limit_support(scheme.mask),
                 searched || scheme.mask.has_factors() ? multivariate_regularity(scheme.mask, budget)
                                                       : sobolev_alone(scheme.mask)};
  });
  return result;
}

}  // namespace subcert::reports
