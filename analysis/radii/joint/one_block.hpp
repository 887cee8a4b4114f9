#pragma once
/// The joint spectral radius of a family that is not split further. Inner header.

#include "joint_spectral_radius.hpp"

namespace subcert::radius {

/// By a polytope, or where none closes by it, a quadratic form or norms, whichever gives the least upper end.
/// `target`: an upper bound that is low enough. Domain: size >= 2.
JointSpectralRadius radius_of_one_block(const MatrixFamily& family, const Budget& budget,
                                        const std::optional<NormProof>& known,
                                        const std::optional<Rational>& target = std::nullopt);

/// By a product and norms only: a quick look. Domain: size >= 2.
JointSpectralRadius first_look(const MatrixFamily& family, const Budget& budget);

/// An upper bound by a quadratic form, as small as the target if possible. Domain: any entries.
std::optional<GraphProof> quadratic_bound(const MatrixFamily& family, const Rational& target, const Budget& budget);

/// The same towards the radius of a product; where it attains the radius of the family, with the number that this is.
/// Domain: entries near 1 in size; different matrices; `product` is of this family.
std::optional<GraphProof> prove_by_forms(const MatrixFamily& family, const Rational& target, const Budget& budget,
                                         const ProductEvidence& product);

/// The largest modulus of numbers. Domain: size 1.
JointSpectralRadius radius_of_numbers(const MatrixFamily& family);

}  // namespace subcert::radius
