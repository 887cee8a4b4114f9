#include "explorer.hpp"

#include "facts/exponents.hpp"
#include "formats/html.hpp"

#include <subcert/analysis/family/exponent_curve.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace subcert::reports {
namespace {

using facts::Json;

constexpr double points_of_limit = 300, points_of_variance = 64;
constexpr double share_of_curve = 0.75;  ///< of the budget; the functions need the rest

/// With four digits behind the point: more than a picture shows.
double rounded(const Rational& value) { return std::round(value.convert_to<double>() * 1e4) / 1e4; }

Json rounded(const std::vector<Rational>& values) {
  Json result = Json::array();
  for (const Rational& value : values) result.push_back(rounded(value));
  return result;
}

/// The largest level with at most so many points.
int level_for(double width, int arity, double points) {
  return std::max(1, static_cast<int>(std::log(points / width) / std::log(arity)));
}

/// The exponent at w: that of a single value, or of a piece.
Enclosure exponent_at(const ExponentCurve& curve, const Rational& w) {
  for (const CurvePoint& point : curve.special)
    if (point.exponent && point.at.value.lower == w && point.at.value.upper == w) return *point.exponent;
  for (const CurvePiece& piece : curve.pieces)
    if (piece.proof.low <= w && w <= piece.proof.high) return piece.exponent;
  return {};
}

/// Limit function and variance curve where they exist; `note` says why not.
void add_functions(Json& value, const Mask& mask, const Deadline& deadline) {
  try {
    const double width = static_cast<double>(mask.symbol().highest() - mask.symbol().lowest()) / (mask.arity() - 1);
    const LimitValues phi = limit_values(mask, level_for(width, mask.arity(), points_of_limit), 0, deadline);
    value["limit"] = {{"from", phi.point(0).convert_to<double>()},
                      {"step", std::pow(phi.arity, -phi.level)},
                      {"values", rounded(phi.values)}};
    value["variance"] = rounded(
        variance_grid(mask, level_for(1, mask.arity(), points_of_variance), false, deadline).values);
  } catch (const Error& error) {
    value["note"] = error.what();
  }
}

std::vector<Rational> values_of(const ExponentCurve& curve, const Rational& low, const Rational& high, int steps) {
  std::vector<Rational> result;
  for (int i = 0; i <= steps; ++i) result.push_back(low + (high - low) * Rational(i, steps));
  for (const CurvePoint& point : curve.special)
    if (point.at.value.lower && point.at.value.lower == point.at.value.upper) result.push_back(*point.at.value.lower);
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

Json value_json(const ParametricScheme& scheme, const ExponentCurve& curve, const Rational& w,
                const Deadline& deadline) {
  const Enclosure exponent = exponent_at(curve, w), holder = facts::positive_part(exponent);
  Json value = {{"text", to_text(w)}, {"at", w.convert_to<double>()}};
  const Mask mask = scheme.mask.at(w);
  value["mask"] = mask.symbol().to_mask_text();
  if (exponent.lower && *exponent.lower > 0) {
    value["exponent"] = enclosure_text(holder, 8);
    add_functions(value, mask, deadline);
  } else {
    value["note"] = exponent.upper && *exponent.upper <= 0 ? "does not converge" : "convergence is not decided";
  }
  return value;
}

Json end_json(const std::optional<Rational>& end) { return end ? Json(end->convert_to<double>()) : Json(); }

/// From, to, and the ends of the exponent, null where they are not proved or not positive.
Json curve_json(const ExponentCurve& curve) {
  Json result = Json::array();
  for (const CurvePiece& piece : curve.pieces) {
    const Enclosure holder = facts::positive_part(piece.exponent);
    result.push_back({piece.proof.low.convert_to<double>(), piece.proof.high.convert_to<double>(),
                      end_json(holder.lower), end_json(holder.upper)});
  }
  return result;
}

std::string figure(const char* name, const char* caption) {
  return fmt::format(
      "<figure><svg class=picture data-shows={} viewBox=\"0 0 420 260\" role=img></svg>"
      "<figcaption>{}</figcaption></figure>\n",
      name, caption);
}

}  // namespace

std::string explorer_html(const ParametricScheme& scheme, const Rational& low, const Rational& high,
                          const ExplorerOptions& options) {
  const Budget of_curve{options.budget.deadline.after(share_of_curve), options.budget.memory};
  const ExponentCurve curve = exponent_curve(scheme.mask, low, high, {options.pieces, options.jobs, of_curve});
  const std::vector<Rational> values = values_of(curve, low, high, options.steps);
  Json shown = Json::array();
  for (const Rational& w : values) shown.push_back(value_json(scheme, curve, w, options.budget.deadline));
  const std::string body = fmt::format(
      "<h1>{}</h1>\n<p class=subtitle>{}, {} = {} to {}</p>\n<form class=explorer><label>{} = <output></output> "
      "<input type=range min=0 max={} value={} aria-label=\"{}\"></label></form>\n<dl>\n<dt>mask</dt>"
      "<dd class=mask data-shows=mask></dd>\n<dt>Hoelder exponent</dt><dd data-shows=value "
      "aria-live=polite></dd>\n</dl>\n"
      "<div class=pictures>\n{}{}{}</div>\n{}",
      formats::html(scheme.specification), formats::html(scheme.title), scheme.name, to_text(low), to_text(high),
      scheme.name, values.size() - 1, values.size() / 2, scheme.name,
      figure("curve", "the exponent: between the lines, with proof"),
      figure("limit", "phi, the limit of the unit sequence"),
      figure("variance", "psi, the variance of limits of unit noise, over one period"),
      formats::data_script("explorer",
                           Json{{"letter", scheme.name}, {"values", shown}, {"curve", curve_json(curve)}}.dump()));
  return formats::html_page(formats::html(scheme.specification), body, {scheme.specification});
}

}  // namespace subcert::reports
