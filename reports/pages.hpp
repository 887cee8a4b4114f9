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

/// By paper: first what holds, then what fails at an edge only, then what to correct, each fault with what follows from
/// it, and what cannot be checked. Beside a statement stand the claims among `results` that are about the same
/// sentences, with their verdicts; without them, the commands that decide them.
std::string errata_page(const std::vector<CheckedStatement>& checked, const std::vector<Result>& results);

struct ScreenOptions {
  bool colours = false;  ///< escape sequences of a terminal
  std::string folder;    ///< where the page was written; empty where there is none
  double seconds = 0;    ///< that the run took
};

/// A few lines a paper, the findings that matter, where the pages are and how long it took: at most 45 lines of at most
/// 100 characters, but for verdicts that are not the recorded ones, of which up to ten are named.
std::string first_screen(const Findings& findings, const ScreenOptions& options);

/// Every table and experiment with its counts, then everything that does not match, does not hold or is not confirmed:
/// a line each, or lines of the width of a screen. What follows from other values is counted alone.
std::string full_list(const Findings& findings, std::size_t width = std::string::npos);

}  // namespace subcert::reports
