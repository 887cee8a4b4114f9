#include "multivariate_convergence.hpp"

#include <subcert/analysis/symbol/index_arithmetic.hpp>
#include <subcert/analysis/symbol/term_text.hpp>

#include <algorithm>
#include <map>
#include <string>

namespace subcert {
namespace {

constexpr double most_terms = 1e6;

std::map<std::vector<long>, Rational> sums_over_cosets(const MultivariateMask& mask, bool moduli) {
  std::map<std::vector<long>, Rational> sums;
  const long arity = mask.arity();
  for (auto& term : mask.symbol().terms()) {
    for (long& n : term.exponents) n = modulo(n, arity);
    sums[term.exponents] += moduli ? Rational(abs(term.coefficient)) : term.coefficient;
  }
  return sums;
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
    const Rational norm = operator_norm(MultivariateMask(power, static_cast<int>(dilation)));
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
  Rational largest = 0;
  for (const auto& [residue, sum] : sums_over_cosets(mask, true)) largest = std::max(largest, sum);
  return largest;
}

Decision converges(const MultivariateMask& mask, const ProofLimits& limits) {
  const auto sums = sums_over_cosets(mask, false);
  std::size_t classes = 1;
  for (int v = 0; v < mask.dimension(); ++v) classes *= static_cast<std::size_t>(mask.arity());
  if (sums.size() < classes) return {Truth::no, "a coset has no coefficients, so its sum is 0 instead of 1"};
  for (const auto& [residue, sum] : sums) {
    if (sum == 1) continue;
    std::string text;
    for (const long r : residue) text += (text.empty() ? "" : ", ") + std::to_string(r);
    return {Truth::no,
            "the coefficients with indices congruent to (" + text + ") sum to " + short_text(sum) + " instead of 1"};
  }
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
