#include "comparison.hpp"

#include <subcert/analysis/symbol/printed_decimal.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace subcert {
namespace {

constexpr std::array<std::pair<Verdict, const char*>, 4> verdict_names{
    {{Verdict::match, "match"},
     {Verdict::mismatch, "mismatch"},
     {Verdict::open, "open"},
     {Verdict::not_reproducible, "not-reproducible"}}};

}  // namespace

std::string to_text(Verdict verdict) {
  return std::find_if(verdict_names.begin(), verdict_names.end(), [&](const auto& v) { return v.first == verdict; })
      ->second;
}

Verdict parse_verdict(const std::string& text) {
  for (const auto& [verdict, name] : verdict_names)
    if (text == name) return verdict;
  throw std::invalid_argument("verdict: need match, mismatch, open or not-reproducible, got '" + text + "'");
}

Verdict compare(const std::string& printed, const Enclosure& computed) {
  switch (agrees(read_printed_decimal(printed), computed)) {
    case Truth::yes: return Verdict::match;
    case Truth::no: return Verdict::mismatch;
    default: return Verdict::open;
  }
}

std::string Comparison::computed_text() const {
  if (const auto* text = std::get_if<std::string>(&computed)) return *text;
  const Enclosure& enclosure = std::get<Enclosure>(computed);
  const int places = read_printed_decimal(printed).places + 3;
  if (!enclosure.is_bounded()) {
    if (enclosure.lower) return ">= " + to_fixed(*enclosure.lower, places, Rounding::down);
    if (enclosure.upper) return "<= " + to_fixed(*enclosure.upper, places, Rounding::up);
    return "?";
  }
  const std::string low = to_fixed(*enclosure.lower, places, Rounding::nearest);
  const std::string high = to_fixed(*enclosure.upper, places, Rounding::nearest);
  if (low == high) return low;
  return to_fixed(*enclosure.lower, places, Rounding::down) + " ... " +
         to_fixed(*enclosure.upper, places, Rounding::up);
}

bool ComparisonTable::as_recorded() const {
  return std::all_of(comparisons.begin(), comparisons.end(),
                     [](const Comparison& c) { return c.verdict == c.recorded; });
}

int ComparisonTable::count(Verdict verdict) const {
  return static_cast<int>(
      std::count_if(comparisons.begin(), comparisons.end(), [&](const Comparison& c) { return c.verdict == verdict; }));
}

}  // namespace subcert
