#pragma once
/// The experiments of [DHHS15], by their sections.

#include <subcert/reports/experiments/experiment.hpp>

namespace subcert::experiments::dyn_2015 {

Experiment expected_errors();
std::vector<Experiment> function_experiments();
Experiment alpha_curve();
Experiment star();
Experiment torus();
Experiment mechanical_part_scan();

}  // namespace subcert::experiments::dyn_2015
