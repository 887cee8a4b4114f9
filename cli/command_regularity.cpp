// subcert regularity SCHEME

#include "sobolev_text.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/symbol/error.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/reports/runtime/files.hpp>

#include <algorithm>
#include <sstream>

namespace subcert::cli {
namespace {

constexpr double sobolev_share = 0.3;  // of the time, at most

struct RegularityOptions : CommonOptions {
  std::string scheme;
  std::string certificate;
  int levels = 16;
  double budget = 60;
  std::size_t memory = 1024;
};

std::string method_text(const JointSpectralRadius& radius) {
  switch (radius.method()) {
    case JsrMethod::invariant_polytope: return "invariant polytope";
    case JsrMethod::single_spectral_radius: return "single spectral radius";
    default: return "norms of the difference scheme";
  }
}

/// Whether the exponent is attained: the modulus of continuity of the derivative that decides.
std::string attained_text(const HolderRegularity& regularity) {
  const LogarithmicFactor& factor = regularity.logarithm;
  if (!factor.derivative) return "unknown: " + factor.reason;
  const auto modulus = [&](int power) {
    const Rational difference = *regularity.exponent.lower - *factor.derivative;
    return "h" + (difference == 1 ? "" : "^" + to_decimal(difference, 6, Rounding::nearest)) +
           (power == 0   ? ""
            : power == 1 ? " |log h|"
                         : " |log h|^" + std::to_string(power));
  };
  const std::string subject = *factor.derivative == 0
                                  ? "the limits"
                                  : "the derivatives of order " + std::to_string(*factor.derivative);
  if (!factor.at_most)
    return factor.at_least == 0
               ? "unknown: " + factor.reason
               : "no: " + subject + " have no smaller modulus of continuity than " + modulus(factor.at_least);
  const std::string has = subject + " have the modulus of continuity " + modulus(*factor.at_most);
  if (*factor.at_most == 0) return "yes: " + has;
  if (factor.at_least == 0) return "unknown: " + has + " or a smaller one";
  return "no: " + has + (factor.at_least == *factor.at_most ? ", and no smaller one" : " or a smaller one");
}

std::string word_text(const std::vector<int>& word) {
  std::string text;
  for (int letter : word) text += (letter > 9 && !text.empty() ? "," : "") + std::to_string(letter);
  return text;
}

/// Everything the command prints.
struct Answer {
  Scheme scheme;
  HolderRegularity regularity;
  std::optional<SobolevRegularity> sobolev;
  Decision convergence;
  Enclosure holder;
  bool complete;
  double seconds;

