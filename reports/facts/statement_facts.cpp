#include "statement_facts.hpp"

namespace subcert::facts {
namespace {

Json grade_json(const std::optional<Grade>& grade) { return grade ? Json(to_text(*grade)) : Json(); }

Json statement_json(const statements::Statement& statement) {
  return {{"id", statement.id},
          {"place", statement.place},
          {"paraphrase", statement.paraphrase},
          {"checked", statement.checked},
          {"printed", printed_latex(statement)},
          {"sentence", statement.sentence},
          {"readings", statement.readings},
          {"follows", statement.follows},
          {"scan", statement.scan},
          {"experiments", statement.experiments},
          {"recorded", to_text(statement.recorded)},
          {"recorded_grade", grade_json(statement.grade)}};
}

Json outcome_json(const statements::CheckedStatement& checked) {
  const statements::Statement& statement = *checked.statement;
  Json json = statement_json(statement);
  json["verdict"] = to_text(checked.outcome.verdict);
  json["grade"] = grade_json(grade_of(statement, checked.outcome));
  json["edge"] = checked.outcome.edge;
  json["range"] = checked.outcome.range;
  json["witness"] = checked.outcome.witness;
  json["corrected"] = corrected_latex(statement);
  json["argument"] = checked.outcome.argument;
  json["seconds"] = checked.seconds;
  return json;
}

}  // namespace

Json statements_json(const std::vector<const statements::Statement*>& list) {
  Json json = Json::array();
  for (const statements::Statement* statement : list) json.push_back(statement_json(*statement));
  return json;
}

Json statements_json(const std::vector<statements::CheckedStatement>& list) {
  Json json = Json::array();
  for (const statements::CheckedStatement& checked : list) json.push_back(outcome_json(checked));
  return json;
}

}  // namespace subcert::facts
