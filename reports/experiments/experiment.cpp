#include "experiment.hpp"

#include "papers.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace subcert {
extern const std::map<std::string, std::string_view> experiment_files;  // experiments.toml of each folder, by the build
}

namespace subcert::experiments {

bool ExperimentResult::all_confirmed() const {
  return std::none_of(claims.begin(), claims.end(),
                      [](const DecidedClaim& c) { return c.finding == ClaimVerdict::contrary; });
}

bool ExperimentResult::as_recorded() const {
  return std::all_of(claims.begin(), claims.end(), [](const DecidedClaim& c) { return c.finding == c.recorded; });
}

std::size_t ExperimentResult::count(ClaimVerdict finding) const {
  return static_cast<std::size_t>(
      std::count_if(claims.begin(), claims.end(), [&](const DecidedClaim& c) { return c.finding == finding; }));
}

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> every = [] {
    const std::pair<const char*, Measures (*)()> papers[]{{"dyn-2015", dyn_2015::measures},
                                                          {"mustafa-li-2015", mustafa_li_2015::measures},
                                                          {"mustafa-hameed", mustafa_hameed::measures},
                                                          {"mustafa-bari-2016", mustafa_bari_2016::measures}};
    std::vector<Experiment> result;
    for (const auto& [paper, measures] : papers) try {
        const std::vector<Experiment> read = read_experiments(paper, experiment_files.at(paper), measures());
        result.insert(result.end(), read.begin(), read.end());
      } catch (const Error& error) {
        fail(error.kind(), "experiments/{}/experiments.toml: {}", paper, error.what());
      }
    return result;
  }();
  return every;
}

const Experiment& experiment(const std::string& id) {
  for (const Experiment& candidate : experiments())
    if (candidate.id == id) return candidate;
  fail(ErrorKind::domain, "unknown experiment '{}'", id);
}

namespace {

std::string smallest_to_largest(const std::vector<double>& values) {
  const auto [least, largest] = std::minmax_element(values.begin(), values.end());
  return short_number(*least) + " to " + short_number(*largest);
}

/// Adds the printed table beside the errors of the schemes that its columns name, none of them reproducible, and the
/// claim that says so.
void add_printed_errors(ExperimentResult& result, const Experiment& experiment, const Measured& measured) {
  const statements::PublishedTable printed = statements::paper(experiment.paper).table(experiment.printed);
  DecidedClaim claim{"The errors of " + printed.title + ".",
                     printed.place,
                     ClaimVerdict::own_data,
                     "the data were not published; the printed values beside the range over our samples",
                     "",
                     ClaimVerdict::own_data};
  formats::ComparisonTable table{experiment.paper, printed.id, printed.title, printed.place, printed.grid, {}};
  for (const statements::PublishedCell& cell : printed.cells) {
    const auto& errors = measured.at({"error", cell.column});
    const std::string range = smallest_to_largest(errors);
    claim.numbers += (claim.numbers.empty() ? "" : "; ") + cell.column + ": printed " + cell.printed + ", ours " +
                     range;
    table.comparisons.push_back(
        {cell.row, cell.column, cell.scheme, cell.printed, mean_interval(errors).text(), ValueVerdict::not_reproducible,
         cell.recorded,
         "The printed value rests on one unpublished sample; over our samples the error runs from " + range + "."});
  }
  result.claims.push_back(claim);
  result.comparisons.push_back(table);
}

formats::PlainTable claims_table(const RanExperiment& ran) {
  formats::PlainTable table{ran.experiment->id + "-claims",
                            "What the paper says, and what decides it",
                            {"claim", "place", "statistic", "finding", "numbers"},
                            {}};
  for (const DecidedClaim& c : ran.result.claims) {
    table.rows.push_back({c.sentence, c.place, c.statistic, to_text(c.finding), c.numbers});
    table.row_classes.push_back(c.finding == ClaimVerdict::holds      ? "match"
                                : c.finding == ClaimVerdict::contrary ? "mismatch"
                                                                      : "open");
    table.row_ids.push_back(claim_key(*ran.experiment, table.row_ids.size()));
  }
  return table;
}

}  // namespace

RanExperiment run_experiment(const Experiment& experiment, const ExperimentOptions& options) {
  Measured measured = experiment.measure({options, experiment});
  ExperimentResult result;
  for (const std::string& text : experiment.setup) result.setup.push_back(measured.filled(text));
  for (const auto& [sentence, place, relation, recorded] : experiment.claims) try {
      const auto [verdict, statistic, numbers] = relation(measured);
      result.claims.push_back({sentence, place, verdict, statistic, numbers, recorded});
    } catch (const Error& error) {
      fail(error.kind(), "{}: claim '{}': {}", experiment.id, sentence, error.what());
    }
  if (!experiment.printed.empty()) add_printed_errors(result, experiment, measured);
  result.tables = std::move(measured.tables);
  result.figures = std::move(measured.figures);
  result.surface_figures = std::move(measured.surface_figures);
  return {&experiment, options, std::move(result)};
}

std::string claim_key(const Experiment& experiment, std::size_t index) {
  return fmt::format("{}-{}-claim-{}", experiment.paper, experiment.id, index + 1);
}

formats::Section experiment_section(const RanExperiment& ran) {
  const ExperimentResult& result = ran.result;
  formats::Section section{ran.experiment->id, ran.experiment->title, result.setup, result.comparisons, {},
                           result.figures,     result.surface_figures};
  section.paragraphs.push_back(
      ran.experiment->random ? "Seed " + std::to_string(ran.options.seed) + ", " + std::to_string(ran.options.runs) +
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
  for (const DecidedClaim& c : ran.result.claims)
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
