#pragma once
/// A report about one paper and its files.

#include "experiments/experiment.hpp"
#include "formats/section.hpp"
#include "row_proof.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace subcert::reports {

struct Report {
  std::string paper;
  std::string citation;
  std::vector<formats::Section> sections;
  std::vector<experiments::RanExperiment> experiments = {};
  bool listed = false;             ///< whether a terminal shows its tables whole
  std::size_t experiments_at = 0;  ///< the section before which those of the experiments stand

  std::vector<const formats::ComparisonTable*> comparison_tables() const;
  /// Whether all verdicts and findings are the recorded ones.
  bool as_recorded() const;
};

/// What to compute and how.
struct ReportOptions {
  std::vector<std::string> only = {};  ///< item ids; empty for all
  bool wants(const std::string& item) const {
    return only.empty() || std::find(only.begin(), only.end(), item) != only.end();
  }
  int jobs = 2;
  /// Called with a line about what is being done; may be empty.
  std::function<void(const std::string&)> progress = {};
  std::uint64_t seed = 1;             ///< of the experiments
  std::size_t runs = 50;              ///< samples of the noise in each experiment, more where they leave a claim open
  std::optional<double> budget = {};  ///< seconds for the exponent of each surface; nothing for those of the report
  Verified verified = bounds_alone;   ///< of the certificates on the page
  bool experiments = true;            ///< or later, by add_experiments()
};

/// The papers and collections that can be reproduced, those that are where none is named, and the items of each.
std::vector<std::string> reproducible_papers();
std::vector<std::string> default_papers();
/// Errors: throws a domain error for a paper that is not among them.
std::vector<std::string> report_items(const std::string& paper);

/// Recomputes the paper and compares. Errors: throws a domain error for an unknown paper or item.
Report make_report(const std::string& paper, const ReportOptions& options);

/// Runs the experiments of the paper that are wanted and puts their sections into its report. Precondition: the report
/// was made without them.
void add_experiments(Report& report, const ReportOptions& options);

}  // namespace subcert::reports
