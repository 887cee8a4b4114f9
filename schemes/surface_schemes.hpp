#pragma once
/// Classical schemes of two and three variables.

#include <subcert/analysis/symbol/masks/mask.hpp>

#include <vector>

namespace subcert {

/// The box spline with these directions v, refined by M: symbol |det M| prod of (1 - z^(Mv)) / (1 - z^v), the factors
/// divided by their values at 1, centred as bspline_mask() along each axis. For M = 2I that is 4 prod of (1 + z^v) / 2.
/// Domain: directions that span the space and are as many as 64 or fewer; M maps lines of directions to lines of
/// directions. Errors: throws Error for other directions, and where the mask would pass 10^5 coefficients. Cost: a
/// product of polynomials for each line of directions. Proof: docs/schemes.md. Ref: [dBHR93].
LatticeMask box_spline_mask(const std::vector<LatticePoint>& directions, const Dilation& dilation);

/// The butterfly scheme with tension w on the triangulation by the directions (1,0), (0,1), (1,1). Ref: [DLG90].
LatticeMask butterfly_mask(const Rational& w);

}  // namespace subcert
