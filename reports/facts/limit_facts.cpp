#include "limit_facts.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>

namespace subcert::facts {
namespace {

Fact enclosed(std::string key, std::string label, const Enclosure& value) {
  return {std::move(key), std::move(label), enclosure_text(value), "", enclosure_json(value)};
}

/// `attained`: the end of the enclosure that is a value.
Fact extreme_fact(const char* name, const Enclosure& value, const std::optional<Rational>& attained,
                  const std::optional<std::vector<Rational>>& point) {
  Fact fact = enclosed(name, name, value);
  if (!point) return fact;
  fact.remark = point->empty() ? "outside the support"
                               : "phi(" + coordinates_text(*point) + ") = " + short_text(*attained);
  fact.json["point"] = point->empty() ? Json() : numbers_json(*point);
  return fact;
}

template <class Range>
Facts completed(Facts list, const Range& range) {
  list.push_back(member("complete", range.complete));
  list.push_back(member("cells", range.cells));
  return list;
}

}  // namespace

std::string coordinates_text(const std::vector<Rational>& point) {
  std::string text;
  for (const Rational& coordinate : point) text += (text.empty() ? "" : ", ") + to_text(coordinate);
  return text;
}

Facts limit_facts(const LimitRange& range) {
  Facts list{extreme_fact("maximum", range.maximum, range.maximum.lower, range.highest),
             extreme_fact("minimum", range.minimum, range.minimum.upper, range.lowest)};
  if (range.l1_norm.lower)
    append(list, {{"derivative_sup", "largest |phi'|", range.slope ? enclosure_text(*range.slope) : "not known",
                   range.slope_reason, enclosure_json(range.slope)},
                  enclosed("l1_norm", "integral |phi|", range.l1_norm)});
  list.push_back(decided("nonnegative", "nonnegative", range.nonnegative));
  return completed(std::move(list), range);
}

Facts variance_facts(const VarianceRange& range) {
  Facts list{enclosed("sup", "maximum", range.maximum),
             enclosed("inf", "minimum", range.minimum),
             {"derivative_sup", "largest |psi'|",
              range.slope ? enclosure_text(*range.slope) : "not known: " + range.slope_reason,
              range.slope && !range.slope_reason.empty() ? "best Lipschitz constant; " + range.slope_reason : "",
              enclosure_json(range.slope)},
             {"mean", "mean", to_decimal(range.mean, 15, Rounding::nearest) + "  = " + to_text(range.mean), "",
              to_text(range.mean)}};
  if (!range.slope_reason.empty()) list.push_back(member("derivative_note", range.slope_reason));
  return completed(std::move(list), range);
}

}  // namespace subcert::facts
