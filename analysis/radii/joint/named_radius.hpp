#pragma once
/// What algebraic number a joint spectral radius is.

#include "joint_spectral_radius.hpp"

namespace subcert {

/// The number that |z|^(1/length) is for an eigenvalue z of the product, where it lies in `radius`: nothing where more
/// than z, -z and their conjugates may lie there, or a polynomial of z has a degree above `degree`; z is not negative.
/// Domain: a square product; `radius` holds |z|^(1/length) of one eigenvalue z, and `near` is near to that one. Cost: a
/// characteristic polynomial with its factors and the balls of its zeros; products of more than 64 rows are left out.
std::optional<AttainedNumber> named_radius(const RationalMatrix& product, std::size_t length,
                                           const RationalComplex& near, const Enclosure& radius, long degree);

/// The same of the radius of a family, where its product is proved to attain it. Domain: `radius` is of this family.
std::optional<AttainedNumber> named_radius(const MatrixFamily& family, const JointSpectralRadius& radius, long degree);

}  // namespace subcert
