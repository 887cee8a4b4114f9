#pragma once
/// For sources: the search for supersolutions.

#include <subcert/analysis/radii/polytope_search/dense.hpp>

#include <optional>
#include <vector>

namespace subcert::frequency {

/// The solution of w = first + matrix w where it is positive, which for positive `first` is so where the spectral
/// radius of the matrix is below 1.
std::optional<std::vector<double>> positive_fixed_point(const polytope::Matrix& matrix,
                                                        const std::vector<double>& first);

}  // namespace subcert::frequency
