#include "sweep_plan.hpp"

#include "scheme_grid.hpp"

#include <subcert/proofs-checks/toml_fields.hpp>
#include <subcert/schemes/data/runtime/files.hpp>
#include <subcert/schemes/data/runtime/process.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace subcert::sweeps {
namespace {

/// The arguments of a command that answers about a scheme, before those that all have.
struct Question {
  std::string name;
  std::vector<std::string> arguments = {};
  bool has_budget = true, has_memory = false, has_certificate = false;
};

const std::vector<Question>& questions() {
  static const std::vector<Question> all = {{.name = "regularity", .has_memory = true, .has_certificate = true},
                                            {.name = "analyze"},
                                            {.name = "variance"},
                                            {.name = "limit", .arguments = {"--range"}},
                                            {.name = "mask", .has_budget = false}};
  return all;
}

constexpr const char* certificate_name = "certificate";

/// Whether an answer tells of a certificate.
bool is_written(const Json& answer) {
  const Json* certificate = member_at(answer, "certificate");
  return certificate && !certificate->is_null();
}

/// No input of the user's, so nobody hears of it.
std::string content(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What stands at the key, or the usual number.
double number_at(const toml::table& table, const std::string& key, double least, double most, double usual) {
  const toml::node* node = table.get(key);
  if (!node) return usual;
  const auto number = node->value<double>();
  if (!number || !(*number >= least && *number <= most))
    throw FileError(place_of(*node), fmt::format("'{}' takes a number from {:g} to {:g}", key, least, most));
  return *number;
}

Json keys_json(const std::string& scheme) {
  Json keys = Json::object();
  for (const auto& [key, value] : keys_of_scheme(scheme)) keys[key] = value;
  return keys;
}

/// The last line of what a program said, without its name.
std::string message_of(const runtime::ProcessEnd& end) {
  std::string text = end.errors;
  while (text.ends_with('\n')) text.pop_back();
  if (const std::size_t line = text.rfind('\n'); line != std::string::npos) text.erase(0, line + 1);
  if (text.starts_with("subcert: ")) text.erase(0, 9);
  return text.empty() ? fmt::format("exit code {} without an answer", end.code) : text;
}

/// How the program answered. A search that does not heed its budget is ended.
runtime::ProcessEnd asked(const Question& question, const SweepPlan& plan, const std::string& scheme,
                          const std::string& program) {
  std::vector<std::string> arguments{question.name, scheme, "--json", "--quiet", "--jobs", "1"};
  arguments.insert(arguments.end(), question.arguments.begin(), question.arguments.end());
  if (question.has_budget) arguments.insert(arguments.end(), {"--budget", fmt::format("{}", plan.budget)});
  if (question.has_memory) arguments.insert(arguments.end(), {"--memory", std::to_string(plan.memory)});
  return runtime::run_process(program, arguments, 4 * plan.budget + 60);
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
  only_keys(table, {"schemes", "ask", "where", "expect", "columns", "budget", "memory", "certificates"});
  plan.schemes = optional_texts(table, "schemes");
  if (plan.schemes.empty()) throw FileError({1, 1}, "no schemes; expected schemes = [\"primal:n=1..9\", ...]");
  if (table.get("ask")) plan.ask = optional_texts(table, "ask");
  for (const std::string& name : plan.ask)
    if (std::ranges::find(known_questions(), name) == known_questions().end())
      throw FileError(place_of(*table.get("ask")),
                      fmt::format("'ask' takes some of {}", fmt::join(known_questions(), ", ")));
  plan.where = optional_text(table, "where");
  plan.expect = optional_text(table, "expect");
  plan.columns = optional_texts(table, "columns");
  plan.budget = number_at(table, "budget", 0.001, 1e6, plan.budget);
  plan.memory = static_cast<std::size_t>(number_at(table, "memory", 1, 1e6, static_cast<double>(plan.memory)));
  if (const toml::node* node = table.get("certificates")) {
    if (!node->is_boolean()) throw FileError(place_of(*node), "'certificates' takes true or false");
    plan.certificates = node->as_boolean()->get();
  }
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
        const Json keys = keys_json(scheme);
        if (where->holds([&](const std::string& name) { return member_at(keys, name); }) != Truth::yes) continue;
      }
      if (seen.insert(scheme).second) result.push_back(std::move(scheme));
    }
  return result;
}

Json answers_of_scheme(const SweepPlan& plan, const std::string& scheme, const std::string& program) {
  Json result = {
      {"scheme", scheme}, {"keys", keys_json(scheme)}, {"answers", Json::object()}, {"errors", Json::object()}};
  std::optional<runtime::TemporaryFolder> folder;
  for (Question question : questions()) {
    if (std::ranges::find(plan.ask, question.name) == plan.ask.end()) continue;
    if (plan.certificates && question.has_certificate)
      question.arguments = {"--certificate", folder.emplace() / certificate_name};
    const runtime::ProcessEnd end = asked(question, plan, scheme, program);
    Json answer = Json::parse(end.output, nullptr, false);
    if (end.signal != 0) {
      result["errors"][question.name] = fmt::format("ended by signal {}", end.signal);
    } else if (!answer.is_object()) {
      result["errors"][question.name] = message_of(end);
    } else {
      answer.erase("seconds");
      answer.erase("subcert");
      if (is_written(answer)) result["certificate"] = content(*folder / certificate_name);
      answer.erase("certificate");
      result["answers"][question.name] = std::move(answer);
    }
  }
  return result;
}

SweepCase case_of(const SweepPlan& plan, const std::string& scheme) {
  return {fmt::format("sweep {} of {} budget {} memory {}{}", fmt::join(plan.ask, ","), scheme, plan.budget,
                      plan.memory, plan.certificates ? " certificates" : "")};
}

bool write_certificate(const SweepPlan& plan, const std::string& scheme, const std::string& program,
                       const std::string& file) {
  Question question = questions().front();
  question.arguments = {"--certificate", file};
  const Json answer = Json::parse(asked(question, plan, scheme, program).output, nullptr, false);
  return is_written(answer);
}

const Json* value_of(const Json& answers, std::string_view name) {
  if (const Json* value = member_at(answers, name)) return value;
  if (const Json* several = member_at(answers, "answers"))
    for (const Json& answer : *several)
      if (const Json* value = member_at(answer, name)) return value;
  const Json* keys = member_at(answers, "keys");
  return keys ? member_at(*keys, name) : nullptr;
}

}  // namespace subcert::sweeps
