#include "check_reports.hpp"

#include <subcert/analysis/symbol/support/parse_error.hpp>
#include <subcert/proofs-checks/properties/properties.hpp>
#include <subcert/reports/formats/html.hpp>
#include <subcert/reports/formats/provenance.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

namespace subcert::cli {
namespace {

std::size_t count(const std::vector<CheckedProperty>& all, Truth truth) {
  return static_cast<std::size_t>(
      std::ranges::count_if(all, [=](const CheckedProperty& one) { return one.is(truth); }));
}

/// As a reference of a file in a report: what is no letter, digit or one of -._~/ by its bytes.
std::string uri(const std::string& file) {
  std::string result = file.starts_with('/') ? "file://" : "";
  for (const char c : file) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x80 && (std::isalnum(byte) || std::string_view("-._~/").find(c) != std::string_view::npos)
                  ? std::string(1, c)
                  : fmt::format("%{:02X}", byte);
  }
  return result;
}

}  // namespace

Json property_json(const CheckedProperty& one) {
  return {{"file", one.file},     {"line", one.place.line},      {"scheme", one.specification},
          {"name", one.name},     {"property", one.property},    {"expected", one.expected},
          {"holds", one.holds()}, {"found", one.decision.reason}};
}

std::string property_line(const CheckedProperty& one) {
  const std::string claim = one.claim();
  const std::string column = one.unreadable ? ":" + std::to_string(one.place.column) : "";
  const std::string place = one.file + ":" + std::to_string(one.place.line) + column + ": ";
  if (one.is(Truth::yes)) return "holds      " + place + claim + "\n";
  const std::string verdict = one.error ? "error      " : one.is(Truth::no) ? "FAILS      " : "undecided  ";
  return verdict + place + claim + " (" + visible(one.decision.reason) + ")\n";
}

std::string counts_text(const std::vector<CheckedProperty>& all) {
  const auto errors = std::ranges::count_if(all, &CheckedProperty::error);
  return fmt::format("\n{} {}: {} hold, {} fail, {} undecided{}.\n", all.size(),
                     all.size() == 1 ? "property" : "properties", count(all, Truth::yes), count(all, Truth::no),
                     count(all, Truth::unknown),
                     errors == 0 ? "" : fmt::format(", {} error{}", errors, errors == 1 ? "" : "s"));
}

std::string junit_text(const std::vector<CheckedProperty>& all) {
  using formats::html;
  std::string tests;
  for (const CheckedProperty& one : all) {
    const std::string file = html(visible(one.file)), reason = html(visible(one.decision.reason));
    tests += fmt::format("  <testcase classname=\"{0}\" name=\"{1}\" file=\"{0}\" line=\"{2}\"", file,
                         html(visible(one.claim())), one.place.line);
    tests += one.is(Truth::yes) ? "/>\n"
             : one.is(Truth::no)
                 ? fmt::format("><failure message=\"{}\"/></testcase>\n", reason)
                 : fmt::format("><error message=\"{}{}\"/></testcase>\n", one.error ? "" : "undecided: ", reason);
  }
  const std::size_t failures = count(all, Truth::no);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuite name=\"subcert check\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n{}</testsuite>\n",
      all.size(), failures, all.size() - failures - count(all, Truth::yes), tests);
}

std::string sarif_text(const std::vector<CheckedProperty>& all) {
  Json rules = Json::array(), results = Json::array();
  for (const auto& property : properties::known_properties())
    rules.push_back({{"id", property.name}, {"shortDescription", {{"text", property.meaning}}}});
  rules.push_back({{"id", "scheme"}, {"shortDescription", {{"text", "can be read, with its properties"}}}});
  for (const CheckedProperty& one : all) {
    if (one.is(Truth::yes)) continue;
    const bool open = one.is(Truth::unknown);
    const Json region{{"startLine", one.place.line}, {"startColumn", std::max(1U, one.place.column)}};
    results.push_back(
        {{"ruleId", one.unreadable ? "scheme" : one.property},
         {"kind", open ? "open" : "fail"},
         {"level", open ? "none" : "error"},
         {"message", {{"text", visible(one.claim() + (open ? " is undecided: " : ": ") + one.decision.reason)}}},
         {"locations",
          {{{"physicalLocation", {{"artifactLocation", {{"uri", uri(one.file)}}}, {"region", region}}}}}}});
  }
  const Json driver{{"name", "subcert"}, {"version", formats::version()}, {"rules", std::move(rules)}};
  return Json{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
              {"version", "2.1.0"},
              {"runs", {{{"tool", {{"driver", driver}}}, {"results", std::move(results)}}}}}
             .dump(1) +
         "\n";
}

}  // namespace subcert::cli
