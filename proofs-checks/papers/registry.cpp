#include "registry.hpp"

#include "dyn_2015/dyn_2015.hpp"
#include "mustafa_bari_2016/mustafa_bari_2016.hpp"
#include "mustafa_hameed/mustafa_hameed.hpp"
#include "mustafa_li_2015/mustafa_li_2015.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <stdexcept>

namespace subcert::statements {
namespace {

std::string expanded(std::string text, Form form) {
  for (std::size_t open = text.find("<<"); open != std::string::npos; open = text.find("<<", open)) {
    const std::size_t close = text.find(">>", open);
    const std::string id = text.substr(open + 2, close - open - 2);
    text.replace(open, close + 2 - open, transcriptions().latex(id, form));
  }
  return text;
}

}  // namespace

const std::vector<PaperStatements>& papers() {
  static const std::vector<PaperStatements> all{dyn_2015::paper(), mustafa_li_2015::paper(), mustafa_hameed::paper(),
                                                mustafa_bari_2016::paper()};
  return all;
}

const std::string& citation(const std::string& paper) {
  for (const PaperStatements& candidate : papers())
    if (candidate.key == paper) return candidate.citation;
  fail(ErrorKind::domain, "unknown paper '{}'", paper);
}

const Transcriptions& transcriptions() {
  static const Transcriptions all = [] {
    std::vector<Transcription> list;
    for (const PaperStatements& paper : papers())
      list.insert(list.end(), paper.transcriptions.begin(), paper.transcriptions.end());
    return Transcriptions(list);
  }();
  return all;
}

const std::vector<Statement>& statements() {
  static const std::vector<Statement> all = [] {
    std::vector<Statement> list;
    for (const PaperStatements& paper : papers())
      list.insert(list.end(), paper.statements.begin(), paper.statements.end());
    return list;
  }();
  return all;
}

std::vector<const Statement*> find_statements(const std::string& id_or_paper) {
  std::vector<const Statement*> result;
  for (const Statement& statement : statements())
    if (statement.id == id_or_paper || statement.paper() == id_or_paper) result.push_back(&statement);
  if (result.empty()) {
    std::string known;
    for (const PaperStatements& paper : papers()) known += (known.empty() ? "" : ", ") + paper.key;
    fail(ErrorKind::usage,
         "no statement or paper '{}'; the papers are {}, the ids are listed by 'subcert statements list'", id_or_paper,
         known);
  }
  return result;
}

std::string printed_latex(const Statement& statement) { return expanded(statement.printed, Form::printed); }

std::string corrected_latex(const Statement& statement) { return expanded(statement.corrected, Form::corrected); }

}  // namespace subcert::statements
