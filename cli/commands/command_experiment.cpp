// subcert experiment ID: one experiment of a paper, seeded

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/reports/report_files.hpp>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace subcert::cli {
namespace {

struct ExperimentCommand : CommonOptions {
  std::string id = "list";
  std::size_t runs = 200;
};

std::vector<std::string> known() {
  std::vector<std::string> result{"list"};
  for (const experiments::Experiment& candidate : experiments::experiments()) result.push_back(candidate.id);
  return result;
}

ExitCode list(const ExperimentCommand& options) {
  if (!options.out.empty()) fail(ErrorKind::usage, "--out: 'list' writes no files");
  Json rows = Json::array();
  std::string text;
  for (const experiments::Experiment& candidate : experiments::experiments()) {
    rows.push_back({{"experiment", candidate.id}, {"paper", candidate.paper}, {"title", candidate.title}});
    text += candidate.id + std::string(candidate.id.size() < 16 ? 16 - candidate.id.size() : 1, ' ') + candidate.paper +
            std::string(candidate.paper.size() < 18 ? 18 - candidate.paper.size() : 1, ' ') + candidate.title + "\n";
  }
  options.answer(Json{{"experiments", rows}}, text);
  return done;
}

std::string page(const experiments::RanExperiment& ran, const formats::Section& section) {
  const experiments::ExperimentResult& result = ran.result;
  std::ostringstream text;
  text << ran.experiment->title << " (" << ran.experiment->paper << ")\n\n";
  for (const std::string& paragraph : section.paragraphs) text << paragraph << "\n\n";
  for (const experiments::DecidedClaim& claim : result.claims)
    text << to_text(claim.finding) << ": " << claim.sentence << " [" << claim.place
         << "]\n  decided by: " << claim.statistic << "\n  found: " << claim.numbers << "\n";
  for (std::size_t t = 1; t < section.tables.size(); ++t) {  // the first has the claims
    const formats::PlainTable& table = section.tables[t];
    text << "\n" << table.title << "\n";
    for (std::size_t i = 0; i < table.head.size(); ++i) text << (i ? "; " : "  ") << table.head[i];
    text << "\n";
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) text << (i ? "; " : "  ") << row[i];
      text << "\n";
    }
  }
  return facts::wrapped(text.str(), 4);
}

ExitCode run(const ExperimentCommand& options) {
  if (options.id == "list") return list(options);
  const auto& all = experiments::experiments();
  if (std::none_of(all.begin(), all.end(), [&](const experiments::Experiment& e) { return e.id == options.id; }))
    fail(ErrorKind::usage, "ID: {}", expected_one_of(known(), options.id));
  const experiments::Experiment& chosen = experiments::experiment(options.id);
  options.progress("experiment " + chosen.id);
  const experiments::RanExperiment ran = experiments::run_experiment(chosen,
                                                                     {options.seed, options.runs, options.threads()});
  const formats::Section section = experiments::experiment_section(ran);
  if (!options.out.empty())
    reports::write_reports({{{chosen.paper, chosen.title, {section}, {ran}}}}, options.out, options.threads());
  options.end_progress();
  if (options.json)
    print_json(experiments::experiment_json(ran));
  else
    std::cout << page(ran, section);
  return ran.result.count(ClaimVerdict::contrary)    ? failed
         : ran.result.count(ClaimVerdict::undecided) ? undecided
                                                     : done;
}

}  // namespace

void add_experiment(Command& app) {
  auto options = std::make_shared<ExperimentCommand>();
  Command command = add_command(app, "experiment", "Runs an experiment of a paper on seeded random data",
                                "subcert experiment fig5 --seed 7", options, [=] { return run(*options); });
  command.option("ID", options->id, "An experiment, or 'list' (default)").suggest([] {
    std::vector<Suggestion> ids{{"list", "all experiments"}};
    for (const experiments::Experiment& one : experiments::experiments()) ids.push_back({one.id, one.title});
    return ids;
  });
  command.option("--runs", options->runs, "Samples of the noise").within(2, 100000).with_default();
  command.existing("--out").describe("Folder for index.html, tables and figures");
}

}  // namespace subcert::cli
