#pragma once
/// Experiments with random noise, and what they say about the claims that a paper makes.

#include <subcert/reports/report.hpp>

#include <cstdint>

namespace subcert {

/// not_confirmed: the statistic does not show the claim; its numbers say whether it shows the contrary.
enum class Finding { confirmed, not_confirmed, not_reproducible };

std::string to_text(Finding finding);

/// A sentence of a paper and the statistic that decides it.
struct Claim {
  std::string sentence;
  std::string place;
  std::string statistic;
  Finding finding;
  std::string numbers;
};

struct ExperimentOptions {
  std::uint64_t seed = 1;
  std::size_t runs = 200;  ///< samples of the noise
  int jobs = 2;
};

struct ExperimentResult {
  std::vector<std::string> setup;  ///< what the paper leaves open and how it was chosen
  std::vector<Claim> claims = {};
  std::vector<PlainTable> tables = {};
  std::vector<Figure> figures = {};

  bool all_confirmed() const;
};

struct Experiment {
  std::string id;     ///< unique over all papers
  std::string paper;  ///< key
  std::string title;
  std::function<ExperimentResult(const ExperimentOptions&)> run;
};

/// All experiments, by paper and place.
const std::vector<Experiment>& experiments();
/// Errors: throws std::out_of_range for an unknown id.
const Experiment& experiment(const std::string& id);

/// As a section of a page: the setup, the claims as a table, and the experiment's tables and figures.
/// Domain: options.runs >= 2. The same seed and runs give the same numbers for any number of jobs.
Section experiment_section(const Experiment& experiment, const ExperimentResult& result, const ExperimentOptions& options);

/// {"experiment", "paper", "title", "seed", "runs", "setup", "claims", "tables"} as text.
std::string experiment_json(const Experiment& experiment, const ExperimentResult& result, const ExperimentOptions& options);

}  // namespace subcert
