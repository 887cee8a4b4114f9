#include "experiment.hpp"

#include "families.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace subcert::experiments {

bool ExperimentResult::all_confirmed() const {
  return std::none_of(claims.begin(), claims.end(), [](const Claim& c) { return c.finding == Verdict::not_confirmed; });
}

bool ExperimentResult::as_recorded() const {
  return std::all_of(claims.begin(), claims.end(), [](const Claim& c) { return c.finding == c.recorded; });
}

std::size_t ExperimentResult::count(Verdict finding) const {
  return static_cast<std::size_t>(
      std::count_if(claims.begin(), claims.end(), [&](const Claim& c) { return c.finding == finding; }));
}

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> all = [] {
    std::vector<Experiment> result;
    for (const auto& family :
         {expected_errors::all, functions::all, plane_curves::all, torus::all, part_scan::all, l1_experiments,
          nonlinear_polynomials::all, nonlinear_quiet::all, nonlinear_noise::all, nonlinear_surface::all,
          aary_limit_functions::all, aary_curves::all, aary_car::all, aary_surfaces::all}) {
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
  fail(ErrorKind::domain, "unknown experiment '{}'", id);
}

RanExperiment run_experiment(const Experiment& experiment, const ExperimentOptions& options) {
  return {&experiment, options, experiment.run(options)};
}

namespace {

formats::PlainTable claims_table(const RanExperiment& ran) {
  formats::PlainTable table{ran.experiment->id + "-claims",
                            "What the paper says, and what decides it",
                            {"claim", "place", "statistic", "finding", "numbers"},
                            {}};
  for (const Claim& c : ran.result.claims) {
    table.rows.push_back({c.sentence, c.place, c.statistic, to_text(c.finding), c.numbers});
    table.row_classes.push_back(c.finding == Verdict::confirmed       ? "match"
                                : c.finding == Verdict::not_confirmed ? "mismatch"
                                                                      : "open");
  }
  return table;
}

}  // namespace

formats::Section experiment_section(const RanExperiment& ran) {
  const ExperimentResult& result = ran.result;
  formats::Section section{ran.experiment->id, ran.experiment->title, result.setup, result.comparisons, {},
                           result.figures,     result.surface_figures};
  section.paragraphs.push_back(
      result.random ? "Seed " + std::to_string(ran.options.seed) + ", " + std::to_string(ran.options.runs) +
                          " samples of the noise; intervals are means with 95 % confidence (Student's t)."
                    : "Nothing here is random.");
  if (!result.claims.empty()) section.tables.push_back(claims_table(ran));
  section.tables.insert(section.tables.end(), result.tables.begin(), result.tables.end());
  return section;
}

std::string experiment_json(const RanExperiment& ran) {
  using Json = nlohmann::ordered_json;
  Json json{{"experiment", ran.experiment->id}, {"paper", ran.experiment->paper}, {"title", ran.experiment->title},
            {"seed", ran.options.seed},         {"runs", ran.options.runs},       {"setup", ran.result.setup},
            {"claims", Json::array()},          {"tables", Json::array()}};
  for (const Claim& c : ran.result.claims)
    json["claims"].push_back({{"claim", c.sentence},
                              {"place", c.place},
                              {"statistic", c.statistic},
                              {"finding", to_text(c.finding)},
                              {"recorded", to_text(c.recorded)},
                              {"numbers", c.numbers}});
  for (const formats::PlainTable& table : ran.result.tables)
    json["tables"].push_back({{"id", table.id}, {"title", table.title}, {"head", table.head}, {"rows", table.rows}});
  return json.dump(2);
}

}  // namespace subcert::experiments
