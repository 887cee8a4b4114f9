#pragma once
/// Experiments with random noise, and what they say about the claims that a paper makes.

#include "measured.hpp"

#include <cstdint>
#include <string_view>

namespace subcert::experiments {

/// A sentence of a paper, and the relation between measured quantities that decides it.
struct Claim {
  std::string sentence;
  std::string place;
  Relation relation;
  /// What this version of the toolkit is known to find with the default seed.
  ClaimVerdict recorded = ClaimVerdict::holds;
};

/// A claim with what was found.
struct DecidedClaim {
  std::string sentence;
  std::string place;
  ClaimVerdict finding;
  std::string statistic;
  std::string numbers;
  ClaimVerdict recorded = ClaimVerdict::holds;
};

struct ExperimentOptions {
  std::uint64_t seed = 1;
  std::size_t runs = 200;  ///< samples of the noise
  int jobs = 2;
};

struct Run;
/// Measures `run.runs` samples and draws the first. The same seed and runs give the same for any number of jobs.
using Measure = std::function<Measured(const Run& run)>;
/// By the id of the experiment.
using Measures = std::vector<std::pair<std::string, Measure>>;

/// What experiments.toml says of it, and its function.
struct Experiment {
  std::string id;  ///< unique over all papers
  std::string paper;
  std::string title;
  std::vector<std::string> setup;  ///< what the paper leaves open and how it was chosen; {name} is a measured number
  std::vector<Claim> claims;
  std::string printed;  ///< the paper's table of errors that rest on its unpublished data
  bool random;          ///< whether seed and samples matter
  Measure measure;
};

struct Run : ExperimentOptions {
  const Experiment& experiment;
};

struct ExperimentResult {
  std::vector<std::string> setup = {};
  std::vector<DecidedClaim> claims = {};
  std::vector<formats::PlainTable> tables = {};
  std::vector<formats::Figure> figures = {};
  std::vector<formats::SurfaceFigure> surface_figures = {};
  std::vector<formats::ComparisonTable> comparisons = {};  ///< printed values beside ours, where the paper prints any

  bool all_confirmed() const;
  bool as_recorded() const;
  std::size_t count(ClaimVerdict finding) const;
};

/// Reads an experiments.toml as docs/experiments.md describes it. Errors: throws FileError for what is no TOML, an
/// unknown or missing key, a value of the wrong kind, an id that is there twice, and for experiments without measure
/// and measures without experiment, by their ids.
std::vector<Experiment> read_experiments(const std::string& paper, std::string_view text, const Measures& measures);

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

/// Measures and decides the claims. Domain: options.runs >= 2. Errors: throws a domain error that names the claim and
/// what it names but was not measured.
RanExperiment run_experiment(const Experiment& experiment, const ExperimentOptions& options);

/// The name of the link to the claim with this index, unique over all papers.
std::string claim_key(const Experiment& experiment, std::size_t index);

/// As a section of a page: the setup, the claims as a table, and the experiment's tables and figures.
formats::Section experiment_section(const RanExperiment& ran);

/// {"experiment", "paper", "title", "seed", "runs", "setup", "claims", "tables"} as text.
std::string experiment_json(const RanExperiment& ran);

}  // namespace subcert::experiments
