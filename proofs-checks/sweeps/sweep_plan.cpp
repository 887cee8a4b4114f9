#include "sweep_plan.hpp"

#include "scheme_grid.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/proofs-checks/toml_fields.hpp>
#include <subcert/schemes/data/runtime/files.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

namespace subcert::sweeps {
namespace {

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

}  // namespace

SweepPlan read_sweep_plan(std::string_view toml) {
  SweepPlan plan;
  const toml::table table = parse_toml(toml);
  only_keys(table, {"schemes", "ask", "where", "expect", "columns", "budget", "memory", "certificates"});
  plan.schemes = optional_texts(table, "schemes");
  if (plan.schemes.empty()) throw FileError({1, 1}, "no schemes; expected schemes = [\"primal:n=1..9\", ...]");
  if (table.get("ask")) plan.ask = optional_texts(table, "ask");
  for (std::string& text : plan.ask) try {
      text = SchemeQuestion::parse(text).text();
    } catch (const ParseError& error) {
      throw FileError(place_of(*table.get("ask")),
                      fmt::format("'ask' takes questions, got '{}'; expected {}", text, error.expected()));
    }
  plan.where = optional_text(table, "where");
  plan.expect = optional_text(table, "expect");
  plan.columns = optional_texts(table, "columns");
  plan.budget = number_at(table, "budget", 0.001, 1e6, plan.budget);
  plan.memory = static_cast<std::size_t>(number_at(table, "memory", 16, 1e6, static_cast<double>(plan.memory)));
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
  for (const std::string& text : plan.ask) {
    const SchemeQuestion question = SchemeQuestion::parse(text);
    const bool is_certified = plan.certificates && question.has_certificate();
    const std::string file = is_certified ? folder.emplace() / certificate_name : "";
    auto [answer, error] = question.ask(scheme, plan, program, file);
    if (answer.is_null()) {
      result["errors"][text] = error;
      continue;
    }
    if (is_written(answer)) result["certificate"] = content(file);
    answer.erase("certificate");
    result["answers"][text] = std::move(answer);
  }
  return result;
}

SweepCase case_of(const SweepPlan& plan, const std::string& scheme) {
  return {fmt::format("sweep {} of {} budget {} memory {}{}", fmt::join(plan.ask, ","), scheme, plan.budget,
                      plan.memory, plan.certificates ? " certificates" : "")};
}

bool write_certificate(const SweepPlan& plan, const std::string& scheme, const std::string& program,
                       const std::string& file) {
  return is_written(SchemeQuestion::parse("regularity").ask(scheme, plan, program, file).answer);
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
