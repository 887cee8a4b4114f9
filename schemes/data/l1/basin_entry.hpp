#pragma once
/// Data whose refinement by reweighted fits is proved to come so near to least squares that their limit is as smooth.

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>
#include <subcert/schemes/l1_scheme.hpp>

#include <optional>
#include <vector>

namespace subcert::data {

/// The first level, 0, ..., most_levels, at which all differences of order degree + 1 are proved to be at most
/// l1_basin().radius * sqrt(delta): from there on the limit exists and is as smooth as that of least squares
/// (docs/l1.md, Theorem 4). The data are continued by zeros. Nothing where no level is proved to be one in time.
/// Domain: a scheme of curves without `exact`, as of l1_basin, at most 100 iterations, tolerance 0; 0 <= most_levels
/// <= 16. Errors: throws a domain error. Error: none; all is computed in balls. Cost: points^2 * iterations operations
/// for each of 2^level * (data.size() + points) windows.
std::optional<int> basin_entry(const L1Scheme& scheme, const std::vector<Rational>& data, int most_levels,
                               const Deadline& deadline = {});

}  // namespace subcert::data
