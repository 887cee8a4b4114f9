// subcert regularity SCHEME

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/cli/checker.hpp>
#include <subcert/cli/pages/multivariate_regularity_page.hpp>
#include <subcert/cli/pages/regularity_page.hpp>

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr double sobolev_share = 0.3;  // of the time, at most

struct RegularityOptions : SearchOptions {
  std::string scheme;
  std::string certificate;
  int levels = 16;
};

RegularityPage compute(Scheme scheme, const RegularityOptions& options, const WantedWidth& wanted,
                       const Budget& budget) {
  const Stopwatch watch;
  options.progress("norms, products and polytopes");
  std::optional<SobolevRegularity> sobolev;
  if (is_affine(scheme.mask) && !scheme.rounding)  // otherwise holder_regularity says so
    sobolev = sobolev_if_small(scheme.mask, Deadline::in(sobolev_share * budget.deadline.remaining() + 1));
  const HolderProof proof = options.certificate.empty() ? HolderProof::shortest : HolderProof::certificate;
  HolderRegularity regularity = holder_regularity(scheme.mask, options.levels, budget, proof, scheme.rounding,
                                                  wanted.bits);
  options.end_progress();
  const Enclosure holder = regularity.proved_exponent();
  const bool complete = regularity.deciding().radius.is_closed() && wanted.holds(holder);
  return {std::move(scheme), std::move(regularity), std::move(sobolev), holder,
          complete,          watch.seconds(),       wanted.digits};
}

ExitCode run(Scheme scheme, const RegularityOptions& options, const Budget& budget) {
  const RegularityPage page = compute(std::move(scheme), options, wanted_width(options), budget);
  const WrittenCertificate certificate = write_certificate(options.certificate, [&] {
    return exponent_certificate(page.scheme.mask, page.regularity, page.scheme.rounding);
  });
  Json json = page.json();
  certificate.add_to(json);
  options.answer(json, page.text() + certificate.text(page.regularity.deciding().radius.exact.is_yes()));
  certificate.failure.raise();
  if (page.regularity.converges.is_no()) return failed;
  return page.regularity.converges.is_yes() && page.complete ? done : undecided;
}

ExitCode run(MultivariateScheme scheme, const RegularityOptions& options, const Budget& budget) {
  options.progress("products and polytopes");
  const WantedWidth wanted = wanted_width(options);
  const MultivariateRegularityPage page = multivariate_regularity_page(std::move(scheme), budget, wanted);
  const MultivariateMask& mask = page.scheme.mask;
  // A certificate is about the mask, also of a tensor product.
  const WrittenCertificate certificate = write_certificate(options.certificate, [&] {
    return surface_certificate(
        mask, page.scheme.factors.empty() ? page.regularity : multivariate_regularity(mask, budget, wanted.bits));
  });
  options.end_progress();
  Json json = page.json();
  certificate.add_to(json);
  options.answer(json, page.text() + certificate.text(page.regularity.exact.is_yes()));
  certificate.failure.raise();
  if (page.regularity.converges.is_no()) return failed;
  const bool complete = page.regularity.is_closed() && wanted.holds(page.regularity.exponent);
  return page.regularity.converges.is_yes() && complete ? done : undecided;
}

}  // namespace

void add_regularity(Command& app) {
  auto options = std::make_shared<RegularityOptions>();
  Command command = add_command(app, "regularity", "The Hoelder exponent, enclosed with proof",
                                "subcert regularity primal:n=5 --certificate s5.cert", options, [=] {
                                  require_place(options->certificate);
                                  const Budget budget = options->limits();
                                  return std::visit(
                                      [&](auto scheme) { return run(std::move(scheme), *options, budget); },
                                      make_linear_scheme(options->scheme));
                                });
  command.option("--levels", options->levels, "Levels of the difference scheme").within(1, 64).with_default();
  add_limits(command, *options);
  add_width(command, *options);
  command.option("--certificate", options->certificate, "Write a certificate for 'subcert verify' there");
  add_scheme(command, options->scheme, true);
}

}  // namespace subcert::cli
