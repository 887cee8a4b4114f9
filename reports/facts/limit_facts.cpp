#include "limit_facts.hpp"

#include <subcert/analysis/symbol/decimal.hpp>

namespace subcert::facts {
namespace {

Fact enclosed(std::string key, std::string label, const Enclosure& value) {
  return {std::move(key), std::move(label), enclosure_text(value), "", enclosure_json(value)};
}

/// `attained` is the end of the enclosure that is a value.
Fact attained_fact(const char* name, const AttainedExtreme& extreme, const std::optional<Rational>& attained) {
  Json json = enclosure_json(extreme.value);
  json["point"] = extreme.point.empty() ? Json() : numbers_json(extreme.point);
  return {name, name, enclosure_text(extreme.value),
          extreme.point.empty() ? "outside the support"
                                : "phi(" + coordinates_text(extreme.point) + ") = " + short_text(*attained),
          std::move(json)};
}

Decision is_nonnegative(const Enclosure& minimum) {
  if (*minimum.lower >= 0) return {Truth::yes, "the minimum is 0"};
  if (*minimum.upper < 0) return {Truth::no, "the minimum is negative"};
  return {Truth::unknown, "the minimum may be 0"};
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
  return completed({enclosed("maximum", "maximum", range.maximum),
                    enclosed("minimum", "minimum", range.minimum),
                    {"derivative_sup", "largest |phi'|", range.slope ? enclosure_text(*range.slope) : "not known",
                     range.slope_reason, enclosure_json(range.slope)},
                    enclosed("l1_norm", "integral |phi|", range.l1_norm),
                    decided("nonnegative", "nonnegative", is_nonnegative(range.minimum))},
                   range);
}

Facts limit_facts(const MultivariateLimitRange& range) {
  return completed({attained_fact("maximum", range.maximum, range.maximum.value.lower),
                    attained_fact("minimum", range.minimum, range.minimum.value.upper),
                    decided("nonnegative", "nonnegative", range.nonnegative)},
                   range);
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
