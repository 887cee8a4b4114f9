#pragma once
/// What `subcert conjecture` prints.

#include <subcert/cli/command.hpp>
#include <subcert/proofs-checks/conjectures/conjecture_8.hpp>

namespace subcert::cli {

/// The range asked for.
struct ConjectureRange {
  std::string n, d;   ///< lists of numbers in their shortest form
  std::string shard;  ///< I/N, or empty for the whole range
  conjectures::PrimalSchemes schemes;
};

Json conjecture_json(const conjectures::Conjecture7& answer, const ConjectureRange& range);
std::string conjecture_text(const conjectures::Conjecture7& answer, const ConjectureRange& range);
Json conjecture_json(const conjectures::Conjecture8& answer, const ConjectureRange& range);
std::string conjecture_text(const conjectures::Conjecture8& answer, const ConjectureRange& range);

}  // namespace subcert::cli
