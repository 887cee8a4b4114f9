#include "paper.hpp"

#include <subcert/proofs-checks/toml_file.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace subcert::statements {
namespace {

using Keys = std::vector<std::string>;

void only_keys(const toml::table& table, const Keys& known) {
  for (const auto& [key, node] : table)
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      throw FileError(place_of(key.source()), fmt::format("unknown key '{}'; expected one of {}", printable(key.str()),
                                                          fmt::join(known, ", ")));
}

/// A text, in which a line break with the blanks around it is one blank.
std::string text_of(const toml::node& node) {
  if (!node.is_string()) throw FileError(place_of(node), "expected a text in quotes");
  std::string result;
  bool broken = true;
  for (const char c : node.as_string()->get()) {
    if (c == '\n') broken = true;
    if (broken && (c == '\n' || c == ' ')) continue;
    if (broken) {
      while (!result.empty() && result.back() == ' ') result.pop_back();
      if (!result.empty()) result += ' ';
    }
    broken = false;
    result += c;
  }
  return result;
}

std::string optional_text(const toml::table& table, const std::string& key) {
  const toml::node* node = table.get(key);
  return node ? text_of(*node) : "";
}

std::string needed_text(const toml::table& table, const std::string& key) {
  if (!table.get(key)) throw FileError(place_of(table), "expected the key '" + key + "'");
  return text_of(*table.get(key));
}

/// The tables of an array; none where there is no such key.
std::vector<const toml::table*> tables_of(const toml::table& table, const std::string& key) {
  std::vector<const toml::table*> result;
  const toml::node* node = table.get(key);
  if (!node) return result;
  if (!node->is_array()) throw FileError(place_of(*node), "'" + key + "' takes a list of tables");
  for (const toml::node& entry : *node->as_array()) {
    if (!entry.is_table()) throw FileError(place_of(entry), "'" + key + "' takes a list of tables");
    result.push_back(entry.as_table());
  }
  return result;
}

Verdict verdict_of(const toml::node& node) {
  const std::string word = text_of(node);
  const auto found = std::find(verdict_words.begin(), verdict_words.end(), word);
  if (found == verdict_words.end())
    throw FileError(place_of(node), fmt::format("'{}' is no verdict; expected one of {}", printable(word),
                                                fmt::join(verdict_words, ", ")));
  return static_cast<Verdict>(found - verdict_words.begin());
}

/// The statement without its check, but for one that cannot be checked.
Statement read_statement(const toml::table& table, const std::string& paper) {
  only_keys(table, {"id", "place", "claim", "checked", "latex", "corrected", "recorded", "not-checkable"});
  Statement result{paper + "/" + needed_text(table, "id"),
                   needed_text(table, "place"),
                   needed_text(table, "claim"),
                   optional_text(table, "checked"),
                   needed_text(table, "latex"),
                   optional_text(table, "corrected"),
                   Verdict::not_checkable,
                   {}};
  if (!table.contains("not-checkable") != table.contains("recorded"))
    throw FileError(place_of(table), "expected either 'recorded' or 'not-checkable'");
  if (table.contains("recorded")) {
    result.recorded = verdict_of(*table.get("recorded"));
    const bool wrong = result.recorded == Verdict::misprint || result.recorded == Verdict::false_claim;
    if (wrong && result.corrected.empty()) result.corrected = result.printed;
  } else {
    result.check = [reason = needed_text(table, "not-checkable")](const Context&) {
      return Outcome{Verdict::not_checkable, "", "", reason};
    };
  }
  return result;
}

const Keys cell_keys{"row", "column", "scheme", "quantity", "over", "words", "n", "d"};

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
  std::string filled(const std::string& key) const {
    std::string text = plain(key);
    for (const auto& [name, content] : texts) {
      const std::string field = "{" + name + "}";
      for (std::size_t at = text.find(field); at != std::string::npos; at = text.find(field, at + content.size()))
        text.replace(at, field.size(), content);
    }
    return text;
  }
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
                              cell.plain("over"), cell.number("n"), cell.number("d"), text, cell.plain("words"),
                              recorded                              ? verdict_of(*recorded)
                              : text.find('{') == std::string::npos ? Verdict::match
                                                                    : Verdict::mismatch});
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
    if (cell.recorded == Verdict::match && typed.find('{') != std::string::npos) cell.recorded = Verdict::mismatch;
    std::string content = form_text(typed, Form::printed);
    if (content.starts_with('['))
      content.erase(std::remove(content.begin(), content.end(), ' '), content.end());
    else
      content = subcert::to_text(transcriptions.formula(id, Form::printed)(values));
    text.replace(open, close + 2 - open, content);
  }
  text = form_text(text, Form::printed);
}

std::string names(const std::vector<std::string>& ids) {
  return ids.empty() ? "none" : fmt::format("{}", fmt::join(ids, ", "));
}

}  // namespace

Paper read_paper(const std::string& key, std::string_view text, const Checks& checks) {
  const toml::table file = parse_toml(text);
  only_keys(file, {"citation", "transcription", "statement", "table"});
  std::vector<PublishedTable> tables;
  for (const toml::table* table : tables_of(file, "table")) tables.push_back(read_table(*table));

  std::vector<Transcription> transcriptions;
  if (const toml::node* list = file.get("transcription")) {
    if (!list->is_table()) throw FileError(place_of(*list), "expected the table [transcription]");
    for (const auto& [id, node] : *list->as_table()) transcriptions.push_back({std::string(id.str()), text_of(node)});
  }
  std::map<std::string, std::string> words;
  for (const PublishedTable& table : tables)
    for (const PublishedCell& cell : table.cells)
      if (!cell.words.empty()) words[cell.words] += (words[cell.words].empty() ? "" : " ") + cell.printed;
  for (const auto& [id, row] : words) transcriptions.push_back({id, row});

  Paper paper{key, needed_text(file, "citation"), Transcriptions(transcriptions), {}, std::move(tables)};
  for (PublishedTable& table : paper.tables)
    for (PublishedCell& cell : table.cells) print(cell, paper.transcriptions);

  std::map<std::string, Check> open;
  for (const auto& [id, check] : checks)
    if (!open.emplace(id, check).second) fail(ErrorKind::domain, "{}: two checks of '{}'", key, id);
  std::set<std::string> ids;
  std::vector<std::string> without_check;
  for (const toml::table* table : tables_of(file, "statement")) {
    paper.statements.push_back(read_statement(*table, key));
    Statement& statement = paper.statements.back();
    const std::string id = statement.id.substr(key.size() + 1);
    if (!ids.insert(id).second) throw FileError(place_of(*table), "the statement '" + id + "' is there twice");
    if (statement.check) continue;
    if (auto check = open.extract(id))
      statement.check = check.mapped();
    else
      without_check.push_back(id);
  }
  std::vector<std::string> without_statement;
  for (const auto& [id, check] : open) without_statement.push_back(id);
  if (!without_check.empty() || !without_statement.empty())
    throw FileError({1, 1}, "statements without check: " + names(without_check) +
                                "; checks without statement: " + names(without_statement));
  return paper;
}

}  // namespace subcert::statements