  ExitCode code() const {
    if (convergence.is_no()) return failed;
    return convergence.is_yes() && complete ? done : undecided;
  }
};

Answer compute(const RegularityOptions& options) {
  const Stopwatch watch;
  const Budget budget{Deadline::in(options.budget), options.memory << 20};
  Scheme scheme = make_scheme(options.scheme);
  options.progress("norms, products and polytopes");
  std::optional<SobolevRegularity> sobolev;
  if (is_affine(scheme.mask))  // otherwise holder_regularity says so
    sobolev = sobolev_if_small(scheme.mask, Deadline::in(sobolev_share * budget.deadline.remaining() + 1));
  const HolderProof proof = options.certificate.empty() ? HolderProof::shortest : HolderProof::certificate;
  HolderRegularity regularity = holder_regularity(scheme.mask, options.levels, budget, proof);
  options.end_progress();
  // A bound that is not positive proves nothing, not even convergence.
  const bool proves = *regularity.exponent.lower > 0;
  Decision convergence = proves ? Decision{Truth::yes, "the exponent is positive"}
                                : converges(scheme.mask,
                                            {options.levels, Deadline::in(std::max(budget.deadline.remaining(), 0.5))});
  Enclosure holder;
  if (proves)
    holder = regularity.exponent;
  else if (convergence.is_yes())
    holder = {0, regularity.exponent.upper};
  const bool complete = regularity.radius.is_closed();
  return {std::move(scheme), std::move(regularity), std::move(sobolev), std::move(convergence), holder,
          complete,          watch.seconds()};
}

Json to_json(const Answer& answer) {
  const HolderBounds& bounds = answer.regularity.bounds;
  const JointSpectralRadius &radius = answer.regularity.radius, &rational = answer.regularity.certifiable();
  Json by_level = Json::array();
  for (const HolderBound& bound : bounds.levels) by_level.push_back(bound.exponent.lower_text(12));
  const HolderBound& last = bounds.last();
  const LogarithmicFactor& logarithm = answer.regularity.logarithm;
  return {{"scheme", answer.scheme.specification},
          {"sum_rules", bounds.sum_rules},
          {"bound", {{"levels", last.levels}, {"norm", to_text(last.norm)}, {"holder", enclosure_json(last.exponent)}}},
          {"bounds_by_level", by_level},
          {"converges", to_text(answer.convergence.truth)},
          {"radius", enclosure_json(radius.radius)},
          {"holder", enclosure_json(answer.holder)},
          {"exact", radius.exact.is_yes()},
          {"exactness", radius.exact.reason},
          {"closed", radius.is_closed()},
          {"method", method_text(radius)},
          {"product", word_text(radius.product.word)},
          {"vertices", rational.vertices()},
          {"blocks", rational.by_blocks() ? Json(rational.by_blocks()->triangular.sizes) : Json()},
          {"stable", answer.regularity.stable.is_yes() && answer.holder.upper.has_value()},
          {"stability", answer.regularity.stable.reason},
          {"logarithm",
           {{"at_least", logarithm.at_least},
            {"at_most", logarithm.at_most ? Json(*logarithm.at_most) : Json()},
            {"derivative", logarithm.derivative ? Json(*logarithm.derivative) : Json()},
            {"reason", logarithm.reason}}},
          {"single",
           {{"verdict", to_text(answer.regularity.single.applies.truth)},
            {"reason", answer.regularity.single.applies.reason}}},
          {"sobolev", sobolev_json(answer.sobolev, answer.regularity.stable)},
          {"seconds", answer.seconds}};
}

std::string page_text(const Answer& answer) {
  const HolderBounds& bounds = answer.regularity.bounds;
  const JointSpectralRadius& radius = answer.regularity.radius;
  const HolderBound& last = bounds.last();
  std::ostringstream text;
  text << "scheme       " << answer.scheme.specification << "  (" << answer.scheme.title << ")\n"
       << "sum rules    " << bounds.sum_rules << "\n"
       << "converges    " << subcert::to_text(answer.convergence.truth) << ": " << answer.convergence.reason << "\n"
       << "bound        >= " << last.exponent.lower_text(12) << " after " << last.levels << " levels; ||S_b^"
       << last.levels << "|| = " << to_decimal(last.norm, 12, Rounding::nearest) << "\n"
       << "radius       " << enclosure_text(radius.radius, 15) << "  (joint spectral radius, " << method_text(radius);
  if (radius.method() == JsrMethod::invariant_polytope)
    text << " with " << radius.vertices() << (radius.vertices() == 1 ? " vertex" : " vertices");
  text << ")\n";
  if (const BlockProof* blocks = answer.regularity.certifiable().by_blocks())
    text << "blocks       " << sizes_text(blocks->triangular.sizes) << "\n";
  if (!radius.product.word.empty())
    text << "product      " << word_text(radius.product.word) << "  (radius "
         << enclosure_text(radius.product.radius, 15)
         << (radius.exact.is_yes() ? ", proved to attain the joint spectral radius)\n" : ")\n");
  text << "stable       " << subcert::to_text(answer.regularity.stable.truth) << ": " << answer.regularity.stable.reason
       << "\n"
       << "exponent     " << enclosure_text(answer.holder, 14) << "  (";
  if (!answer.holder.upper)
    text << "a proved lower bound)\n";
  else if (radius.is_closed())
    text << "enclosed with proof, " << answer.holder.lower_text(17) << " ... " << answer.holder.upper_text(17) << ")\n";
  else
    text << "enclosed with proof)\n";
  if (answer.holder.lower && *answer.regularity.exponent.lower > 0)
    text << "attained     " << attained_text(answer.regularity) << "\n";
  if (answer.sobolev) text << "Sobolev      " << sobolev_text(*answer.sobolev, answer.regularity.stable) << "\n";
  if (!answer.complete) text << "budget       the polytope did not close; the enclosure reached is printed\n";
  return text.str();
}

/// A word where the certificate proves less than the answer says.
std::string certificate_text(const HolderRegularity& regularity, const CertificateClaim& claim) {
  if (!regularity.radius.is_closed()) return "";
  const Rational sharp = *regularity.radius.radius.lower * (1 + power(Rational(10), -12));
  if (regularity.certifiable().proved_upper() <= sharp) return "";
  const auto decimal = [](const std::optional<std::string>& end, Rounding rounding) {
    return to_decimal(*parse_rational(*end), 12, rounding);
  };
  return "certificate  proves only " + decimal(claim.lower, Rounding::down) + " <= exponent" +
         (claim.upper ? " <= " + decimal(claim.upper, Rounding::up) : "") + ": no polytope closed, and " +
         method_text(regularity.radius) + " has no certificate\n";
}

ExitCode run(const RegularityOptions& options) {
  const Answer answer = compute(options);
  std::optional<CertificateClaim> claim;
  if (!options.certificate.empty()) {
    // Other arguments may prove more than rational numbers do.
    const Rational radius = answer.regularity.certifiable().proved_upper();
    const int rules = answer.regularity.bounds.sum_rules;
    if (!(radius < power(Rational(answer.scheme.mask.arity()), rules)))
      fail(ErrorKind::usage, "--certificate: rational numbers prove nothing positive about {}",
           answer.scheme.specification);
    const Certificate certificate = exponent_certificate(answer.scheme.mask, answer.regularity);
    runtime::write_file(options.certificate, certificate.text);
    claim = certificate.claim;
  }
  if (options.json) {
    Json json = to_json(answer);
    if (claim)
      json["certificate"] = {{"lower", claim->lower ? Json(*claim->lower) : Json()},
                             {"upper", claim->upper ? Json(*claim->upper) : Json()}};
    options.answer(json);
  } else {
    options.answer(page_text(answer) + (claim ? certificate_text(answer.regularity, *claim) : ""));
  }
  return answer.code();
}

}  // namespace

void add_regularity(Command& app) {
  auto options = std::make_shared<RegularityOptions>();
  Command command = add_command(app, "regularity", "The Hoelder exponent, enclosed with proof",
                                "subcert regularity primal:n=5 --certificate s5.cert", options,
                                [=] { return run(*options); });
  command.option("--levels", options->levels, "Levels of the difference scheme").within(1, 64).with_default();
  command.option("--budget", options->budget, "Seconds").within(0.001, 1e6).with_default();
  command.option("--memory", options->memory, "MiB that the search may hold; near them it ends with what is proved")
      .within(16, 1 << 20)
      .with_default();
  command.option("--certificate", options->certificate, "Write a certificate for 'subcert verify' there");
  add_scheme(command, options->scheme);
}

}  // namespace subcert::cli
