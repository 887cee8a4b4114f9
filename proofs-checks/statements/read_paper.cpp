#include "statement.hpp"

#include <subcert/proofs-checks/toml_fields.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace subcert::statements {
namespace {

/// What is wrong has a grade and the words of the paper; what has a grade is wrong, or fails at an edge.
void require_fair_record(const toml::table& table, const Statement& statement) {
  const bool wrong = standing(statement.recorded) == Standing::wrong, edge = statement.grade == Grade::edge;
  if (statement.grade ? wrong == edge : wrong)
    throw FileError(place_of(table), wrong ? "expected a grade: slip, number or claim" : "expected no grade but edge");
  if (statement.grade && statement.sentence.empty()) throw FileError(place_of(table), "expected the key 'sentence'");
  if (wrong && statement.readings.empty()) throw FileError(place_of(table), "expected the key 'readings'");
}

/// The statement without its check, but for one that cannot be checked.
Statement read_statement(const toml::table& table, const std::string& paper) {
  only_keys(table, {"id", "place", "claim", "checked", "latex", "corrected", "recorded", "not-checkable", "grade",
                    "sentence", "readings", "follows", "scan", "experiments"});
  Statement result{.id = paper + "/" + needed_text(table, "id"),
                   .place = needed_text(table, "place"),
                   .paraphrase = needed_text(table, "claim"),
                   .checked = optional_text(table, "checked"),
                   .printed = needed_text(table, "latex"),
                   .corrected = optional_text(table, "corrected"),
                   .recorded = StatementVerdict::not_checkable,
                   .check = {},
                   .sentence = optional_text(table, "sentence"),
                   .readings = optional_text(table, "readings"),
                   .scan = optional_text(table, "scan"),
                   .experiments = optional_texts(table, "experiments")};
  if (!table.contains("not-checkable") != table.contains("recorded"))
    throw FileError(place_of(table), "expected either 'recorded' or 'not-checkable'");
  if (table.contains("grade")) result.grade = verdict_of<Grade>(*table.get("grade"));
  if (table.contains("follows")) result.follows = paper + "/" + needed_text(table, "follows");
  if (table.contains("recorded")) {
    result.recorded = verdict_of<StatementVerdict>(*table.get("recorded"));
    if (standing(result.recorded) == Standing::wrong && result.corrected.empty()) result.corrected = result.printed;
  } else {
    result.check = [reason = needed_text(table, "not-checkable")](const Context&) {
      return Outcome{StatementVerdict::not_checkable, "", "", reason};
    };
  }
  require_fair_record(table, result);
  return result;
}

/// A fault is followed in one step, from what shows it in its first place.
void require_first_faults(const std::vector<Statement>& statements) {
  for (const Statement& one : statements)
    if (!one.follows.empty() && std::ranges::none_of(statements, [&](const Statement& first) {
          return first.id == one.follows && first.follows.empty() && first.grade;
        }))
      throw FileError({1, 1}, fmt::format("'{}' follows '{}', which is no first fault", one.id, one.follows));
}

const Keys cell_keys{"row", "column", "scheme", "quantity", "words", "n", "d", "source", "derived"};

Keys with(const Keys& keys, const Keys& more) {
  Keys result = keys;
  result.insert(result.end(), more.begin(), more.end());
  return result;
}

/// What a table says about a cell: of the table itself, of the column and of the row, the later ones first.
struct CellFields {
  std::map<std::string, std::string> texts;

