// subcert vertex SCHEME --valence 3..12

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/proofs-checks/sweeps/number_list.hpp>
#include <subcert/reports/facts/vertex_facts.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <fmt/ranges.h>

namespace subcert::cli {
namespace {

constexpr int largest_valence = 1000;

struct VertexOptions : SearchOptions {
  std::string scheme;
  std::string valence = "3..12";
};

ExitCode run(const VertexOptions& options) {
  const std::vector<int> numbers = sweeps::parse_number_list("--valence", options.valence, 3, largest_valence);
  const Scheme scheme = make_linear_scheme(options.scheme);
  if (!has_vertex_rules(scheme))
    fail(ErrorKind::usage, "{}: has no rules at vertices; these have: {}", scheme.specification,
         fmt::join(schemes_with_vertex_rules(), ", "));
  options.progress("the regular part");
  const RegularPart regular = regular_part(vertex_rules(scheme.specification, numbers.front()), options.limits());
  std::vector<VertexSmoothness> valences(numbers.size());
  options.progress("eigenvalues and characteristic maps");
  parallel_for_each(numbers.size(), options.threads(), [&](std::size_t i) {
    valences[i] = vertex_smoothness(vertex_rules(scheme.specification, numbers[i]), regular);
  });
  options.end_progress();
  options.answer(vertex_facts(scheme, regular, valences), 14);
  // More time would only help with the regular part.
  return exit_code(all_of(valences), regular.c1.is_yes());
}

}  // namespace

void add_vertex(Command& app) {
  auto options = std::make_shared<VertexOptions>();
  Command command = add_command(app, "vertex", "Whether surfaces are smooth at vertices of any valence, with proof",
                                "subcert vertex catmull-clark --valence 3..12", options, [=] { return run(*options); });
  command.option("--valence", options->valence, "Valences, as 3..12 or 3,5,8..10, up to 1000").with_default();
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
