#include "experiment.hpp"

#include "papers.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/schemes/data/refine/axis_refinement.hpp>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace subcert {
extern const std::map<std::string, std::string_view> experiment_files;  // experiments.toml of each folder, by the build
}

namespace subcert::experiments {

const std::string& Run::chosen(const std::string& name) const {
  if (name == choice) return value;
  for (const Choice& one : experiment.choices)
    if (one.name == name) return one.taken;
  fail(ErrorKind::domain, "{}: there is no choice '{}'", experiment.id, name);
}

double Run::number(const std::string& name) const {
  const auto found = parse_number(chosen(name));
  require(found.has_value(), "{}: the choice '{}' is no number: '{}'", experiment.id, name, chosen(name));
  return data::nearest_double(*found);
}

bool ExperimentResult::as_recorded() const {
  const auto is_recorded = [](const DecidedClaim& c) { return c.finding == c.recorded; };
  return std::ranges::all_of(claims, is_recorded) && std::ranges::all_of(remarks, is_recorded);
}

std::size_t ExperimentResult::count(ClaimVerdict finding) const {
  return static_cast<std::size_t>(
      std::ranges::count_if(claims, [&](const DecidedClaim& c) { return c.finding == finding; }));
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

/// The printed table beside the errors of the schemes that its columns name, none of them reproducible.
formats::ComparisonTable printed_errors(const Experiment& experiment, const Measured& measured) {
  const statements::PublishedTable printed = statements::paper(experiment.paper).table(experiment.printed);
  formats::ComparisonTable table{experiment.paper, printed.id, printed.title, printed.place, printed.grid, {}};
  for (const statements::PublishedCell& cell : printed.cells) {
    const auto& errors = measured.at({"error", cell.column});
    table.comparisons.push_back({cell.row, cell.column, cell.scheme, cell.printed, mean_interval(errors).text(),
                                 ValueVerdict::not_reproducible, cell.recorded,
                                 "The printed value rests on one unpublished sample; over our samples the error runs "
                                 "from " +
                                     smallest_to_largest(errors) + "."});
  }
  return table;
}

/// The choices as taken, then each with each of its other values.
std::vector<Variant> measured_variants(const Experiment& experiment, const ExperimentOptions& options) {
  std::vector<Variant> result{{"", "", options.runs, experiment.measure({options, experiment})}};
  for (const Choice& choice : experiment.choices)
    for (const std::string& other : choice.others)
      result.push_back(
          {choice.name, other, options.runs, experiment.measure({options, experiment, choice.name, other})});
  return result;
}

std::vector<DecidedClaim> decided_claims(const Experiment& experiment, const std::vector<Variant>& variants) {
  std::vector<DecidedClaim> result;
  for (const Claim& claim : experiment.claims) try {
      result.push_back(decided(claim, variants));
    } catch (const Error& error) {
      fail(error.kind(), "{}: claim '{}': {}", experiment.id, claim.sentence, error.what());
    }
  return result;
}

/// The names of the variants that leave a claim open.
std::set<std::string> open_variants(const std::vector<DecidedClaim>& claims) {
  std::set<std::string> result;
  for (const DecidedClaim& claim : claims) {
    for (const DecidedReading& reading : claim.readings) {
      if (!is_open(claim, reading)) continue;
      for (const VariantFinding& one : reading.findings)
        if (one.finding.truth == Truth::unknown) result.insert(one.variant);
    }
  }
  return result;
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

/// Other readings of the claims, and sentences that another experiment counts.
formats::PlainTable remarks_table(const RanExperiment& ran) {
  formats::PlainTable table{ran.experiment->id + "-remarks",
                            "Remarks: other readings, and sentences that are counted elsewhere",
                            {"sentence", "read as", "found", "numbers"},
                            {}};
  const auto add = [&](const DecidedClaim& claim, std::size_t from) {
    for (std::size_t i = from; i < claim.readings.size(); ++i) {
      const DecidedReading& r = claim.readings[i];
      table.rows.push_back({claim.sentence + (claim.counted_in.empty() ? "" : " (" + claim.counted_in + ")"),
                            r.read_as().empty() ? r.findings.front().finding.statistic : r.read_as(),
                            to_text(r.verdict), r.numbers()});
    }
  };
  for (const DecidedClaim& claim : ran.result.claims) add(claim, 1);
  for (const DecidedClaim& claim : ran.result.remarks) add(claim, 0);
  return table;
}

/// What the paper leaves open.
formats::PlainTable choices_table(const Experiment& experiment) {
  formats::PlainTable table{experiment.id + "-choices",
                            "What the paper leaves open",
                            {"choice", "what the paper says", "taken", "tried beside it"},
                            {}};
  for (const Choice& c : experiment.choices)
    table.rows.push_back({c.name, c.open, c.taken, fmt::format("{}", fmt::join(c.others, "; "))});
  return table;
}

/// Each claim with each choice.
formats::PlainTable variants_table(const RanExperiment& ran) {
  formats::PlainTable table{ran.experiment->id + "-variants",
                            "What each choice gives",
                            {"claim", "choice", "samples", "shown", "numbers"},
                            {}};
  for (const DecidedClaim& claim : ran.result.claims)
    for (const VariantFinding& f : claim.readings.front().findings)
      table.rows.push_back(
          {claim.sentence, f.variant, std::to_string(f.runs), to_text(f.finding.truth), f.finding.numbers});
  return table;
}

nlohmann::ordered_json claim_json(const DecidedClaim& c) {
  nlohmann::ordered_json json{{"claim", c.sentence},
                              {"place", c.place},
                              {"statistic", c.statistic},
                              {"finding", to_text(c.finding)},
                              {"recorded", to_text(c.recorded)},
                              {"numbers", c.numbers}};
  if (!c.counted_in.empty()) json["counted in"] = c.counted_in;
  json["readings"] = nlohmann::ordered_json::array();
  for (const DecidedReading& r : c.readings) {
    nlohmann::ordered_json choices = nlohmann::ordered_json::array();
    for (const VariantFinding& f : r.findings)
      choices.push_back({{"choice", f.variant},
                         {"runs", f.runs},
                         {"shown", to_text(f.finding.truth)},
                         {"numbers", f.finding.numbers}});
    json["readings"].push_back({{"read as", r.words},
                                {"late", r.late},
                                {"weaker", r.weaker},
                                {"finding", to_text(r.verdict)},
                                {"statistic", r.findings.front().finding.statistic},
                                {"choices", choices}});
  }
  return json;
}

}  // namespace

RanExperiment run_experiment(const Experiment& experiment, const ExperimentOptions& options) {
  ExperimentOptions first = options;
  first.runs *= experiment.times;
  std::vector<Variant> variants = measured_variants(experiment, first);
  std::vector<DecidedClaim> claims = decided_claims(experiment, variants);
  for (const std::size_t times : patience) {
    const auto open = open_variants(claims);
    if (!experiment.random || open.empty()) break;
    ExperimentOptions more = first;
    more.runs *= times;
    for (Variant& variant : variants)
      if (open.contains(variant.name()))
        variant = {variant.choice, variant.value, more.runs,
                   experiment.measure({more, experiment, variant.choice, variant.value})};
    claims = decided_claims(experiment, variants);
  }
  Measured& measured = variants.front().measured;
  ExperimentResult result;
  result.runs = variants.front().runs;
  for (const std::string& text : experiment.setup) result.setup.push_back(measured.filled(text));
  for (DecidedClaim& claim : claims)
    (claim.counted_in.empty() ? result.claims : result.remarks).push_back(std::move(claim));
  if (!experiment.printed.empty()) result.comparisons.push_back(printed_errors(experiment, measured));
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
  const auto samples = [](std::size_t runs) { return std::to_string(runs) + " samples of the noise"; };
  section.paragraphs.push_back(!ran.experiment->random
                                   ? "Nothing here is random."
                                   : "Seed " + std::to_string(ran.options.seed) + ", " + samples(result.runs) +
                                         (result.runs > ran.options.runs
                                              ? ", as " + std::to_string(ran.options.runs) + " left a claim open"
                                              : "") +
                                         "; intervals are means with 95 % confidence (Student's t); those that decide "
                                         "a claim hold together with "
                                         "99 %.");
  if (!result.claims.empty()) section.tables.push_back(claims_table(ran));
  if (auto remarks = remarks_table(ran); !remarks.rows.empty()) section.tables.push_back(std::move(remarks));
  if (!ran.experiment->choices.empty())
    section.tables.insert(section.tables.end(), {choices_table(*ran.experiment), variants_table(ran)});
  section.tables.insert(section.tables.end(), result.tables.begin(), result.tables.end());
  return section;
}

nlohmann::ordered_json experiment_json(const RanExperiment& ran) {
  using Json = nlohmann::ordered_json;
  Json json{{"experiment", ran.experiment->id}, {"paper", ran.experiment->paper}, {"title", ran.experiment->title},
            {"seed", ran.options.seed},         {"runs", ran.options.runs},       {"samples", ran.result.runs},
            {"setup", ran.result.setup},        {"choices", Json::array()},       {"claims", Json::array()},
            {"remarks", Json::array()},         {"tables", Json::array()}};
  for (const Choice& c : ran.experiment->choices)
    json["choices"].push_back({{"choice", c.name}, {"open", c.open}, {"taken", c.taken}, {"others", c.others}});
  for (const DecidedClaim& c : ran.result.claims) json["claims"].push_back(claim_json(c));
  for (const DecidedClaim& c : ran.result.remarks) json["remarks"].push_back(claim_json(c));
  for (const formats::PlainTable& table : ran.result.tables)
    json["tables"].push_back({{"id", table.id}, {"title", table.title}, {"head", table.head}, {"rows", table.rows}});
  return json;
}

}  // namespace subcert::experiments
