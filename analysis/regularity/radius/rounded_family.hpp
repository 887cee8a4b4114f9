#pragma once
/// Bounds for all families of matrices near one. Inner header.

#include "joint_spectral_radius.hpp"

namespace subcert::radius {

/// What errors of the entries do to norms: SPEC.md, section 7.
struct EntryError {
  Rational norm;   ///< of the matrices, the largest 1-norm
  Rational error;  ///< of a matrix, in that norm

  EntryError(const MatrixFamily& family, const Rational& distance);
  /// Of products of so many matrices, in that norm.
  Rational of_products(long length) const { return power(norm + error, length) - power(norm, length); }
};

/// Encloses the joint spectral radii of all families whose entries differ from these by at most `distance`. `known`: an
/// upper bound of all. Domain: as joint_spectral_radius; distance > 0. Cost: likewise, by a polytope of the whole
/// matrices.
JointSpectralRadius radius_of_rounded_family(const MatrixFamily& family, const Rational& distance, const Budget& budget,
                                             const NormProof& known);

}  // namespace subcert::radius
