// subcert analyze SCHEME: one page about one scheme

#include "multivariate_page.hpp"
#include "sobolev_text.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/holder_bound.hpp>
#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/variance/variance.hpp>

#include <sstream>

namespace subcert::cli {
namespace {

struct AnalyzeOptions : CommonOptions {
  std::string scheme;
  int levels = 16;
  int grid_level = 6;
  double budget = 10;
};

/// All answers, once computed, for both ways of printing.
struct Page {
  Scheme scheme;
  int rules;
  LaurentPolynomial rest;  ///< symbol / (1 + ... + z^(arity-1))^rules
  Interval support;
  SymmetryReport symmetry;
  PolynomialReproduction polynomials;
  Decision convergence;
  SmoothnessProof smoothness;
  std::optional<HolderBounds> bounds;
  Decision stable;
  std::optional<SobolevRegularity> sobolev;
  std::optional<LimitValues> integers;
  std::optional<VarianceGrid> grid;
  std::optional<Rational> mean;
  std::string skipped;  ///< why values are missing although the scheme converges
};

Page make_page(Scheme scheme, const AnalyzeOptions& options) {
  const Mask mask = scheme.mask;
  const int rules = sum_rules(mask);
  Page page{std::move(scheme),
            rules,
            *mask.symbol().exact_quotient(LaurentPolynomial::all_ones(mask.arity()).pow(rules)),
            limit_support(mask),
            symmetry(mask),
            polynomial_reproduction(mask),
            {},
            {},
            {},
            {},
            {},
            {},
            {},
            {},
            {}};
  options.progress("convergence");
  const ProofLimits limits{options.levels, Deadline::in(options.budget)};
  page.convergence = converges(mask, limits);
  if (!page.convergence.is_yes()) {
    options.end_progress();
    return page;
  }
  page.smoothness = proved_smoothness(mask, limits);
  options.progress("norms of the difference scheme");
  page.bounds = holder_bounds(mask, options.levels, Deadline::in(options.budget));
  page.stable = has_stable_shifts(mask);
  page.sobolev = sobolev_if_small(mask);
  options.progress("limit values");
  try {
    page.integers = limit_values(mask, 0);
    page.grid = variance_grid(mask, options.grid_level, page.smoothness.order >= 1);
    page.mean = squared_l2_norm(mask);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size) throw;
    page.skipped = error.what();
  }
  options.end_progress();
  return page;
}

std::string symmetry_text(const SymmetryReport& report) {
  if (report.kind == Symmetry::none) return "none";
  return (report.kind == Symmetry::odd ? "odd, about " : "even, about ") + to_text(report.centre);
}

Json page_json(const Page& page) {
  const LaurentPolynomial& symbol = page.scheme.mask.symbol();
  Json coefficients = Json::array();
  for (const Rational& c : symbol.coefficients()) coefficients.push_back(to_text(c));
  Json json{{"scheme", page.scheme.specification},
            {"title", page.scheme.title},
            {"arity", page.scheme.mask.arity()},
            {"first_index", symbol.lowest()},
            {"coefficients", coefficients},
            {"symbol", symbol.to_text()},
            {"sum_rules", page.rules},
            {"remaining_factor", page.rest.to_text()},
            {"support", {{"lower", to_text(page.support.lower)}, {"upper", to_text(page.support.upper)}}},
            {"symmetry", page.symmetry.kind == Symmetry::none  ? "none"
                         : page.symmetry.kind == Symmetry::odd ? "odd"
                                                               : "even"},
            {"generation_degree", page.polynomials.generation_degree},
            {"reproduction_degree", page.polynomials.reproduction_degree},
            {"parametrization", to_text(page.polynomials.parametrization)},
            {"approximation_order", page.polynomials.approximation_order()},
            {"convergence", {{"verdict", to_text(page.convergence.truth)}, {"reason", page.convergence.reason}}}};
  if (!page.convergence.is_yes()) return json;
  json["smoothness"] = {{"proved", page.smoothness.order},
                        {"evidence", page.smoothness.evidence},
                        {"obstacle", page.smoothness.obstacle}};
  const HolderBound& bound = page.bounds->last();
  json["bound"] = {{"levels", bound.levels}, {"norm", to_text(bound.norm)}, {"holder", enclosure_json(bound.exponent)}};
  json["stable"] = {{"verdict", to_text(page.stable.truth)}, {"reason", page.stable.reason}};
  json["sobolev"] = sobolev_json(page.sobolev, page.stable);
  if (page.integers) {
    Json values = Json::array();
    for (const Rational& value : page.integers->values) values.push_back(to_text(value));
    json["limit"] = {{"level", 0}, {"first_index", page.integers->first_index}, {"values", values}};
  }
  if (page.grid && page.mean)
    json["variance"] = {{"level", page.grid->level},
                        {"sup", enclosure_json({page.grid->largest(), variance_ceiling(page.scheme.mask)})},
                        {"inf", enclosure_json({variance_floor(page.scheme.mask), page.grid->smallest()})},
                        {"derivative_sup", enclosure_json(Enclosure::at_least(page.grid->steepest()))},
                        {"mean", to_text(*page.mean)}};
  if (!page.skipped.empty()) json["skipped"] = page.skipped;
  return json;
}

std::string factor_text(const Page& page) {
  const std::string ones = "(" + LaurentPolynomial::all_ones(page.scheme.mask.arity()).to_text() + ")";
  return ones + (page.rules == 1 ? "" : "^" + std::to_string(page.rules)) + " * (" + page.rest.to_text() + ")";
}

std::string page_text(const Page& page) {
  std::ostringstream text;
  const Mask& mask = page.scheme.mask;
  const IndexRange range = support(mask);
  const PolynomialReproduction& polynomials = page.polynomials;
  text << "scheme        " << page.scheme.specification << "  (" << page.scheme.title << ")\n"
       << "mask          " << mask.symbol().to_mask_text() << "\n"
       << "symbol        " << mask.symbol().to_text() << "\n"
       << "              = " << factor_text(page) << "\n"
       << "symmetry      " << symmetry_text(page.symmetry) << "\n"
       << "support       mask " << range.first << " ... " << range.last << ", basic limit function ["
       << to_text(page.support.lower) << ", " << to_text(page.support.upper) << "]\n"
       << "sum rules     " << page.rules << "\n"
       << "polynomials   generates degree " << polynomials.generation_degree << ", reproduces degree "
       << polynomials.reproduction_degree << " with f_j at j"
       << (polynomials.parametrization == 0  ? ""
           : polynomials.parametrization > 0 ? " + "
                                             : " - ")
       << (polynomials.parametrization == 0 ? "" : to_text(abs(polynomials.parametrization)))
       << "; approximation order " << polynomials.approximation_order() << "\n"
       << "convergence   " << to_text(page.convergence.truth) << ": " << page.convergence.reason << "\n";
  if (!page.convergence.is_yes()) return text.str();
  text << "smoothness    C^" << page.smoothness.order << " proved: " << page.smoothness.evidence << "\n"
       << "              C^" << page.smoothness.order + 1 << " not proved: " << page.smoothness.obstacle << "\n";
  const HolderBound& bound = page.bounds->last();
  text << "Hoelder       >= " << bound.exponent.lower_text(12) << " after " << bound.levels << " levels; ||S_b^"
       << bound.levels << "|| = " << to_decimal(bound.norm, 12, Rounding::nearest) << "\n";
  if (page.sobolev) text << "Sobolev       " << sobolev_text(*page.sobolev, page.stable) << "\n";
  text << "stable        " << to_text(page.stable.truth) << ": " << page.stable.reason << "\n";
  if (!page.skipped.empty()) text << "values        skipped: " << page.skipped << "\n";
  if (page.integers) {
    text << "at integers  ";
    for (std::size_t i = 0; i < page.integers->values.size(); ++i)
      text << (i ? ", " : " ") << "phi(" << to_text(page.integers->point(i))
           << ") = " << to_text(page.integers->values[i]);
    text << "\n";
  }
  if (page.grid && page.mean)
    text << "variance      psi on the grid of level " << page.grid->level
         << ": maximum >= " << to_decimal(page.grid->largest(), 9, Rounding::down)
         << ", minimum <= " << to_decimal(page.grid->smallest(), 9, Rounding::up)
         << ", max |psi'| >= " << to_decimal(page.grid->steepest(), 9, Rounding::down) << "\n"
         << "              mean = squared L2 norm of phi = " << to_decimal(*page.mean, 15, Rounding::nearest) << " = "
         << to_text(*page.mean) << "\n";
  return text.str();
}

ExitCode run(const AnalyzeOptions& options) {
  const AnyScheme scheme = make_any_scheme(options.scheme);
  if (const auto* multivariate = std::get_if<MultivariateScheme>(&scheme))
    return analyze_multivariate(*multivariate, {options.levels, Deadline::in(options.budget)}, options);
  const Page page = make_page(std::get<Scheme>(scheme), options);
  if (options.json)
    options.answer(page_json(page));
  else
    options.answer(page_text(page));
  return page.convergence.truth == Truth::unknown ? undecided : done;
}

}  // namespace

void add_analyze(Command& app) {
  auto options = std::make_shared<AnalyzeOptions>();
  Command command = add_command(app, "analyze", "One page about one scheme", "subcert analyze 'mask:[1,3,3,1]/4'",
                                options, [=] { return run(*options); });
  command.option("--levels", options->levels, "Levels of the difference scheme").within(1, 64).with_default();
  command.option("--budget", options->budget, "Seconds for each proof").within(0.001, 1e6).with_default();
  add_scheme(command, options->scheme, true);
}

}  // namespace subcert::cli
