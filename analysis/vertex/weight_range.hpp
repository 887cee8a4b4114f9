#pragma once
/// For which values of a weight the limits of a scheme are smooth at a vertex.

#include "vertex_smoothness.hpp"

#include <optional>
#include <string>
#include <vector>

namespace subcert {

/// C1 as VertexSmoothness::c1; bounded curvature: C1, and |mu| <= lambda^2.
enum class WeightProperty { c1, bounded_curvature };

/// What is proved on an interval of the weight b, ends included.
struct WeightPiece {
  Rational low, high;
  Decision holds;
};

/// Where pieces with different answers meet: within [low, high] the moduli that decide are equal at one value alone,
/// and the answers are those of the pieces up to it.
struct WeightEnd {
  Rational low, high;
  /// The value, as a polynomial in c = cos(2 pi/n), where it is one.
  std::optional<LaurentPolynomial> value;
  /// A polynomial with this value as its only zero in [low, high]: coefficients of the powers of b, in c.
  std::vector<LaurentPolynomial> polynomial;
  Decision holds;  ///< at the value itself
};

struct WeightRange {
  long valence;
  std::vector<WeightPiece> pieces;  ///< in order, without gaps
  std::vector<WeightEnd> ends;      ///< in order; each in a piece that is unknown
};

/// Domain: rules with a letter (letter_stride), low < high, width > 0, jobs >= 1. Neighbouring values are told apart
/// down to `width`, or, where that is not a matter of eigenvalues, down to a thousandth of the range. Errors: as
/// vertex_smoothness(). Cost: a proof for each interval, which are halved. Proof: docs/vertex-rules.md.
WeightRange weight_range(const SectorRules& rules, const RegularPart& regular, WeightProperty property,
                         const Rational& low, const Rational& high, const Rational& width, int jobs,
                         const Budget& budget);

}  // namespace subcert
