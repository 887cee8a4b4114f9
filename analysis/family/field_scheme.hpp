#pragma once
/// Vector and Hermite schemes whose matrices hold a square root, by what annihilates the polynomials that they keep.

#include "parametric_family.hpp"

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/masks/matrix_masks.hpp>

namespace subcert {

/// On the sequences over the field that annihilate the data, arity^(m+1) times the operators T_t.
struct FieldScheme {
  AnnihilatingSpace space;  ///< of the doubled mask, the rational space of the parts of these sequences
  MatrixFamily family;      ///< on that space, rational
  /// On the sequences over the field: a proof by blocks in a rational basis e_1, J e_1, e_2, J e_2, ..., J the product
  /// with the root.
  JointSpectralRadius radius;
};

/// Domain: one variable, an arity; the scheme keeps data of polynomials over the field, those of constants at least.
/// Errors: throws Error, also where the window needs more than 128 numbers of the field. Error: none, what is said
/// holds for the matrices that are meant. Cost: a joint spectral radius for each diagonal block. Proof: SPEC.md,
/// section 6.9.
FieldScheme field_scheme(const QuadraticMask& mask, const Budget& budget);

}  // namespace subcert
