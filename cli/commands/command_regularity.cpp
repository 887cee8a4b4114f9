// subcert regularity SCHEME

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/proofs-checks/certificates/scheme_regularity.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>

#include <fmt/format.h>

namespace subcert::cli {
namespace {

constexpr double sobolev_share = 0.3;  // of the time, at most

struct RegularityCommandOptions : SearchOptions {
  std::string scheme;
  std::string certificate, scheme_certificate;
  std::string method = "radius";
  int levels = 16;
  int component = 0;
  PaperForm form;
};

/// `\alpha = 2`, or a remark.
std::string latex_of(const std::string& scheme, const Enclosure& exponent, const Decision& converges,
                     const std::optional<ExponentFormula>& closed = {}) {
  const std::string formula = exponent_latex(exponent, closed);
  return "% " + scheme + ": " +
         (formula.empty() ? "no exponent is known; convergence: " + to_text(converges.truth) + "\n"
                          : "the Hoelder exponent, enclosed with proof\n" + formula + "\n");
}

/// In the form that was asked for.
void print(const RegularityCommandOptions& options, const Json& json, const Facts& facts, const std::string& latex,
           const std::string& more) {
  options.form.latex ? options.answer(latex) : answer(options, options.form, {facts, 13, json, more});
}

/// A lower end alone, within seconds also where matrices are far too large.
ExitCode by_frequency(const RegularityCommandOptions& options) {
  const Scheme scheme = make_linear_scheme(options.scheme);
  if (scheme.mask.dimension() != 1 || scheme.rounding || !is_affine(scheme.mask.curve()))
    fail(ErrorKind::usage,
         "--method frequency: need a mask of exact numbers, in one variable, with coset sums 1, got {}",
         options.scheme);
  const Stopwatch watch;
  const std::optional<FrequencyBound> bound = frequency_bound(scheme.mask.curve());
  const Facts facts = frequency_facts(scheme, bound, watch.seconds());
  Json json = page_json(facts);
  const WrittenCertificate certificate = write_certificate(
      options.certificate, [&] { return frequency_certificate(scheme.mask.curve(), bound); });
  certificate.add_to(json);
  const Decision converges{bound && bound->exponent > 0 ? Truth::yes : Truth::unknown, ""};
  print(options, json, facts,
        latex_of(scheme.specification, converges.is_yes() ? Enclosure::at_least(bound->exponent) : Enclosure{},
                 converges),
        certificate.text(false));
  certificate.failure.raise();
  return bound && bound->exponent > 0 ? done : undecided;
}

/// As the page has it.
Enclosure proved_exponent(const Regularity& found) {
  const Enclosure exponent = found.curve ? found.curve->proved_exponent() : found.exponent();
  return found.curve || exponent.lower ? exponent : Enclosure{};
}

ExitCode run(const RegularityCommandOptions& options, const Budget& budget) {
  require_one_form(options, options.form);
  if (options.method == "frequency") return by_frequency(options);
  const WantedWidth wanted = wanted_width(options);
  const Scheme scheme = make_refinable_scheme(options.scheme);
  const LatticeMask& mask = scheme.mask;
  const bool curve = mask.factors().size() == 1;
  const Stopwatch watch;
  options.progress(curve ? "norms, products and polytopes" : "products and polytopes");
  std::optional<SobolevRegularity> sobolev;
  if (curve && is_affine(mask.curve()) && !scheme.rounding)  // otherwise the exponent says so
    sobolev = sobolev_if_small(mask.curve(), budget.deadline.after(sobolev_share).later(1));
  const HolderProof proof = options.certificate.empty() ? HolderProof::shortest : HolderProof::certificate;
  RegularityOptions how = of_scheme(scheme, {wanted.bits, options.levels, proof});
  if (options.component > 0) {
    if (options.component > static_cast<int>(mask.components()) || mask.components() == 1)
      fail(ErrorKind::usage, "--component: need {}, got {}",
           mask.components() == 1 ? "a mask of matrices" : fmt::format("1 to {}", mask.components()),
           options.component);
    how.component = options.component - 1;
  }
  const Regularity found = regularity_of(mask, budget, how);
  const bool complete = found.is_closed() && wanted.holds(found.exponent());
  const Facts list = regularity_facts(scheme, found, sobolev, {watch.seconds(), wanted.digits, complete});
  // A certificate is about the mask, also of a tensor product.
  const WrittenCertificate certificate = write_certificate(options.certificate, [&] {
    return exponent_certificate(
        mask, curve || !mask.has_factors() ? found : regularity_of(mask.without_factors(), budget, how),
        scheme.rounding, scheme.quadratic);
  });
  const WrittenCertificate of_scheme = write_scheme_certificate(options.scheme_certificate, scheme, budget);
  options.end_progress();
  Json json = page_json(list);
  certificate.add_to(json);
  of_scheme.add_to(json, "scheme_certificate");
  print(options, json, list,
        latex_of(scheme.specification, proved_exponent(found), found.converges(), exponent_formula(scheme, found)),
        certificate.text(found.exact().is_yes()) + of_scheme.text(false));
  certificate.failure.raise();
  of_scheme.failure.raise();
  const Decision& limits = found.surface && found.surface->vector ? found.surface->vector->continuous
                                                                  : found.converges();
  if (limits.is_no()) return failed;
  return limits.is_yes() && complete ? done : undecided;
}

}  // namespace

void add_regularity(Command& app) {
  auto options = std::make_shared<RegularityCommandOptions>();
  Command command = add_command(app, "regularity", "The Hoelder exponent, enclosed with proof",
                                "subcert regularity primal:n=5 --certificate s5.cert", options, [=] {
                                  require_place(options->certificate);
                                  require_place(options->scheme_certificate);
                                  return run(*options, options->limits());
                                });
  command.option("--levels", options->levels, "Levels of the difference scheme").within(1, 64).with_default();
  add_limits(command, *options);
  add_width(command, *options);
  command
      .option(
          "--method", options->method,
          "radius: by joint spectral radii, and by frequencies where those stay open; frequency: a lower end alone, at "
          "once, for curves of any size")
      .one_of({"radius", "frequency"})
      .with_default();
  command.option("--component", options->component, "Of a vector of functions the exponent of this one alone")
      .within(1, 64);
  command.option("--certificate", options->certificate, "Write a certificate for 'subcert verify' there");
  add_scheme_certificate(command, options->scheme_certificate);
  add_scheme(command, options->scheme, true, true);
  add_paper_form(command, options->form, "The exponent as a formula of LaTeX", "All facts as a table in Markdown");
}

}  // namespace subcert::cli
