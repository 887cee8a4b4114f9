#pragma once
/// A report about one paper and its files.

#include "comparison.hpp"
#include "figure.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace subcert {

/// A table of our own, without printed counterpart.
struct PlainTable {
  std::string id;
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};

/// One part of the page. Items that were not asked for have no section.
struct Section {
  std::string id;
  std::string heading;
  std::vector<std::string> paragraphs;
  std::vector<ComparisonTable> comparisons = {};
  std::vector<PlainTable> tables = {};
  std::vector<Figure> figures = {};
};

struct Report {
  std::string paper;
  std::string citation;
  std::vector<Section> sections;

  std::vector<const ComparisonTable*> comparison_tables() const;
  bool as_recorded() const;
};

/// What to compute and how.
struct ReportOptions {
  std::vector<std::string> only = {};  ///< item ids; empty for all
  int jobs = 2;
  /// Called with a line about what is being done; may be empty.
  std::function<void(const std::string&)> progress = {};
};

/// The papers that can be reproduced, and the items of each.
std::vector<std::string> reproducible_papers();
/// Errors: throws std::out_of_range for a paper that is not among them.
std::vector<std::string> report_items(const std::string& paper);

/// Recomputes the paper and compares. Errors: throws std::out_of_range for an unknown paper or item.
Report make_report(const std::string& paper, const ReportOptions& options);

/// Writes DIR/index.html for the reports, with a link to DIR/errata.html where that is there, and for each table
/// DIR/PAPER/ID.csv, .tex, .json, for each figure .svg, .png
/// and .csv. Errors: throws std::runtime_error that names the file.
void write_reports(const std::vector<Report>& reports, const std::filesystem::path& folder);

/// {"comparisons": [...]} as in the contract.
std::string comparisons_json(const std::vector<Report>& reports);

}  // namespace subcert
