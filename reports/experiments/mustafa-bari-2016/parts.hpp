#pragma once
/// The experiments of [MB16]. Nothing in them is random.

#include <subcert/reports/experiments/experiment.hpp>

namespace subcert::experiments::mustafa_bari_2016 {

Experiment limit_functions();
Experiment refined_polygons();
Experiment car_profile();
Experiment vase();
Experiment ring();

}  // namespace subcert::experiments::mustafa_bari_2016
