#include "entry_facts.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::facts {
namespace {

std::string value_text(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{:g}", value.get<double>());
  if (value.is_array()) {
    std::vector<std::string> texts;
    for (const Json& one : value) texts.push_back(value_text(one));
    return fmt::format("{}", fmt::join(texts, ", "));
  }
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string enclosure_text(const Json& value) {
  const auto end = [&](const char* name) { return parse_number(value.at(name).get<std::string>()); };
  return subcert::enclosure_text({end("lower"), end("upper")});
}

/// `power 1, by the growth of ...`
std::string logarithm_text(const Json& value) {
  const std::string least = value_text(value.at("at_least")), most = value_text(value.at("at_most"));
  return fmt::format("power {}, {}",
                     least == most  ? least
                     : most.empty() ? "at least " + least
                                    : fmt::format("{} to {}", least, most),
                     value_text(value.at("reason")));
}

std::string member_text(const Json& value) {
  if (!value.is_object()) return value_text(value);
  return value.contains("reason") ? logarithm_text(value) : enclosure_text(value);
}

std::string label_of(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

}  // namespace

Facts entry_facts(const Json& entry) {
  Facts list;
  for (const atlas::Member& member : atlas::entry_members()) {
    const std::string text = member_text(entry.at(member.name));
    list.push_back({member.name, text.empty() ? "" : label_of(member.name), text, "", entry.at(member.name)});
  }
  return list;
}

std::string title_of_entry(const Json& entry) {
  const Json& names = entry.at("names");
  return (names.empty() ? entry.at("mask") : names.front()).get<std::string>();
}

}  // namespace subcert::facts
