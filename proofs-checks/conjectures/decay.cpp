#include "decay.hpp"

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cstdlib>
#include <functional>

namespace subcert::conjectures {
namespace {

/// The quotient of a number and a positive one.
Enclosure quotient(const Enclosure& number, const Enclosure& positive) {
  Enclosure result;
  if (number.lower) result.lower = *number.lower / (*number.lower >= 0 ? *positive.upper : *positive.lower);
  if (number.upper) result.upper = *number.upper / (*number.upper >= 0 ? *positive.lower : *positive.upper);
  return result;
}

using End = std::optional<Rational>;

bool all_present(const std::vector<End>& ends) {
  return std::all_of(ends.begin(), ends.end(), [](const End& end) { return end.has_value(); });
}

/// The end that is `better` than the other present ones; nothing where none is present.
template <class Better>
End best_end(const std::vector<End>& ends, Better better) {
  End best;
  for (const End& end : ends)
    if (end && (!best || better(*end, *best))) best = end;
  return best;
}

Decision decide_above(const Enclosure& value, const Rational& bound, const std::string& what) {
  const std::string place = what + " " + to_text(bound);
  if (value.lower && *value.lower > bound) return {Truth::yes, "the exponent is above " + place};
  if (value.upper && *value.upper < bound) return {Truth::no, "the exponent is below " + place};
  return {Truth::unknown, "the exponent is not enclosed on one side of " + place};
}

}  // namespace

Enclosure decay_exponent(int first_n, const Enclosure& first, int second_n, const Enclosure& second) {
  if (first_n < 1 || second_n <= first_n) fail(ErrorKind::domain, "decay_exponent: need 1 <= first_n < second_n");
  Enclosure logarithm;
  if (first.lower && second.upper && *first.lower > 0)
    logarithm.lower = log_ratio(*first.lower / *second.upper, 2).lower;
  if (first.upper && second.lower && *second.lower > 0)
    logarithm.upper = log_ratio(*first.upper / *second.lower, 2).upper;
  return quotient(logarithm, log_ratio(Rational(second_n, first_n), 2));
}

std::size_t rate_start(const std::vector<CertifiedMaximum>& values) {
  require(values.size() >= 2, "rate_start: need at least two values");
  const int last = values.back().n;
  const auto distance = [&](const CertifiedMaximum& value) { return std::abs(2 * value.n - last); };
  const auto half = std::min_element(values.begin(), values.end() - 1, [&](const auto& a, const auto& b) {
    return std::pair(a.interpolates, distance(a)) < std::pair(b.interpolates, distance(b));
  });
  return static_cast<std::size_t>(half - values.begin());
}

DecayFinding decay_finding(int power_of_n, const std::vector<CertifiedMaximum>& values) {
  require(!values.empty(), "decay_finding: need at least one value");
  DecayFinding finding;
  finding.power = power_of_n;
  finding.first_n = values.front().n;
  finding.last_n = values.back().n;
  std::vector<End> lower, upper;
  for (const CertifiedMaximum& value : values) {
    const Enclosure one = scaled(value.value, power(Rational(value.n), power_of_n));
    lower.push_back(one.lower);
    upper.push_back(one.upper);
  }
  finding.largest = {best_end(lower, std::greater<>()), all_present(upper) ? best_end(upper, std::greater<>()) : End()};
  finding.smallest = {all_present(lower) ? best_end(lower, std::less<>()) : End(), best_end(upper, std::less<>())};
  if (values.size() == 1) {
    finding.upper_bound = finding.rate = {Truth::unknown, "a single n has no rate"};
    return finding;
  }
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(rate_start(values));
  finding.rate_from = half->n;
  finding.exponent = decay_exponent(half->n, half->value, finding.last_n, values.back().value);
  const Rational below = power_of_n - Rational(1, 2), above = power_of_n + Rational(1, 2);
  finding.upper_bound = decide_above(*finding.exponent, below, "the power less 1/2,");
  const Decision faster = decide_above(*finding.exponent, above, "the power plus 1/2,");
  if (finding.upper_bound.is_no())
    finding.rate = {Truth::no, finding.upper_bound.reason};
  else if (faster.is_yes())
    finding.rate = {Truth::no, faster.reason};
  else if (finding.upper_bound.is_yes() && faster.is_no())
    finding.rate = {Truth::yes, "the exponent is within 1/2 of the power"};
  else
    finding.rate = {Truth::unknown, finding.upper_bound.is_yes() ? faster.reason : finding.upper_bound.reason};
  return finding;
}

std::string DecayFinding::sentence(const std::string& what) const {
  const std::string claim = power == 1 ? "1/n" : "1/n^" + std::to_string(power);
  const std::string factor = power == 1 ? "n" : "n^" + std::to_string(power);
  const bool single = first_n == last_n;
  std::string text = factor + " " + what;
  if (single)
    return text + " is " + shown(largest) + " for n = " + std::to_string(first_n) + "; a single n has no rate.";
  text += " lies between " + (smallest.lower ? to_decimal(*smallest.lower, 6, Rounding::down) : "-inf") + " and " +
          (largest.upper ? to_decimal(*largest.upper, 6, Rounding::up) : "inf") + " for n from " +
          std::to_string(first_n) + " to " + std::to_string(last_n) + ". From n = " + std::to_string(rate_from) +
          " to " + std::to_string(last_n) + " " + what + " falls like n^-r with r = " + shown(*exponent) + ". ";
  if (upper_bound.is_no())
    return text + "It falls more slowly than " + claim + " there: this range speaks against the conjecture.";
  if (!upper_bound.is_yes()) return text + "This does not decide between the rates: " + upper_bound.reason + ".";
  text += "So on this range " + claim + " is a true upper bound, ";
  if (rate.is_yes()) return text + "and it is the observed rate.";
  if (rate.is_no()) return text + "but not the observed rate: the maximum falls faster.";
  return text + "and whether it is the rate there is open: " + rate.reason + ".";
}

std::string shown(const Enclosure& enclosure) {
  constexpr int digits = 6;
  if (enclosure.is_bounded()) {
    std::string low = to_decimal(*enclosure.lower, digits, Rounding::nearest);
    if (low == to_decimal(*enclosure.upper, digits, Rounding::nearest)) return low;
  }
  return enclosure.lower_text(digits) + " ... " + enclosure.upper_text(digits);
}

}  // namespace subcert::conjectures
