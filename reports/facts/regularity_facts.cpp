#include "regularity_facts.hpp"

#include "exponents.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/numbers/decimal.hpp>
#include <subcert/analysis/symbol/polynomials/quadratic_number.hpp>
#include <subcert/proofs-checks/certificates/certificate.hpp>
#include <subcert/schemes/data/refine/vector_refinement.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <set>

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
  if (holder.is_exact()) return exponent_fact(std::move(text), "exactly, with proof", holder, digits);
  const int most = holder.telling_digits(std::max(digits, 17));
  return exponent_fact(std::move(text),
                       "enclosed with proof" + (regularity.deciding().radius.is_closed()
                                                    ? ", " + holder.lower_text(most) + " ... " + holder.upper_text(most)
                                                    : ""),
                       holder, digits);
}

Fact exponent_fact(const MultivariateRegularity& regularity, bool by_factors, int digits) {
  const Enclosure& exponent = regularity.exponent;
  if (!exponent.lower && regularity.vector) {
    const Decision& continuous = regularity.vector->continuous;
    return exponent_fact(continuous.is_no() ? "none, as there is no continuous solution"
                                            : "unknown, as a continuous solution is not proved",
                         "", exponent, digits);
  }
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

std::string function_name(std::size_t component) { return fmt::format("phi_{}", component + 1); }

std::size_t count_of_matrices(const LatticeMask& mask) {
  std::set<LatticePoint> exponents;
  for (const LatticeMask::Term& term : mask.terms()) exponents.insert(term.exponents);
  return exponents.size();
}

/// Of an integral, component by component.
std::vector<std::string> numbers_of(const std::vector<Rational>& integral, long root) {
  std::vector<std::string> result;
  const std::size_t size = root > 0 ? integral.size() / 2 : integral.size();
  for (std::size_t c = 0; c < size; ++c)
    result.push_back(
        (root > 0 ? QuadraticNumber{integral[c], integral[size + c], root} : QuadraticNumber{integral[c]}).to_text());
  return result;
}

std::string integral_text(const std::vector<Rational>& integral, long root) {
  return fmt::format("[{}]", fmt::join(numbers_of(integral, root), ","));
}

/// How to choose one of several solutions; nothing where their integrals are all 0.
std::string chosen_by_integral(const FunctionVector& vector) {
  if (vector.integrals.empty()) return "";
  std::vector<std::string> basis;
  for (const auto& integral : vector.integrals) basis.push_back(integral_text(integral, vector.root));
  return fmt::format("; their integrals are combinations of {}, and one is chosen as by integral={}",
                     fmt::join(basis, " and "), basis.front());
}

std::string solutions_text(const FunctionVector& vector) {
  const std::string integral = vector.integral ? integral_text(*vector.integral, vector.root) : "";
  if (vector.solutions == 0)
    return integral.empty() || vector.integrals.empty()
               ? "none that is continuous"
               : "none that is continuous has the integral " + integral + chosen_by_integral(vector);
  if (vector.solutions == 1)
    return integral.empty() ? "at most one that is continuous, up to a factor"
                            : "at most one that is continuous has the integral " + integral;
  const std::string them = "; what follows is about all of them";
  return fmt::format("at most {} that are continuous and independent", vector.solutions) +
         (integral.empty() ? them + chosen_by_integral(vector) : ", with the integral " + integral + " or 0" + them);
}

/// What a Hermite scheme keeps, and whether it would keep more in another convention.
Fact spectral_fact(const Scheme& scheme) {
  const LatticeMask& mask = scheme.mask;
  const int degree = data::hermite_reproduction(mask, scheme.quadratic).degree,
            wanted = static_cast<int>(mask.components()) - 1;
  const auto up_to = [](int d) {
    return d == 0 ? std::string("of constants") : fmt::format("of polynomials up to degree {}", d);
  };
  std::string text = degree < 0 ? "not even those of constants" : "those " + up_to(degree);
  if (degree < wanted) {
    text += ": the spectral condition of its data fails";
    if (scheme.quadratic) return {"spectral_degree", "keeps data", text, "", degree};
    // Of A_k the columns are the rows of P_k.
    std::vector<LatticeMask::Term> exchanged = mask.terms(), divided = exchanged;
    for (LatticeMask::Term& term : exchanged) std::swap(term.row, term.column);
    for (LatticeMask::Term& term : divided)
      term.coefficient *= power(Rational(mask.arity()), -static_cast<long>(term.column));
    for (const auto& [terms, change] : {std::pair(exchanged, std::string("their transposes")),
                                        {divided, fmt::format("row k divided by {}^k, k = 0, 1, ...", mask.arity())}}) {
      const int other = data::hermite_reproduction(matrix_mask(terms, mask.components(), mask.dilation())).degree;
      if (other >= wanted)
        text += fmt::format("; the matrices may be meant in another convention: {} keep those {}", change,
                            up_to(other));
    }
  }
  return {"spectral_degree", "keeps data", text, "", degree};
}

Facts dilation_facts(const LatticeMask& mask) {
  const Dilation& dilation = mask.dilation();
  return {member("variables", mask.dimension()),
          {"dilation", "dilation", dilation.to_text() + ", digits " + to_text(dilation.digits()), "", dilation.rows()},
          member("digits", dilation.digits())};
}

}  // namespace

