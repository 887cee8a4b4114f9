#pragma once
/// Norms that a product keeps which attains the joint spectral radius. Inner header.

#include "integer_forms.hpp"

#include <subcert/analysis/symbol/matrix_family.hpp>
#include <subcert/analysis/symbol/rational_complex.hpp>

namespace subcert::quadratic {

/// With the left eigenvectors u_0 A = r u_1, ... of a product, scaled so that a coordinate of u_0 has modulus 1, each
/// letter of the product leads max(|L x|, scale |u x|) over into r times that of the next state, `kept` being the part
/// of |L x|^2 that does not come from u. The second part is at most low/bound times the first.
struct KeptCycle {
  std::size_t coordinate = 0;
  Rational kept, scale;
  Enclosure radius = Enclosure::at_least(0);  ///< of r, the root of the modulus of an eigenvalue of the product
};

/// Nothing where the inequalities of SPEC.md, 4.14, do not hold. Domain: a product from left to right, its leading
/// eigenvalue, nearly; lower triangular coordinates L before each letter; 0 < bound. Cost: an inverse of balls, and
/// some exact decompositions for each letter.
std::optional<KeptCycle> prove_kept_cycle(const MatrixFamily& family, const std::vector<int>& product,
                                          const RationalComplex& eigenvalue, std::span<const Integers> coordinates,
                                          const Rational& bound);

}  // namespace subcert::quadratic
