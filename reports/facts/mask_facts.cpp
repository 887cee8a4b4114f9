#include "scheme_facts.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/reproduction/multivariate_reproduction.hpp>
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

Facts symbol_facts(const Mask& mask, int rules) {
  const LaurentPolynomial ones = LaurentPolynomial::all_ones(mask.arity());
  const std::string symbol = mask.symbol().to_text(), rest = mask.symbol().exact_quotient(ones.pow(rules))->to_text();
  return {
      {"", "mask", mask.symbol().to_mask_text()},
      {"symbol", "symbol",
       fmt::format("{}\n= ({}){} * ({})", symbol, ones.to_text(), rules == 1 ? "" : fmt::format("^{}", rules), rest),
       "", symbol},
      member("remaining_factor", rest)};
}

Facts support_facts(const Mask& mask) {
  const IndexRange range = support(mask);
  const Interval limit = limit_support(mask);
  return {{"support", "support",
           fmt::format("mask {} ... {}, basic limit function {}", range.first, range.last, in_brackets(limit)), "",
           interval_json(limit)}};
}

Facts polynomial_facts(const PolynomialReproduction& polynomials) {
  const Rational& shift = polynomials.parametrization;
  return {{"", "polynomials",
           fmt::format("generates degree {}, reproduces degree {} with f_j at j{}; approximation order {}",
                       polynomials.generation_degree, polynomials.reproduction_degree,
                       shift == 0 ? "" : (shift > 0 ? " + " : " - ") + to_text(abs(shift)),
                       polynomials.approximation_order())},
          member("generation_degree", polynomials.generation_degree),
          member("reproduction_degree", polynomials.reproduction_degree),
          member("parametrization", to_text(shift)),
          member("approximation_order", polynomials.approximation_order())};
}

Json nested(const MultivariatePolynomial& symbol, MultivariatePolynomial::Exponents& at, std::size_t variable) {
  Json list = Json::array();
  const long first = symbol.lowest()[variable], last = symbol.highest()[variable];
  for (at[variable] = first; at[variable] <= last; ++at[variable])
    list.push_back(variable == 0 ? Json(to_text(symbol.coefficient(at))) : nested(symbol, at, variable - 1));
  return list;
}

/// `2; factors (1 + x)^2, (1 + y)^1`.
std::string sum_rules_text(const MultivariateReproduction& polynomials, int arity) {
  std::string text = std::to_string(polynomials.sum_rules);
  for (std::size_t v = 0; v < polynomials.factors.size(); ++v)
    text += fmt::format("{}(1 + {}{}{})^{}", v ? ", " : "; factors ", arity == 2 ? "" : "... + ", variables[v],
                        arity > 2 ? fmt::format("^{}", arity - 1) : "", polynomials.factors[v]);
  return text;
}

Facts polynomial_facts(const MultivariateReproduction& polynomials) {
  std::string at;
  for (const Rational& shift : polynomials.parametrization) at += (at.empty() ? "" : ", ") + to_text(shift);
  return {{"", "polynomials",
           fmt::format("generates total degree {}, reproduces total degree {} with f_j at j + ({})",
                       polynomials.generation_degree(), polynomials.reproduction_degree, at)},
          member("generation_degree", polynomials.generation_degree()),
          member("reproduction_degree", polynomials.reproduction_degree),
          member("parametrization", numbers_json(polynomials.parametrization))};
}

std::string limit_support_text(const MultivariateMask& mask) {
  std::string text;
  for (const Interval& side : limit_support(mask)) text += (text.empty() ? "" : " x ") + in_brackets(side);
  return text;
}

}  // namespace

Json coefficients_json(const MultivariateMask& mask) {
  MultivariatePolynomial::Exponents at = mask.symbol().lowest();
  return nested(mask.symbol(), at, at.size() - 1);
}

Json limit_support_json(const MultivariateMask& mask) {
  Json list = Json::array();
  for (const Interval& side : limit_support(mask)) list.push_back(interval_json(side));
  return list;
}

Facts mask_facts(const Scheme& scheme) {
  const Mask& mask = scheme.mask;
  const int rules = sum_rules(mask);
  Facts list = named(scheme.specification, scheme.title);
  list.push_back(member("arity", mask.arity()));
  list.push_back(member("first_index", mask.symbol().lowest()));
  list.push_back(member("coefficients", numbers_json(mask.symbol().coefficients())));
  append(list, symbol_facts(mask, rules));
  list.push_back(symmetry_fact(symmetry(mask)));
  append(list, support_facts(mask));
  list.push_back(plain("sum_rules", "sum rules", rules));
  append(list, polynomial_facts(polynomial_reproduction(mask)));
  return list;
}

Facts mask_facts(const MultivariateScheme& scheme) {
  const MultivariateMask& mask = scheme.mask;
  const MultivariateReproduction polynomials = scheme.factors.empty() ? polynomial_reproduction(mask)
                                                                      : tensor_product_reproduction(scheme.factors);
  const long count = mask.symbol().count();
  Facts list = named(scheme.specification, scheme.title);
  list.push_back(member("variables", mask.dimension()));
  list.push_back(member("arity", optional_json(mask.dilation().factor())));
  list.push_back(member("dilation", mask.dilation().rows()));
  list.push_back(member("first_index", mask.symbol().lowest()));
  list.push_back(member("coefficients", coefficients_json(mask)));
  list.push_back(
      {"", "mask",
       count <= most_printed ? to_mask_text(mask) : fmt::format("{} coefficients, see subcert mask", count)});
  list.push_back(
      {"support", "support", "basic limit function in " + limit_support_text(mask), "", limit_support_json(mask)});
  list.push_back({"sum_rules", "sum rules", sum_rules_text(polynomials, mask.dilation().factor().value_or(0)), "",
                  polynomials.sum_rules});
  list.push_back(member("factors", polynomials.factors));
  append(list, polynomial_facts(polynomials));
  return list;
}

}  // namespace subcert::facts
