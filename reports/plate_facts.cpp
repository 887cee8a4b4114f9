#include "plate_facts.hpp"

#include "formats/comparison.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

constexpr int places = 10, places_of_variance = 5;
constexpr std::size_t longest = 1200;  // characters of an exact object for people

std::string number_text(const Enclosure& enclosure, int digits) {
  return enclosure.is_exact() ? to_text(*enclosure.lower) : formats::fixed_text(enclosure, digits);
}

Fact decided(const std::string& name, const Decision& decision) {
  return {name, decision.is_yes() ? "yes" : decision.is_no() ? "no" : "not decided", decision.reason};
}

std::string symmetry_text(const SymmetryReport& report) {
  if (report.kind == Symmetry::none) return "none";
  return (report.kind == Symmetry::odd ? "odd, about " : "even, about ") + to_text(report.centre);
}

std::string polynomials_text(const PolynomialReproduction& polynomials) {
  const Rational& shift = polynomials.parametrization;
  return fmt::format("generates degree {}, reproduces degree {} with f_j at j{}; approximation order {}",
                     polynomials.generation_degree, polynomials.reproduction_degree,
                     shift == 0 ? "" : (shift > 0 ? " + " : " - ") + to_text(abs(shift)),
                     polynomials.approximation_order());
}

std::string factored_symbol(const Scheme& scheme, int rules) {
  const LaurentPolynomial ones = LaurentPolynomial::all_ones(scheme.mask.arity());
  const auto rest = scheme.mask.symbol().exact_quotient(ones.pow(rules));
  if (!rest) return scheme.mask.symbol().to_text();
  return rules == 0 ? rest->to_text()
                    : fmt::format("({}){} * ({})", ones.to_text(), rules == 1 ? "" : fmt::format("^{}", rules),
                                  rest->to_text());
}

/// Facts that follow from the mask alone.
void add_algebra(std::vector<Fact>& list, const Scheme& scheme, int rules) {
  const Interval support = limit_support(scheme.mask);
  list.push_back({"support", fmt::format("[{}, {}]", to_text(support.lower), to_text(support.upper)),
                  "of the basic limit function"});
  if (scheme.rounding) return;
  if (std::string symbol = factored_symbol(scheme, rules); symbol.size() <= longest)
    list.insert(list.begin() + 1, {"symbol", std::move(symbol), ""});
  list.push_back({"symmetry", symmetry_text(symmetry(scheme.mask)), ""});
  list.push_back({"polynomials", polynomials_text(polynomial_reproduction(scheme.mask)), ""});
}

Fact holder_fact(const Plate& plate) {
  const char* name = "Hoelder exponent";
  if (plate.convergence.is_no()) return {name, "none"};
  if (!plate.holder.lower) return {name, "not proved"};
  return {name, number_text(plate.holder, places),
          !plate.holder.upper    ? "a lower bound; the shifts are not proved stable"
          : plate.exact.is_yes() ? "enclosed with proof; a product attains the radius"
                                 : "enclosed with proof"};
}

}  // namespace

std::string mask_text(const Scheme& scheme) {
  const LaurentPolynomial& symbol = scheme.mask.symbol();
  std::string text = symbol.to_mask_text();
  if (!scheme.rounding && text.size() <= longest) return text;
  text.clear();
  for (const Rational& coefficient : symbol.coefficients())
    text += (text.empty() ? "" : ",") + to_decimal(coefficient, places, Rounding::nearest);
  return fmt::format("[{}]@{}, to {} digits; subcert mask prints it exactly", text, symbol.lowest(), places);
}

std::vector<Fact> facts(const Plate& plate) {
  std::vector<Fact> list;
  const auto* scheme = std::get_if<Scheme>(&plate.scheme);
  list.push_back({"mask", scheme ? mask_text(*scheme)
                                 : fmt::format("{} coefficients",
                                               std::get<MultivariateScheme>(plate.scheme).mask.symbol().count())});
  if (scheme) add_algebra(list, *scheme, plate.sum_rules);
  list.push_back({"sum rules", std::to_string(plate.sum_rules)});
  list.push_back(decided("converges", plate.convergence));
  list.push_back(holder_fact(plate));
  if (!plate.convergence.is_yes()) return list;
  if (plate.sobolev) list.push_back({"Sobolev exponent", number_text(*plate.sobolev, places)});
  if (plate.derivatives >= 0)
    list.push_back({"continuous derivatives", std::to_string(plate.derivatives), "proved by norms"});
  list.push_back(decided("stable shifts", plate.stable));
  if (!plate.at_integers.empty()) list.push_back({"at integers", plate.at_integers});
  if (plate.largest_variance)
    list.push_back({"max psi", number_text(*plate.largest_variance, places_of_variance), "the variance curve"});
  if (plate.mean_variance) {
    constexpr std::size_t longest_number = 40;
    const std::string exact = to_text(*plate.mean_variance);
    list.push_back({"mean of psi", to_decimal(*plate.mean_variance, places, Rounding::nearest) +
                                       (exact.size() <= longest_number ? " = " + exact : "")});
  }
  return list;
}

std::vector<std::string> fact_names(const std::vector<std::vector<Fact>>& of_schemes) {
  std::vector<std::string> names;
  for (const std::vector<Fact>& list : of_schemes) {
    auto place = names.begin();
    for (const Fact& fact : list) {
      const auto there = std::ranges::find(names, fact.name);
      place = std::next(there != names.end() ? there : names.insert(place, fact.name));
    }
  }
  return names;
}

}  // namespace subcert::reports
