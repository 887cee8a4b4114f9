// [MB16, sec. 2.2, Figure 1]: basic limit functions of the 4-point binary, ternary and quaternary schemes.

#include "parts.hpp"

#include <subcert/analysis/difference/convergence.hpp>
#include <subcert/analysis/limit/limit_at_point.hpp>
#include <subcert/analysis/limit/limit_range.hpp>
#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/reports/experiments/figures.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::experiments::mustafa_bari_2016 {
namespace {

constexpr int points = 4;

struct DrawnArity {
  int arity;
  std::string name;
  int level;  // of the picture
};

const std::vector<DrawnArity> drawn_arities{{2, "binary", 7}, {3, "ternary", 4}, {4, "quaternary", 4}};

/// A scheme about its centre: the datum at 0 stands at 0.
struct Centred {
  Scheme scheme;
  Rational shift;
  Interval support;

  explicit Centred(int arity)
      : scheme(make_scheme("ary:a=" + std::to_string(arity) + ",points=" + std::to_string(points) + ",d=3")),
        shift(polynomial_reproduction(scheme.mask).parametrization),
        support(limit_support(scheme.mask)) {
    support = {support.lower - shift, support.upper - shift};
  }
  Rational width() const { return support.upper - support.lower; }
};

std::string text(const Interval& interval) {
  return "[" + to_text(interval.lower) + ", " + to_text(interval.upper) + "]";
}

/// The exact value of the centred function at the integer k.
Rational centred_value(const Centred& centred, long k) {
  const ShiftedValues values = limit_values_at(centred.scheme.mask, centred.shift);
  const long i = k - values.first;
  return i < 0 || i >= static_cast<long>(values.values.size()) ? Rational(0)
                                                               : values.values[static_cast<std::size_t>(i)];
}

formats::Panel drawn_function(const DrawnArity& arity, const Centred& centred) {
  const LimitValues values = limit_values(centred.scheme.mask, arity.level);
  Points drawn;
  for (std::size_t i = 0; i < values.values.size(); ++i)
    drawn.emplace_back(Rational(values.point(i) - centred.shift).convert_to<double>(),
                       values.values[i].convert_to<double>());
  return {std::to_string(points) + "-point " + arity.name, "x", "", {line("", drawn, "")}};
}

std::vector<std::string> table_row(const DrawnArity& arity, const Centred& centred) {
  const LimitRange range = limit_range(centred.scheme.mask);
  const SmoothnessProof smooth = proved_smoothness(centred.scheme.mask);
  std::vector<std::string> row{std::to_string(arity.arity), centred.scheme.mask.symbol().to_mask_text(),
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
  for (const DrawnArity& arity : drawn_arities) {
    const Centred centred(arity.arity);
    const Rational end(2 * arity.arity * (points / 2) - 1, 2 * (arity.arity - 1));
    result.add_fact("ends", arity.name, centred.support.lower == -end && centred.support.upper == end,
                    text(centred.support));
    const Decision decision = converges(centred.scheme.mask);
    result.add_fact("convergence", arity.name, decision.is_yes(), decision.reason);
    const Rational width = centred.width(), scaled = arity.arity * width;
    const std::string which = " for a = " + std::to_string(arity.arity);
    result.add_fact("proportion", "", product == 0 || scaled == product, to_text(scaled) + which);
    result.add_fact("falling", "", last_width == 0 || width < last_width, to_text(width) + which);
    product = scaled;
    last_width = width;
    table.rows.push_back(table_row(arity, centred));
    figure.panels.push_back(drawn_function(arity, centred));
  }
  result.tables = {table};
  result.figures = {figure};
  return result;
}

}  // namespace subcert::experiments::mustafa_bari_2016
