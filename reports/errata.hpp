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

  bool as_recorded() const { return is_as_recorded(*statement, outcome); }
};

/// Runs the checks on at most `jobs` threads; `progress` is called with an id before each, one call at a time. Errors:
/// those of the checks.
std::vector<CheckedStatement> check_statements(const std::vector<const statements::Statement*>& chosen,
                                               statements::Tier tier, int jobs,
                                               const std::function<void(const std::string&)>& progress);

struct Result;

/// By paper: first what holds, then what fails at an edge only, then what to correct, each fault with what follows from
/// it, and what cannot be checked. Beside a statement stand the claims among `results` that are about the same
/// sentences, with their verdicts; without them, the commands that decide them.
std::string errata_page(const std::vector<CheckedStatement>& checked, const std::vector<Result>& results);

}  // namespace subcert::reports
