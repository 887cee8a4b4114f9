#include "comparison.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::formats {
namespace {

/// Whether the exponent is at most this. No: it is larger.
Truth bounded_by(const Rational& bound, const Enclosure& exponent) {
  if (exponent.lower && *exponent.lower > bound) return Truth::no;
  return exponent.upper && *exponent.upper <= bound ? Truth::yes : Truth::unknown;
}

/// Whether it is at least this. No: it is smaller.
Truth reaches(const Rational& bound, const Enclosure& exponent) {
  if (exponent.upper && *exponent.upper < bound) return Truth::no;
  return exponent.lower && *exponent.lower >= bound ? Truth::yes : Truth::unknown;
}

/// Exponents above k prove C^k, those below k refute it.
Truth lies_in_class(const Rational& k, const Enclosure& exponent) {
  if (exponent.lower && *exponent.lower > k) return Truth::yes;
  return exponent.upper && *exponent.upper < k ? Truth::no : Truth::unknown;
}

Truth is_number(const Rational& value, const Enclosure& exponent) {
  if (!exponent.contains(value)) return Truth::no;
  return exponent.is_exact() ? Truth::yes : Truth::unknown;
}

}  // namespace

ValueVerdict compare(const std::string& printed, const Enclosure& computed) {
  return comparison_verdict(agrees(read_decimal(printed), computed));
}

ValueVerdict compare_exponent(const std::string& printed, const Enclosure& computed) {
  const auto after = [&](std::string_view head) { return read_decimal(std::string_view(printed).substr(head.size())); };
  if (printed.starts_with("C^")) return comparison_verdict(lies_in_class(after("C^").value, computed));
  if (printed.starts_with("<= ")) return comparison_verdict(bounded_by(after("<= ").value, computed));
  if (printed.starts_with(">= ")) return comparison_verdict(reaches(after(">= ").value, computed));
  const Decimal number = read_decimal(printed);
  return comparison_verdict(number.places() == 0 ? is_number(number.value, computed) : agrees(number, computed));
}

std::string fixed_text(const Enclosure& enclosure, int places) {
  if (!enclosure.is_bounded()) {
    if (enclosure.lower) return ">= " + to_fixed(*enclosure.lower, places, Rounding::down);
    if (enclosure.upper) return "<= " + to_fixed(*enclosure.upper, places, Rounding::up);
    return "?";
  }
  std::string low = to_fixed(*enclosure.lower, places, Rounding::nearest);
  const std::string high = to_fixed(*enclosure.upper, places, Rounding::nearest);
  if (low == high) return low;
  return to_fixed(*enclosure.lower, places, Rounding::down) + " ... " +
         to_fixed(*enclosure.upper, places, Rounding::up);
}

std::string Comparison::computed_text() const {
  if (const auto* text = std::get_if<std::string>(&computed)) return *text;
  const std::optional<Decimal> number = parse_plain_decimal(printed);
  return fixed_text(std::get<Enclosure>(computed), number ? number->places() + 3 : 6);
}

bool ComparisonTable::as_recorded() const {
  return std::all_of(comparisons.begin(), comparisons.end(),
                     [](const Comparison& c) { return c.verdict == c.recorded; });
}

bool ComparisonTable::is_gathered() const {
  return std::ranges::any_of(comparisons, [](const Comparison& c) { return !c.source.empty(); });
}

int ComparisonTable::values() const {
  return static_cast<int>(std::ranges::count_if(comparisons, [](const Comparison& c) { return c.derived.empty(); }));
}

int ComparisonTable::count(ValueVerdict verdict) const {
  return static_cast<int>(std::ranges::count_if(
      comparisons, [&](const Comparison& c) { return c.verdict == verdict && c.derived.empty(); }));
}

}  // namespace subcert::formats
