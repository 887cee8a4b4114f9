#pragma once
/// The eigenvalues of a scheme at a vertex, by frequency. For sources.

#include <subcert/analysis/symbol/matrices/ball_matrix.hpp>
#include "cosine_field.hpp"
#include "sector_block.hpp"

#include <optional>
#include <vector>

namespace subcert::vertex {

/// Eigenvalues of a diagonal block of the frequency k, for 0 < k < n/2 as many of n - k.
struct FrequencyGroup {
  long frequency;
  std::vector<std::size_t> block;  ///< its unknowns, which depend on each other
  ComplexBall value;
  std::size_t count;  ///< in this block, with multiplicity; 2 stands for 2 or more
};

/// The eigenvalue 1 of the constants left out. Sorted by upper bounds of the moduli, the largest first.
struct VertexSpectrum {
  std::vector<FrequencyGroup> groups;

  /// Whether the first group is one real positive eigenvalue, larger than the modulus of every other.
  bool has_simple_leader() const;
};

/// Domain: symmetric rules that reproduce constants. Nothing where `bits` bits do not separate the eigenvalues, or 1 is
/// not proved to be simple. Cost: a QR iteration for each diagonal block of each frequency.
std::optional<VertexSpectrum> vertex_spectrum(const SectorRules& rules, const ClosedSet& set, slong bits);

/// The one number of largest modulus, which several frequencies may share, or Jordan blocks have.
struct Leader {
  struct Share {
    long frequency;
    std::size_t size;  ///< of its largest Jordan block
    /// The eigenvector of that block, where no other is as large; empty where it is not computed, as the number is
    /// simple.
    std::vector<CosineField::Number> vector = {};
  };
  Ball value;  ///< real and positive
  std::vector<Share> shares;

  /// Those of the frequencies with the largest blocks.
  std::vector<Share> largest() const;
};

/// Exact. Nothing where it is not simple and not found in Q(c), where a frequency has several of the largest blocks, or
/// where other eigenvalues may be as large. Domain: a spectrum of these. Cost: where it is not simple, characteristic
/// polynomials over Q(c).
std::optional<Leader> leader_of(const VertexSpectrum& spectrum, const SectorRules& rules, const ClosedSet& set);

/// Whether eigenvalues are exactly the square of one. Domain: groups of one eigenvalue, that of `root` real and
/// positive; rules and set that stay. Cost: a characteristic polynomial over Q(c) at first, another and a gcd for each.
class SquareTest {
 public:
  SquareTest(FrequencyGroup root, const SectorRules& rules, const ClosedSet& set);
  bool operator()(const FrequencyGroup& square) const;

 private:
  FrequencyGroup root_;
  const SectorRules& rules_;
  const ClosedSet& set_;
  CosineField field_;
  FieldPolynomial polynomial_;
};

}  // namespace subcert::vertex
