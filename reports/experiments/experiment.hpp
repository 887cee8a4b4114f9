#pragma once
/// Experiments with random noise, and what they say about the claims that a paper makes.

#include "measured.hpp"

#include <cstdint>

namespace subcert::experiments {

/// A sentence of a paper, and the relation between measured quantities that decides it.
struct Claim {
  std::string sentence;
  std::string place;
  Relation relation;
  /// What this version of the toolkit is known to find with the default seed.
  Verdict recorded = Verdict::confirmed;
};

/// A claim with what was found.
struct DecidedClaim {
  std::string sentence;
  std::string place;
  std::string statistic;
  Verdict finding;
  std::string numbers;
  Verdict recorded = Verdict::confirmed;
};

struct ExperimentOptions {
  std::uint64_t seed = 1;
  std::size_t runs = 200;  ///< samples of the noise
  int jobs = 2;
};

struct Experiment {
  std::string id;  ///< unique over all papers
  std::string title;
  std::vector<std::string> setup;  ///< what the paper leaves open and how it was chosen
  std::vector<Claim> claims;
  std::vector<MeansTable> tables = {};
  /// Measures `options.runs` samples and draws the first. The same seed and runs give the same for any number of jobs.
  std::function<Measured(const ExperimentOptions& options)> measure = {};
  std::string printed = {};  ///< the paper's table of errors that rest on its unpublished data
  bool random = true;        ///< whether seed and samples matter
  std::string paper = {};    ///< key
};

struct ExperimentResult {
  std::vector<DecidedClaim> claims = {};
  std::vector<formats::PlainTable> tables = {};
  std::vector<formats::Figure> figures = {};
  std::vector<formats::SurfaceFigure> surface_figures = {};
  std::vector<formats::ComparisonTable> comparisons = {};  ///< printed values beside ours, where the paper prints any

  bool all_confirmed() const;
  bool as_recorded() const;
  std::size_t count(Verdict finding) const;
};

/// All experiments, by paper and place.
const std::vector<Experiment>& experiments();
/// Errors: throws a domain error for an unknown id.
const Experiment& experiment(const std::string& id);

/// An experiment with its outcome.
struct RanExperiment {
  const Experiment* experiment;
  ExperimentOptions options;
  ExperimentResult result;
};

/// Measures, decides the claims and fills the tables. Domain: options.runs >= 2.
RanExperiment run_experiment(const Experiment& experiment, const ExperimentOptions& options);

/// As a section of a page: the setup, the claims as a table, and the experiment's tables and figures.
formats::Section experiment_section(const RanExperiment& ran);

/// {"experiment", "paper", "title", "seed", "runs", "setup", "claims", "tables"} as text.
std::string experiment_json(const RanExperiment& ran);

}  // namespace subcert::experiments
