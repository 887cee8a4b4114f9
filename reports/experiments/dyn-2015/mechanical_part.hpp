#pragma once
/// A surface that looks like the scan of a mechanical element.

#include "limit_trial.hpp"

namespace subcert::experiments::dyn_2015 {

/// A plate of 48 x 80 units with its centre at the origin: a raised end behind a rounded step with a groove across it,
/// a cylindrical boss with a fillet at its foot and a blind bore in it, and a half-round rib. The grid points lie over
/// multiples of 1/refinement unit, so that refinement = 1 gives 49 x 81 points. Domain: refinement >= 1.
PointGrid mechanical_part(std::size_t refinement);

/// Its height over (x, y). Domain: |x| <= 24, |y| <= 40.
double part_height(double x, double y);

}  // namespace subcert::experiments::dyn_2015
