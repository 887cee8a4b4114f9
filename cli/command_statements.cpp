// subcert statements list|check: the statements of the papers as executable checks

#include "command.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/reports/errata.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <algorithm>
#include <map>

namespace subcert::cli {
namespace {

using statements::Outcome;
using statements::Statement;
using statements::Tier;

struct StatementsOptions : CommonOptions {
  std::vector<std::string> wanted;
  bool ids = false;
  bool wide = false;
  std::string page;
};

/// All statements, or those asked for, each once and in the order of the papers.
std::vector<const Statement*> selected(const std::vector<std::string>& wanted) {
  std::vector<const Statement*> chosen;
  for (const std::string& one : wanted) {
    const auto found = statements::find_statements(one);
    chosen.insert(chosen.end(), found.begin(), found.end());
  }
  std::vector<const Statement*> result;
  for (const Statement& statement : statements::statements())
    if (wanted.empty() || std::find(chosen.begin(), chosen.end(), &statement) != chosen.end())
      result.push_back(&statement);
  return result;
}

Json statement_json(const Statement& statement) {
  return {{"id", statement.id},
          {"place", statement.place},
          {"paraphrase", statement.paraphrase},
          {"checked", statement.checked},
          {"printed", printed_latex(statement)},
          {"recorded", to_text(statement.recorded)}};
}

ExitCode list(const StatementsOptions& options) {
  const auto chosen = selected(options.wanted);
  if (options.json) {
    Json json{{"statements", Json::array()}};
    for (const Statement* statement : chosen) json["statements"].push_back(statement_json(*statement));
    options.answer(json);
    return done;
  }
  std::string text, paper;
  for (const Statement* statement : chosen) {
    if (options.ids) {
      text += statement->id + "\n";
      continue;
    }
    if (statement->paper() != paper) {
      paper = statement->paper();
      text += (text.empty() ? "" : "\n") + paper + "\n";
    }
    const std::string verdict = to_text(statement->recorded);
    text += "  " + verdict + std::string(17 - verdict.size(), ' ') + statement->id + "  " + statement->paraphrase +
            "\n";
  }
  options.answer(text);
  return done;
}

Json outcome_json(const reports::CheckedStatement& checked) {
  const Statement& statement = *checked.statement;
  Json json = statement_json(statement);
  json["verdict"] = to_text(checked.outcome.verdict);
  json["range"] = checked.outcome.range;
  json["witness"] = checked.outcome.witness;
  json["corrected"] = corrected_latex(statement);
  json["argument"] = checked.outcome.argument;
  json["seconds"] = checked.seconds;
  return json;
}

std::string outcome_text(const Statement& statement, const Outcome& outcome) {
  const std::string verdict = to_text(outcome.verdict);
  std::string text = verdict + std::string(17 - verdict.size(), ' ') + statement.id + "  " + statement.paraphrase +
                     "\n";
  const auto line = [&](const char* name, const std::string& content) {
    if (!content.empty()) text += std::string(19, ' ') + name + content + "\n";
  };
  line("range: ", outcome.range);
  line("witness: ", outcome.witness);
  if (outcome.verdict == StatementVerdict::misprint || outcome.verdict == StatementVerdict::false_claim)
    line("corrected: ", corrected_latex(statement));
  line("", outcome.argument);
  if (outcome.verdict != statement.recorded)
    line("NOT AS RECORDED: the verdict on record is ", to_text(statement.recorded));
  return text;
}

ExitCode run_checks(const StatementsOptions& options) {
  const auto results = reports::check_statements(selected(options.wanted), options.wide ? Tier::wide : Tier::quick,
                                                 options.threads(),
                                                 [&](const std::string& id) { options.progress(id); });
  options.end_progress();
  if (!options.page.empty()) runtime::write_file(options.page, reports::errata_page(results));
  ExitCode code = done;
  Json json{{"statements", Json::array()}};
  std::string text;
  std::map<StatementVerdict, int> counts;
  for (const reports::CheckedStatement& checked : results) {
    ++counts[checked.outcome.verdict];
    if (checked.outcome.verdict == StatementVerdict::undecided)
      code = code == done ? undecided : code;
    else if (!checked.as_recorded())
      code = failed;
    json["statements"].push_back(outcome_json(checked));
    text += outcome_text(*checked.statement, checked.outcome);
  }
  text += "\n" + std::to_string(results.size()) + (results.size() == 1 ? " statement:" : " statements:");
  for (const auto& [verdict, count] : counts) text += " " + std::to_string(count) + " " + to_text(verdict) + ",";
  text.back() = '.';
  text += std::string(code == done ? " All verdicts are the ones on record." : "") + "\n";
  options.answer(json, text);
  return code;
}

}  // namespace

void add_statements(Command& app) {
  Command group = app.subcommand("statements", "The statements of the papers as executable checks");
  std::string known;
  for (const auto& paper : statements::paper_keys()) known += (known.empty() ? "" : ", ") + paper;
  const std::string meaning = "Statements or papers (" + known + "; default: all)";

  const auto suggestions = [] {
    std::vector<Suggestion> words;
    for (const std::string& paper : statements::paper_keys()) words.push_back({paper, "all statements of the paper"});
    for (const Statement& one : statements::statements()) words.push_back({one.id, one.paraphrase});
    return words;
  };

  auto list_options = std::make_shared<StatementsOptions>();
  Command list_command = add_command(group, "list", "Lists the statements with the verdicts on record",
                                     "subcert statements list dyn-2015", list_options,
                                     [=] { return list(*list_options); });
  list_command.option("ID", list_options->wanted, meaning).suggest(suggestions);
  list_command.flag("--ids", list_options->ids, "Only the ids, one a line");

  group.run_without_subcommand([=] { return static_cast<int>(list(*list_options)); });

  auto check_options = std::make_shared<StatementsOptions>();
  Command check_command = add_command(group, "check", "Checks statements and compares with the verdicts on record",
                                      "subcert statements check dyn-2015/eq-2", check_options,
                                      [=] { return run_checks(*check_options); });
  check_command.option("ID", check_options->wanted, meaning).suggest(suggestions);
  check_command.flag("--wide", check_options->wide, "Larger ranges");
  check_command.option("--page", check_options->page, "Write the page 'errata and confirmations' there");
}

}  // namespace subcert::cli
