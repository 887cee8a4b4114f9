#pragma once
/// What `subcert theorem` prints.

#include <subcert/cli/command.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>

namespace subcert::cli {

Json theorem_json(const theorems::Theorem& theorem);
/// `all`: every inequality; else one line for many that differ in n only.
std::string theorem_text(const theorems::Theorem& theorem, bool all);

}  // namespace subcert::cli
