#pragma once
/// Values of the library as JSON, wherever they are printed: exact numbers are texts `p/q`, enclosures decimals rounded
/// outward.

#include <subcert/analysis/symbol/interval.hpp>
#include <subcert/analysis/symbol/numbers.hpp>

#include <nlohmann/json.hpp>

#include <optional>
#include <vector>

namespace subcert::facts {

using Json = nlohmann::ordered_json;

/// {"lower", "upper"}, with as many digits as tell it from thresholds (Enclosure::telling_digits).
Json enclosure_json(const Enclosure& enclosure, int digits = 20);
Json enclosure_json(const std::optional<Enclosure>& enclosure);  ///< null where there is none
/// {"lower", "upper"}, exact.
Json interval_json(const Interval& interval);
/// {"verdict", "reason"}.
Json decision_json(const Decision& decision);
/// A list of exact numbers.
Json numbers_json(const std::vector<Rational>& numbers);
/// The value, or null.
template <class Value>
Json optional_json(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

}  // namespace subcert::facts
