#pragma once
/// The pages of a run.

#include "results.hpp"

#include <string>
#include <vector>

namespace subcert::reports {

/// index.html: what was checked, how much of it holds, what matters, and the way to everything else.
std::string front_page(const Findings& findings);

/// PAPER.html: its results in short, then its tables, figures and experiments. `own`: the results of this report.
std::string report_page(const Report& report, const std::vector<Result>& own);

/// results.html: every result of every report, to be searched and filtered.
std::string results_page(const std::vector<Result>& results);

/// How many values, statements and claims are right, as bars with links to the list of them; of one paper or of all.
std::string score_bars(const std::vector<Result>& results, const std::string& paper = "");

}  // namespace subcert::reports
