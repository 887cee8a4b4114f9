// subcert vertex SCHEME --valence 3..12 | --all-valences [--certificate DIR] [--stencils] [--stencils-header FILE]

#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/vertex/every_valence.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/proofs-checks/certificates/vertex_certificate.hpp>
#include <subcert/proofs-checks/number_list.hpp>
#include <subcert/reports/facts/vertex_facts.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <fmt/ranges.h>

namespace subcert::cli {
namespace {

constexpr int first_of_all = 13;
constexpr const char* usual_valences = "3..12";

struct VertexOptions : SearchOptions {
  std::string scheme;
  std::string valence = usual_valences;
  bool all = false, stencils = false;
  std::string header;
  std::string certificate;
};

/// One for each valence where smoothness is proved by what certificates can say, and one for all that follow.
WrittenCertificates write_certificates_of(const VertexOptions& options, const std::vector<SectorRules>& rules,
                                          const std::vector<VertexSmoothness>& valences,
                                          const std::optional<EveryValence>& rest, Json& json) {
  std::vector<NamedCertificate> certificates;
  std::optional<Regularity> regularity;  // of the mask itself, not of its factors
  const auto add = [&](long valence, const char* end, const auto& of, const auto& smoothness) {
    if (!smoothness.evidence) return;
    if (!regularity) regularity = regularity_of(rules.front().mask.without_factors(), options.limits());
    certificates.push_back(
        {fmt::format("{:04}-{}", valence, end), vertex_certificate(of, *regularity->surface, smoothness)});
  };
  for (std::size_t i = 0; i < rules.size(); ++i) add(valences[i].valence, "vertex", rules[i], valences[i]);
  if (rest && rest->evidence) add(rest->first, "vertices", vertex_rule_family(options.scheme), *rest);
  return write_certificates(options.certificate, certificates, {"-vertex", "-vertices"},
                            "what is not proved, or not by hulls of differences", json);
}

ExitCode run(const VertexOptions& options) {
  if (options.all && options.valence != usual_valences)
    fail(ErrorKind::usage, "--all-valences: need no --valence beside it, got {}", options.valence);
  const std::vector<int> numbers = parse_number_list("--valence", options.valence, smallest_valence, largest_valence);
  const Scheme scheme = make_linear_scheme(options.scheme);
  if (!has_vertex_rules(scheme))
    fail(ErrorKind::usage, "{}: has no rules at vertices; these have: {}", scheme.specification,
         fmt::join(schemes_with_vertex_rules(), ", "));
  if (!options.certificate.empty()) require_folder(options.certificate);
  options.progress("the regular part");
  const std::vector<SectorRules> rules = vertex_rules(scheme.specification, numbers);
  const RegularPart regular = regular_part(rules.front(), options.limits());
  options.progress("eigenvalues and characteristic maps");
  const std::vector<VertexSmoothness> valences = vertex_smoothness(rules, regular, options.threads());
  std::optional<EveryValence> rest;
  if (options.all) {
    options.progress(fmt::format("all valences from {} on", first_of_all));
    rest = every_valence(vertex_rule_family(scheme.specification), regular, first_of_all, options.limits());
  }
  std::vector<StencilsAt> stencils;
  if (options.stencils || !options.header.empty())
    for (std::size_t i = 0; i < rules.size(); ++i)
      stencils.push_back({rules[i].valence, vertex_stencils(rules[i], valences[i])});
  if (!options.header.empty()) runtime::write_file(options.header, stencils_header(scheme, stencils));
  const Facts list = vertex_facts(scheme, regular, valences, rest,
                                  options.stencils ? stencils : std::vector<StencilsAt>{});
  Json json = page_json(list);
  WrittenCertificates written;
  if (!options.certificate.empty()) written = write_certificates_of(options, rules, valences, rest, json);
  options.end_progress();
  options.answer(json, page_text(list, 14) + written.text);
  written.failure.raise();
  // More time would only help with the regular part.
  return exit_code(all_of(valences, rest), regular.c1.is_yes());
}

}  // namespace

void add_vertex(Command& app) {
  auto options = std::make_shared<VertexOptions>();
  Command command = add_command(app, "vertex", "Whether surfaces are smooth at vertices of any valence, with proof",
                                "subcert vertex catmull-clark --valence 3..12", options, [=] { return run(*options); });
  command
      .option("--valence", options->valence, fmt::format("Valences, as 3..12 or 3,5,8..10, up to {}", largest_valence))
      .with_default();
  command.flag("--all-valences", options->all, "Every valence: 3 to 12 one by one, and from 13 on all at once");
  command.flag("--stencils", options->stencils, "What each datum counts in the limit point and in two tangents");
  command.option("--stencils-header", options->header, "Write them as a header of C");
  command.option("--certificate", options->certificate, "Write certificates for 'subcert verify' into this folder");
  add_limits(command, *options);
  std::string known;
  for (const std::string& name : schemes_with_vertex_rules()) known += " " + name;
  command.option("SCHEME", options->scheme, "Scheme specification").required().suggest([] {
    std::vector<Suggestion> words;
    for (const std::string& name : schemes_with_vertex_rules()) words.push_back({name, ""});
    return words;
  });
  command.add_to_footer("\n\nSchemes with rules at vertices:" + known);
}

}  // namespace subcert::cli
