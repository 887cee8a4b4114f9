#include "theorem_page.hpp"

#include <subcert/reports/facts/screen_lines.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace subcert::cli {
namespace {

using theorems::Check;
using theorems::Constant;
using theorems::Side;
using theorems::Theorem;

constexpr int digits = 10;

std::string verdict_word(Truth truth) {
  return truth == Truth::yes ? "holds" : truth == Truth::no ? "fails" : "unknown";
}

std::string side_text(const Constant& constant) { return constant.side == Side::above ? "<=" : ">="; }
/// Decimals as stated; what has too many digits for that as a fraction.
std::string stated_text(const Constant& constant) {
  const std::string text = to_decimal(constant.value, 40, Rounding::nearest);
  return text.size() > 40 ? to_text(constant.value) : text;
}

Json check_json(const Check& check) {
  return {{"id", check.id},
          {"claim", check.claim},
          {"left", enclosure_json(check.left)},
          {"right", enclosure_json(check.right)},
          {"margin", enclosure_json(check.margin())},
          {"verdict", verdict_word(check.decision.truth)}};
}

Json pairs_json(const std::vector<std::pair<std::string, std::string>>& pairs, const char* first, const char* second) {
  Json json = Json::array();
  for (const auto& [name, value] : pairs) json.push_back({{first, name}, {second, value}});
  return json;
}

/// The certified margin in units of the right side; -1 where nothing is proved.
Rational relative_margin(const Check& check) {
  const Enclosure margin = check.margin();
  if (!margin.lower || !check.right.upper || *check.right.upper == 0) return -1;
  return *margin.lower / abs(*check.right.upper);
}

/// The ends that decide, with enough digits to see it.
std::string sides_text(const Check& check) {
  const int shown = relative_margin(check) * power(Rational(10), 8) > 1 ? digits : 4 * digits;
  return check.left.upper_text(shown) + " < " + check.right.lower_text(shown) + ", margin " +
         check.margin().lower_text(3);
}

std::string check_text(const Check& check) {
  return "  (" + check.id + ") " + padded(verdict_word(check.decision.truth), 8) + check.claim + "\n" +
         std::string(18, ' ') + sides_text(check) + "\n";
}

/// Checks with one number, which differ in n, as one line: how many, and the tightest.
std::string group_text(const std::vector<const Check*>& group) {
  const Check* tightest = *std::min_element(group.begin(), group.end(), [](const Check* a, const Check* b) {
    return relative_margin(*a) < relative_margin(*b);
  });
  if (group.size() == 1) return check_text(*tightest);
  return "  (" + tightest->id + ") " + padded(verdict_word(tightest->decision.truth), 8) +
         std::to_string(group.size()) + " inequalities; the tightest: " + tightest->claim + "\n" +
         std::string(18, ' ') + sides_text(*tightest) + "\n";
}

std::string checks_text(const Theorem& theorem, bool all) {
  std::string text = "inequalities, by their numbers in the text, with certified margins\n";
  for (std::size_t i = 0; i < theorem.checks.size();) {
    std::vector<const Check*> group;
    const std::string id = theorem.checks[i].id;
    for (; i < theorem.checks.size() && theorem.checks[i].id == id; ++i) group.push_back(&theorem.checks[i]);
    if (!all) {
      text += group_text(group);
      continue;
    }
    for (const Check* check : group) text += check_text(*check);
  }
  return text;
}

}  // namespace

Json theorem_json(const Theorem& theorem) {
  Json json{{"theorem", theorem.id},
            {"d", theorem.degrees},
            {"title", theorem.title},
            {"statement", theorem.statement},
            {"text", theorem.text}};
  json["values"] = pairs_json(theorem.values, "name", "value");
  json["constants"] = Json::array();
  for (const Constant& constant : theorem.constants.all())
    json["constants"].push_back({{"name", constant.name},
                                 {"value", to_text(constant.value)},
                                 {"bounds", constant.side == Side::above ? "from above" : "from below"},
                                 {"check", constant.check},
                                 {"meaning", constant.meaning}});
  json["ranges"] = pairs_json(theorem.ranges, "n", "settled_by");
  json["checks"] = Json::array();
  for (const Check& check : theorem.checks) json["checks"].push_back(check_json(check));
  json["missing"] = theorem.missing;
  json["reason"] = theorem.decision.reason;
  json["verdict"] = verdict_word(theorem.decision.truth);
  return json;
}

std::string theorem_text(const Theorem& theorem, bool all) {
  std::ostringstream text;
  text << theorem.id << ", d = " << fmt::format("{}", fmt::join(theorem.degrees, ", ")) << ": " << theorem.title
       << "\n\n";
  for (const std::string& sentence : theorem.statement) text << facts::wrapped(sentence, 0) << "\n";
  if (!theorem.text.empty()) text << "Proof: " << theorem.text << "\n";
  for (const std::string& lack : theorem.missing) text << "missing: " << lack << "\n";
  if (!theorem.values.empty()) text << "\n";
  for (const auto& [name, value] : theorem.values) text << padded(name, 8) << " = " << value << "\n";
  if (!theorem.constants.all().empty()) text << "\nconstants, each needed from one side\n";
  std::size_t width = 0;
  for (const Constant& constant : theorem.constants.all()) width = std::max(width, stated_text(constant).size() + 2);
  for (const Constant& constant : theorem.constants.all())
    text << "  " << padded(constant.name, 9) << side_text(constant) << " " << padded(stated_text(constant), width)
         << "(" << constant.check << ")  " << constant.meaning << "\n";
  if (!theorem.ranges.empty()) text << "\nranges\n";
  width = 14;
  for (const auto& [range, means] : theorem.ranges) width = std::max(width, range.size() + 2);
  for (const auto& [range, means] : theorem.ranges) text << "  " << padded(range, width) << means << "\n";
  if (!theorem.checks.empty()) text << "\n" << checks_text(theorem, all);
  text << "\nverdict: " << verdict_word(theorem.decision.truth) << " (" << theorem.decision.reason << ")\n";
  return facts::wrapped(text.str(), 18);
}

}  // namespace subcert::cli
