#pragma once
/// What a run writes.

#include "baseline.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <set>
#include <string>
#include <utility>

namespace subcert::reports {

/// Sections with their papers.
using Written = std::set<std::pair<std::string, std::string>>;
Written written(const Findings& findings);

/// Writes DIR/index.html, DIR/PAPER.html for each report, DIR/results.html and DIR/results.json with everything that
/// was found, DIR/errata.html where statements were checked, in DIR/docs the documents that they name; for each table
/// DIR/PAPER/ID.csv, .tex, .json, for each figure .svg, .png and .csv; for each certificate DIR/PAPER/NAME and NAME.js,
/// which the page reads. Domain: jobs >= 1, the pictures drawn at a time. `before`: what this run wrote there already,
/// whose pictures stand. Errors: throws missing_file that names the file.
void write_reports(const Findings& findings, const std::filesystem::path& folder, int jobs, const Written& before = {});

/// {"counts": ..., "comparisons": [...], "experiments": [...], "tables": [...]} as in the contract; the experiments are
/// those of experiment_json(), the tables those without printed counterpart. With an earlier run beside it also
/// "changes": [{"key", "change", "matters"}].
nlohmann::ordered_json reports_json(const std::vector<Report>& reports,
                                    const std::optional<std::vector<Change>>& changed = {});

}  // namespace subcert::reports
