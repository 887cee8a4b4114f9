#include "conjecture_page.hpp"

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/reports/facts/screen_lines.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::cli {
namespace {

using namespace conjectures;

std::string conjecture_verdict(Truth truth) {
  return truth == Truth::yes ? "holds" : truth == Truth::no ? "violated" : "undecided";
}

/// Columns as wide as their widest word.
std::string table_text(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += padded(row[i], widths[i] + 2);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Json head_json(int number, const ConjectureRange& range) {
  Json json{{"conjecture", number}, {"n", range.n}, {"d", range.d}};
  if (!range.shard.empty()) json["shard"] = range.shard;
  return json;
}

Json skipped_json(const PrimalSchemes& schemes) {
  Json skipped = Json::array();
  for (const auto& one : schemes.skipped)
    skipped.push_back({{"scheme", one.scheme.specification()}, {"reason", one.reason()}});
  return skipped;
}

std::string skipped_text(const PrimalSchemes& schemes) {
  std::string text;
  for (const std::string& line : schemes.skipped_lines()) text += "left out: " + line + "\n";
  return text;
}

std::string shard_note(const ConjectureRange& range) {
  return "shard " + range.shard + ": no verdict; join the journals with 'subcert merge' and run without --shard\n";
}

Json constant_json(const LimitComparison& limit) {
  constexpr int digits = 26;
  return {{"lower", limit.constant.lower_text(digits)}, {"upper", limit.constant.upper_text(digits)}};
}

Json row_json(const VarianceRow& row, const Conjecture7& answer) {
  const int n = row.scheme.n;
  const auto deviation = answer.deviation(row.scheme);
  Json json{{"d", row.scheme.d},
            {"n", n},
            {"scheme", row.scheme.specification()},
            {"sup", enclosure_json(row.sup)},
            {"n_sup", enclosure_json(scaled(row.sup, n))},
            {"limit_constant", deviation ? constant_json(answer.limits.at(row.scheme.d)) : Json()},
            {"limit_deviation", enclosure_json(deviation)},
            {"derivative_sup", enclosure_json(row.slope)},
            {"n2_derivative_sup", row.slope ? enclosure_json(scaled(*row.slope, n * n)) : Json()}};
  if (!row.slope) json["derivative_reason"] = row.slope_reason;
  json["mean"] = to_text(row.mean);
  json["complete"] = row.complete;
  return json;
}

std::vector<std::string> row_words(const VarianceRow& row, const Conjecture7& answer) {
  constexpr int digits = 6;
  const int n = row.scheme.n;
  const auto deviation = answer.deviation(row.scheme);
  std::vector<std::string> words{std::to_string(row.scheme.d),
                                 std::to_string(n),
                                 enclosure_text(row.sup, digits),
                                 enclosure_text(scaled(row.sup, n), digits),
                                 deviation ? enclosure_text(*deviation, 4) : "-",
                                 row.slope ? enclosure_text(*row.slope, digits) : "-",
                                 row.slope ? enclosure_text(scaled(*row.slope, n * n), digits) : row.slope_reason};
  if (!row.complete) words.emplace_back("(budget spent)");
  return words;
}

Json finding_json(const DegreeDecay& finding) {
  const DecayFinding& decay = finding.decay;
  Json json{{"d", finding.d},
            {"quantity", finding.quantity},
            {"power", decay.power},
            {"largest", enclosure_json(decay.largest)},
            {"smallest", enclosure_json(decay.smallest)}};
  if (decay.exponent) {
    json["exponent"] = enclosure_json(*decay.exponent);
    json["exponent_n"] = {decay.rate_from, decay.last_n};
  }
  json["upper_bound"] = to_text(decay.upper_bound.truth);
  json["rate"] = to_text(decay.rate.truth);
  json["sentence"] = decay.sentence(finding.quantity);
  return json;
}

Json limit_json(const LimitComparison& limit) {
  Json json{{"d", limit.degree}, {"constant", constant_json(limit)}};
  if (limit.exponent) {
    json["deviation_exponent"] = enclosure_json(*limit.exponent);
    json["exponent_n"] = {limit.rate_from, limit.deviation.back().n};
  }
  json["sentence"] = limit.sentence();
  return json;
}

}  // namespace

Json conjecture_json(const Conjecture7& answer, const ConjectureRange& range) {
  Json json = head_json(7, range);
  json["rows"] = Json::array();
  for (const VarianceRow& row : answer.rows) json["rows"].push_back(row_json(row, answer));
  json["skipped"] = skipped_json(range.schemes);
  if (range.shard.empty()) {
    json["findings"] = Json::array();
    for (const DegreeDecay& finding : answer.findings) json["findings"].push_back(finding_json(finding));
    json["limits"] = Json::array();
    for (const auto& [degree, limit] : answer.limits) json["limits"].push_back(limit_json(limit));
  }
  json["verdict"] = answer.has_rate ? Json(conjecture_verdict(answer.verdict)) : Json();
  return json;
}

std::string conjecture_text(const Conjecture7& answer, const ConjectureRange& range) {
  std::vector<std::vector<std::string>> table{
      {"d", "n", "max psi", "n max psi", "n max psi / C_d - 1", "max |psi'|", "n^2 max |psi'|"}};
  for (const VarianceRow& row : answer.rows) table.push_back(row_words(row, answer));
  std::string text = table_text(table) + "\n" + skipped_text(range.schemes);
  if (!range.shard.empty()) text += shard_note(range);
  for (const DegreeDecay& finding : answer.findings)
    text += facts::wrapped(fmt::format("d = {}: {}\n", finding.d, finding.decay.sentence(finding.quantity)), 2);
  if (range.shard.empty())
    for (const auto& [degree, limit] : answer.limits)
      text += facts::wrapped(fmt::format("d = {}: {}\n", degree, limit.sentence()), 2);
  return text;
}

Json conjecture_json(const Conjecture8& answer, const ConjectureRange& range) {
  Json json = head_json(8, range);
  json["rows"] = Json::array();
  for (const ComparisonRow& row : answer.rows) {
    Json& one = json["rows"].emplace_back(Json{{"larger", row.pair.larger.specification()},
                                               {"smaller", row.pair.smaller.specification()},
                                               {"verdict", to_text(row.holds.truth)},
                                               {"reason", row.holds.reason}});
    if (row.witness) one["witness"] = to_text(*row.witness);
    if (row.difference) one["difference"] = to_text(*row.difference);
  }
  json["skipped"] = skipped_json(range.schemes);
  json["verdict"] = range.shard.empty() ? Json(conjecture_verdict(answer.verdict)) : Json();
  return json;
}

std::string conjecture_text(const Conjecture8& answer, const ConjectureRange& range) {
  std::string text;
  for (const ComparisonRow& row : answer.rows) {
    text += padded(conjecture_verdict(row.holds.truth), 10) + "psi of " + row.pair.larger.specification() +
            " >= psi of " + row.pair.smaller.specification();
    if (row.witness) text += ", false at x = " + to_text(*row.witness);
    if (row.holds.truth == Truth::unknown) text += " (" + row.holds.reason + ")";
    text += "\n";
  }
  text += "\n" + skipped_text(range.schemes) +
          fmt::format("{} comparisons: {} hold, {} violated, {} undecided.\n", answer.rows.size(),
                      answer.count(Truth::yes), answer.count(Truth::no), answer.count(Truth::unknown));
  if (!range.shard.empty()) return text + shard_note(range);
  const char* const verdict = answer.verdict == Truth::yes  ? "holds"
                              : answer.verdict == Truth::no ? "is violated"
                                                            : "is undecided";
  return text + fmt::format("Conjecture 8 {} for n in {} and d in {}{}.\n", verdict, range.n, range.d,
                            answer.verdict == Truth::yes ? "; all other comparisons follow by transitivity" : "");
}

}  // namespace subcert::cli
