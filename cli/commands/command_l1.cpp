// subcert l1 SCHEME

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/proofs-checks/certificates/l1_certificate.hpp>
#include <subcert/reports/facts/l1_facts.hpp>

namespace subcert::cli {
namespace {

struct L1Options : CommonOptions {
  std::string scheme;
  std::string certificate;
  int steps = 0;
  int order = 0;
  std::string bound = "0";
  double budget = 60;
  bool rule = false;
  PaperForm form;
};

ExitCode run(const L1Options& options) {
  require_one_form(options, options.form);
  if (!is_l1_specification(options.scheme))
    fail(ErrorKind::usage, "{}: need a scheme of the family l1, as l1:points=6,d=1", options.scheme);
  const DataDependentScheme scheme = make_l1_scheme(options.scheme);
  const int points = points_of_curve(scheme), degree = scheme.rules.degree, arity = scheme.rules.arity;
  if (options.order > degree + 1)
    fail(ErrorKind::usage, "--order: need at most d + 1 = {}, got {}", degree + 1, options.order);
  if (const int most = piecewise::most_steps(arity); options.steps > most)
    fail(ErrorKind::usage, "--steps: need at most {} for arity {}, got {}", most, arity, options.steps);
  const auto enough = parse_number(options.bound);
  if (!enough || *enough < 0)
    fail(ErrorKind::usage, "--bound: expected a number that is not negative, got '{}'", options.bound);
  options.progress("linear programs");
  const Deadline deadline = Deadline::in(options.budget);
  const data::LeastAbsoluteLimit limit = data::least_absolute_limit(
      points, degree,
      {options.steps, options.order, *enough, deadline.after(facts::share_of_limit), !options.certificate.empty()},
      arity);
  const WrittenCertificate certificate = write_certificate(options.certificate, [&] {
    if (points == degree + 1)
      fail(ErrorKind::undecided,
           "certificate: the fit interpolates its data; ask for one of the mask, by 'regularity'");
    if (!limit.contraction) fail(ErrorKind::undecided, "certificate: no contraction was found within the budget");
    return contraction_certificate(*data::least_absolute_rule(points, degree, arity), *limit.contraction, limit.edge);
  });
  options.end_progress();
  const Facts list = l1_facts(scheme, limit, {deadline, options.rule});
  Json json = page_json(list);
  certificate.add_to(json);
  answer(options, options.form, {list, 13, json, certificate.text(false)});
  certificate.failure.raise();
  return exit_code(limit.converges.truth);
}

}  // namespace

void add_l1(Command& app) {
  auto options = std::make_shared<L1Options>();
  Command command = add_command(app, "l1",
                                "What is proved about a scheme of local l1 regression: limits, exponent, range",
                                "subcert l1 l1:points=6,d=1 --certificate l1.cert", options, [=] {
                                  require_place(options->certificate);
                                  return run(*options);
                                });
  command.option("--steps", options->steps, "Steps of the contraction; 0: the fewest that contract")
      .within(0, 8)
      .with_default();
  command.option("--order", options->order, "Order of the differences; 0: the one that proves most")
      .within(0, 4)
      .with_default();
  command.option("--bound", options->bound, "A bound of the contraction that is enough; 0: the least one")
      .with_default();
  command.flag("--rule", options->rule,
               "Try longer to prove that the rule itself converges, delta > 0 and its own fits");
  command.option("--budget", options->budget, "Seconds of processor time").within(0.001, 1e6).with_default();
  command.option("--certificate", options->certificate, "Write a certificate for 'subcert verify' there");
  add_scheme(command, options->scheme, true);
  add_fact_forms(command, options->form);
}

}  // namespace subcert::cli
