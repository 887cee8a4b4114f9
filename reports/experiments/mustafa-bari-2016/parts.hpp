#pragma once
/// What the experiments of [MB16] measure. Nothing in them is random.

#include <subcert/reports/experiments/papers.hpp>

namespace subcert::experiments::mustafa_bari_2016 {

Measured limit_functions(const Run& run);
Measured refined_polygons(const Run& run);
Measured car_profile(const Run& run);
Measured vase(const Run& run);
Measured ring(const Run& run);

}  // namespace subcert::experiments::mustafa_bari_2016
