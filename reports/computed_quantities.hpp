#pragma once
/// What the items of the report on Dyn, Heard, Hormann & Sharon 2015 share: schemes, certified numbers, comparisons.

#include "report.hpp"

#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/variance/variance_range.hpp>
#include <subcert/proofs-checks/papers/dyn-2015/checks.hpp>
#include <subcert/proofs-checks/papers/dyn-2015/numerical_recipe.hpp>
#include <subcert/proofs-checks/papers/registry.hpp>
#include <subcert/proofs-checks/statements/computed.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace subcert::reports {

inline constexpr int holder_levels = 16;  ///< as in the paper
inline constexpr int plot_level = 7;      ///< of the drawn curves

/// To the nearest, with this many places.
std::string decimal(const Rational& value, int places);

/// A variance curve on an exact grid, whose points are the witnesses, and enclosed between them.
struct VarianceFacts {
  Rational largest, largest_at;
  Enclosure maximum, minimum, slope;
  Rational steepest;
  std::string steepest_at;
};

VarianceFacts variance_facts(const std::string& specification);

/// Makes what the map does not have yet of these names, in parallel, and says which.
template <class Map, class Make>
void make_missing(Map& map, const std::vector<std::string>& names, const ReportOptions& options, const Make& make) {
  std::vector<typename Map::value_type*> missing;
  for (const std::string& name : names) {
    const auto [entry, fresh] = map.try_emplace(name);
    if (fresh) missing.push_back(&*entry);
  }
  parallel_tasks(missing.size(), options.jobs, [&](std::size_t i) {
    if (options.progress) options.progress(missing[i]->first);
    missing[i]->second = make(missing[i]->first);
  });
}

/// Certified numbers, each computed once.
class ComputedQuantities {
 public:
  explicit ComputedQuantities(const ReportOptions& options);

  const statements::Paper& paper() const { return paper_; }
  const statements::PublishedTable& published(const std::string& id) const { return paper_.table(id); }
  int jobs() const { return options_.jobs; }
  void say(const std::string& line) const {
    if (options_.progress) options_.progress(line);
  }

  /// Make what is missing, in parallel.
  void need_bounds(const std::vector<std::string>& specifications);
  const HolderBounds& bounds(const std::string& specification) const { return *bounds_.at(specification); }

  /// Enclosures of the exponents.
  void need_exponents(const std::vector<std::string>& specifications, double seconds = 60);
  const HolderRegularity& exponent(const std::string& specification) const { return *exponents_.at(specification); }

  void need_variance(const std::vector<std::string>& specifications);
  const VarianceFacts& variance(const std::string& specification) const { return *variance_.at(specification); }

  /// The recipes behind Table 3.
  const statements::dyn_2015::NumericalRecipeSearch& recipes();

 private:
  const ReportOptions& options_;
  const statements::Paper& paper_;
  std::map<std::string, std::optional<HolderBounds>> bounds_;
  std::map<std::string, std::optional<HolderRegularity>> exponents_;
  std::map<std::string, std::optional<VarianceFacts>> variance_;
  std::optional<statements::dyn_2015::NumericalRecipeSearch> recipes_;
};

formats::ComparisonTable empty_table(const statements::PublishedTable& table, const std::string& paper = "dyn-2015");

/// Adds the table of a collection with each cell compared, and the sentence that counts the verdicts.
void add_published(formats::Section& section, const std::string& collection,
                   const statements::PublishedTable& published,
                   const std::function<formats::Comparison(const statements::PublishedCell&)>& compare, int jobs = 1);

/// The report on a collection of published values: one section.
Report collection_report(const std::string& collection, formats::Section section);

/// `[KEY] reference`; empty where the cell is of a paper's own table.
std::string source_text(const statements::PublishedCell& cell);

/// What is on record, given what was found: in a collection an open value may be decided by more time or a faster
/// machine (docs/comparison.md).
ValueVerdict recorded_verdict(const statements::PublishedCell& cell, ValueVerdict found);

/// What a reader types to see this value again; empty where only the table as a whole can be computed.
std::string command_of(const statements::PublishedCell& cell);

formats::Comparison compare_number(const statements::PublishedCell& cell, const Enclosure& computed,
                                   const std::string& note = "");

/// Of an exponent or a class, with the reason where it is open.
formats::Comparison compare_smoothness(const statements::PublishedCell& cell, const std::string& specification,
                                       const MultivariateRegularity& regularity);

/// yes is a match, no a mismatch.
formats::Comparison compare_text(const statements::PublishedCell& cell, const std::string& computed, Truth equal);

std::vector<std::string> schemes_of(const statements::PublishedTable& table);

/// "20 of 44 printed values match, ...".
std::string verdict_sentence(const formats::ComparisonTable& table);

}  // namespace subcert::reports
