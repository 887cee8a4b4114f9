#include "gallery.hpp"

#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/reports/facts/regularity_facts.hpp>
#include <subcert/reports/facts/scheme_facts.hpp>
#include <subcert/reports/formats/comparison.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::reports {
namespace {

using facts::decided;
using facts::Fact;
using facts::Facts;
using facts::member;

constexpr int places = 10, places_of_variance = 5;  // for people
constexpr std::size_t longest_text = 1200;          // characters of an exact object for people

std::string number_text(const Enclosure& enclosure, int digits) {
  return enclosure.is_exact() ? to_text(*enclosure.lower) : formats::fixed_text(enclosure, digits);
}

std::string short_mask(const LaurentPolynomial& symbol) {
  std::string text;
  for (const Rational& coefficient : symbol.coefficients())
    text += (text.empty() ? "" : ",") + to_decimal(coefficient, places, Rounding::nearest);
  return fmt::format("[{}]@{}, to {} digits; subcert mask prints it exactly", text, symbol.lowest(), places);
}

/// Of rounded coefficients the algebra says nothing about those that are meant.
Facts known_of_mask(const Scheme& scheme) {
  Facts list = facts::mask_facts(scheme);
  const bool curve = scheme.mask.dimension() == 1;
  for (Fact& fact : list)
    if (curve && fact.label == "mask" && (scheme.rounding || fact.text.size() > longest_text))
      fact.text = short_mask(scheme.mask.curve().symbol());
  std::erase_if(list, [&](const Fact& fact) {
    return fact.label == "scheme" || (curve && fact.label != "mask" && fact.text.size() > longest_text) ||
           (scheme.rounding && (fact.label == "symbol" || fact.label == "symmetry" || fact.label == "polynomials"));
  });
  return list;
}

Fact holder_fact(const Plate& plate, int digits) {
  Fact fact{"holder", "Hoelder exponent", "none"};
  if ((plate.vector ? plate.vector->continuous : plate.convergence).is_no()) return fact;
  fact.text = "not proved";
  if (!plate.holder.lower) return fact;
  return {"holder", "Hoelder exponent", number_text(plate.holder, digits),
          !plate.holder.upper    ? "a lower bound; the shifts are not proved stable"
          : plate.exact.is_yes() ? "enclosed with proof; a product attains the radius"
                                 : "enclosed with proof",
          facts::enclosure_json(plate.holder)};
}

/// As many as norms prove, or the exponent: more than k has C^k limits.
Fact derivatives_fact(const Plate& plate) {
  int order = plate.derivatives;
  const Enclosure& exponent = plate.holder;
  const bool by_exponent = exponent.lower && *exponent.lower > order + 1;
  if (by_exponent) order = static_cast<int>(ceil_index(*exponent.lower)) - 1;
  if (order < 0) return member("derivatives", {});
  return {"derivatives", "continuous derivatives", std::to_string(order),
          by_exponent ? "from the exponent" : "proved by norms", order};
}

/// Of a vector of functions what the equation says; else what the mask does.
Facts vector_facts(const Plate& plate, int digits) {
  if (!plate.vector) return {decided("convergence", "convergence", plate.convergence)};  // a note says why
  const FunctionVector& vector = *plate.vector;
  Facts list = facts::equation_facts(plate.scheme.mask, vector);
  append(list, {facts::plain("functions", "functions", plate.scheme.mask.components()),
                decided("convergence", "convergence", plate.convergence), facts::continuous_fact(vector.continuous),
                holder_fact(plate, digits), facts::components_fact(vector), member("exact", plate.exact.is_yes())});
  if (plate.sobolev)
    list.push_back(
        {"sobolev", "Sobolev exponent", number_text(*plate.sobolev, digits), "", facts::enclosure_json(plate.sobolev)});
  list.push_back(derivatives_fact(plate));
  list.push_back(facts::hermite_fact(vector.hermite));
  return list;
}

Fact mean_fact(const Rational& mean) {
  constexpr std::size_t longest_number = 40;
  const std::string exact = to_text(mean);
  return {"variance_mean", "mean of psi",
          to_decimal(mean, places, Rounding::nearest) + (exact.size() <= longest_number ? " = " + exact : ""), "",
          exact};
}

}  // namespace

Facts plate_facts(const Plate& plate, int digits) {
  const bool converges = plate.convergence.is_yes();
  Facts list{member("scheme", plate.specification())};
  if (plate.scheme.form) {
    append(list, vector_facts(plate, digits));
    return list;
  }
  append(list, known_of_mask(plate.scheme));
  list.push_back(decided("convergence", "convergence", plate.convergence));
  list.push_back(holder_fact(plate, digits));
  list.push_back(member("exact", plate.exact.is_yes()));
  const auto known = [&](bool is, Fact fact) { list.push_back(is && converges ? fact : member(fact.key, fact.json)); };
  const auto number = [](const std::optional<Enclosure>& value, int shown) {
    return value ? number_text(*value, shown) : "";
  };
  known(plate.sobolev.has_value(),
        {"sobolev", "Sobolev exponent", number(plate.sobolev, digits), "", facts::enclosure_json(plate.sobolev)});
  known(true, derivatives_fact(plate));
  known(true, decided("stable", "stable shifts", plate.stable));
  known(!plate.at_integers.empty(), {"", "at integers", plate.at_integers});
  known(plate.largest_variance.has_value(),
        {"variance_sup", "max psi", number(plate.largest_variance, places_of_variance), "the variance curve",
         facts::enclosure_json(plate.largest_variance)});
  known(plate.mean_variance.has_value(),
        plate.mean_variance ? mean_fact(*plate.mean_variance) : member("variance_mean", {}));
  return list;
}

}  // namespace subcert::reports
