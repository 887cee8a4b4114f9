#pragma once
/// Smoothing of heights on grids: surfaces and volumes.

#include "smooth.hpp"

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// What smoothing makes of numbers on a grid. Canonical: one column for each number of a point, with a value for each
/// point of the axes.
struct SmoothedGrid {
  std::string method;
  std::vector<Axis> axes;               ///< of the output
  std::vector<SmoothedColumn> columns;  ///< without paths: bands at all positions at once are not known
};

/// Smooths along each axis: by the factors of a tensor product `tensor:(A)x(B)`, or by the same linear method of one
/// variable, as `primal:n=4` or `local:points=7`. Values are combinations of the data whose coefficients are products
/// of those along the axes, and so are their variances. Noise is independent, of one variance; it is estimated from
/// second differences along all axes that have three data, one after another, unless `noise`, its standard deviation,
/// is known. Domain: uniform data without gaps, derivative 0. Errors: throws a usage error for other methods, a domain
/// error where convergence has no proof or the axes do not fit, else as smooth(). Cost: outputs times the widths of the
/// rows. Proof: docs/smoothing.md.
SmoothedGrid smooth_grid(const GridData<double>& grid, std::string_view specification, const SmoothingOptions& options,
                         const std::optional<double>& noise, int threads = 1);

/// The noise of each number of the points. Without an axis of three data there is no estimate.
std::vector<NoiseEstimate> estimate_noise(const GridData<double>& grid);

}  // namespace subcert::data
