#pragma once
/// What the experiments of [MH] measure, and what they share.

#include <subcert/reports/experiments/noisy_data.hpp>
#include <subcert/reports/experiments/papers.hpp>

namespace subcert::experiments::mustafa_hameed {

Measured linear_polynomials(const Run& run);
Measured polynomial_reproduction(const Run& run);
Measured data_without_noise(const Run& run);
Measured noisy_function(const Run& run);
Measured noisy_curve(const Run& run);
Measured noisy_surface(const Run& run);

/// D_p^d: l1 regression of degree d on p data, on curves or (grid) on p x p data. S_p^d: the same by least squares.
Method l1_method(int points, int degree, bool grid = false);
Method least_squares_method(int points, int degree, bool grid = false);

/// D_p^d for these d and p, by d.
std::vector<Method> l1_methods(const std::vector<int>& windows, const std::vector<int>& degrees, bool grid = false);

}  // namespace subcert::experiments::mustafa_hameed
