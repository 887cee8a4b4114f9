#include "multivariate_convergence.hpp"

#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/analysis/symbol/term_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace subcert {
namespace {

constexpr double most_terms = 1e6;

/// The sums of the coefficients, or of their moduli, over the classes of the exponents modulo `modulus`.
std::map<LatticePoint, Rational> sums_over_classes(const MultivariatePolynomial& symbol, long modulus) {
  std::map<LatticePoint, Rational> sums;
  for (auto& term : symbol.terms()) {
    for (long& n : term.exponents) n = modulo(n, modulus);
    sums[term.exponents] += abs(term.coefficient);
  }
  return sums;
}

Rational largest(const std::map<LatticePoint, Rational>& sums) {
  Rational result = 0;
  for (const auto& [residue, sum] : sums) result = std::max(result, sum);
  return result;
}

/// The scheme for data that depend on the variable `index` alone: the others set to 1, divided by arity for each.
Mask reduced(const MultivariateMask& mask, std::size_t index) {
  const auto variables = static_cast<std::size_t>(mask.dimension());
  const long lowest = mask.symbol().lowest()[index], highest = mask.symbol().highest()[index];
  std::vector<Rational> coefficients(static_cast<std::size_t>(highest - lowest + 1), 0);
  const Rational scale = power(Rational(mask.arity()), static_cast<long>(variables) - 1);
  for (const auto& term : mask.symbol().terms())
    coefficients[static_cast<std::size_t>(term.exponents[index] - lowest)] += term.coefficient / scale;
  return {LaurentPolynomial(coefficients, lowest), mask.arity()};
}

/// The largest number of terms that the symbol of the next power can have.
double next_terms(const MultivariatePolynomial& power, const MultivariatePolynomial& symbol, long dilation) {
  const auto low = power.lowest(), high = power.highest(), step_low = symbol.lowest(), step_high = symbol.highest();
  double product = 1;
  for (std::size_t v = 0; v < low.size(); ++v)
    product *= static_cast<double>(high[v] - low[v] + dilation * (step_high[v] - step_low[v]) + 1);
  return product;
}

/// Whether a power of the difference scheme in the variable contracts.
Decision contracts(const MultivariatePolynomial& quotient, int arity, const std::string& variable,
                   const ProofLimits& limits) {
  MultivariatePolynomial power = quotient;
  const std::string name = "S_q" + variable;
  Rational smallest = 0;
  long dilation = arity;  // arity^level
  int level = 1;
  for (;; ++level, dilation *= arity) {
    const Rational norm = largest(sums_over_classes(power, dilation));
    if (norm < 1)
      return {Truth::yes, "||" + name + (level == 1 ? "" : "^" + std::to_string(level)) + "|| = " + short_text(norm)};
    smallest = level == 1 ? norm : std::min(smallest, norm);
    if (level >= limits.levels || limits.deadline.expired() || next_terms(power, quotient, dilation) > most_terms)
      break;
    power = power * quotient.dilated(dilation);
  }
  return {Truth::unknown, "no power of " + name + " up to level " + std::to_string(level) +
                              " contracts; the smallest norm is " + short_text(smallest)};
}

}  // namespace

Rational operator_norm(const MultivariateMask& mask) {
  std::vector<Rational> sums(mask.dilation().digits().size(), 0);
  for (const auto& term : mask.symbol().terms())
    sums[mask.dilation().divide(term.exponents).digit] += abs(term.coefficient);
  return *std::max_element(sums.begin(), sums.end());
}

Decision converges(const MultivariateMask& mask, const ProofLimits& limits) {
  const auto sums = coset_sums(mask);
  for (std::size_t d = 0; d < sums.size(); ++d)
    if (sums[d] != 1)
      return {Truth::no, fmt::format("the coefficients with indices congruent to ({}) sum to {} instead of 1",
                                     fmt::join(mask.dilation().digits()[d], ", "), short_text(sums[d]))};
  if (!mask.dilation().factor() || *mask.dilation().factor() < 2)
    return {Truth::unknown,
            "the dilation is no multiple of the identity, so differences along the axes have no schemes"};
  const auto names = text::variable_names(mask.dimension());
  for (std::size_t v = 0; v < names.size(); ++v) {
    const Decision one = converges(reduced(mask, v), limits);
    if (one.is_no()) return {Truth::no, "data that depend on " + names[v] + " alone: " + one.reason};
  }
  std::string evidence;
  for (std::size_t v = 0; v < names.size(); ++v) {
    const auto factor = MultivariatePolynomial::in_variable(mask.dimension(), static_cast<int>(v),
                                                            LaurentPolynomial::all_ones(mask.arity()));
    const auto quotient = mask.symbol().exact_quotient(factor);
    if (!quotient)
      return {Truth::unknown, std::string("the symbol has no factor ") + factor.to_text() + ", so differences in " +
                                  names[v] + " have no scheme of their own"};
    Decision decision = contracts(*quotient, mask.arity(), names[v], limits);
    if (!decision.is_yes()) return decision;
    evidence += (evidence.empty() ? "" : ", ") + decision.reason;
  }
  return {Truth::yes, "the difference schemes contract: " + evidence};
}

Decision tensor_product_converges(const std::vector<Mask>& factors, const ProofLimits& limits) {
  Decision unknown{Truth::yes, ""};
  std::string evidence;
  const auto names = text::variable_names(static_cast<int>(factors.size()));
  for (std::size_t v = 0; v < factors.size(); ++v) {
    const Decision one = converges(factors[v], limits);
    const std::string reason = (factors.size() == 1 ? "" : "factor " + names[v] + ": ") + one.reason;
    if (one.is_no()) return {Truth::no, reason};
    if (!one.is_yes() && unknown.is_yes()) unknown = {Truth::unknown, reason};
    evidence += (v ? "; " : "") + reason;
  }
  return unknown.is_yes() ? Decision{Truth::yes, evidence} : unknown;
}

}  // namespace subcert
