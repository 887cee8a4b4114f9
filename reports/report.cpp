#include "report.hpp"

#include "collections.hpp"

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace subcert::reports {
namespace {

/// What holds more than experiments.
struct SpecialReport {
  std::vector<std::string> items;
  Report (*make)(const ReportOptions&);
};

const SpecialReport* special_report(const std::string& paper) {
  static const std::map<std::string, SpecialReport> all{
      {"dyn-2015", {dyn_2015_items(), report_dyn_2015}},
      {"surfaces", {{"least-squares", "tensor-products"}, report_least_squares_surfaces}},
      {"bivariate", {{"published", "schemes"}, report_bivariate}},
      {"families", {{"ranges"}, report_families}},
      {"daubechies", {{"published", "exponents"}, report_daubechies}},
      {"jsr", {{"published", "families"}, report_joint_spectral_radii}},
      {"levels", {{"published", "intervals", "recurrences", "lists", "points"}, report_levels}},
      {"vectors", {{"published", "functions"}, report_vectors}},
      {"vertices", {{"published", "schemes", "valences", "fits"}, report_vertices}},
  };
  const auto found = all.find(paper);
  return found == all.end() ? nullptr : &found->second;
}

}  // namespace

std::vector<const formats::ComparisonTable*> Report::comparison_tables() const {
  std::vector<const formats::ComparisonTable*> result;
  for (const formats::Section& section : sections)
    for (const formats::ComparisonTable& table : section.comparisons) result.push_back(&table);
  return result;
}

bool Report::as_recorded() const {
  const auto tables = comparison_tables();
  return std::all_of(tables.begin(), tables.end(),
                     [](const formats::ComparisonTable* table) { return table->as_recorded(); }) &&
         std::all_of(experiments.begin(), experiments.end(),
                     [](const experiments::RanExperiment& e) { return e.result.as_recorded(); });
}

std::vector<std::string> default_papers() {
  std::vector<std::string> result = statements::paper_keys();
  result.push_back("surfaces");
  return result;
}

std::vector<std::string> reproducible_papers() {
  std::vector<std::string> result = default_papers();
  result.insert(result.end(), statements::collection_keys().begin(), statements::collection_keys().end());
  return result;
}

std::vector<std::string> report_items(const std::string& paper) {
  if (const SpecialReport* special = special_report(paper)) return special->items;
  const auto papers = reproducible_papers();
  if (std::find(papers.begin(), papers.end(), paper) != papers.end()) return experiment_ids(paper);
  fail(ErrorKind::domain, "unknown paper '{}'", paper);
}

Report make_report(const std::string& paper, const ReportOptions& options) {
  const auto items = report_items(paper);
  for (const std::string& item : options.only)
    require(std::find(items.begin(), items.end(), item) != items.end(), "unknown item '{}' of {}", item, paper);
  const SpecialReport* special = special_report(paper);
  Report report = special ? special->make(options) : Report{paper, statements::citation(paper), {}};
  if (options.experiments) add_experiments(report, options);
  return report;
}

std::vector<std::string> experiment_ids(const std::string& paper) {
  std::vector<std::string> result;
  for (const experiments::Experiment& candidate : experiments::experiments())
    if (candidate.paper == paper) result.push_back(candidate.id);
  return result;
}

void add_experiments(Report& report, const ReportOptions& options) {
  std::vector<formats::Section> sections;
  for (const std::string& id : experiment_ids(report.paper)) {
    if (!options.wants(id)) continue;
    if (options.progress) options.progress(id);
    report.experiments.push_back(
        experiments::run_experiment(experiments::experiment(id), {options.seed, options.runs, options.jobs}));
    sections.push_back(experiments::experiment_section(report.experiments.back()));
  }
  report.sections.insert(report.sections.begin() + static_cast<std::ptrdiff_t>(report.experiments_at),
                         std::make_move_iterator(sections.begin()), std::make_move_iterator(sections.end()));
}

}  // namespace subcert::reports
