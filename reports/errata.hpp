#pragma once
/// The statements of the papers, checked, and the page about them.

#include <subcert/proofs-checks/papers/registry.hpp>

#include <functional>
#include <string>
#include <vector>

namespace subcert::reports {

struct CheckedStatement {
  const statements::Statement* statement;
  statements::Outcome outcome;
  double seconds;

  bool as_recorded() const { return outcome.verdict == statement->recorded; }
};

/// Runs the checks on at most `jobs` threads; `progress` is called with an id before each, one call at a time. Errors:
/// those of the checks.
std::vector<CheckedStatement> check_statements(const std::vector<const statements::Statement*>& chosen,
                                               statements::Tier tier, int jobs,
                                               const std::function<void(const std::string&)>& progress);

/// Errata and confirmations by paper: first what is wrong, with witness and correction, then what holds.
std::string errata_page(const std::vector<CheckedStatement>& checked);

}  // namespace subcert::reports
