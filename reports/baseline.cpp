#include "baseline.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/proofs-checks/json_file.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace subcert::reports {
namespace {

std::string field(const nlohmann::json& json, const char* name, const std::string& where) {
  const auto found = json.find(name);
  if (found == json.end() || !found->is_string()) fail(ErrorKind::data, "{}: expected the text '{}'", where, name);
  return found->get<std::string>();
}

Enclosure enclosure_of(const nlohmann::json& json, const std::string& where) {
  Enclosure result;
  for (const auto& [name, end] : {std::pair{"lower", &result.lower}, std::pair{"upper", &result.upper}}) {
    const std::string text = field(json, name, where);
    if (text == "-inf" || text == "inf") continue;
    *end = parse_number(text);
    if (!*end) fail(ErrorKind::data, "{}: expected a number as '{}', got '{}'", where, name, text.substr(0, 40));
  }
  return result;
}

bool are_disjoint(const Enclosure& a, const Enclosure& b) {
  return (a.upper && b.lower && *a.upper < *b.lower) || (b.upper && a.lower && *b.upper < *a.lower);
}

/// Nothing where both are the same.
std::optional<Change> change(const EarlierResult& before, const Result& now) {
  if (before.verdict != now.verdict)
    return Change{
        now.key,
        fmt::format("{}, was {} (computed {}, was {})", now.verdict, before.verdict, now.computed, before.computed),
        true};
  if (before.printed != now.printed)
    return Change{now.key, fmt::format("printed {}, was {}", now.printed, before.printed), true};
  if (before.enclosure && now.enclosure && are_disjoint(*before.enclosure, *now.enclosure))
    return Change{now.key, fmt::format("computed {}, which excludes what it was, {}", now.computed, before.computed),
                  true};
  if (before.computed == now.computed) return std::nullopt;
  const bool is_exact_object = now.kind == ResultKind::value && !now.enclosure && now.standing != Standing::aside;
  return Change{now.key, fmt::format("computed {}, was {}", now.computed, before.computed), is_exact_object};
}

}  // namespace

std::vector<EarlierResult> read_results(const std::string& text, const std::string& file) {
  try {
    static_cast<void>(parse_json(text));  // names the place of what is no JSON, and keys that are there twice
  } catch (const FileError& error) {
    fail(ErrorKind::data, "{}, {}", file, error.what());
  }
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("results") || !json["results"].is_array())
    fail(ErrorKind::data, "{}: expected {{\"results\": [...]}} as 'subcert reproduce --out' writes it", file);
  std::vector<EarlierResult> list;
  for (const auto& one : json["results"]) {
    const std::string where = fmt::format("{}: result {}", file, list.size() + 1);
    if (!one.is_object()) fail(ErrorKind::data, "{}: expected an object", where);
    list.push_back({field(one, "key", where), field(one, "paper", where), field(one, "item", where),
                    field(one, "printed", where), field(one, "computed", where), field(one, "verdict", where),
                    std::nullopt});
    if (one.contains("enclosure")) list.back().enclosure = enclosure_of(one["enclosure"], where);
  }
  return list;
}

std::vector<Change> changes(const std::vector<EarlierResult>& earlier, const std::vector<Result>& now) {
  std::map<std::string, const EarlierResult*> before;
  std::set<std::pair<std::string, std::string>> items, items_before;
  for (const EarlierResult& one : earlier) {
    before[one.key] = &one;
    items_before.emplace(one.paper, one.item);
  }
  std::vector<Change> list;
  for (const Result& one : now) {
    items.emplace(one.paper, one.item);
    const auto found = before.find(one.key);
    if (found != before.end()) {
      if (auto what = change(*found->second, one)) list.push_back(std::move(*what));
      before.erase(found);
    } else if (items_before.contains({one.paper, one.item})) {
      list.push_back({one.key, fmt::format("new: {}, computed {}", one.verdict, one.computed)});
    }
  }
  for (const EarlierResult& one : earlier)
    if (before.contains(one.key) && items.contains({one.paper, one.item}))
      list.push_back({one.key, fmt::format("gone: was {}, computed {}", one.verdict, one.computed), true});
  return list;
}

std::string changes_text(const std::vector<Change>& changes, std::size_t results, const std::string& folder) {
  std::string text;
  for (const Change& one : changes) text += fmt::format("  {} {}: {}\n", one.is_alarm ? '!' : '-', one.key, one.text);
  const auto alarms = std::ranges::count_if(changes, &Change::is_alarm);
  return text + fmt::format("Against {}: {} results, {} changed, {} of them so that it matters.\n", folder, results,
                            changes.size(), alarms);
}

}  // namespace subcert::reports
