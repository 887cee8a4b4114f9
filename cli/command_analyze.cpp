// subcert analyze SCHEME: one page about one scheme

#include "multivariate_page.hpp"
#include "scheme_page.hpp"

#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/error.hpp>

namespace subcert::cli {
namespace {

struct AnalyzeOptions : CommonOptions {
  std::string scheme;
  int levels = 16;
  int grid_level = 6;
  double budget = 10;
};

SchemePage make_page(Scheme scheme, const AnalyzeOptions& options) {
  const Mask mask = scheme.mask;
  const int rules = sum_rules(mask);
  SchemePage page{std::move(scheme),
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

ExitCode run(const AnalyzeOptions& options) {
  const LinearScheme scheme = make_linear_scheme(options.scheme);
  if (const auto* multivariate = std::get_if<MultivariateScheme>(&scheme))
    return analyze_multivariate(*multivariate, {options.levels, Deadline::in(options.budget)}, options);
  const SchemePage page = make_page(std::get<Scheme>(scheme), options);
  if (options.json)
    options.answer(page.json());
  else
    options.answer(page.text());
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
