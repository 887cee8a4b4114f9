#pragma once
// The experiments of each kind, in the order of their papers.

#include "experiment.hpp"

namespace subcert {

std::vector<Experiment> function_experiments();
std::vector<Experiment> curve_experiments();
std::vector<Experiment> expected_error_experiments();
std::vector<Experiment> nonlinear_polynomial_experiments();
std::vector<Experiment> nonlinear_quiet_experiments();
std::vector<Experiment> nonlinear_noise_experiments();
std::vector<Experiment> nonlinear_surface_experiments();
std::vector<Experiment> aary_limit_function_experiments();
std::vector<Experiment> aary_curve_experiments();
std::vector<Experiment> aary_car_experiments();
std::vector<Experiment> aary_surface_experiments();

}  // namespace subcert
