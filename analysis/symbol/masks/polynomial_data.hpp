#pragma once
/// Polynomials that a scheme of vectors with letters keeps.

#include "parametric_mask.hpp"

namespace subcert {

/// Data of polynomials: e_l(j) = sum over s of y_s j^(l-s)/(l-s)! for l = 0, ..., m. With P_k = A_k transposed and S
/// e(i) = sum over j of P_{i-aj} e(j) each S e_l is a^-l e_l and a combination of e_0, ..., e_{l-1}, for all values of
/// the letters.
struct PolynomialData {
  std::vector<Values> data;  ///< y_0, ..., y_m; empty, or y_0 is not 0
  /// The e_l are values and derivatives, as many as components: y_s is the unit vector of component s, or 0 beyond.
  bool hermite = false;
  /// Then the scheme interpolates as well: A_0 is diag(1, 1/a, 1/a^2, ...), A_{ak} = 0 for all other k.
  bool interpolating = false;
  /// Not 0 where the mask is [P, root Q; Q, P] of a QuadraticMask: the y_s are vectors p + sqrt(root) q, (q, p), and so
  /// are their combinations.
  long root = 0;

  /// e_l(j), l = 0, 1, ...; with a root then all of them times sqrt(root).
  std::vector<Values> at(long j) const;
  /// Of the vectors: rows of the matrices of the scheme.
  std::size_t components() const { return data.front().size() / (root > 0 ? 2 : 1); }
};

/// As many as there are; values and derivatives where these are all kept up to a degree of components - 1 at least.
/// None where y_0 depends on the letters, or is not the only one up to a factor. Domain: more than one component; with
/// a root the doubled mask of a QuadraticMask. Cost: small linear systems. Proof of what follows from them:
/// docs/vectors.md.
PolynomialData kept_polynomials(const ParametricMask& mask, long root = 0);
/// What all of them keep. Domain: a mask at least, of one arity and one size.
PolynomialData kept_polynomials(const std::vector<ParametricMask>& masks, long root = 0);

}  // namespace subcert
