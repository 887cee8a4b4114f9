#include "convergence.hpp"

#include "difference.hpp"
#include "level_norms.hpp"

#include <subcert/analysis/symbol/numbers/index_arithmetic.hpp>
#include <subcert/analysis/symbol/polynomials/root_modulus.hpp>
#include <subcert/analysis/symbol/polynomials/term_text.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/transition/transition.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace subcert {
namespace {

constexpr long largest_refuted_size = 200;  // beyond this, characteristic polynomials take too long
constexpr double most_terms = 1e6;          // of powers of symbols of several variables
constexpr double few_terms = 1e4;           // such powers are looked at in any time, so that more time never tells less

/// Whether a power of the difference scheme S_q contracts, q = a / (1 + ... + z^(arity-1)).
Decision contracts(const Mask& mask, const ProofLimits& limits) {
  const Mask derived = divided_difference_scheme(mask, 1);  // S_q is this divided by the arity
  const auto norm_of_difference = [&](const Rational& norm, int level) {
    return norm * power(Rational(mask.arity()), -level);
  };
  Rational smallest = 0;
  int reached = 0;
  // Doubling keeps the cost near that of the first level that proves it.
  for (int levels = std::min(4, limits.levels); levels > reached; levels = std::min(2 * levels, limits.levels)) {
    const LevelNorms powers = level_norms(derived, levels, limits.deadline);
    for (std::size_t l = static_cast<std::size_t>(reached); l < powers.norms.size(); ++l) {
      const int level = static_cast<int>(l) + 1;
      const Rational norm = norm_of_difference(powers.norms[l], level);
      if (norm < 1)
        return {Truth::yes,
                "the difference scheme contracts: ||S_q^" + std::to_string(level) + "|| = " + short_text(norm)};
      smallest = reached == 0 && l == 0 ? norm : std::min(smallest, norm);
    }
    reached = static_cast<int>(powers.norms.size());
    const bool small = derived.symbol().length() <= largest_refuted_size * (mask.arity() - 1);
    if (small &&
        (levels == 4 || reached < levels))  // cheap, and often the true answer where four levels did not contract
      for (const RationalMatrix& transition : transition_matrices(derived)) {
        const auto scaled = characteristic_polynomial(transition, limits.deadline);
        if (!scaled) break;
        const Rational arity(mask.arity());
        const bool on_circle = (*scaled)(arity) == 0 || (*scaled)(-arity) == 0;
        const auto modulus = on_circle ? std::nullopt : largest_root_modulus(*scaled, 64, limits.deadline);
        if (!on_circle && !modulus) break;
        if (on_circle || *modulus->largest.lower >= arity)
          return {Truth::no, "a transition matrix of the difference scheme has an eigenvalue of modulus " +
                                 std::string(on_circle ? "1" : "above 1")};
      }
    if (reached < levels) break;
  }
  return {Truth::unknown, "no contractive power of the difference scheme up to level " + std::to_string(reached) +
                              "; the smallest norm is " + short_text(smallest)};
}

Decision curve_converges(const Mask& mask, const ProofLimits& limits) {
  const std::vector<Rational> sums = coset_sums(mask);
  for (std::size_t residue = 0; residue < sums.size(); ++residue)
    if (sums[residue] != 1)
      return {Truth::no, "the coefficients with index congruent to " + std::to_string(residue) + " sum to " +
                             short_text(sums[residue]) + " instead of 1"};
  if (has_positive_mask(mask))
    return {Truth::yes, "all coefficients are positive and the mask is longer than the arity"};
  return contracts(mask, limits);
}

SmoothnessProof curve_smoothness(const Mask& mask, const ProofLimits& limits) {
  SmoothnessProof proof;
  if (!is_affine(mask)) {
    proof.obstacle = curve_converges(mask, limits).reason;
    return proof;
  }
  const int rules = sum_rules(mask);
  Mask derived = mask;
  for (int order = 0; order < rules; ++order) {
    if (order > 0) derived = divided_difference_scheme(derived, 1);
    const Decision decision = curve_converges(derived, limits);
    if (!decision.is_yes()) {
      proof.obstacle = decision.reason;
      return proof;
    }
    proof.order = order;
    proof.evidence = decision.reason;
  }
  proof.obstacle = "the mask has only " + std::to_string(rules) + (rules == 1 ? " sum rule" : " sum rules");
  return proof;
}

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
Mask reduced(const LatticeMask& mask, std::size_t index) {
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
Decision power_contracts(const MultivariatePolynomial& quotient, int arity, const std::string& variable,
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
    const double terms = next_terms(power, quotient, dilation);
    if (level >= limits.levels || terms > (limits.deadline.expired() ? few_terms : most_terms)) break;
    power = power * quotient.dilated(dilation);
  }
  return {Truth::unknown, "no power of " + name + " up to level " + std::to_string(level) +
                              " contracts; the smallest norm is " + short_text(smallest)};
}

Decision whole_converges(const LatticeMask& mask, const ProofLimits& limits) {
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
    const Decision one = curve_converges(reduced(mask, v), limits);
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
    Decision decision = power_contracts(*quotient, mask.arity(), names[v], limits);
    if (!decision.is_yes()) return decision;
    evidence += (evidence.empty() ? "" : ", ") + decision.reason;
  }
  return {Truth::yes, "the difference schemes contract: " + evidence};
}

Decision factors_converge(const std::vector<Mask>& factors, const ProofLimits& limits) {
  Decision unknown{Truth::yes, ""};
  std::string evidence;
  const auto names = text::variable_names(static_cast<int>(factors.size()));
  for (std::size_t v = 0; v < factors.size(); ++v) {
    const Decision one = curve_converges(factors[v], limits);
    const std::string reason = (factors.size() == 1 ? "" : "factor " + names[v] + ": ") + one.reason;
    if (one.is_no()) return {Truth::no, reason};
    if (!one.is_yes() && unknown.is_yes()) unknown = {Truth::unknown, reason};
    evidence += (v ? "; " : "") + reason;
  }
  return unknown.is_yes() ? Decision{Truth::yes, evidence} : unknown;
}

}  // namespace

bool has_positive_mask(const Mask& mask) {
  const auto coefficients = mask.symbol().coefficients();
  return mask.symbol().length() > mask.arity() && is_affine(mask) &&
         std::all_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c > 0; });
}

Decision converges(const LatticeMask& mask, const ProofLimits& limits) {
  return mask.has_factors() ? factors_converge(mask.factors(), limits) : whole_converges(mask, limits);
}

SmoothnessProof proved_smoothness(const LatticeMask& mask, const ProofLimits& limits) {
  require(mask.has_factors(), "proved_smoothness: need a mask of one variable or a tensor product");
  std::optional<SmoothnessProof> roughest;
  for (const Mask& factor : mask.factors()) {
    SmoothnessProof proof = curve_smoothness(factor, limits);
    if (!roughest || proof.order < roughest->order) roughest = std::move(proof);
  }
  return *roughest;
}

}  // namespace subcert
