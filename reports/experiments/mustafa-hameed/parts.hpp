#pragma once
/// The experiments of [MH], and what they share.

#include <subcert/reports/experiments/noisy_data.hpp>

namespace subcert::experiments::mustafa_hameed {

Experiment linear_polynomials();
Experiment polynomial_reproduction();
Experiment data_without_noise();
Experiment noisy_function();
Experiment noisy_curve();
Experiment noisy_surface();

/// D_p^d: l1 regression of degree d on p data, on curves or (grid) on p x p data. S_p^d: the same by least squares.
Method l1_method(int points, int degree, bool grid = false);
Method least_squares_method(int points, int degree, bool grid = false);

/// D_p^d for these d and p, by d.
std::vector<Method> l1_methods(const std::vector<int>& windows, const std::vector<int>& degrees, bool grid = false);

/// The first and second of both, in pairs. Domain: as many of both.
NamePairs pairs(const std::vector<Method>& first, const std::vector<Method>& second);

}  // namespace subcert::experiments::mustafa_hameed
