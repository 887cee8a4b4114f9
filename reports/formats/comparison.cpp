#include "comparison.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>

namespace subcert::formats {

Verdict compare(const std::string& printed, const Enclosure& computed) {
  return comparison_verdict(agrees(read_decimal(printed), computed));
}

std::string Comparison::computed_text() const {
  if (const auto* text = std::get_if<std::string>(&computed)) return *text;
  const Enclosure& enclosure = std::get<Enclosure>(computed);
  const int places = read_decimal(printed).places() + 3;
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

}  // namespace subcert::formats
