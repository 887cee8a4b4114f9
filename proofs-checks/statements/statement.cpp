#include "statement.hpp"

#include "paper.hpp"

#include <algorithm>
#include <iterator>

namespace subcert::statements {

Context::Context(const Paper& paper, Tier tier) : Context(paper, paper.transcriptions, tier) {}

std::vector<PublishedCell> Context::cells(const std::string& id) const {
  std::vector<PublishedCell> result;
  for (const PublishedTable& table : paper_->tables)
    std::copy_if(table.cells.begin(), table.cells.end(), std::back_inserter(result),
                 [&](const PublishedCell& cell) { return cell.words == id; });
  return result;
}

const PublishedTable& Paper::table(const std::string& id) const {
  for (const PublishedTable& candidate : tables)
    if (candidate.id == id) return candidate;
  fail(ErrorKind::domain, "no table '{}' in {}", id, key);
}

Checks joined(const std::vector<Checks>& parts) {
  Checks result;
  for (const Checks& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

Outcome check(const Statement& statement, const Context& context) {
  try {
    return statement.check(context);
  } catch (const Undefined& error) {
    return {Verdict::false_claim, "", error.what(), ""};
  }
}

}  // namespace subcert::statements
