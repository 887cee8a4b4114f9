#pragma once
/// Experiments with random noise, and what they say about the claims that a paper makes.

#include "claim.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string_view>

namespace subcert::experiments {

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
  std::vector<std::string> setup;  ///< how the data are made; {name} is a measured number
  std::vector<Choice> choices;     ///< what the paper leaves open and verdicts may hang on
  std::vector<Claim> claims;
  std::string printed;  ///< the paper's table of errors that rest on its unpublished data
  bool random;          ///< whether seed and samples matter
  Measure measure;
  std::size_t times = 1;  ///< samples for each one of the other experiments
};

/// One measurement: the choices as taken, or one of them with another value.
struct Run : ExperimentOptions {
  const Experiment& experiment;
  std::string choice = {};  ///< empty as taken
  std::string value = {};

  /// Whether a choice is not the one taken: then tables, figures and what no claim names are not wanted.
  bool is_alternative() const { return !choice.empty(); }
  /// The value of the choice of this name. Errors: throws a domain error where the experiment has none.
  const std::string& chosen(const std::string& name) const;
  /// The same as a number. Errors: throws a domain error where it is none, too.
  double number(const std::string& name) const;
};

struct ExperimentResult {
  std::vector<std::string> setup = {};
  std::size_t runs = 0;                    ///< samples as taken, after an open question had more
  std::vector<DecidedClaim> claims = {};   ///< those that count here
  std::vector<DecidedClaim> remarks = {};  ///< on sentences that another experiment counts
  std::vector<formats::PlainTable> tables = {};
  std::vector<formats::Figure> figures = {};
  std::vector<formats::SurfaceFigure> surface_figures = {};
  std::vector<formats::ComparisonTable> comparisons = {};  ///< printed values beside ours, where the paper prints any

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

/// Measures with every choice as taken and with each other value of one of them, and decides the claims. What is open
/// is measured again with `patience` times the samples. Domain: options.runs >= 2. Errors: throws a domain error
/// that names the claim and what it names but was not measured.
RanExperiment run_experiment(const Experiment& experiment, const ExperimentOptions& options);

/// The name of the link to the claim with this index, unique over all papers.
std::string claim_key(const Experiment& experiment, std::size_t index);

/// As a section of a page: the setup, the claims as a table, and the experiment's tables and figures.
formats::Section experiment_section(const RanExperiment& ran);

/// {"experiment", "paper", "title", "seed", "runs", "setup", "claims", "tables"}
nlohmann::ordered_json experiment_json(const RanExperiment& ran);

}  // namespace subcert::experiments
