#include "limit_facts.hpp"
#include "scheme_facts.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>

#include <fmt/format.h>

namespace subcert::facts {
namespace {

constexpr const char* variables[] = {"x", "y", "z"};
constexpr long most_printed = 150;  // coefficients of a surface

std::string in_brackets(const Interval& interval) {
  return fmt::format("[{}, {}]", to_text(interval.lower), to_text(interval.upper));
}

Fact symmetry_fact(const SymmetryReport& report) {
  const std::string kind = report.kind == Symmetry::none ? "none" : report.kind == Symmetry::odd ? "odd" : "even";
  return {"symmetry", "symmetry", kind + (report.kind == Symmetry::none ? "" : ", about " + to_text(report.centre)), "",
          kind};
}

bool is_curve(const LatticeMask& mask) { return mask.dimension() == 1; }

/// What of several variables has one entry for each.
Json entries(const LatticeMask& mask, Json list) { return is_curve(mask) ? list.front() : list; }

Facts index_facts(const LatticeMask& mask) {
  Facts list;
  if (!is_curve(mask)) list.push_back(member("variables", mask.dimension()));
  list.push_back(member("arity", optional_json(mask.dilation().factor())));
  if (!is_curve(mask)) list.push_back(member("dilation", mask.dilation().rows()));
  append(list, {member("first_index", first_index_json(mask)), member("coefficients", coefficients_json(mask))});
  return list;
}

Facts symbol_facts(const LatticeMask& lattice, int rules) {
  if (const long count = lattice.symbol().count(); !is_curve(lattice))
    return {{"", "mask",
             count <= most_printed ? to_mask_text(lattice) : fmt::format("{} coefficients, see subcert mask", count)}};
  const Mask& mask = lattice.curve();
  const LaurentPolynomial ones = LaurentPolynomial::all_ones(mask.arity());
  const std::string symbol = mask.symbol().to_text(), rest = mask.symbol().exact_quotient(ones.pow(rules))->to_text();
  return {
      {"", "mask", mask.symbol().to_mask_text()},
      {"symbol", "symbol",
       fmt::format("{}\n= ({}){} * ({})", symbol, ones.to_text(), rules == 1 ? "" : fmt::format("^{}", rules), rest),
       "", symbol},
      member("remaining_factor", rest),
      symmetry_fact(symmetry(mask))};
}

Fact support_fact(const LatticeMask& mask) {
  std::string text;
  if (is_curve(mask))
    text = fmt::format("mask {} ... {}, basic limit function ", mask.symbol().lowest().front(),
                       mask.symbol().highest().front());
  else
    text = "basic limit function in ";
  std::vector<std::string> sides;
  for (const Interval& side : limit_support(mask)) sides.push_back(in_brackets(side));
  return {"support", "support", fmt::format("{}{}", text, fmt::join(sides, " x ")), "", limit_support_json(mask)};
}

/// As the coefficients of each class sum to 1, those below 0 sum to (1 - norm)/2 at least.
Fact norm_fact(const LatticeMask& mask) {
  const Rational norm = operator_norm(mask);
  return {"operator_norm", "norm",
          "||S|| = " + short_text(norm) +
              (norm == 1 ? ": new points are convex combinations of old ones"
                         : fmt::format(": a step leaves the range of the data by at most {} of it",
                                       short_text((norm - 1) / 2))),
          "", to_text(norm)};
}

/// Of surfaces `2; factors (1 + x)^2, (1 + y)^1`.
Facts sum_rules_facts(const LatticeMask& mask, const PolynomialReproduction& polynomials) {
  if (is_curve(mask)) return {plain("sum_rules", "sum rules", polynomials.sum_rules)};
  const int arity = mask.dilation().factor().value_or(0);
  std::string text = std::to_string(polynomials.sum_rules);
  for (std::size_t v = 0; v < polynomials.factors.size(); ++v)
    text += fmt::format("{}(1 + {}{}{})^{}", v ? ", " : "; factors ", arity == 2 ? "" : "... + ", variables[v],
                        arity > 2 ? fmt::format("^{}", arity - 1) : "", polynomials.factors[v]);
  return {{"sum_rules", "sum rules", text, "", polynomials.sum_rules}, member("factors", polynomials.factors)};
}

std::string polynomials_text(const LatticeMask& mask, const PolynomialReproduction& polynomials) {
  const char* total = is_curve(mask) ? "" : "total ";
  const std::string degrees = fmt::format("generates {0}degree {1}, reproduces {0}degree {2} with f_j at j", total,
                                          polynomials.generation_degree(), polynomials.reproduction_degree);
  if (!is_curve(mask)) return fmt::format("{} + ({})", degrees, coordinates_text(polynomials.parametrization));
  const Rational& shift = polynomials.parametrization.front();
  return fmt::format("{}{}; approximation order {}", degrees,
                     shift == 0 ? "" : (shift > 0 ? " + " : " - ") + to_text(abs(shift)),
                     polynomials.approximation_order());
}

Facts polynomial_facts(const LatticeMask& mask, const PolynomialReproduction& polynomials) {
  Facts list{{"", "polynomials", polynomials_text(mask, polynomials)},
             member("generation_degree", polynomials.generation_degree()),
             member("reproduction_degree", polynomials.reproduction_degree),
             member("parametrization", entries(mask, numbers_json(polynomials.parametrization)))};
  if (is_curve(mask)) list.push_back(member("approximation_order", polynomials.approximation_order()));
  return list;
}

/// Lists of one level have one length; numbers come in the order of the coefficients.
Json nested(const text::MaskText& parts, std::size_t levels, std::size_t& at) {
  if (levels == 0) return to_text(parts.coefficients[at++]);
  Json list = Json::array();
  for (std::size_t k = 0; k < parts.sizes[levels - 1]; ++k) list.push_back(nested(parts, levels - 1, at));
  return list;
}

}  // namespace

Json first_index_json(const LatticeMask& mask) { return entries(mask, *mask_text_parts(mask).first); }

Json coefficients_json(const LatticeMask& mask) {
  const text::MaskText parts = mask_text_parts(mask);
  std::size_t at = 0;
  return nested(parts, parts.sizes.size(), at);
}

Json limit_support_json(const LatticeMask& mask) {
  Json list = Json::array();
  for (const Interval& side : limit_support(mask)) list.push_back(interval_json(side));
  return entries(mask, list);
}

Facts mask_facts(const Scheme& scheme) {
  const LatticeMask& mask = scheme.mask;
  const PolynomialReproduction polynomials = polynomial_reproduction(mask);
  Facts list = named(scheme.specification, scheme.title);
  append(list, index_facts(mask));
  append(list, symbol_facts(mask, polynomials.sum_rules));
  append(list, {support_fact(mask), norm_fact(mask)});
  append(list, sum_rules_facts(mask, polynomials));
  append(list, polynomial_facts(mask, polynomials));
  return list;
}

}  // namespace subcert::facts
