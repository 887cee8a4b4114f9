#pragma once
/// What changed against an earlier run, result by result.

#include "results.hpp"

#include <string>
#include <vector>

namespace subcert::reports {

/// A result that an earlier run wrote to results.json.
struct EarlierResult {
  std::string key, paper, item, printed, computed, verdict;
  std::optional<Enclosure> enclosure;
};

/// The text of a results.json. Errors: throws a data error that names the file and what it lacks.
std::vector<EarlierResult> read_results(const std::string& text, const std::string& file);

struct Change {
  std::string key;
  std::string text;       ///< what was, and what is
  bool is_alarm = false;  ///< two proofs that exclude each other, another verdict or print, a result that is gone
};

/// Of the items that both runs have: results that are new or gone, other verdicts, other prints, enclosures that are
/// disjoint, narrower or wider, other texts. In the order of this run; what is gone stands at the end.
std::vector<Change> changes(const std::vector<EarlierResult>& earlier, const std::vector<Result>& now);

/// For people: a line a change, then how many there are.
std::string changes_text(const std::vector<Change>& changes, std::size_t results, const std::string& folder);

}  // namespace subcert::reports
