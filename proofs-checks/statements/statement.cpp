#include "statement.hpp"

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

const PublishedTable& Context::table(const std::string& id) const { return paper_->table(id); }

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

std::optional<Grade> grade_of(const Statement& statement, const Outcome& outcome) {
  if (!outcome.edge.empty()) return Grade::edge;
  return standing(outcome.verdict) == Standing::wrong ? statement.grade : std::nullopt;
}

bool is_as_recorded(const Statement& statement, const Outcome& outcome) {
  return outcome.verdict == statement.recorded && grade_of(statement, outcome) == statement.grade;
}

bool is_left_to_experiments(const Statement& statement, const Outcome& outcome) {
  return outcome.verdict == StatementVerdict::not_checkable && !statement.experiments.empty();
}

std::string verdict_in_words(const Statement& statement, const Outcome& outcome) {
  if (!outcome.edge.empty()) return "holds, but not at " + outcome.edge;
  if (is_left_to_experiments(statement, outcome)) return "see the experiments";
  switch (outcome.verdict) {
    case StatementVerdict::holds_for_all: return "proved for all n";
    case StatementVerdict::holds: return "holds on the range tried";
    case StatementVerdict::not_checkable: return "cannot be checked";
    case StatementVerdict::undecided: return "undecided";
    default: break;
  }
  const std::optional<Grade> grade = grade_of(statement, outcome);
  if (grade == Grade::slip) return statement.scan.empty() ? "slip of the pen" : "slip of the pen, or of the scan";
  return grade == Grade::number ? "numbers are off" : "does not hold";
}

Outcome check(const Statement& statement, const Context& context) {
  try {
    return statement.check(context);
  } catch (const Undefined& error) {
    return {StatementVerdict::false_claim, "", error.what(), ""};
  }
}

}  // namespace subcert::statements
