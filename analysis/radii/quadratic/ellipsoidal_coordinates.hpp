#pragma once
/// Coordinates in which the Euclidean norms of all matrices of a family are small, in floating point: the search for a
/// quadratic form. Inner header. Nothing of it is proved.

#include <subcert/analysis/radii/polytope_search/product_search.hpp>

namespace subcert::quadratic {

struct EllipsoidalCoordinates {
  polytope::Matrix to, from;               ///< x' = to x, x = from x'; the form is to^T to
  std::vector<polytope::Matrix> matrices;  ///< of the family, in these coordinates
  double bound = 0;                        ///< the largest of the norms: the joint spectral radius is not larger
  bool ended_flat = false;                 ///< other forms may do better, but for doubles they are too flat from here
};

/// Minimises the largest norm over all coordinates: first the sum of the q-th powers of all squared singular values
/// for q = 1, then for larger q. That sum is a geodesically convex function of the form, with the gradient sum_t (B_t
/// B_t^T)^q - (B_t^T B_t)^q in its own coordinates. The form is invariant under the symmetry of the family, up to
/// rounding. `target`: a norm that is small enough. Domain: at least one matrix that is not zero. Cost: a few hundred
/// times a decomposition of each matrix. Ref: [BN05] for the ellipsoids; L-BFGS.
EllipsoidalCoordinates ellipsoidal_coordinates(const polytope::SearchFamily& family, double target,
                                               const Deadline& deadline);

}  // namespace subcert::quadratic
