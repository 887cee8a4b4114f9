#include "regularity_facts.hpp"

#include "exponents.hpp"

#include <subcert/analysis/symbol/decimal.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace subcert::facts {
namespace {

constexpr int most_digits = 20, usual_digits = 14;  // of an exponent, in JSON and for people

/// The first digits of what the exponent exceeds this derivative by, never rounded up.
std::string leading_digits(const Enclosure& exponent, int derivative) {
  const Rational low = *exponent.lower - derivative;
  if (exponent.is_exact()) return to_text(low);
  const Rational high = exponent.upper ? Rational(*exponent.upper - derivative) : low;
  const int digits = Enclosure{low, high}.telling_digits(6);
  std::string text = to_decimal(low, digits, Rounding::down);
  return text == to_decimal(high, digits, Rounding::down) ? text + "..." : text;
}

/// Whether the exponent is attained: the modulus of continuity of the derivative that decides.
Fact attained_fact(const HolderRegularity& regularity) {
  const LogarithmicFactor& factor = regularity.logarithm;
  const auto answer = [](const char* verdict, const std::string& why) { return Fact{"", "attained", verdict, why}; };
  if (!factor.derivative) return answer("unknown", factor.reason);
  const auto modulus = [&](int power) {
    const std::string exponent = leading_digits(regularity.exponent, *factor.derivative);
    return "h" + (exponent == "1" ? "" : "^" + exponent) +
           (power == 0   ? ""
            : power == 1 ? " |log h|"
                         : " |log h|^" + std::to_string(power));
  };
  const std::string subject = *factor.derivative == 0
                                  ? "the limits"
                                  : "the derivatives of order " + std::to_string(*factor.derivative);
  if (!factor.at_most)
    return factor.at_least == 0
               ? answer("unknown", factor.reason)
               : answer("no", subject + " have no smaller modulus of continuity than " + modulus(factor.at_least));
  const std::string has = subject + " have the modulus of continuity " + modulus(*factor.at_most);
  if (*factor.at_most == 0) return answer("yes", has);
  if (factor.at_least == 0) return answer("unknown", has + " or a smaller one");
  return answer("no", has + (factor.at_least == *factor.at_most ? ", and no smaller one" : " or a smaller one"));
}

/// A verdict alone in JSON, as the contract has it.
Fact converges_fact(const Decision& converges) {
  Fact fact = decided("converges", "converges", converges);
  fact.json = to_text(converges.truth);
  return fact;
}

Facts stable_facts(const Decision& stable, bool of_limits) {
  Fact fact{"stable", "stable", to_text(stable.truth), stable.reason, stable.is_yes()};
  if (!of_limits) {
    fact.text += ", the shifts of the refinable distribution: " + stable.reason;
    fact.remark.clear();
  }
  return {fact, member("stability", stable.reason)};
}

Fact exponent_fact(std::string text, std::string remark, const Enclosure& exponent, int digits) {
  return {"holder", "exponent", std::move(text), std::move(remark),
          enclosure_json(exponent, std::max(digits, most_digits))};
}

std::string no_exponent_text(const Decision& converges) {
  return converges.is_no()    ? "none, as the scheme does not converge"
         : converges.is_yes() ? "unknown"
                              : "unknown, as convergence is not proved";
}

Fact exponent_fact(const HolderRegularity& regularity, const Enclosure& holder, int digits) {
  if (!holder.lower && !holder.upper) return exponent_fact(no_exponent_text(regularity.converges), "", holder, digits);
  std::string text = enclosure_text(holder, std::max(digits, usual_digits));
  if (!holder.upper) return exponent_fact(std::move(text), "a proved lower bound", holder, digits);
  const int most = holder.telling_digits(std::max(digits, 17));
  return exponent_fact(std::move(text),
                       "enclosed with proof" + (regularity.deciding().radius.is_closed()
                                                    ? ", " + holder.lower_text(most) + " ... " + holder.upper_text(most)
                                                    : ""),
                       holder, digits);
}

Fact exponent_fact(const MultivariateRegularity& regularity, bool by_factors, int digits) {
  const Enclosure& exponent = regularity.exponent;
  if (!exponent.lower) return exponent_fact(no_exponent_text(regularity.converges), "", exponent, digits);
  if (!exponent.upper)
    return exponent_fact(
        enclosure_text(exponent, usual_digits),
        std::string("a proved lower bound") +
            (regularity.stable.is_no() ? "; the shifts are unstable, so the limits may be smoother" : ""),
        exponent, digits);
  return exponent_fact(enclosure_text(exponent, std::max(digits, usual_digits)),
                       std::string("enclosed with proof") + (by_factors ? ", by the factors" : ""), exponent, digits);
}

Fact reduced_fact(const HolderRegularity& regularity) {
  if (!regularity.reduced) return member("reduced", nullptr);
  const auto& [mask, its] = *regularity.reduced;
  return {"reduced",
          "reduced",
          fmt::format("{}: b(z) p(z^{}) = a(z) p(z), p = {}; the same smoothness, {} with {}",
                      mask.mask.symbol().to_mask_text(), mask.mask.arity(), mask.factor.to_text(),
                      its.converges.is_yes() ? "exponent " + enclosure_text(its.exponent, usual_digits) : "no exponent",
                      sized_method_text(its.radius)),
          "",
          {{"factor", mask.factor.to_text()},
           {"mask", mask.mask.symbol().to_mask_text()},
           {"radius", enclosure_json(its.radius.radius)},
           {"product", word_text(its.radius.product.word)},
           {"exact", its.radius.exact.is_yes()}}};
}

Fact space_fact(const MultivariateRegularity& regularity, const Dilation& dilation) {
  if (!regularity.space) return member("dimension", nullptr);
  const DifferenceSpace& space = *regularity.space;
  return {"dimension", "space",
          fmt::format("dimension {}, differences of order {}{}{} lattice points{}", space.family.size(), space.order,
                      space.is_of_values() ? " of phi on " : " on ", space.window.size(),
                      space.dilation == dilation ? ""
                                                 : ", for the dilation " + space.dilation.to_text() + ", digits " +
                                                       to_text(space.dilation.digits())),
          "", space.family.size()};
}

Fact rounding_fact(const std::optional<MaskRounding>& rounding) {
  if (!rounding) return member("rounded", nullptr);
  return {"rounded", "rounded",
          "coefficients, by " + to_decimal(rounding->distance, 2, Rounding::up) +
              " at most; what follows holds for all such masks",
          "", to_text(rounding->distance)};
}

Fact logarithm_member(const LogarithmicFactor& logarithm) {
  return member("logarithm", {{"at_least", logarithm.at_least},
                              {"at_most", optional_json(logarithm.at_most)},
                              {"derivative", optional_json(logarithm.derivative)},
                              {"reason", logarithm.reason}});
}

Fact levels_member(const HolderBounds& bounds) {
  Json by_level = Json::array();
  for (const HolderBound& bound : bounds.levels) by_level.push_back(bound.exponent.lower_text(12));
  return member("bounds_by_level", std::move(by_level));
}

Fact surface_bound_fact(const std::optional<HolderBound>& bound) {
  if (!bound) return member("bound", nullptr);
  if (bound->exponent.lower.value_or(0) <= 0) return member("bound", bound_json(*bound));
  return {"bound", "bound",
          fmt::format(">= {} by norms of products of length {}", bound->exponent.lower_text(12), bound->levels), "",
          bound_json(*bound)};
}

}  // namespace

