// subcert analyze SCHEME: one page about one scheme

#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/proofs-checks/certificates/scheme_regularity.hpp>
#include <subcert/reports/explorer.hpp>
#include <subcert/reports/facts/family_facts.hpp>
#include <subcert/reports/facts/l1_facts.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>
#include <subcert/reports/facts/scheme_facts.hpp>
#include <subcert/reports/gallery/gallery.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

namespace subcert::cli {
namespace {

struct AnalyzeOptions : CommonOptions {
  std::string scheme;
  int levels = 16;
  int grid_level = 6;
  double budget = 10;
  std::string plot;
  std::string html;
  std::string over;
  std::string scheme_certificate;
  PaperForm form;
};

void print(const AnalyzeOptions& options, const facts::Facts& facts, std::size_t width,
           const std::string& formulas = {}) {
  answer(options, options.form, {facts, width, page_json(facts), "", formulas});
}

/// Mask, symbol and exponent.
std::string formulas_of(const Scheme& scheme, const facts::Analysis& known) {
  std::string text = scheme.mask.dimension() <= 2 ? mask_formulas(scheme) : "% " + scheme.specification + "\n";
  if (known.convergence.is_yes() && known.regularity)
    if (const std::string exponent = exponent_latex(known.regularity->exponent(),
                                                    exponent_formula(scheme, *known.regularity));
        !exponent.empty())
      text += exponent + "\n";
  return text;
}

/// Prints the page, and says whether the scheme converges.
Decision analyze(const Scheme& scheme, const AnalyzeOptions& options, const Deadline& deadline) {
  const facts::AnalysisOptions limits{
      {options.levels, deadline}, options.grid_level, [&](const std::string& next) { options.progress(next); }};
  const facts::Analysis known = facts::analysis(scheme, limits);
  options.end_progress();
  const facts::Facts list = facts::scheme_facts(scheme, known);
  print(options, list, 14, options.form.latex ? formulas_of(scheme, known) : "");
  return known.convergence;
}

/// What the values of a vector of functions tell, and a picture of all functions.
ExitCode analyze_vector(const Scheme& scheme, const AnalyzeOptions& options) {
  const Stopwatch watch;
  const Regularity found = regularity_of(scheme.mask, {Deadline::in(options.budget)}, of_scheme(scheme));
  const FunctionVector& vector = *found.surface->vector;
  facts::Facts list = regularity_facts(scheme, found, {}, {watch.seconds(), 0, found.is_closed()});
  if (vector.continuous.is_yes() && vector.values)
    list.push_back(facts::values_fact(by_points(*vector.values, scheme.mask.components(), vector.root)));
  const WrittenCertificate certificate = write_scheme_certificate(options.scheme_certificate, scheme,
                                                                  {Deadline::in(options.budget)});
  Json json = page_json(list);
  certificate.add_to(json, "scheme_certificate");
  answer(options, options.form,
         {list, 13, json, certificate.text(false), options.form.latex ? "% " + scheme.specification + "\n" : ""});
  if (!options.plot.empty()) draw_vector(options.plot, scheme, vector);
  certificate.failure.raise();
  return exit_code(vector.continuous.truth);
}

/// Of the exact rule behind a scheme that acts on data.
ExitCode analyze_l1(const AnalyzeOptions& options) {
  if (!options.plot.empty() || !options.html.empty())
    fail(ErrorKind::usage, "{}: pictures are of linear schemes, got {}", options.html.empty() ? "--plot" : "--html",
         options.scheme);
  const DataDependentScheme scheme = make_l1_scheme(options.scheme);
  const Deadline deadline = Deadline::in(options.budget);
  const data::LeastAbsoluteLimit limit = data::least_absolute_limit(points_of_curve(scheme), scheme.rules.degree,
                                                                    {.deadline = deadline.after(facts::share_of_limit)},
                                                                    scheme.rules.arity);
  print(options, l1_facts(scheme, limit, {deadline}), 13);
  return exit_code(limit.converges.truth);
}

/// What holds for all values, and a page on which the parameter is moved.
ExitCode analyze_family(const AnalyzeOptions& options) {
  if (!options.plot.empty())
    fail(ErrorKind::usage, "--plot: pictures are of single schemes; {} has a parameter, see --html", options.scheme);
  if (options.html.empty() != options.over.empty())
    fail(ErrorKind::usage, "{} of a scheme with a parameter: expected {}, too",
         options.html.empty() ? "--over" : "--html", options.html.empty() ? "--html FILE" : "--over w=LOW..HIGH");
  const ParametricScheme scheme = make_parametric_scheme(options.scheme);
  if (scheme.form)
    fail(ErrorKind::usage,
         "{}: expected numbers, or no parameter; of matrices with one 'subcert range' and 'curve' tell what is known",
         options.scheme);
  if (!options.html.empty()) {
    const auto [low, high] = read_over(options.over, scheme.name);
    reports::ExplorerOptions limits;
    limits.jobs = options.threads();
    limits.budget.deadline = Deadline::in(options.budget);
    runtime::write_file(options.html, reports::explorer_html(scheme, low, high, limits));
  }
  print(options, family_facts(scheme), 14);
  return done;
}

ExitCode run(const AnalyzeOptions& options) {
  require_one_form(options, options.form);
  require_picture_name(options.plot);
  require_place(options.scheme_certificate);
  const bool is_family = has_parameter(options.scheme);
  if (!options.scheme_certificate.empty() &&
      (is_family || is_l1_specification(options.scheme) || !make_refinable_scheme(options.scheme).form))
    fail(ErrorKind::usage, "--scheme-certificate: expected a vector or Hermite scheme without a parameter, got {}",
         options.scheme);
  if (is_family) return analyze_family(options);
  if (!options.over.empty()) fail(ErrorKind::usage, "--over: {} has no parameter", options.scheme);
  if (is_l1_specification(options.scheme)) return analyze_l1(options);
  const Deadline deadline = Deadline::in(options.budget);
  const Scheme scheme = make_refinable_scheme(options.scheme);
  require_drawable(options.plot, scheme);
  if (!options.html.empty())
    runtime::write_file(options.html, reports::gallery_html({reports::make_plate(
                                          {options.scheme}, {.budget = options.budget, .verified = verified})}));
  if (scheme.form) return analyze_vector(scheme, options);
  const Decision convergence = analyze(scheme, options, deadline);
  if (!options.plot.empty()) {
    if (convergence.is_no()) require_convergence(scheme.specification, convergence);
    draw_limit(options.plot, scheme, convergence);
  }
  return exit_code(convergence.truth);
}

}  // namespace

void add_analyze(Command& app) {
  auto options = std::make_shared<AnalyzeOptions>();
  Command command = add_command(app, "analyze", "One page about one scheme", "subcert analyze 'mask:[1,3,3,1]/4'",
                                options, [=] { return run(*options); });
  command.option("--levels", options->levels, "Levels of the difference scheme").within(1, 64).with_default();
  command.option("--budget", options->budget, "Seconds of processor time").within(0.001, 1e6).with_default();
  command.option("--plot", options->plot,
                 "Draw the basic limit function of one or two variables, as .svg, .png, .pdf, .tex or .html");
  command.option(
      "--html", options->html,
      "A page with pictures and the certificate, all in one file; of a family, a page to move its parameter");
  command.option("--over", options->over, "The values on that page: w=LOW..HIGH");
  add_scheme_certificate(command, options->scheme_certificate);
  add_scheme(command, options->scheme, true);
  add_paper_form(command, options->form, "Mask, symbol and exponent as formulas of LaTeX, and all facts as a table",
                 "All facts as a table in Markdown");
}

}  // namespace subcert::cli
