#pragma once
/// What is known of the statements of the papers, for programs.

#include "fact.hpp"

#include <subcert/proofs-checks/papers/registry.hpp>

namespace subcert::facts {

/// A list of what is on record.
Json statements_json(const std::vector<const statements::Statement*>& list);
/// The same with what was found.
Json statements_json(const std::vector<statements::CheckedStatement>& list);

}  // namespace subcert::facts
