#pragma once
/// The eigenvalues of a scheme at a vertex, by frequency. For sources.

#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>
#include "cosine_field.hpp"
#include "sector_block.hpp"

#include <optional>
#include <vector>

namespace subcert::vertex {

/// Eigenvalues of the frequency k, and for 0 < k < n/2 as many of n - k.
struct FrequencyGroup {
  long frequency;
  ComplexBall value;
  std::size_t count;  ///< with multiplicity
};

/// The eigenvalue 1 of the constants left out. Sorted by upper bounds of the moduli, the largest first.
struct VertexSpectrum {
  std::vector<FrequencyGroup> groups;

  /// Whether the first group is one real positive eigenvalue, larger than the modulus of every other.
  bool has_simple_leader() const;
};

/// Domain: symmetric rules that reproduce constants. Nothing where `bits` bits do not separate the eigenvalues, or 1 is
/// not proved to be simple. Cost: a QR iteration for each frequency.
std::optional<VertexSpectrum> vertex_spectrum(const SectorRules& rules, const ClosedSet& set, slong bits);

/// Whether an eigenvalue of frequency k in a ball is exactly the square of a simple eigenvalue of frequency 1 in
/// another. Domain: each ball holds one of its frequency, apart from all others of it, that of `root` positive. Cost: two
/// characteristic polynomials over Q(c) and their gcd.
bool is_square_of(const FrequencyGroup& square, const FrequencyGroup& root, const SectorRules& rules,
                  const ClosedSet& set);

}  // namespace subcert::vertex
