#pragma once
/// What `subcert reproduce` says in a terminal: a first screen, and the full list for a file.

#include "results.hpp"

#include <string>

namespace subcert::reports {

struct ScreenOptions {
  bool colours = false;  ///< escape sequences of a terminal
  std::string folder;    ///< where the page was written; empty where there is none
  double seconds = 0;    ///< that the run took
};

/// A few lines a paper, the findings that matter, where the pages are and how long it took: at most 45 lines of at most
/// 100 characters, but for verdicts that are not the recorded ones, of which up to ten are named.
std::string first_screen(const Findings& findings, const ScreenOptions& options);

/// Every table and experiment with its counts, then everything that does not match, does not hold or is not confirmed.
std::string full_list(const Findings& findings);

}  // namespace subcert::reports
