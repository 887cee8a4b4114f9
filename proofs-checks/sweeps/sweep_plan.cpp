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

/// An answer, and the certificate that came with it.
struct CertifiedReply {
  Reply reply;
  std::optional<std::string> certificate;
};

CertifiedReply ask_with_certificate(const SchemeQuestion& question, const std::string& scheme, const SweepPlan& plan,
                                    const std::string& program) {
  const runtime::TemporaryFolder folder;
  const std::string file = folder / certificate_name;
  CertifiedReply result{question.ask(scheme, plan, program, file), std::nullopt};
  if (is_written(result.reply.answer)) result.certificate = content(file);
  return result;
}

/// A condition that can be read; empty where there is none.
std::string condition_at(const toml::table& table, const std::string& key) {
  std::string text = optional_text(table, key);
  try {
    if (!text.empty()) Condition::parse(key, text);
  } catch (const ParseError& error) {
    throw FileError(place_of(*table.get(key)), error.what());
  }
  return text;
}

/// The texts at the key with their places.
std::vector<SchemeText> scheme_texts(const toml::table& table) {
  std::vector<SchemeText> result;
  const std::vector<std::string> texts = optional_texts(table, "schemes");
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const Place at = place_of(*table.get("schemes")->as_array()->get(k));
    result.push_back({texts[k], fmt::format("line {}, column {}", at.line, at.column)});
  }
  return result;
}

/// The schemes that a text names. Errors: as schemes_of_plan().
std::vector<std::string> schemes_of_text(const SchemeText& grid) {
  try {
    return schemes_of_grid(grid.text);
  } catch (const ParseError& error) {
    if (grid.place.empty()) throw;
    fail(ErrorKind::data, "{}: {}", grid.place, error.what());
  }
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
  plan.schemes = scheme_texts(table);
  if (plan.schemes.empty()) throw FileError({1, 1}, "no schemes; expected schemes = [\"primal:n=1..9\", ...]");
  if (table.get("ask")) plan.ask = optional_texts(table, "ask");
  for (std::string& text : plan.ask) try {
      text = SchemeQuestion::parse(text).text();
    } catch (const ParseError& error) {
      throw FileError(place_of(*table.get("ask")),
                      fmt::format("'ask' takes questions, got '{}'; expected {}", text, error.expected()));
    }
  plan.where = condition_at(table, "where");
  plan.expect = condition_at(table, "expect");
  plan.columns = optional_texts(table, "columns");
  plan.budget = number_at(table, "budget", 0.001, 1e6, plan.budget);
  if (const toml::node* node = table.get("memory"); node && !node->is_integer())
    throw FileError(place_of(*node), "'memory' takes a whole number of MiB");
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
  for (const SchemeText& grid : plan.schemes)
    for (std::string& scheme : schemes_of_text(grid)) {
      if (where) {
        const Json keys = keys_json(scheme);
        if (where->holds([&](const std::string& name) { return member_at(keys, name); }) != Truth::yes) continue;
      }
      if (!seen.insert(scheme).second) continue;
      require(result.size() < most_schemes, "sweep: need at most {} schemes", most_schemes);
      result.push_back(std::move(scheme));
    }
  return result;
}

Json answers_of_scheme(const SweepPlan& plan, const std::string& scheme, const std::string& program) {
  Json result = {
      {"scheme", scheme}, {"keys", keys_json(scheme)}, {"answers", Json::object()}, {"errors", Json::object()}};
  for (const std::string& text : plan.ask) {
    const SchemeQuestion question = SchemeQuestion::parse(text);
    auto [reply, certificate] = plan.certificates && question.has_certificate()
                                    ? ask_with_certificate(question, scheme, plan, program)
                                    : CertifiedReply{question.ask(scheme, plan, program), std::nullopt};
    auto& [answer, error] = reply;
    if (answer.is_null()) {
      result["errors"][text] = error;
      continue;
    }
    if (certificate) result["certificate"] = *certificate;
    answer.erase("certificate");
    result["answers"][text] = std::move(answer);
  }
  return result;
}

SweepCase case_of(const SweepPlan& plan, const std::string& scheme) {
  return {fmt::format("sweep {} of {} budget {} memory {}{}", fmt::join(plan.ask, ","), scheme, plan.budget,
                      plan.memory, plan.certificates ? " certificates" : "")};
}

std::optional<std::string> certificate_of(const SweepPlan& plan, const std::string& scheme,
                                          const std::string& program) {
  auto [reply, certificate] = ask_with_certificate(SchemeQuestion::parse("regularity"), scheme, plan, program);
  if (!reply.answer.is_null() && !reply.error.empty()) fail(ErrorKind::missing_file, "{}", reply.error);
  return certificate;
}

Truth meets(const Json& answers, const Condition& condition) {
  return condition.meets([&](const std::string& name) { return value_of(answers, name); });
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
