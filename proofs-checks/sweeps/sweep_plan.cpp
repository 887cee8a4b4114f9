#include "sweep_plan.hpp"

#include "scheme_grid.hpp"

#include <subcert/proofs-checks/toml_file.hpp>
#include <subcert/schemes/data/runtime/process.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace subcert::sweeps {
namespace {

/// The arguments of a command that answers about a scheme, before those that all have.
struct Question {
  std::string name;
  std::vector<std::string> arguments = {};
  bool has_budget = true, has_memory = false;
};

const std::vector<Question>& questions() {
  static const std::vector<Question> all = {{.name = "regularity", .has_memory = true},
                                            {.name = "analyze"},
                                            {.name = "variance"},
                                            {.name = "limit", .arguments = {"--range"}},
                                            {.name = "mask", .has_budget = false}};
  return all;
}

std::string text_of(const toml::node& node, const char* key) {
  if (const auto* text = node.as_string()) return text->get();
  throw FileError(place_of(node), fmt::format("'{}' takes a text in quotes", key));
}

std::vector<std::string> texts_of(const toml::node& node, const char* key) {
  const auto* list = node.as_array();
  if (!list || list->empty()) throw FileError(place_of(node), fmt::format("'{}' takes a list of texts", key));
  std::vector<std::string> result;
  for (const toml::node& item : *list) result.push_back(text_of(item, key));
  return result;
}

double number_of(const toml::node& node, const char* key, double least, double most) {
  const auto number = node.value<double>();
  if (!number || !(*number >= least && *number <= most))
    throw FileError(place_of(node), fmt::format("'{}' takes a number from {:g} to {:g}", key, least, most));
  return *number;
}

/// What to do with a key, or nothing for one that is unknown.
bool read_key(std::string_view key, const toml::node& node, SweepPlan& plan) {
  if (key == "schemes") {
    plan.schemes = texts_of(node, "schemes");
  } else if (key == "ask") {
    plan.ask = texts_of(node, "ask");
    for (const std::string& name : plan.ask)
      if (std::ranges::find(known_questions(), name) == known_questions().end())
        throw FileError(place_of(node), fmt::format("'ask' takes some of {}", fmt::join(known_questions(), ", ")));
  } else if (key == "where") {
    plan.where = text_of(node, "where");
  } else if (key == "expect") {
    plan.expect = text_of(node, "expect");
  } else if (key == "columns") {
    plan.columns = texts_of(node, "columns");
  } else if (key == "budget") {
    plan.budget = number_of(node, "budget", 0.001, 1e6);
  } else if (key == "memory") {
    plan.memory = static_cast<std::size_t>(number_of(node, "memory", 1, 1e6));
  } else {
    return false;
  }
  return true;
}

/// The last line of what a program said, without its name.
std::string message_of(const runtime::ProcessEnd& end) {
  std::string text = end.errors;
  while (text.ends_with('\n')) text.pop_back();
  if (const std::size_t line = text.rfind('\n'); line != std::string::npos) text.erase(0, line + 1);
  if (text.starts_with("subcert: ")) text.erase(0, 9);
  return text.empty() ? fmt::format("exit code {} without an answer", end.code) : text;
}

}  // namespace

const std::vector<std::string>& known_questions() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Question& question : questions()) result.push_back(question.name);
    return result;
  }();
  return names;
}

SweepPlan read_sweep_plan(std::string_view toml) {
  SweepPlan plan;
  const toml::table table = parse_toml(toml);
  for (const auto& [key, node] : table)
    if (!read_key(key.str(), node, plan))
      throw FileError(place_of(key.source()), "unknown key " + in_quotes(key.str()) +
                                                  "; expected schemes, ask, where, expect, columns, budget or memory");
  if (plan.schemes.empty()) throw FileError({1, 1}, "no schemes; expected schemes = [\"primal:n=1..9\", ...]");
  return plan;
}

std::vector<std::string> schemes_of_plan(const SweepPlan& plan) {
  std::optional<Condition> where;
  if (!plan.where.empty()) where = Condition::parse("--where", plan.where);
  std::vector<std::string> result;
  std::set<std::string> seen;
  for (const std::string& grid : plan.schemes)
    for (std::string& scheme : schemes_of_grid(grid)) {
      if (where) {
        Json keys = Json::object();
        for (const auto& [key, value] : keys_of_scheme(scheme)) keys[key] = value;
        if (where->holds([&](const std::string& name) { return member_at(keys, name); }) != Truth::yes) continue;
      }
      if (seen.insert(scheme).second) result.push_back(std::move(scheme));
    }
  return result;
}

Json answers_of_scheme(const SweepPlan& plan, const std::string& scheme, const std::string& program) {
  Json result = {{"scheme", scheme}, {"keys", Json::object()}, {"answers", Json::object()}, {"errors", Json::object()}};
  for (const auto& [key, value] : keys_of_scheme(scheme)) result["keys"][key] = value;
  for (const Question& question : questions()) {
    if (std::ranges::find(plan.ask, question.name) == plan.ask.end()) continue;
    std::vector<std::string> arguments{question.name, scheme, "--json", "--quiet", "--jobs", "1"};
    arguments.insert(arguments.end(), question.arguments.begin(), question.arguments.end());
    if (question.has_budget) arguments.insert(arguments.end(), {"--budget", fmt::format("{}", plan.budget)});
    if (question.has_memory) arguments.insert(arguments.end(), {"--memory", std::to_string(plan.memory)});
    // A search that does not heed its budget is ended.
    const runtime::ProcessEnd end = runtime::run_process(program, arguments, 4 * plan.budget + 60);
    Json answer = Json::parse(end.output, nullptr, false);
    if (end.signal != 0) {
      result["errors"][question.name] = fmt::format("ended by signal {}", end.signal);
    } else if (!answer.is_object()) {
      result["errors"][question.name] = message_of(end);
    } else {
      answer.erase("seconds");
      answer.erase("subcert");
      result["answers"][question.name] = std::move(answer);
    }
  }
  return result;
}

const Json* value_of(const Json& answers, std::string_view name) {
  if (const Json* value = member_at(answers, name)) return value;
  for (const Json& answer : answers.at("answers"))
    if (const Json* value = member_at(answer, name)) return value;
  return member_at(answers.at("keys"), name);
}

}  // namespace subcert::sweeps
