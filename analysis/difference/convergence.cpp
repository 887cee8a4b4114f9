#include "convergence.hpp"

#include "difference.hpp"
#include "level_norms.hpp"

#include <subcert/analysis/transition/transition.hpp>

#include <algorithm>
#include <string>

namespace subcert {
namespace {

constexpr long largest_refuted_size = 200;  // beyond this, characteristic polynomials take too long

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
        const Stopwatch watch;
        const auto scaled = characteristic_polynomial(transition, limits.deadline);
        if (!scaled || limits.deadline.remaining() < watch.seconds()) break;  // its zeros take as long again
        const Rational arity(mask.arity());
        const bool on_circle = (*scaled)(arity) == 0 || (*scaled)(-arity) == 0;
        if (on_circle || *largest_root_modulus(*scaled).largest.lower >= arity)
          return {Truth::no, "a transition matrix of the difference scheme has an eigenvalue of modulus " +
                                 std::string(on_circle ? "1" : "above 1")};
      }
    if (reached < levels) break;
  }
  return {Truth::unknown, "no contractive power of the difference scheme up to level " + std::to_string(reached) +
                              "; the smallest norm is " + short_text(smallest)};
}

}  // namespace

bool has_positive_mask(const Mask& mask) {
  const auto coefficients = mask.symbol().coefficients();
  return mask.symbol().length() > mask.arity() && is_affine(mask) &&
         std::all_of(coefficients.begin(), coefficients.end(), [](const Rational& c) { return c > 0; });
}

Decision converges(const Mask& mask, const ProofLimits& limits) {
  const auto sums = coset_sums(mask);
  for (std::size_t residue = 0; residue < sums.size(); ++residue)
    if (sums[residue] != 1)
      return {Truth::no, "the coefficients with index congruent to " + std::to_string(residue) + " sum to " +
                             short_text(sums[residue]) + " instead of 1"};
  if (has_positive_mask(mask))
    return {Truth::yes, "all coefficients are positive and the mask is longer than the arity"};
  return contracts(mask, limits);
}

SmoothnessProof proved_smoothness(const Mask& mask, const ProofLimits& limits) {
  SmoothnessProof proof;
  if (!is_affine(mask)) {
    proof.obstacle = converges(mask, limits).reason;
    return proof;
  }
  const int rules = sum_rules(mask);
  Mask derived = mask;
  for (int order = 0; order < rules; ++order) {
    if (order > 0) derived = divided_difference_scheme(derived, 1);
    const Decision decision = converges(derived, limits);
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

}  // namespace subcert
