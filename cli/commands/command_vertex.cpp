// subcert vertex SCHEME|FILE.toml --valence 3..12 | --all-valences [--certificate DIR] [--stencils]
// [--stencils-header FILE] [--plot FILE] [--html FILE]
// subcert vertex FILE.toml --over b=LOW..HIGH [--property C1|bounded-curvature] [--width 1e-6] [--valence 3..12]

#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/vertex/every_valence.hpp>
#include <subcert/cli/pages/plot.hpp>
#include <subcert/cli/pages/vertex_pictures.hpp>
#include <subcert/cli/paper_form.hpp>
#include <subcert/cli/parameter_range.hpp>
#include <subcert/cli/vertex_arguments.hpp>
#include <subcert/proofs-checks/certificates/vertex_certificate.hpp>
#include <subcert/proofs-checks/number_list.hpp>
#include <subcert/reports/facts/vertex_facts.hpp>
#include <subcert/reports/facts/weight_facts.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/plain_text.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::cli {
namespace {

constexpr const char* usual_valences = "3..12";

struct VertexOptions : SearchOptions {
  std::string scheme;
  std::string valence = usual_valences;
  bool all = false, stencils = false;
  std::string header;
  std::string certificate;
  std::string plot, html;
  std::string over;
  std::string property = facts::property_text(WeightProperty::c1);
  std::string width = "1e-6";
  PaperForm form;
};

/// One for each valence where smoothness is decided by what certificates can say, and one for all that follow.
WrittenCertificates write_certificates_of(const VertexOptions& options, const std::vector<SectorRules>& rules,
                                          const std::vector<VertexSmoothness>& valences,
                                          const std::optional<SectorRuleFamily>& family,
                                          const std::optional<EveryValence>& rest, Json& json) {
  std::vector<NamedCertificate> certificates;
  std::optional<MultivariateRegularity> regularity;  // of the mask itself, not of its factors
  const auto add = [&](long valence, const char* end, bool by_hulls, const auto& of, const auto& smoothness) {
    if (!regularity) regularity = regularity_around(rules.front().mask, by_hulls, options.limits());
    certificates.push_back({fmt::format("{:04}-{}", valence, end), vertex_certificate(of, *regularity, smoothness)});
  };
  for (std::size_t i = 0; i < rules.size(); ++i)
    if (const auto& evidence = valences[i].evidence)
      add(valences[i].valence, "vertex", evidence->by_hulls, rules[i], valences[i]);
  if (rest && rest->evidence) add(rest->first, "vertices", true, *family, *rest);
  return write_certificates(options.certificate, certificates, {"-vertex", "-vertices"},
                            "what is not decided, or with several eigenvalues or a Jordan block in front, or of all "
                            "valences not by hulls of differences",
                            json);
}

/// For which values of a letter.
ExitCode run_over(const VertexOptions& options) {
  if (options.all || options.stencils || !options.header.empty() || !options.certificate.empty() ||
      !options.plot.empty() || !options.html.empty() || options.form.asked_for())
    fail(ErrorKind::usage,
         "--over: need no --all-valences, --stencils, --stencils-header, --certificate, --plot, --html, --latex or "
         "--markdown beside it");
  const std::vector<int> numbers = parse_number_list("--valence", options.valence, smallest_valence, largest_valence);
  const WeightProperty property = facts::parse_weight_property(options.property, "--property");
  const auto width = parse_number(options.width);
  if (!width || !(*width > 0))
    fail(ErrorKind::usage, "--width: expected a positive number, as 1e-6, got {}", in_quotes(options.width));
  const std::string name = plain_text(options.over.substr(0, options.over.find('=')));
  const VertexScheme scheme = read_free_rules(options.scheme, {name});
  const auto [low, high] = read_over(options.over, name);
  options.progress("the regular part");
  const Budget budget = options.limits();
  std::vector<SectorRules> rules;
  for (const int n : numbers) rules.push_back(rules_with_letters(*scheme.written, n));
  const RegularPart regular = regular_part(rules.front(), budget);
  std::vector<WeightRange> ranges;
  for (const SectorRules& at : rules) {
    options.progress(fmt::format("valence {}", at.valence));
    ranges.push_back(weight_range(at, regular, property, low, high, *width, options.threads(), budget));
  }
  options.end_progress();
  const Facts list = facts::weight_facts(scheme, regular, property, ranges);
  options.answer(page_json(list), page_text(list, 14));
  return exit_code(std::ranges::all_of(ranges, facts::is_decided) ? Truth::yes : Truth::unknown,
                   !budget.deadline.expired());
}

/// Draws what is asked for.
void draw(const VertexOptions& options, const VertexScheme& scheme, const std::vector<SectorRules>& rules,
          const RegularPart& regular, const std::vector<VertexSmoothness>& valences, const std::string& facts) {
  if (options.plot.empty() && options.html.empty()) return;
  std::vector<VertexPicture> pictures;
  for (std::size_t i = 0; i < rules.size(); ++i)
    pictures.push_back({valences[i], vertex_surface(rules[i], regular, valences[i])});
  if (!options.html.empty()) runtime::write_file(options.html, vertex_html(scheme, facts, pictures));
  if (!options.plot.empty()) draw_vertices(options.plot, scheme, pictures);
}

ExitCode run(const VertexOptions& options) {
  require_one_form(options, options.form);
  if (options.form.asked_for() && options.stencils)
    fail(ErrorKind::usage, "--stencils: need no --latex or --markdown beside it; --stencils-header writes a file");
  if (!options.over.empty()) return run_over(options);
  if (options.all && options.valence != usual_valences)
    fail(ErrorKind::usage, "--all-valences: need no --valence beside it, got {}", options.valence);
  require_picture_name(options.plot);
  std::vector<int> numbers = parse_number_list("--valence", options.valence, smallest_valence, largest_valence);
  const VertexScheme scheme = read_vertex_scheme(options.scheme);
  std::optional<SectorRuleFamily> family;
  if (options.all) {
    family = scheme.family();
    while (numbers.back() + 1 < first_of_all(*family)) numbers.push_back(numbers.back() + 1);
  }
  if (!options.certificate.empty()) require_folder(options.certificate);
  options.progress("the regular part");
  const std::vector<SectorRules> rules = scheme.at(numbers);
  const RegularPart regular = regular_part(rules.front(), options.limits());
  options.progress("eigenvalues and characteristic maps");
  const std::vector<VertexSmoothness> valences = vertex_smoothness(rules, regular, options.threads());
  std::optional<EveryValence> rest;
  if (family) {
    options.progress(fmt::format("all valences from {} on", numbers.back() + 1));
    rest = every_valence(*family, regular, numbers.back() + 1, options.limits());
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
  if (!options.certificate.empty()) written = write_certificates_of(options, rules, valences, family, rest, json);
  draw(options, scheme, rules, regular, valences, page_text(list, 14));
  options.end_progress();
  if (options.form.asked_for())
    answer(options, options.form,
           TableAnswer{"% " + scheme.specification + ", at vertices of valence n\n", vertex_rows(valences, rest)});
  else
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
  command.option("--plot", options->plot,
                 "Draw the surface near the vertex, coloured by curvature, as .svg, .png, .pdf, .tex or .html");
  command.option("--html", options->html,
                 "A page with the characteristic map and the surface at each valence, all in one file");
  command.option("--over", options->over, "For which values of the letter of a file: b=LOW..HIGH");
  command.option("--property", options->property, "With --over: C1 or bounded-curvature").with_default();
  command.option("--width", options->width, "With --over: of what is left open about an end")
      .exact_number()
      .with_default();
  add_paper_form(command, options->form, "The table of valences in LaTeX", "The table of valences in Markdown");
  add_limits(command, *options);
  std::string known;
  for (const std::string& name : schemes_with_vertex_rules()) known += " " + name;
  command.option("SCHEME", options->scheme, "Scheme specification, or a file with rules, FILE.toml")
      .required()
      .suggest([] {
        std::vector<Suggestion> words;
        for (const std::string& name : schemes_with_vertex_rules()) words.push_back({name, ""});
        return words;
      });
  command.add_to_footer("\n\nSchemes with rules at vertices:" + known);
}

}  // namespace subcert::cli