Facts regularity_facts(const Scheme& scheme, const HolderRegularity& regularity,
                       const std::optional<SobolevRegularity>& sobolev, const RegularityForm& form) {
  const Enclosure holder = regularity.proved_exponent();
  Facts list = named(scheme.specification, scheme.title);
  list.push_back(rounding_fact(scheme.rounding));
  list.push_back(plain("sum_rules", "sum rules", regularity.bounds.sum_rules));
  list.push_back(converges_fact(regularity.converges));
  list.push_back(bound_fact("bound", regularity.bounds.last()));
  list.push_back(levels_member(regularity.bounds));
  append(list, radius_facts(regularity.radius, std::max(form.digits, most_digits)));
  append(list, exact_facts(regularity.radius.exact, regularity.radius.is_closed()));
  append(list, stable_facts(regularity.stable, regularity.converges.is_yes()));
  list.push_back(reduced_fact(regularity));
  list.push_back(exponent_fact(regularity, holder, form.digits));
  if (holder.lower && *regularity.exponent.lower > 0) list.push_back(attained_fact(regularity));
  list.push_back(logarithm_member(regularity.logarithm));
  list.push_back(member("single", decision_json(regularity.single.applies)));
  list.push_back(sobolev_fact(sobolev, regularity.stable));
  if (!form.complete) list.push_back({"", "budget", "the polytope did not close; the enclosure reached is printed"});
  list.push_back(member("seconds", form.seconds));
  return list;
}

