// subcert variance SCHEME

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/derivatives.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/reports/facts/limit_facts.hpp>

namespace subcert::cli {
namespace {

constexpr double convergence_share = 0.5;  // of the time, at most

struct Options : CommonOptions {
  std::string scheme;
  std::string width = "1/1000000";
  double budget = 60;
  PaperForm form;
};

ExitCode run(const Options& options) {
  require_one_form(options, options.form);
  const Deadline deadline = Deadline::in(options.budget);
  const Scheme scheme = make_scheme(options.scheme);
  const auto width = parse_number(options.width);
  if (!width || *width <= 0)
    fail(ErrorKind::usage, "--width: expected a positive number, as 1e-9 or 1/1000, got '{}'", options.width);
  require_derivative(scheme.specification, scheme.mask, {0}, {16, deadline.after(convergence_share)});
  VarianceRange range;
  try {
    range = variance_range(scheme.mask.curve(), {*width, {deadline}});
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::domain) throw;
    fail(ErrorKind::undecided, "{}: no variance curve; {}", scheme.specification, error.what());
  }
  return print_range(scheme, variance_facts(range), range.complete, 16, options, options.form);
}

}  // namespace

void add_variance(Command& app) {
  auto options = std::make_shared<Options>();
  Command command = add_command(app, "variance",
                                "The variance curve psi: maximum, minimum and largest slope, enclosed with proof",
                                "subcert variance primal:n=5", options, [=] { return run(*options); });
  command.option("--width", options->width, "Relative width of the enclosures, p or p/q").exact_number().with_default();
  command.option("--budget", options->budget, "Seconds of processor time").within(1e-9, 1e6).with_default();
  add_scheme(command, options->scheme);
  add_fact_forms(command, options->form);
}

}  // namespace subcert::cli
