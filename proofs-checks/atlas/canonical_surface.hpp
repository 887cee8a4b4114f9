#pragma once
/// The one mask of the plane that stands for all that have the same limit functions but for an affine map of the
/// lattice.

#include <subcert/analysis/symbol/masks/mask.hpp>

namespace subcert::atlas {

/// With a_k and the dilation M the same limits, but for x -> T x and a shift, have a_(T^-1 k + s) and T M T^-1, for
/// each integer matrix T with determinant 1 or -1 and each s in Z^2. Of all of these the one with the smallest box
/// among those that have, at some corner of the hull of the support, the one edge in the direction (1, 0) and the other
/// one in (p, q), 0 <= p < q; with lowest exponents 0 and the usual digits. Domain: numbers in two variables. Errors:
/// throws a usage error where the support is on a line that M leaves invariant. Cost: twice the corners times the
/// terms. Proof that it is one for all: docs/atlas.md.
LatticeMask canonical_surface(const LatticeMask& mask);

/// The corners of the convex hull of points in the plane, counterclockwise; less than three where all are on a line.
std::vector<LatticePoint> corners_of_hull(std::vector<LatticePoint> points);

}  // namespace subcert::atlas
