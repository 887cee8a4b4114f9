// subcert experiment ID: one experiment of a paper, seeded

#include "command.hpp"

#include <subcert/reports/report.hpp>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace subcert::cli {
namespace {

struct ExperimentCommand : CommonOptions {
  std::string id = "list";
  std::size_t runs = 200;
};

std::string known() {
  std::string result = "list";
  for (const Experiment& candidate : experiments()) result += ", " + candidate.id;
  return result;
}

int list(const ExperimentCommand& options) {
  if (!options.out.empty()) throw UsageError("--out: 'list' writes no files");
  Json rows = Json::array();
  std::string text;
  for (const Experiment& candidate : experiments()) {
    rows.push_back({{"experiment", candidate.id}, {"paper", candidate.paper}, {"title", candidate.title}});
    text += candidate.id + std::string(candidate.id.size() < 16 ? 16 - candidate.id.size() : 1, ' ') + candidate.paper +
            std::string(candidate.paper.size() < 18 ? 18 - candidate.paper.size() : 1, ' ') + candidate.title + "\n";
  }
  if (options.json)
    options.answer(Json{{"experiments", rows}});
  else
    options.answer(text);
  return done;
}

std::string page(const RanExperiment& ran, const Section& section) {
  const ExperimentResult& result = ran.result;
  std::ostringstream text;
  text << ran.experiment->title << " (" << ran.experiment->paper << ")\n\n";
  for (const std::string& paragraph : section.paragraphs) text << paragraph << "\n\n";
  for (const Claim& claim : result.claims)
    text << to_text(claim.finding) << ": " << claim.sentence << " [" << claim.place
         << "]\n  decided by: " << claim.statistic << "\n  found: " << claim.numbers << "\n";
  for (const PlainTable& table : result.tables) {
    text << "\n" << table.title << "\n";
    for (std::size_t i = 0; i < table.head.size(); ++i) text << (i ? "; " : "  ") << table.head[i];
    text << "\n";
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) text << (i ? "; " : "  ") << row[i];
      text << "\n";
    }
  }
  return text.str();
}

int run(const ExperimentCommand& options) {
  if (options.id == "list") return list(options);
  const auto& all = experiments();
  if (std::none_of(all.begin(), all.end(), [&](const Experiment& e) { return e.id == options.id; }))
    throw UsageError("ID '" + options.id + "': unknown experiment; expected " + known());
  const Experiment& chosen = experiment(options.id);
  options.progress("experiment " + chosen.id);
  const RanExperiment ran = run_experiment(chosen, {options.seed, options.runs, options.threads()});
  const Section section = experiment_section(ran);
  if (!options.out.empty())
    write_reports({{chosen.paper, chosen.title, {section}, {ran}}}, options.out, options.threads());
  options.end_progress();
  std::cout << (options.json ? experiment_json(ran) + "\n" : page(ran, section));
  if (!std::cout.flush()) throw std::runtime_error("cannot write to standard output");
  return ran.result.all_confirmed() ? done : failed;
}

}  // namespace

void add_experiment(CLI::App& app) {
  auto options = std::make_shared<ExperimentCommand>();
  CLI::App& command = add_command(app, "experiment", "Runs an experiment of a paper on seeded random data",
                                  "subcert experiment fig5 --seed 7", options, [=] { return run(*options); });
  command.add_option("ID", options->id, "An experiment, or 'list' (default)");
  command.add_option("--runs", options->runs, "Samples of the noise")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  command.get_option("--out")->description("Folder for index.html, tables and figures");
}

}  // namespace subcert::cli
