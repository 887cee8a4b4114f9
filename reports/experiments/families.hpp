#pragma once
// The experiments of each kind, in the order of their papers.

#include "experiment.hpp"

namespace subcert::experiments {

std::vector<Experiment> function_experiments();
std::vector<Experiment> curve_experiments();
std::vector<Experiment> torus_experiments();
std::vector<Experiment> part_experiments();
std::vector<Experiment> expected_error_experiments();
std::vector<Experiment> nonlinear_polynomial_experiments();
std::vector<Experiment> nonlinear_quiet_experiments();
std::vector<Experiment> nonlinear_noise_experiments();
std::vector<Experiment> nonlinear_surface_experiments();
std::vector<Experiment> aary_limit_function_experiments();
std::vector<Experiment> aary_curve_experiments();
std::vector<Experiment> aary_car_experiments();
std::vector<Experiment> aary_surface_experiments();

std::vector<Experiment> l1_function_experiments();
std::vector<Experiment> l1_limit_experiments();
std::vector<Experiment> l1_iteration_experiments();
std::vector<Experiment> l1_spiral_experiments();
std::vector<Experiment> l1_impulse_experiments();
std::vector<Experiment> l1_surface_experiments();
std::vector<Experiment> l1_band_experiments();
/// Those of [MLZD15] in the order of the paper.
std::vector<Experiment> l1_experiments();

}  // namespace subcert::experiments
