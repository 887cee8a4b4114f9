#include "experiment.hpp"

#include "families.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert {

std::string to_text(Finding finding) {
  switch (finding) {
    case Finding::confirmed:
      return "confirmed";
    case Finding::not_confirmed:
      return "not confirmed";
    case Finding::not_reproducible:
      return "not-reproducible";
  }
  throw std::invalid_argument("unknown finding");
}

bool ExperimentResult::all_confirmed() const {
  return std::none_of(claims.begin(), claims.end(), [](const Claim& c) { return c.finding == Finding::not_confirmed; });
}

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = [] {
    std::vector<Experiment> result;
    for (const auto& family : {function_experiments, curve_experiments, expected_error_experiments}) {
      const auto more = family();
      result.insert(result.end(), more.begin(), more.end());
    }
    return result;
  }();
  return all;
}

const Experiment& experiment(const std::string& id) {
  for (const Experiment& candidate : experiments())
    if (candidate.id == id) return candidate;
  throw std::out_of_range("unknown experiment '" + id + "'");
}

Section experiment_section(const Experiment& experiment, const ExperimentResult& result, const ExperimentOptions& options) {
  Section section{experiment.id, experiment.title, result.setup, {}, {}, result.figures};
  section.paragraphs.push_back("Seed " + std::to_string(options.seed) + ", " + std::to_string(options.runs) +
                               " samples of the noise; intervals are means with 95 % confidence (Student's t).");
  if (!result.claims.empty()) {
    PlainTable claims{experiment.id + "-claims", "What the paper says, and what decides it",
                      {"claim", "place", "statistic", "finding", "numbers"}, {}};
    for (const Claim& c : result.claims)
      claims.rows.push_back({c.sentence, c.place, c.statistic, to_text(c.finding), c.numbers});
    section.tables.push_back(claims);
  }
  section.tables.insert(section.tables.end(), result.tables.begin(), result.tables.end());
  return section;
}

std::string experiment_json(const Experiment& experiment, const ExperimentResult& result, const ExperimentOptions& options) {
  nlohmann::ordered_json json{{"experiment", experiment.id}, {"paper", experiment.paper}, {"title", experiment.title},
                              {"seed", options.seed},        {"runs", options.runs},      {"setup", result.setup},
                              {"claims", nlohmann::ordered_json::array()},
                              {"tables", nlohmann::ordered_json::array()}};
  for (const Claim& c : result.claims)
    json["claims"].push_back({{"claim", c.sentence},
                              {"place", c.place},
                              {"statistic", c.statistic},
                              {"finding", to_text(c.finding)},
                              {"numbers", c.numbers}});
  for (const PlainTable& table : result.tables)
    json["tables"].push_back({{"id", table.id}, {"title", table.title}, {"head", table.head}, {"rows", table.rows}});
  return json.dump(2);
}

}  // namespace subcert
