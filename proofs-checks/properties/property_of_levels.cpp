#include "deciding.hpp"

#include <subcert/analysis/family/limit_of_levels.hpp>
#include <subcert/analysis/family/local_levels.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

namespace subcert::properties {
namespace {

void require_levels(const Property& property) {
  if (!property.of_levels())
    fail(ErrorKind::domain, "has_property: need a property of levels, got '{}'", property.name);
}

std::string number_text(const Rational& value) { return to_decimal(value, 10, Rounding::nearest); }

/// Of all limits at least the lower end, of some at most the upper one. `all`: whose limits they are.
Decision by_exponent(const Enclosure& exponent, const RangeProperty& asked, const char* all) {
  std::string found = exponent.lower ? "the exponents are at least " + exponent.lower_text(8)
                                     : fmt::format("no convergence is proved for all {}", all);
  if (exponent.upper && *exponent.upper > 0) found += ", of some limits at most " + exponent.upper_text(8);
  return {holds(exponent, asked), std::move(found)};
}

}  // namespace

RangeProperty asked_of(const Property& property, const Expectation& expectation) {
  using Kind = RangeProperty::Kind;
  const bool converges = property.of_ranges == Kind::smooth && expectation.number == 0;
  return {converges ? Kind::convergent : *property.of_ranges, expectation.number};
}

Decision property_of(const SchemeLevels& levels, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits) {
  require_levels(property);
  const RangeProperty asked = asked_of(property, expectation);
  const ParametricMask& mask = levels.family.mask;
  const Budget budget = limits.budget();
  const PropertyOfLevels all = property_of_levels(mask, asked, {{levels.values.lower}, {levels.values.upper}}, budget);
  if (!levels.following) {
    std::string found = all.reason;
    for (const Values& values : all.period)
      found += fmt::format("{}{} = {}", found.empty() ? "not for " : " and ", levels.family.name,
                           number_text(values.front()));
    if (!all.period.empty()) found += all.period.size() == 1 ? " at all levels" : " in turn";
    return {all.holds, std::move(found)};
  }
  const auto& [recurrence, start] = *levels.following;
  const FollowedLevels followed = follow(mask, recurrence, {start}, levels.values, limits.budget());
  const Truth answer = followed.have(asked, all.holds);
  const std::string rule = levels.family.name + " = " + recurrence.text();
  if (!followed.way) return {Truth::unknown, rule + " was not proved to lead into the range and to stay in it"};
  if (!followed.masks_exist) return {Truth::unknown, "there may be no mask at a level before the range"};
  if (answer == Truth::yes || !followed.limit)
    return {answer, answer == Truth::yes ? fmt::format("in the range from level {} on", followed.way->size())
                                         : "not proved for every sequence in the range"};
  return {answer, by_exponent(followed.limit->exponent.exponent, asked, "sequences").reason};
}

Decision property_of(const SchemePoints& points, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits) {
  require_levels(property);
  const LocalLevels found = local_levels(points.family.mask, {{points.values.lower}, {points.values.upper}},
                                         limits.budget());
  return by_exponent(found.exponent, asked_of(property, expectation), "choices of values");
}

Decision property_of(const SchemeList& list, const Property& property, const Expectation& expectation,
                     const SearchLimits& limits) {
  require_levels(property);
  const RangeProperty asked = asked_of(property, expectation);
  subcert::require_property(list.list, asked);
  const ExponentOfList found = exponent_of(list.list, limits.budget());
  return {holds(found, asked), by_exponent(found.exponent, asked, "sequences").reason};
}

}  // namespace subcert::properties
