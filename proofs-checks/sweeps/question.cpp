#include "question.hpp"

#include "condition.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/analysis/symbol/support/utf8.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::sweeps {
namespace {

struct Setting {
  std::string name;
  bool has_value = true;
};

/// A command that answers about a scheme.
struct AnsweringCommand {
  std::string name;
  std::vector<Setting> settings = {};     ///< that change what it answers
  std::vector<std::string> usually = {};  ///< where none is given
  bool has_budget = true, has_memory = false, has_certificate = false;
};

constexpr const char* check_command = "check";
constexpr int not_written = 66;  // the exit code behind an answer

const std::vector<AnsweringCommand>& answering_commands() {
  static const std::vector<AnsweringCommand> all = {
      {.name = "regularity",
       .settings = {{"--levels"}, {"--width"}, {"--method"}, {"--component"}},
       .has_memory = true,
       .has_certificate = true},
      {.name = "analyze", .settings = {{"--levels"}}},
      {.name = "variance", .settings = {{"--width"}}},
      {.name = "limit",
       .settings = {{"--level"}, {"--derivative"}, {"--range", false}, {"--width"}},
       .usually = {"--range"}},
      {.name = "mask", .has_budget = false},
      {.name = "vertex", .settings = {{"--valence"}}, .has_memory = true},
      {.name = "levels",
       .settings = {{"--over"}, {"--property"}, {"--recurrence"}, {"--start"}, {"--each-point", false}},
       .has_memory = true},
      {.name = "range", .settings = {{"--over"}, {"--property"}, {"--width"}}, .has_memory = true},
      {.name = "curve", .settings = {{"--over"}, {"--pieces"}}, .has_memory = true},
      {.name = "l1", .settings = {{"--steps"}, {"--order"}, {"--rule", false}}},
      {.name = check_command}};
  return all;
}

const AnsweringCommand* find_command(std::string_view name) {
  const auto found = std::ranges::find(answering_commands(), name, &AnsweringCommand::name);
  return found == answering_commands().end() ? nullptr : &*found;
}

/// Words between blanks, each with its place.
std::vector<std::pair<std::string, std::size_t>> words_of(std::string_view text) {
  std::vector<std::pair<std::string, std::size_t>> words;
  for (std::size_t begin = text.find_first_not_of(' '); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.emplace_back(text.substr(begin, end - begin), begin);
    begin = text.find_first_not_of(' ', end);
  }
  return words;
}

/// The last line of what a program said, without its name.
std::string message_of(const runtime::ProcessEnd& end) {
  std::string text = end.errors;
  while (text.ends_with('\n')) text.pop_back();
  if (const std::size_t line = text.rfind('\n'); line != std::string::npos) text.erase(0, line + 1);
  if (text.starts_with("subcert: ")) text.erase(0, 9);
  return text.empty() ? fmt::format("exit code {} without an answer", end.code) : text;
}

/// As TOML has it: what it writes without quotes stays.
std::string toml_value(const std::string& expected) {
  const bool is_bare = expected == "true" || expected == "false" || expected.starts_with('[') ||
                       expected.find_first_not_of("-0123456789") == std::string::npos;
  return is_bare ? expected : Json(expected).dump();
}

/// What one property that was asked for is.
Reply checked(const Json& answer) {
  const Json& one = answer.at("properties").at(0);
  const auto holds = one.at("holds").get<std::string>();
  if (holds == "error") return {nullptr, one.at("found")};
  const Json truth = holds == to_text(Truth::unknown) ? Json(nullptr) : Json(holds == to_text(Truth::yes));
  const auto property = one.at("property").get<std::string>();
  return {{{"check", {{property, truth}}}, {"found", {{property, one.at("found")}}}}, ""};
}

}  // namespace

Reply reply_to(const std::vector<std::string>& arguments, const runtime::ProcessSettings& settings,
               const std::string& program) {
  const runtime::ProcessEnd end = runtime::run_process(program, arguments, settings);
  if (end.signal != 0) return {nullptr, fmt::format("ended by signal {}", end.signal)};
  Json answer = Json::parse(end.output, nullptr, false);
  if (!answer.is_object()) return {nullptr, message_of(end)};
  return {std::move(answer), end.code == not_written ? message_of(end) : ""};
}

double most_seconds(double budget) { return 4 * budget + 60; }

double searching_seconds(double budget) {
  constexpr double proofs = 0.5;  // as Deadline::later() has it, beside a tenth
  return std::max(budget - proofs, budget / 2);
}

std::vector<std::string> check_arguments(const AnswerLimits& limits) {
  return {check_command,
          "-",
          "--in-process",
          "--json",
          "--quiet",
          "--jobs",
          "1",
          "--budget",
          fmt::format("{}", limits.budget),
          "--memory",
          std::to_string(limits.memory)};
}