std::string needed_solution(const FunctionVector& vector) {
  return fmt::format("one continuous solution up to a factor, got up to {}{}", vector.solutions,
                     chosen_by_integral(vector));
}

Facts equation_facts(const LatticeMask& mask, const FunctionVector& vector) {
  std::string text = to_mask_text(mask);
  constexpr std::size_t most_text = 400;
  if (text.size() > most_text)
    text = fmt::format("{} matrices of {} rows, see subcert mask", count_of_matrices(mask), mask.components());
  std::vector<std::string> sides;
  for (const Interval& side : limit_support(mask))
    sides.push_back(fmt::format("[{}, {}]", to_text(side.lower), to_text(side.upper)));
  Json integrals = Json::array();
  for (const auto& integral : vector.integrals) integrals.push_back(numbers_of(integral, vector.root));
  return {{"equation", "equation",
           "phi(x) = sum of A_k phi(" + std::string(mask.dimension() == 1 ? fmt::format("{}x", mask.arity()) : "Mx") +
               " - k), A = " + text,
           "", to_mask_text(mask)},
          {"", "support", fmt::format("in {}", fmt::join(sides, " x "))},
          {"solutions", "solutions", solutions_text(vector), "", vector.solutions},
          member("integrals", std::move(integrals))};
}

Fact continuous_fact(const Decision& continuous) {
  Fact fact = decided("continuous", "continuous", continuous);
  fact.json = to_text(continuous.truth);
  return fact;
}

Fact hermite_fact(const std::optional<HermiteOrder>& hermite) {
  if (!hermite) return member("hermite", nullptr);
  const auto& [order, next] = *hermite;
  const std::string after = fmt::format("HC^{}", order + 1);
  std::string text = order < 0 ? next.is_no() ? "none" : "unknown" : fmt::format("HC^{}", order);
  if (order >= 0) text += next.is_no() ? fmt::format(", not {}", after) : fmt::format("; {} is open", after);
  return {"hermite",
          "Hermite",
          std::move(text),
          next.reason,
          {{"order", order < 0 ? Json() : Json(order)}, {"next", to_text(next.truth)}, {"reason", next.reason}}};
}

Fact components_fact(const FunctionVector& vector, int digits) {
  Json list = Json::array();
  std::string text;
  for (const ComponentRegularity& one : vector.components) {
    list.push_back({{"component", one.component + 1},
                    {"holder", enclosure_json(one.exponent, std::max(digits, most_digits))},
                    {"exact", one.exact.is_yes()}});
    text += fmt::format("{}{} {}", text.empty() ? "" : "\n", function_name(one.component),
                        one.is_zero ? "is 0" : enclosure_text(one.exponent, std::max(digits, usual_digits)));
  }
  if (list.empty()) return member("components", list);
  return {"components", "components", text, "", list};
}

