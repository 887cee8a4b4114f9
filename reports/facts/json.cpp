#include "json.hpp"

namespace subcert::facts {

Json enclosure_json(const Enclosure& enclosure, int digits) {
  digits = enclosure.telling_digits(digits);
  return {{"lower", enclosure.lower_text(digits)}, {"upper", enclosure.upper_text(digits)}};
}

Json enclosure_json(const std::optional<Enclosure>& enclosure) {
  return enclosure ? enclosure_json(*enclosure) : Json();
}

Json interval_json(const Interval& interval) {
  return {{"lower", to_text(interval.lower)}, {"upper", to_text(interval.upper)}};
}

Json decision_json(const Decision& decision) {
  return {{"verdict", to_text(decision.truth)}, {"reason", decision.reason}};
}

Json numbers_json(const std::vector<Rational>& numbers) {
  Json list = Json::array();
  for (const Rational& number : numbers) list.push_back(to_text(number));
  return list;
}

}  // namespace subcert::facts
