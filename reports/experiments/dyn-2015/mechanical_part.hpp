#pragma once
/// A surface that looks like the scan of a mechanical element.

#include <subcert/reports/experiments/refined_data.hpp>

namespace subcert::experiments::dyn_2015 {

/// 49 x 81 points, one unit apart.
std::vector<data::Axis> part_axes();

/// A plate of 48 x 80 units with its centre at the origin: a raised end behind a rounded step with a groove across it,
/// a cylindrical boss with a fillet at its foot and a blind bore in it, and a half-round rib. The point of the
/// parameters (i, j).
std::array<double, 3> part_point(double i, double j);

/// Its height over (x, y). Domain: |x| <= 24, |y| <= 40.
double part_height(double x, double y);

}  // namespace subcert::experiments::dyn_2015
