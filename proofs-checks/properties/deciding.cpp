#include "deciding.hpp"

#include <algorithm>

namespace subcert::properties {

Decision decided(bool yes, const std::string& found) { return {yes ? Truth::yes : Truth::no, found}; }

bool compare(const Rational& value, const std::string& relation, const Rational& number) {
  if (relation == "=") return value == number;
  if (relation == ">=") return value >= number;
  if (relation == "<=") return value <= number;
  return relation == ">" ? value > number : value < number;
}

std::string lies_in(const std::string& what, const Enclosure& value, const Rational& threshold) {
  constexpr int fewest = 8, most = 100;
  const auto digits = [&](const std::optional<Rational>& end) {
    if (!end) return fewest;
    return *end == threshold ? most : std::min(most, digits_within(*end, abs(*end - threshold), fewest));
  };
  const std::string lower = value.lower_text(digits(value.lower)), upper = value.upper_text(digits(value.upper));
  return what + (lower == upper ? " is " + lower : " lies in [" + lower + ", " + upper + "]");
}

Decision compare(const Enclosure& value, const Expectation& expectation, const std::string& what) {
  const std::string& relation = expectation.relation;
  const Rational& number = expectation.number;
  const bool from_below = relation == ">=" || relation == ">";
  const std::string found = lies_in(what, value, number);
  if (relation == "=") {
    if (!value.contains(number)) return decided(false, found);
    return {value.is_exact() ? Truth::yes : Truth::unknown, found};
  }
  const auto& worst = from_below ? value.lower : value.upper;
  const auto& best = from_below ? value.upper : value.lower;
  if (worst && compare(*worst, relation, number)) return decided(true, found);
  if (best && !compare(*best, relation, number)) return decided(false, found);
  return {Truth::unknown, found};
}

Decision smoothness(const MultivariateRegularity& regularity, const Expectation& expectation) {
  const Enclosure& exponent = regularity.exponent;
  const std::string found = lies_in("the Hoelder exponent", exponent, expectation.number);
  if (regularity.converges.is_no()) return decided(false, "not convergent: " + regularity.converges.reason);
  if (regularity.converges.is_yes() && expectation.number == 0) return decided(true, "the scheme converges");
  if (exponent.lower && *exponent.lower > expectation.number) return decided(true, found);
  if (exponent.upper && *exponent.upper < expectation.number) return decided(false, found);
  return {Truth::unknown, found};
}

}  // namespace subcert::properties
