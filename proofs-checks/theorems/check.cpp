#include "check.hpp"

namespace subcert::theorems {

Enclosure Check::margin() const {
  Enclosure result;
  if (right.lower && left.upper) result.lower = *right.lower - *left.upper;
  if (right.upper && left.lower) result.upper = *right.upper - *left.lower;
  return result;
}

Check less(const std::string& id, const std::string& claim, const Enclosure& left, const Enclosure& right) {
  Check check{id, claim, left, right, {Truth::unknown, "the enclosures do not decide"}};
  const Enclosure margin = check.margin();
  if (margin.lower && *margin.lower > 0)
    check.decision = {Truth::yes, "enclosures"};
  else if (margin.upper && *margin.upper <= 0)
    check.decision = {Truth::no, "enclosures"};
  return check;
}

Decision verdict(const std::vector<Check>& checks) {
  for (const Check& check : checks)
    if (check.decision.is_no()) return {Truth::no, "(" + check.id + ") fails: " + check.claim};
  for (const Check& check : checks)
    if (!check.decision.is_yes()) return {Truth::unknown, "(" + check.id + ") is undecided: " + check.claim};
  return {Truth::yes, std::to_string(checks.size()) + " inequalities hold"};
}

}  // namespace subcert::theorems