  void take(const toml::table& from) {
    for (const std::string& key : cell_keys) {
      const toml::node* node = from.get(key);
      if (!node) continue;
      const auto* number = node->as_integer();
      if (key != "n" && key != "d")
        texts[key] = text_of(*node);
      else if (number && std::in_range<int>(number->get()))
        texts[key] = std::to_string(number->get());
      else
        throw FileError(place_of(*node), "expected an integer");
    }
  }
  /// The text with {key} replaced by what that key says.
  std::string filled(const std::string& key) const { return subcert::filled(plain(key), texts); }
  std::string plain(const std::string& key) const { return texts.contains(key) ? texts.at(key) : ""; }
  std::optional<int> number(const std::string& key) const {
    return texts.contains(key) ? std::optional(std::stoi(texts.at(key))) : std::nullopt;
  }
};

/// The entry of the row for a column: one text for all columns, or a list of one for each.
const toml::node* entry_of(const toml::table& row, const std::string& key, std::size_t column, std::size_t columns) {
  const toml::node* node = row.get(key);
  if (!node || !node->is_array()) return node;
  if (node->as_array()->size() != columns)
    throw FileError(place_of(*node), fmt::format("expected {} values, one a column", columns));
  return node->as_array()->get(column);
}

/// The cells as they are typed in, misprints marked. A value that is marked is on record as a mismatch, any other as a
/// match, unless the table says so otherwise.
PublishedTable read_table(const toml::table& table) {
  only_keys(table, with(cell_keys, {"id", "title", "place", "layout", "recorded", "columns", "rows"}));
  const std::string layout = needed_text(table, "layout");
  if (layout != "grid" && layout != "list")
    throw FileError(place_of(*table.get("layout")), "expected 'grid' or 'list'");
  PublishedTable result{
      needed_text(table, "id"), needed_text(table, "title"), needed_text(table, "place"), layout == "grid", {}};
  static const toml::table no_fields;
  std::vector<const toml::table*> columns = tables_of(table, "columns");
  if (columns.empty()) columns.push_back(&no_fields);
  for (const toml::table* row : tables_of(table, "rows"))
    for (std::size_t i = 0; i < columns.size(); ++i) {
      only_keys(*row, with(cell_keys, {"printed", "recorded"}));
      only_keys(*columns[i], cell_keys);
      CellFields cell;
      for (const toml::table* one : std::vector<const toml::table*>{&table, columns[i], row}) cell.take(*one);
      const toml::node* printed = entry_of(*row, "printed", i, columns.size());
      if (!printed) throw FileError(place_of(*row), "expected the key 'printed'");
      const toml::node* recorded = entry_of(*row, "recorded", i, columns.size());
      if (!recorded) recorded = table.get("recorded");
      const std::string text = text_of(*printed);
      result.cells.push_back({cell.filled("row"), cell.filled("column"), cell.filled("scheme"), cell.plain("quantity"),
                              cell.number("n"), cell.number("d"), text, cell.plain("words"),
                              recorded                              ? verdict_of<ValueVerdict>(*recorded)
                              : text.find('{') == std::string::npos ? ValueVerdict::match
                                                                    : ValueVerdict::mismatch,
                              cell.plain("source"), cell.plain("derived")});
    }
  return result;
}

/// The cell as printed: <<id>> in it is the value of a formula at n and d, or a list.
void print(PublishedCell& cell, const Transcriptions& transcriptions) {
  Values values;
  if (cell.n) values.emplace_back("n", *cell.n);
  if (cell.d) values.emplace_back("d", *cell.d);
  std::string& text = cell.printed;
  for (std::size_t open = text.find("<<"); open != std::string::npos; open = text.find("<<", open)) {
    const std::size_t close = text.find(">>", open);
    const std::string id = text.substr(open + 2, close - open - 2);
    const std::string& typed = transcriptions.text(id);
    if (cell.recorded == ValueVerdict::match && typed.find('{') != std::string::npos)
      cell.recorded = ValueVerdict::mismatch;
    std::string content = form_text(typed, Form::printed);
    if (content.starts_with('['))
      content.erase(std::remove(content.begin(), content.end(), ' '), content.end());
    else
      content = subcert::to_text(transcriptions.formula(id, Form::printed)(values));
    text.replace(open, close + 2 - open, content);
  }
  text = form_text(text, Form::printed);
}

}  // namespace

Paper read_paper(const std::string& key, std::string_view text, const Checks& checks) {
  const toml::table file = parse_toml(text);
  only_keys(file, {"citation", "transcription", "statement", "table"});
  std::vector<PublishedTable> tables;
  for (const toml::table* table : tables_of(file, "table")) tables.push_back(read_table(*table));

  std::vector<Transcription> transcriptions;
  for (const auto& [id, typed] : texts_in(file, "transcription")) transcriptions.push_back({id, typed});
  std::map<std::string, std::string> words;
  for (const PublishedTable& table : tables)
    for (const PublishedCell& cell : table.cells)
      if (!cell.words.empty()) words[cell.words] += (words[cell.words].empty() ? "" : " ") + cell.printed;
  for (const auto& [id, row] : words) transcriptions.push_back({id, row});

  Paper paper{key, needed_text(file, "citation"), Transcriptions(transcriptions), {}, std::move(tables)};
  for (PublishedTable& table : paper.tables)
    for (PublishedCell& cell : table.cells) print(cell, paper.transcriptions);

  ById<Check> open(key, "check", "statement", checks);
  for (const toml::table* table : tables_of(file, "statement")) {
    Statement statement = read_statement(*table, key);
    const std::string id = statement.id.substr(key.size() + 1);
    if (statement.check)
      open.note(*table, id);
    else
      statement.check = open.taken(*table, id);
    paper.statements.push_back(std::move(statement));
  }
  open.require_all_taken();
  require_first_faults(paper.statements);
  return paper;
}

}  // namespace subcert::statements
