#include "registry.hpp"

#include "dyn-2015/checks.hpp"
#include "mustafa-bari-2016/checks.hpp"
#include "mustafa-hameed/checks.hpp"
#include "mustafa-li-2015/checks.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/symbol/support/parse_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <sstream>

namespace subcert {
// Made by the build: paper.toml of each folder, and docs/references.md.
extern const std::map<std::string, std::string_view> paper_files, reference_file;
}  // namespace subcert

namespace subcert::statements {
namespace {

struct Registered {
  std::string key;     ///< the name of the folder
  Checks (*checks)();  ///< nothing for a collection
};

const std::vector<Registered>& registered() {
  static const std::vector<Registered> all{
      {"dyn-2015", dyn_2015::checks},
      {"mustafa-li-2015", mustafa_li_2015::checks},
      {"mustafa-hameed", mustafa_hameed::checks},
      {"mustafa-bari-2016", mustafa_bari_2016::checks},
      {"bivariate", nullptr},
      {"families", nullptr},
      {"daubechies", nullptr},
      {"jsr", nullptr},
      {"levels", nullptr},
      {"vectors", nullptr},
      {"vertices", nullptr},
  };
  return all;
}

std::vector<std::string> registered_keys(bool with_checks) {
  std::vector<std::string> list;
  for (const Registered& one : registered())
    if ((one.checks != nullptr) == with_checks) list.push_back(one.key);
  return list;
}

std::string expanded(std::string text, const Transcriptions& transcriptions, Form form) {
  for (std::size_t open = text.find("<<"); open != std::string::npos; open = text.find("<<", open)) {
    const std::size_t close = text.find(">>", open);
    text.replace(open, close + 2 - open, transcriptions.latex(text.substr(open + 2, close - open - 2), form));
  }
  return text;
}

}  // namespace

const std::vector<std::string>& paper_keys() {
  static const std::vector<std::string> keys = registered_keys(true);
  return keys;
}

const std::vector<std::string>& collection_keys() {
  static const std::vector<std::string> keys = registered_keys(false);
  return keys;
}

const std::vector<Paper>& papers() {
  static const std::vector<Paper> all = [] {
    std::vector<Paper> list;
    for (const Registered& one : registered()) try {
        list.push_back(read_paper(one.key, paper_files.at(one.key), one.checks ? one.checks() : Checks{}));
      } catch (const Error& error) {
        fail(error.kind(), "papers/{}/paper.toml: {}", one.key, error.what());
      }
    return list;
  }();
  return all;
}

const Paper& paper(const std::string& key) {
  for (const Paper& candidate : papers())
    if (candidate.key == key) return candidate;
  fail(ErrorKind::domain, "unknown paper '{}'", key);
}

std::string reference(const std::string& key) {
  const std::string_view file = reference_file.begin()->second;
  const std::string head = "- [" + key + "] ";
  const std::size_t place = file.find(head);
  if (place == std::string_view::npos) fail(ErrorKind::domain, "unknown reference '{}'", key);
  const std::string_view rest = file.substr(place + head.size());
  std::istringstream words{std::string(rest.substr(0, rest.find("\n- [")))};
  std::string text;
  for (std::string word; words >> word;) text += (text.empty() ? "" : " ") + word;
  return text;
}

const std::vector<Statement>& statements() {
  static const std::vector<Statement> all = [] {
    std::vector<Statement> list;
    for (const Paper& one : papers()) list.insert(list.end(), one.statements.begin(), one.statements.end());
    return list;
  }();
  return all;
}

std::vector<const Statement*> find_statements(const std::string& id_or_paper) {
  std::vector<const Statement*> result;
  for (const Statement& statement : statements())
    if (statement.id == id_or_paper || statement.paper() == id_or_paper) result.push_back(&statement);
  if (result.empty())
    for (const Statement& statement : statements())
      if (statement.id.starts_with(id_or_paper + "-")) result.push_back(&statement);
  std::vector<std::string> words, meant;
  for (const Statement& statement : statements())
    words.insert(words.end(), {statement.id, statement.id.substr(statement.paper().size() + 1)});
  const std::string word = std::ranges::find(words, id_or_paper) == words.end() ? nearest_word(id_or_paper, words)
                                                                                : id_or_paper;
  for (const Statement& statement : statements())
    if (statement.id == word || statement.id.ends_with("/" + word)) meant.push_back(statement.id);
  if (result.empty() && !meant.empty())
    fail(ErrorKind::usage, "no statement or paper '{}'; did you mean {}?", id_or_paper, fmt::join(meant, " or "));
  if (result.empty())
    fail(ErrorKind::usage,
         "no statement or paper '{}'; the papers are {}, the ids are listed by 'subcert statements list'{}",
         id_or_paper, fmt::join(paper_keys(), ", "), did_you_mean(id_or_paper, paper_keys()));
  return result;
}

std::vector<const Statement*> select_statements(const std::vector<std::string>& wanted) {
  std::set<const Statement*> chosen;
  for (const std::string& one : wanted) {
    const auto found = find_statements(one);
    chosen.insert(found.begin(), found.end());
  }
  std::vector<const Statement*> result;
  for (const Statement& statement : statements())
    if (wanted.empty() || chosen.contains(&statement)) result.push_back(&statement);
  return result;
}

Outcome check(const Statement& statement, Tier tier) {
  return check(statement, Context(paper(statement.paper()), tier));
}

std::vector<CheckedStatement> check_statements(const std::vector<const Statement*>& chosen, Tier tier, int jobs,
                                               const std::function<void(const std::string&)>& progress) {
  std::vector<CheckedStatement> results(chosen.size());
  std::mutex one_at_a_time;
  parallel_tasks(chosen.size(), jobs, [&](std::size_t i) {
    if (progress) {
      const std::lock_guard lock(one_at_a_time);
      progress(chosen[i]->id);
    }
    const Stopwatch watch;
    Outcome outcome = check(*chosen[i], tier);
    results[i] = {chosen[i], std::move(outcome), watch.seconds()};
  });
  return results;
}

std::string printed_latex(const Statement& statement) {
  return expanded(statement.printed, paper(statement.paper()).transcriptions, Form::printed);
}

std::string corrected_latex(const Statement& statement) {
  return expanded(statement.corrected, paper(statement.paper()).transcriptions, Form::corrected);
}

}  // namespace subcert::statements
