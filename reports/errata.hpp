#pragma once
/// The page about the statements of the papers, checked.

#include <subcert/proofs-checks/papers/registry.hpp>

#include <string>
#include <vector>

namespace subcert::reports {

using statements::CheckedStatement;

struct Result;

/// By paper: first what holds, then what fails at an edge only, then what to correct, each fault with what follows from
/// it, and what cannot be checked. Beside a statement stand the claims among `results` that are about the same
/// sentences, with their verdicts; without them, the commands that decide them.
std::string errata_page(const std::vector<CheckedStatement>& checked, const std::vector<Result>& results);

}  // namespace subcert::reports
