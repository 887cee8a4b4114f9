#pragma once
// The experiments of each kind, in the order of their papers.

#include "experiment.hpp"

namespace subcert {

std::vector<Experiment> function_experiments();
std::vector<Experiment> curve_experiments();
std::vector<Experiment> torus_experiments();
std::vector<Experiment> part_experiments();
std::vector<Experiment> expected_error_experiments();

}  // namespace subcert
