#pragma once
/// All statements of all papers.

#include <subcert/proofs-checks/statements/paper.hpp>

namespace subcert::statements {

const std::vector<PaperStatements>& papers();
/// Errors: throws a domain error for an unknown key.
const std::string& citation(const std::string& paper);
/// The transcriptions of all papers.
const Transcriptions& transcriptions();
/// All statements, paper by paper.
const std::vector<Statement>& statements();

/// The statements with this id or of this paper. Errors: throws a usage error that names both.
std::vector<const Statement*> find_statements(const std::string& id_or_paper);

/// The printed and the corrected LaTeX with the transcriptions put in.
std::string printed_latex(const Statement& statement);
std::string corrected_latex(const Statement& statement);

}  // namespace subcert::statements
