#include "limit_page.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/limit/multivariate_limit_range.hpp>
#include <subcert/analysis/limit/multivariate_limit_values.hpp>
#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/analysis/symbol/error.hpp>

#include <iomanip>
#include <sstream>

namespace subcert::cli {
namespace {

constexpr const char* too_wide = "The enclosures are wider than asked for: the budget ran out.\n";

LimitOptions limit_options(const LimitPageOptions& options, const Deadline& deadline) {
  const auto width = parse_number(options.width);
  if (!width || *width <= 0)
    fail(ErrorKind::usage, "--width: expected a positive number, as 1e-9 or 1/1000, got '{}'", options.width);
  return {*width, {deadline}};
}

/// `1/2, -1`.
std::string coordinates_text(const std::vector<Rational>& point) {
  std::string text;
  for (const Rational& coordinate : point) text += (text.empty() ? "" : ", ") + to_text(coordinate);
  return text;
}

/// `attained` is the end of the enclosure that is a value.
std::string attained_text(const AttainedExtreme& extreme, const std::optional<Rational>& attained) {
  return enclosure_text(extreme.value) +
         (extreme.point.empty() ? "  (outside the support)"
                                : "  (phi(" + coordinates_text(extreme.point) + ") = " + short_text(*attained) + ")");
}

Json attained_json(const AttainedExtreme& extreme) {
  Json json = enclosure_json(extreme.value);
  json["point"] = extreme.point.empty() ? Json() : numbers_json(extreme.point);
  return json;
}

Decision is_nonnegative(const Enclosure& minimum) {
  if (*minimum.lower >= 0) return {Truth::yes, "the minimum is 0"};
  if (*minimum.upper < 0) return {Truth::no, "the minimum is negative"};
  return {Truth::unknown, "the minimum may be 0"};
}

}  // namespace

ExitCode print_limit_values(const MultivariateScheme& scheme, const LatticePoint& orders,
                            const LimitPageOptions& options, const Deadline&) {
  const LatticeSequence values = scheme.factors.empty()
                                     ? limit_values(scheme.mask, options.level, orders)
                                     : tensor_product_limit_values(scheme.factors, options.level, orders);
  if (options.json) {
    Json points = Json::array(), numbers = Json::array();
    for (const auto& [point, value] : values) {
      points.push_back(point);
      numbers.push_back(to_text(value));
    }
    options.answer(Json{{"scheme", scheme.specification},
                        {"dilation", scheme.mask.dilation().rows()},
                        {"level", options.level},
                        {"derivative", orders},
                        {"indices", std::move(points)},
                        {"values", std::move(numbers)}});
    return done;
  }
  std::ostringstream text;
  for (const auto& [index, value] : values) {
    std::vector<Rational> point(index.begin(), index.end());
    for (int n = 0; n < options.level; ++n) point = scheme.mask.dilation().inverse_times(point);
    text << std::setw(20) << coordinates_text(point) << "  " << std::setw(20)
         << to_decimal(value, 15, Rounding::nearest) << "  " << to_text(value) << "\n";
  }
  options.answer(text.str());
  return done;
}

ExitCode print_limit_values(const Scheme& scheme, const LatticePoint& orders, const LimitPageOptions& options,
                            const Deadline& deadline) {
  const LimitValues values = limit_values(scheme.mask, options.level, static_cast<int>(orders.front()), deadline);
  if (options.json) {
    options.answer(Json{{"scheme", scheme.specification},
                        {"arity", values.arity},
                        {"level", values.level},
                        {"derivative", values.order},
                        {"first_index", values.first_index},
                        {"values", numbers_json(values.values)}});
    return done;
  }
  std::ostringstream text;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    text << std::setw(12) << to_text(values.point(i)) << "  " << std::setw(20)
         << to_decimal(values.values[i], 15, Rounding::nearest) << "  " << to_text(values.values[i]) << "\n";
  options.answer(text.str());
  return done;
}

ExitCode print_limit_range(const MultivariateScheme& scheme, const LimitPageOptions& options,
                           const Deadline& deadline) {
  const MultivariateLimitRange range = limit_range(scheme.mask, limit_options(options, deadline));
  std::ostringstream text;
  text << "scheme       " << scheme.specification << "  (" << scheme.title << ")\n"
       << "maximum      " << attained_text(range.maximum, range.maximum.value.lower) << "\n"
       << "minimum      " << attained_text(range.minimum, range.minimum.value.upper) << "\n"
       << "nonnegative  " << to_text(range.nonnegative.truth) << ": " << range.nonnegative.reason << "\n"
       << (range.complete ? "" : too_wide);
  options.answer(Json{{"scheme", scheme.specification},
                      {"maximum", attained_json(range.maximum)},
                      {"minimum", attained_json(range.minimum)},
                      {"nonnegative", decision_json(range.nonnegative)},
                      {"complete", range.complete},
                      {"cells", range.cells}},
                 text.str());
  return range.complete ? done : undecided;
}

ExitCode print_limit_range(const Scheme& scheme, const LimitPageOptions& options, const Deadline& deadline) {
  LimitRange range;
  try {
    range = limit_range(scheme.mask, limit_options(options, deadline));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::domain) throw;
    return refuse_unproved(scheme.specification, "no bounds of the limit function", {Truth::unknown, error.what()});
  }
  const Decision nonnegative = is_nonnegative(range.minimum);
  std::ostringstream text;
  text << "scheme           " << scheme.specification << "  (" << scheme.title << ")\n"
       << "maximum          " << enclosure_text(range.maximum) << "\n"
       << "minimum          " << enclosure_text(range.minimum) << "\n"
       << "largest |phi'|   " << (range.slope ? enclosure_text(*range.slope) : "not known")
       << (range.slope_reason.empty() ? "" : "  (" + range.slope_reason + ")") << "\n"
       << "integral |phi|   " << enclosure_text(range.l1_norm) << "\n"
       << "nonnegative      " << to_text(nonnegative.truth) << ": " << nonnegative.reason << "\n"
       << (range.complete ? "" : too_wide);
  options.answer(Json{{"scheme", scheme.specification},
                      {"maximum", enclosure_json(range.maximum)},
                      {"minimum", enclosure_json(range.minimum)},
                      {"derivative_sup", enclosure_json(range.slope)},
                      {"l1_norm", enclosure_json(range.l1_norm)},
                      {"nonnegative", decision_json(nonnegative)},
                      {"complete", range.complete},
                      {"cells", range.cells}},
                 text.str());
  return range.complete ? done : undecided;
}

}  // namespace subcert::cli