Facts regularity_facts(const Scheme& scheme, const MultivariateRegularity& regularity, const RegularityForm& form) {
  const Dilation& dilation = scheme.mask.dilation();
  const auto& radius = regularity.radius;
  Facts list = named(scheme.specification, scheme.title);
  list.push_back(member("variables", scheme.mask.dimension()));
  list.push_back(
      {"dilation", "dilation", dilation.to_text() + ", digits " + to_text(dilation.digits()), "", dilation.rows()});
  list.push_back(member("digits", dilation.digits()));
  list.push_back(plain("sum_rules", "sum rules", regularity.sum_rules));
  list.push_back(converges_fact(regularity.converges));
  list.push_back(space_fact(regularity, dilation));
  list.push_back(surface_bound_fact(regularity.bound));
  if (radius)
    append(list, radius_facts(*radius, std::max(form.digits, most_digits)));
  else
    append(list, {member("radius", nullptr), member("blocks", nullptr), member("product", ""),
                  member("method", "factors of a tensor product"), member("vertices", nullptr)});
  append(list, exact_facts(regularity.exact, regularity.is_closed()));
  append(list, stable_facts(regularity.stable, true));
  list.push_back(exponent_fact(regularity, scheme.mask.has_factors() && !radius, form.digits));
  list.push_back(sobolev_fact(regularity.sobolev, regularity.stable));
  if (!regularity.is_closed() && !regularity.converges.is_no())
    list.push_back({"", "budget", "the search did not close; the enclosure reached is printed"});
  list.push_back(member("seconds", form.seconds));
  return list;
}

Facts frequency_facts(const Scheme& scheme, const std::optional<FrequencyBound>& bound, double seconds) {
  Facts result = named(scheme.specification, scheme.title);
  const bool positive = bound && bound->exponent > 0;
  if (bound) result.push_back(plain("sum_rules", "sum rules", bound->sum_rules));
  result.push_back(converges_fact(positive ? Decision{Truth::yes, "the exponent is positive"}
                                           : Decision{Truth::unknown, "no bound was found"}));
  const Enclosure exponent = positive ? Enclosure::at_least(bound->exponent) : Enclosure{};
  result.push_back(exponent_fact(
      positive ? ">= " + to_decimal(bound->exponent, usual_digits, Rounding::down) : "unknown",
      positive ? fmt::format("proved by a function on {} cells of each shell of frequencies that grows by a factor of "
                             "at most 1 + {} a level",
                             bound->proof.cells, to_decimal(Rational(bound->proof.bound - 1), 5, Rounding::up))
               : "",
      exponent, usual_digits));
  result.push_back(member("method", "frequency"));
  result.push_back(member("seconds", seconds));
  return result;
}

}  // namespace subcert::facts
