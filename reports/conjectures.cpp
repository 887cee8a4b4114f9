#include "conjectures.hpp"

#include "sweep/number_list.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/interval.hpp>
#include <subcert/schemes/specification.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <stdexcept>

namespace subcert::reports {
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

std::string PrimalScheme::specification() const { return "primal:n=" + std::to_string(n) + ",d=" + std::to_string(d); }

std::string PrimalSchemes::Skipped::reason() const {
  if (!beyond_data()) return "the same mask as " + same_as.specification();
  return "2n = " + std::to_string(2 * scheme.n) + " data fix no degree above " + std::to_string(same_as.d) +
         ": the same scheme as " + same_as.specification();
}

std::vector<std::string> PrimalSchemes::skipped_lines() const {
  std::map<std::pair<int, bool>, std::vector<int>> groups;
  for (const Skipped& one : skipped) groups[{one.scheme.d, one.beyond_data()}].push_back(one.scheme.n);
  std::vector<std::string> lines;
  for (const auto& [group, sizes] : groups) {
    const auto& [degree, beyond] = group;
    lines.push_back("d = " + std::to_string(degree) + " with n = " + sweeps::number_list_text(sizes) + ": " +
                    (beyond ? "2n data fix no degree above 2n-1; these are the schemes with d = 2n-1"
                            : "the same masks as d = " + std::to_string(degree + 1)));
  }
  return lines;
}

PrimalSchemes distinct_primal_schemes(const std::vector<int>& n, const std::vector<int>& d) {
  PrimalSchemes result;
  for (int degree : d)
    for (int points : n) {
      const PrimalScheme scheme{degree, points};
      const PrimalScheme next{degree + 1, points};
      if (degree > 2 * points - 1) {
        result.skipped.push_back({scheme, {2 * points - 1, points}});
      } else if (std::binary_search(d.begin(), d.end(), next.d) && next.d <= 2 * points - 1 && degree % 2 == 0 &&
                 make_scheme(scheme.specification()).mask == make_scheme(next.specification()).mask) {
        result.skipped.push_back({scheme, next});
      } else {
        result.schemes.push_back(scheme);
      }
    }
  return result;
}

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
  const auto half = std::min_element(values.begin(), values.end() - 1,
                                     [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
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

std::vector<VariancePair> neighbouring_pairs(const std::vector<PrimalScheme>& schemes) {
  std::map<int, std::vector<int>> degrees_of, sizes_of;
  for (const PrimalScheme& scheme : schemes) {
    degrees_of[scheme.n].push_back(scheme.d);
    sizes_of[scheme.d].push_back(scheme.n);
  }
  std::vector<VariancePair> pairs;
  for (auto& [n, degrees] : degrees_of) {
    std::sort(degrees.begin(), degrees.end());
    for (std::size_t i = 1; i < degrees.size(); ++i) pairs.push_back({{degrees[i], n}, {degrees[i - 1], n}});
  }
  for (auto& [d, sizes] : sizes_of) {
    std::sort(sizes.begin(), sizes.end());
    for (std::size_t i = 1; i < sizes.size(); ++i) pairs.push_back({{d, sizes[i - 1]}, {d, sizes[i]}});
  }
  return pairs;
}

std::string shown(const Enclosure& enclosure) {
  constexpr int digits = 6;
  if (enclosure.is_bounded()) {
    std::string low = to_decimal(*enclosure.lower, digits, Rounding::nearest);
    if (low == to_decimal(*enclosure.upper, digits, Rounding::nearest)) return low;
  }
  return enclosure.lower_text(digits) + " ... " + enclosure.upper_text(digits);
}

nlohmann::ordered_json exact_json(const Enclosure& enclosure) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (enclosure.lower) json["lower"] = to_text(*enclosure.lower);
  if (enclosure.upper) json["upper"] = to_text(*enclosure.upper);
  return json;
}

Enclosure enclosure_from(const nlohmann::ordered_json& json) {
  Enclosure enclosure;
  if (!json.is_object()) fail(ErrorKind::domain, "not an enclosure: {}", json.dump().substr(0, 60));
  for (const auto& [key, end] : json.items()) {
    const auto value = end.is_string() ? parse_rational(end.get<std::string>()) : std::nullopt;
    if (!value || (key != "lower" && key != "upper"))
      fail(ErrorKind::domain, "not an enclosure: {}", json.dump().substr(0, 60));
    (key == "lower" ? enclosure.lower : enclosure.upper) = *value;
  }
  require(enclosure.is_canonical(), "not an enclosure: the lower end is above the upper one");
  return enclosure;
}

}  // namespace subcert::reports
