#pragma once
/// What the experiments of [DHHS15] measure.

#include <subcert/reports/experiments/papers.hpp>

namespace subcert::experiments::dyn_2015 {

Measured expected_errors(const Run& run);
Measures functions();
Measured alpha_curve(const Run& run);
Measured star(const Run& run);
Measured torus(const Run& run);
Measured mechanical_part(const Run& run);

}  // namespace subcert::experiments::dyn_2015
