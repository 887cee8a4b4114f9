// subcert regularity SCHEME

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/width.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr double sobolev_share = 0.3;  // of the time, at most

struct RegularityOptions : SearchOptions {
  std::string scheme;
  std::string certificate;
  std::string method = "radius";
  int levels = 16;
};

struct Answer {
  Facts facts;
  std::function<Certificate()> certificate;
  Decision converges, exact;
  bool complete;
};

Answer curve_answer(const Scheme& scheme, const RegularityOptions& options, const WantedWidth& wanted,
                    const Budget& budget) {
  const Mask& mask = scheme.mask.curve();
  const Stopwatch watch;
  options.progress("norms, products and polytopes");
  std::optional<SobolevRegularity> sobolev;
  if (is_affine(mask) && !scheme.rounding)  // otherwise holder_regularity says so
    sobolev = sobolev_if_small(mask, budget.deadline.after(sobolev_share).later(1));
  const HolderProof proof = options.certificate.empty() ? HolderProof::shortest : HolderProof::certificate;
  const HolderRegularity regularity = holder_regularity(mask, options.levels, budget, proof, scheme.rounding,
                                                        wanted.bits);
  const JointSpectralRadius& deciding = regularity.deciding().radius;
  const bool complete = deciding.is_closed() && wanted.holds(regularity.proved_exponent());
  return {regularity_facts(scheme, regularity, sobolev, {watch.seconds(), wanted.digits, complete}),
          [=] { return exponent_certificate(scheme.mask.curve(), regularity, scheme.rounding); }, regularity.converges,
          deciding.exact, complete};
}

Answer surface_answer(const Scheme& scheme, const RegularityOptions& options, const WantedWidth& wanted,
                      const Budget& budget) {
  const Stopwatch watch;
  options.progress("products and polytopes");
  const MultivariateRegularity regularity = multivariate_regularity(scheme.mask, budget, wanted.bits);
  const bool complete = regularity.is_closed() && wanted.holds(regularity.exponent);
  // A certificate is about the mask, also of a tensor product.
  const auto certificate = [=] {
    return surface_certificate(scheme.mask,
                               scheme.mask.has_factors()
                                   ? multivariate_regularity(scheme.mask.without_factors(), budget, wanted.bits)
                                   : regularity);
  };
  return {regularity_facts(scheme, regularity, {watch.seconds(), wanted.digits, complete}), certificate,
          regularity.converges, regularity.exact, complete};
}

/// A lower end alone, within seconds also where matrices are far too large.
ExitCode by_frequency(const RegularityOptions& options) {
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
  options.answer(json, page_text(facts, 13) + certificate.text(false));
  certificate.failure.raise();
  return bound && bound->exponent > 0 ? done : undecided;
}

ExitCode run(const RegularityOptions& options, const Budget& budget) {
  if (options.method == "frequency") return by_frequency(options);
  const WantedWidth wanted = wanted_width(options);
  const Scheme scheme = make_linear_scheme(options.scheme);
  const Answer found = (scheme.mask.dimension() == 1 ? curve_answer : surface_answer)(scheme, options, wanted, budget);
  const WrittenCertificate certificate = write_certificate(options.certificate, found.certificate);
  options.end_progress();
  Json json = page_json(found.facts);
  certificate.add_to(json);
  options.answer(json, page_text(found.facts, 13) + certificate.text(found.exact.is_yes()));
  certificate.failure.raise();
  if (found.converges.is_no()) return failed;
  return found.converges.is_yes() && found.complete ? done : undecided;
}

}  // namespace

void add_regularity(Command& app) {
  auto options = std::make_shared<RegularityOptions>();
  Command command = add_command(app, "regularity", "The Hoelder exponent, enclosed with proof",
                                "subcert regularity primal:n=5 --certificate s5.cert", options, [=] {
                                  require_place(options->certificate);
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
  command.option("--certificate", options->certificate, "Write a certificate for 'subcert verify' there");
  add_scheme(command, options->scheme, true);
}

}  // namespace subcert::cli
