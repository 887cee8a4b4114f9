#pragma once
/// A value of the letters for each new point of each level.

#include <subcert/analysis/radii/joint/joint_spectral_radius.hpp>
#include <subcert/analysis/symbol/masks/parametric_mask.hpp>

namespace subcert {

/// Of all choices of values in a box, one for each new point of each level.
struct LocalLevels {
  int order = 0;  ///< each rule by itself keeps polynomials of lower degree
  /// All limits have at least the lower end, where there is one; those of one value everywhere no more than the upper.
  Enclosure exponent;
  /// Transition matrices of divided differences of that order, with a corner for each new point; or transposed, with
  /// rows and columns in reverse order: then they take the differences of a window, point by point, to finer ones.
  MatrixFamily family;
  bool transposed = false;
  JointSpectralRadius radius;
};

/// f_{k+1, n} = sum over j of a_{n - a j}(w_{k, n}) f_{k, j}, each w_{k, n} in the box by itself. Domain: numbers,
/// coefficients of degree 1 in each letter, without a denominator; coset sums 1. Errors: throws Error, also where there
/// are more than 1024 matrices. Cost: their joint spectral radius. Proof: docs/levels.md, Theorem 62 of SPEC.md.
LocalLevels local_levels(const ParametricMask& mask, const Box& box, const Budget& budget);

}  // namespace subcert