std::vector<std::string> SchemeQuestion::commands() {
  std::vector<std::string> names;
  for (const AnsweringCommand& one : answering_commands()) names.push_back(one.name);
  return names;
}

SchemeQuestion SchemeQuestion::parse(std::string_view text) {
  const auto words = words_of(text);
  const AnsweringCommand* command = words.empty() ? nullptr : find_command(words.front().first);
  const auto refuse = [&](std::size_t word, const std::string& expected) {
    const bool is_end = word >= words.size();
    throw ParseError("--ask", is_end ? "" : words[word].first, (is_end ? text.size() : words[word].second) + 1,
                     expected);
  };
  if (!command) refuse(0, fmt::format("one of {}", fmt::join(commands(), ", ")));
  SchemeQuestion result;
  result.command_ = command->name;
  for (const auto& [word, place] : words) result.text_ += (result.text_.empty() ? "" : " ") + word;
  if (command->name == check_command) {
    const std::string name = words.size() > 1 ? words[1].first : "";
    std::vector<std::string> known;
    for (const auto& property : properties::known_properties()) known.push_back(property.name);
    if (!properties::find_property(name))
      refuse(1, fmt::format("a property, one of {}{}", fmt::join(known, ", "), did_you_mean(name, known)));
    result.property_ = name;
    result.expected_ = words.size() > 2 ? trimmed(text.substr(words[2].second)) : "true";
    return result;
  }
  for (std::size_t k = 1; k < words.size(); ++k) {
    std::vector<std::string> known;
    for (const Setting& setting : command->settings) known.push_back(setting.name);
    const auto setting = std::ranges::find(command->settings, words[k].first, &Setting::name);
    if (setting == command->settings.end())
      refuse(k, known.empty() ? "no more, as " + command->name + " has no settings"
                              : fmt::format("one of {}", fmt::join(known, ", ")));
    result.settings_.push_back(words[k].first);
    if (!setting->has_value) continue;
    if (++k == words.size()) refuse(k, "the value of " + setting->name);
    result.settings_.push_back(words[k].first);
  }
  if (words.size() == 1) result.settings_ = command->usually;
  return result;
}

std::vector<std::string> SchemeQuestion::split(std::string_view texts) {
  std::vector<std::string> result;
  for (std::size_t begin = 0; begin <= texts.size();) {
    const std::size_t end = std::min(texts.find(',', begin), texts.size());
    const std::string_view part = texts.substr(begin, end - begin);
    const auto words = words_of(part);
    if (result.empty() || (!words.empty() && find_command(words.front().first)))
      result.push_back(trimmed(part));
    else
      result.back().append(",").append(part);
    begin = end + 1;
  }
  for (std::string& one : result) one = parse(one).text();
  return result;
}

std::vector<std::string> SchemeQuestion::members() const {
  if (property_.empty()) return {};
  return {fmt::format("{}.{}", check_command, property_), "found." + property_};
}

bool SchemeQuestion::has_certificate() const { return find_command(command_)->has_certificate; }

Reply SchemeQuestion::ask(const std::string& scheme, const AnswerLimits& limits, const std::string& program,
                          const std::string& certificate) const {
  const double seconds = most_seconds(limits.budget);
  if (command_ == check_command) {
    const std::string file = fmt::format("mask = {}\n{} = {}\n", Json(scheme).dump(), property_, toml_value(expected_));
    Reply reply = reply_to(check_arguments(limits), {file, seconds}, program);
    return reply.answer.is_null() ? reply : checked(reply.answer);
  }
  const AnsweringCommand& command = *find_command(command_);
  const bool is_like_option = scheme.starts_with('-');
  std::vector<std::string> arguments{command.name};
  if (!is_like_option) arguments.push_back(scheme);
  arguments.insert(arguments.end(), {"--json", "--quiet", "--jobs", "1"});
  arguments.insert(arguments.end(), settings_.begin(), settings_.end());
  if (!certificate.empty()) arguments.insert(arguments.end(), {"--certificate", certificate});
  if (command.has_budget)
    arguments.insert(arguments.end(), {"--budget", fmt::format("{:.6g}", searching_seconds(limits.budget))});
  if (command.has_memory) arguments.insert(arguments.end(), {"--memory", std::to_string(limits.memory)});
  if (is_like_option) arguments.insert(arguments.end(), {"--", scheme});
  Reply reply = reply_to(arguments, {.most_seconds = seconds}, program);
  if (!reply.answer.is_null())
    for (const char* changing : {"seconds", "subcert"}) reply.answer.erase(changing);
  return reply;
}

}  // namespace subcert::sweeps
