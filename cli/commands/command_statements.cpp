// subcert statements list|check: the statements of the papers as executable checks

#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/cli/command.hpp>
#include <subcert/reports/facts/screen_lines.hpp>
#include <subcert/reports/facts/statement_facts.hpp>
#include <subcert/reports/pages.hpp>
#include <subcert/reports/results.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace subcert::cli {
namespace {

using statements::Outcome;
using statements::Statement;
using statements::Tier;

struct StatementsOptions : CommonOptions {
  std::vector<std::string> wanted;
  std::vector<std::string> verdicts;  ///< on record, of which one is asked for; none: any
  bool ids = false;
  bool wide = false;
  std::string page;
};

/// `misprint, slip`, to a width.
std::string verdict_column(StatementVerdict verdict, const std::optional<Grade>& grade) {
  return fmt::format("{:<23}", to_text(verdict) + (grade ? ", " + to_text(*grade) : ""));
}

/// Those that are asked for. Errors: throws a usage error for an unknown id or verdict.
std::vector<const Statement*> chosen_statements(const StatementsOptions& options) {
  std::set<std::string> known;
  for (const Statement& one : statements::statements()) known.insert(to_text(one.recorded));
  for (const std::string& verdict : options.verdicts)
    if (!known.contains(verdict)) fail(ErrorKind::usage, "--verdict {}: expected {}", verdict, fmt::join(known, ", "));
  std::vector<const Statement*> chosen = statements::select_statements(options.wanted);
  if (!options.verdicts.empty())
    std::erase_if(chosen, [&](const Statement* one) {
      return std::ranges::count(options.verdicts, to_text(one->recorded)) == 0;
    });
  if (chosen.empty()) fail(ErrorKind::usage, "--verdict: none of these statements has it");
  return chosen;
}

/// The option by which they are chosen.
void add_verdicts(Command& command, std::vector<std::string>& verdicts) {
  command.option("--verdict", verdicts, "Only statements with these verdicts on record, as false,misprint")
      .separated_by_commas()
      .one_each();
}

ExitCode list(const StatementsOptions& options) {
  const auto chosen = chosen_statements(options);
  if (options.json) {
    options.answer(Json{{"statements", statements_json(chosen)}});
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
    text += facts::wrapped("  " + verdict_column(statement->recorded, statement->grade) + statement->id + "  " +
                               statement->paraphrase,
                           25) +
            "\n";
  }
  options.answer(text);
  return done;
}

std::string outcome_text(const Statement& statement, const Outcome& outcome) {
  const std::optional<Grade> grade = grade_of(statement, outcome);
  std::string text = facts::wrapped(verdict_column(outcome.verdict, grade) + statement.id + "  " + statement.paraphrase,
                                    25) +
                     "\n";
  const auto line = [&](const char* name, const std::string& content) {
    if (!content.empty()) text += facts::wrapped(std::string(25, ' ') + name + content, 27) + "\n";
  };
  if (grade) line("", verdict_in_words(statement, outcome));
  line("range: ", outcome.range);
  if (grade) line("the paper says: ", statement.sentence);
  if (grade) line("read as: ", statement.readings);
  line("as the scan has it: ", statement.scan);
  line("witness: ", outcome.witness);
  if (grade) line("corrected: ", corrected_latex(statement));
  line("", outcome.argument);
  line("follows from: ", statement.follows);
  for (const std::string& id : statement.experiments) line("experiment: subcert experiment ", id);
  if (!is_as_recorded(statement, outcome))
    line("NOT AS RECORDED: the verdict on record is ",
         to_text(statement.recorded) + (statement.grade ? ", " + to_text(*statement.grade) : ""));
  return text;
}

ExitCode run_checks(const StatementsOptions& options) {
  const auto results = statements::check_statements(chosen_statements(options), options.wide ? Tier::wide : Tier::quick,
                                                    options.threads(),
                                                    [&](const std::string& id) { options.progress(id); });
  options.end_progress();
  if (!options.page.empty()) runtime::write_file(options.page, reports::errata_page(results, {}));
  ExitCode code = done;
  std::string text;
  for (const reports::CheckedStatement& checked : results) {
    if (checked.outcome.verdict == StatementVerdict::undecided)
      code = code == done ? undecided : code;
    else if (!checked.as_recorded())
      code = failed;
    text += outcome_text(*checked.statement, checked.outcome);
  }
  const reports::Counts found = reports::counts(reports::results(results), reports::ResultKind::statement);
  text += "\n" + facts::wrapped(found.text() + (code == done ? ". All verdicts are the ones on record." : "."), 0) +
          "\n";
  options.answer(Json{{"statements", statements_json(results)}}, text);
  return code;
}

}  // namespace

void add_statements(Command& app) {
  Command group = app.subcommand("statements", "The statements of the papers as executable checks");
  std::string known;
  for (const auto& paper : statements::paper_keys()) known += (known.empty() ? "" : ", ") + paper;
  const std::string meaning = "Statements, what their ids begin with, or papers (" + known + "; default: all)";

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
  add_verdicts(list_command, list_options->verdicts);

  group.run_without_subcommand([=] { return static_cast<int>(list(*list_options)); });

  auto check_options = std::make_shared<StatementsOptions>();
  Command check_command = add_command(group, "check", "Checks statements and compares with the verdicts on record",
                                      "subcert statements check dyn-2015/eq-2", check_options,
                                      [=] { return run_checks(*check_options); });
  check_command.option("ID", check_options->wanted, meaning).suggest(suggestions);
  add_verdicts(check_command, check_options->verdicts);
  check_command.flag("--wide", check_options->wide, "Larger ranges");
  check_command.option("--page", check_options->page, "Write the page 'errata and confirmations' there");
}

}  // namespace subcert::cli
