// [MB16, sec. 2.2, Figure 1]: basic limit functions of the 4-point binary, ternary and quaternary schemes.

#include "parts.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/reports/experiments/figures.hpp>

namespace subcert::experiments::mustafa_bari_2016 {
namespace {

/// A scheme about its centre: the datum at 0 stands at 0.
struct Centred {
  Scheme scheme;
  Rational shift;
  Interval support;

  explicit Centred(const FourPointScheme& one)
      : scheme(one.scheme()),
        shift(polynomial_reproduction(scheme.mask).parametrization.front()),
        support(limit_support(scheme.mask.curve())) {
    support = {support.lower - shift, support.upper - shift};
  }
  Rational width() const { return support.upper - support.lower; }
};

std::string text(const Interval& interval) {
  return "[" + to_text(interval.lower) + ", " + to_text(interval.upper) + "]";
}

/// The exact value of the centred function at the integer k.
Rational centred_value(const Centred& centred, long k) {
  const ShiftedValues values = limit_values_at(centred.scheme.mask.curve(), centred.shift);
  const long i = k - values.first;
  return i < 0 || i >= static_cast<long>(values.values.size()) ? Rational(0)
                                                               : values.values[static_cast<std::size_t>(i)];
}

formats::Panel drawn_function(const FourPointScheme& one, const Centred& centred) {
  const LimitValues values = limit_values(centred.scheme.mask.curve(), one.drawn_level);
  Points drawn;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    drawn.emplace_back(Rational(values.point(i) - centred.shift).convert_to<double>(),
                       values.values[i].convert_to<double>());
  return {"4-point " + one.name, "x", "", {line("", drawn, "")}};
}

std::vector<std::string> table_row(const FourPointScheme& one, const Centred& centred) {
  const LimitRange range = limit_range(centred.scheme.mask.curve());
  const SmoothnessProof smooth = proved_smoothness(centred.scheme.mask);
  std::vector<std::string> row{std::to_string(one.arity),   centred.scheme.mask.curve().symbol().to_mask_text(),
                               text(centred.support),       range.maximum.lower_text(6),
                               range.minimum.lower_text(6), "C^" + std::to_string(smooth.order)};
  for (long k = 0; k <= 2; ++k) row.push_back(to_text(centred_value(centred, k)));
  return row;
}

}  // namespace

Measured limit_functions(const Run&) {
  formats::PlainTable table{"aary-fig1-functions",
                            "The functions: exact mask, support and values at 0, 1, 2; certified extremes",
                            {"arity", "mask", "support", "maximum", "minimum", "proved", "at 0", "at 1", "at 2"},
                            {}};
  formats::Figure figure{"aary-fig1", "Basic limit functions of the 4-point schemes", "", 3, {}};
  Measured result;
  Rational last_width = 0, product = 0;
  for (const FourPointScheme& one : four_point_schemes) {
    const Centred centred(one);
    const Rational end(2 * one.arity * 2 - 1, 2 * (one.arity - 1));  // as in Theorem 2.3, n = 2
    result.add_fact("ends", one.name, centred.support.lower == -end && centred.support.upper == end,
                    text(centred.support));
    const Decision decision = converges(centred.scheme.mask);
    result.add_fact("convergence", one.name, decision.is_yes(), decision.reason);
    const Rational width = centred.width(), scaled = one.arity * width;
    const std::string which = " for a = " + std::to_string(one.arity);
    result.add_fact("proportion", "", product == 0 || scaled == product, to_text(scaled) + which);
    result.add_fact("falling", "", last_width == 0 || width < last_width, to_text(width) + which);
    product = scaled;
    last_width = width;
    table.rows.push_back(table_row(one, centred));
    figure.panels.push_back(drawn_function(one, centred));
  }
  result.tables = {table};
  result.figures = {figure};
  return result;
}

}  // namespace subcert::experiments::mustafa_bari_2016
