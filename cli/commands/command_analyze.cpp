// subcert analyze SCHEME: one page about one scheme

#include <subcert/analysis/regularity/stability.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/pages/family_page.hpp>
#include <subcert/cli/pages/multivariate_page.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/pages/scheme_page.hpp>
#include <subcert/reports/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

namespace subcert::cli {
namespace {

constexpr double norm_share = 0.5;   // of the time that is left, at most
constexpr double exact_grace = 0.5;  // seconds more for exact values

struct AnalyzeOptions : CommonOptions {
  std::string scheme;
  int levels = 16;
  int grid_level = 6;
  double budget = 10;
  std::string plot;
  std::string html;
};

SchemePage make_page(Scheme scheme, const AnalyzeOptions& options, const Deadline& deadline) {
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
  const ProofLimits limits{options.levels, deadline};
  page.convergence = converges(mask, limits);
  if (!page.convergence.is_yes()) {
    options.end_progress();
    return page;
  }
  page.smoothness = proved_smoothness(mask, limits);
  options.progress("norms of the difference scheme");
  page.bounds = holder_bounds(mask, options.levels, deadline.after(norm_share));
  page.stable = has_stable_shifts(mask);
  page.sobolev = sobolev_if_small(mask, deadline);
  options.progress("limit values");
  try {
    const Deadline exact = Deadline::in(deadline.remaining() + exact_grace);
    page.integers = limit_values(mask, 0, 0, exact);
    page.grid = variance_grid(mask, options.grid_level, page.smoothness.order >= 1, exact);
    page.mean = squared_l2_norm(mask, exact);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::size && error.kind() != ErrorKind::undecided) throw;
    page.skipped = error.what();
  }
  options.end_progress();
  return page;
}

/// Prints the page, and says whether the scheme converges.
Decision analyze(const Scheme& scheme, const AnalyzeOptions& options, const Deadline& deadline) {
  const SchemePage page = make_page(scheme, options, deadline);
  options.json ? options.answer(page.json()) : options.answer(page.text());
  return page.convergence;
}

Decision analyze(const MultivariateScheme& scheme, const AnalyzeOptions& options, const Deadline& deadline) {
  return analyze_multivariate(scheme, {options.levels, deadline}, options);
}

ExitCode run(const AnalyzeOptions& options) {
  require_picture_name(options.plot);
  const std::string picture = options.html.empty() ? "--plot" : "--html";
  if (has_parameter(options.scheme)) {
    if (!options.plot.empty() || !options.html.empty())
      fail(ErrorKind::usage, "{}: pictures are of single schemes; {} has a parameter", picture, options.scheme);
    const FamilyPage page = family_page(make_parametric_scheme(options.scheme));
    options.answer(page.json, page.text);
    return done;
  }
  const Deadline deadline = Deadline::in(options.budget);
  const LinearScheme scheme = make_linear_scheme(options.scheme);
  require_drawable(options.plot, scheme);
  if (!options.html.empty())
    runtime::write_file(options.html, reports::gallery_html({reports::make_plate(
                                          {options.scheme}, {.budget = options.budget, .verified = verified})}));
  const Decision convergence = std::visit([&](const auto& one) { return analyze(one, options, deadline); }, scheme);
  if (!options.plot.empty()) {
    if (convergence.is_no()) return refuse_unproved(options.scheme, "no limit function to draw", convergence);
    draw_limit(options.plot, scheme, convergence);
  }
  return convergence.truth == Truth::unknown ? undecided : done;
}

}  // namespace

void add_analyze(Command& app) {
  auto options = std::make_shared<AnalyzeOptions>();
  Command command = add_command(app, "analyze", "One page about one scheme", "subcert analyze 'mask:[1,3,3,1]/4'",
                                options, [=] { return run(*options); });
  command.option("--levels", options->levels, "Levels of the difference scheme").within(1, 64).with_default();
  command.option("--budget", options->budget, "Seconds of processor time").within(0.001, 1e6).with_default();
  command.option("--plot", options->plot,
                 "Draw the basic limit function of one or two variables, as .svg, .png or .html");
  command.option("--html", options->html, "A page with pictures and the certificate, all in one file");
  add_scheme(command, options->scheme, true);
}

}  // namespace subcert::cli
