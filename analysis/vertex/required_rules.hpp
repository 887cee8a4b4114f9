#pragma once
/// What proofs at vertices ask of rules. Inner header.

#include "sector_block.hpp"
#include "vertex_smoothness.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert::vertex {

/// Whether all rules of the set sum to 1, exactly.
template <class Ring>
bool reproduces_constants(const ClosedSet& set, const Ring& ring) {
  for (const auto& [point, rule] : set.rules) {
    LaurentPolynomial sum;
    for (const SectorTerm& term : rule.terms) sum += term.weight;
    for (const RingTerm& term : rule.rings)
      if (term.frequency == 0) sum += term.weight;
    if (!ring.number(sum - LaurentPolynomial(1)).is_zero()) return false;
  }
  return true;
}

/// Throws Error for rules that proofs at vertices are not about.
template <class Ring>
void require_rules(const SectorRules& rules, const ClosedSet& set, const RegularPart& regular, const Ring& ring) {
  require(regular.mask == rules.mask, "smoothness at a vertex: need the regular part of the same mask");
  require(turns_with_sectors(rules),
          "smoothness at a vertex: need a mask and a rule of the vertex that turn with the sectors");
  require(is_symmetric(rules, set), "smoothness at a vertex: need rules that are their own mirror images");
  require(reproduces_constants(set, ring), "smoothness at a vertex: need weights of sum 1");
}

}  // namespace subcert::vertex