Fact values_fact(const FieldValues& values) {
  std::string text;
  Json list = Json::array();
  for (const auto& [point, numbers] : values)
    for (std::size_t c = 0; c < numbers.size(); ++c) {
      if (numbers[c].is_zero()) continue;
      text += fmt::format("{}phi_{}({}) = {}", text.empty() ? "" : ", ", c + 1, fmt::join(point, ","),
                          numbers[c].to_text());
      list.push_back({{"component", c + 1}, {"point", point}, {"value", numbers[c].to_text()}});
    }
  return {"lattice_values", "values", text, "", list};
}

Fact exponent_fact(const Scheme& scheme, const Regularity& regularity, int digits) {
  if (regularity.curve) return exponent_fact(*regularity.curve, regularity.curve->proved_exponent(), digits);
  return exponent_fact(*regularity.surface, scheme.mask.has_factors() && !regularity.surface->radius, digits);
}

Facts regularity_facts(const Scheme& scheme, const Regularity& regularity,
                       const std::optional<SobolevRegularity>& sobolev, const RegularityForm& form) {
  const auto& curve = regularity.curve;
  const auto& surface = regularity.surface;
  Facts list = named(scheme.specification, scheme.title);
  list.push_back(exponent_fact(scheme, regularity, form.digits));
  append(list, formula_facts(exponent_formula(scheme, regularity)));
  const FunctionVector* vector = surface && surface->vector ? &*surface->vector : nullptr;
  if (vector) {
    append(list, {components_fact(*vector, form.digits), continuous_fact(vector->continuous)});
    append(list, equation_facts(scheme.mask, *vector));
  }
  append(list, curve ? Facts{rounding_fact(scheme.rounding)} : dilation_facts(scheme.mask));
  list.push_back(vector ? member("sum_rules", nullptr) : plain("sum_rules", "sum rules", regularity.sum_rules()));
  list.push_back(converges_fact(regularity.converges()));
  if (vector) {
    list.push_back(hermite_fact(vector->hermite));
    list.push_back(scheme.form == VectorForm::hermite ? spectral_fact(scheme) : member("spectral_degree", nullptr));
  }
  if (curve)
    append(list, {bound_fact("bound", curve->bounds.last()), levels_member(curve->bounds)});
  else
    append(list, {space_fact(*surface, scheme.mask.dilation()), surface_bound_fact(surface->bound)});
  if (const JointSpectralRadius* radius = regularity.radius())
    append(list, radius_facts(*radius, std::max(form.digits, most_digits)));
  else
    append(list, {member("radius", nullptr), member("blocks", nullptr), member("product", ""),
                  member("method", "factors of a tensor product"), member("vertices", nullptr)});
  // Of the mask itself, also where the exponent is that of the reduced one.
  append(list, curve ? exact_facts(curve->radius.exact, curve->radius.is_closed())
                     : exact_facts(surface->exact, surface->is_closed()));
  append(list, vector ? Facts{member("stable", "unknown"), member("stability", regularity.stable().reason)}
                      : stable_facts(regularity.stable(), !curve || curve->converges.is_yes()));
  if (curve) {
    list.push_back(reduced_fact(*curve));
    if (curve->proved_exponent().lower && *curve->exponent.lower > 0) list.push_back(attained_fact(*curve));
    append(list, {logarithm_member(curve->logarithm), member("single", decision_json(curve->single.applies)),
                  sobolev_fact(sobolev, curve->stable)});
    if (!form.complete) list.push_back({"", "budget", "the polytope did not close; the enclosure reached is printed"});
  } else {
    list.push_back(sobolev_fact(surface->sobolev, surface->stable, vector != nullptr));
    if (!surface->is_closed() && !surface->converges.is_no() && !(vector && vector->continuous.is_no()))
      list.push_back({"", "budget", "the search did not close; the enclosure reached is printed"});
  }
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
