#pragma once
/// The papers, their statements and what they print.

#include <subcert/proofs-checks/statements/statement.hpp>

namespace subcert::statements {

/// The papers in order, and the collections of published values, which claim nothing beside their tables; without
/// reading them.
const std::vector<std::string>& paper_keys();
const std::vector<std::string>& collection_keys();
/// All of both.
const std::vector<Paper>& papers();
/// Errors: throws a domain error for an unknown key.
const Paper& paper(const std::string& key);
inline const std::string& citation(const std::string& key) { return paper(key).citation; }

/// `K. Author: Title. Journal`, by its key in docs/references.md. Errors: throws a domain error for an unknown key.
std::string reference(const std::string& key);

/// All statements, paper by paper.
const std::vector<Statement>& statements();
/// The statement with this id, or those of this paper; where there is none, those whose ids begin so, as
/// dyn-2015/table-3-sup with dyn-2015/table-3. Errors: throws a usage error that names both.
std::vector<const Statement*> find_statements(const std::string& id_or_paper);
/// Those with one of these ids or of one of these papers, each once and in the order of the papers; all where none is
/// named. Errors: as find_statements().
std::vector<const Statement*> select_statements(const std::vector<std::string>& wanted);
/// The check of a statement with its paper.
Outcome check(const Statement& statement, Tier tier);

struct CheckedStatement {
  const Statement* statement;
  Outcome outcome;
  double seconds;

  bool as_recorded() const { return is_as_recorded(*statement, outcome); }
};

/// Runs the checks on at most `jobs` threads; `progress` is called with an id before each, one call at a time. Errors:
/// those of the checks.
std::vector<CheckedStatement> check_statements(const std::vector<const Statement*>& chosen, Tier tier, int jobs,
                                               const std::function<void(const std::string&)>& progress);

/// The printed and the corrected LaTeX with the transcriptions put in.
std::string printed_latex(const Statement& statement);
std::string corrected_latex(const Statement& statement);

}  // namespace subcert::statements
