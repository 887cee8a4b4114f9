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
  std::vector<Axis> axes;                   ///< of the output
  std::vector<SmoothedColumn> columns;      ///< with the length of one path through all outputs, if wanted
  std::optional<MethodChoice> choice = {};  ///< where it was chosen; `points` are those of the widest window
  std::size_t missing = 0;                  ///< points without data
  std::size_t unknown = 0;                  ///< outputs that too few data determine, NaN
};

/// Smooths along each axis: by the factors of a tensor product `tensor:(A)x(B)`, which may be local polynomials, or by
/// the same linear method of one variable, as `primal:n=4` or `local:points=7`; with an empty specification by
/// choose_grid_method(). Values are combinations of the data whose coefficients are products
/// of those along the axes, and so are their variances. Noise is independent, of one variance; it is estimated from
/// second differences along all axes that have three data, one after another, unless `noise`, its standard deviation,
/// is known. A point with a NaN is missing: then methods are local polynomials, whose fits are to the data that are
/// there; with options.keep_holes outputs beside it, or at it, are NaN. Domain: derivative 0, no missing points where
/// options.path. Errors: throws a usage error for other methods, a domain
/// error where convergence has no proof or the axes do not fit, else as smooth(). Cost: outputs times the widths of the
/// rows. Proof: docs/smoothing.md.
SmoothedGrid smooth_grid(const GridData<double>& grid, std::string_view specification, const SmoothingOptions& options,
                         const std::optional<double>& noise, int threads = 1);

/// Local polynomials of degree 1 or 3 along each axis, with windows of at most 64 data, by the smallest estimated
/// expected squared error at the data, that of all numbers of the points added. First windows of one size along all
/// axes, from the smallest until the error is four times the least; from the best of these on other sizes along one
/// axis after another, until none is better. Domain: as many estimates as numbers. Errors: throws a data error where
/// the noise has no estimate. Cost: some fifty times that of smooth_grid().
MethodChoice choose_grid_method(const GridData<double>& grid, const SmoothingOptions& options,
                                const std::vector<NoiseEstimate>& noise, int threads = 1);

/// The noise of each number of the points, from the differences without a missing point. Without an axis of three data
/// there is no estimate.
std::vector<NoiseEstimate> estimate_noise(const GridData<double>& grid);

}  // namespace subcert::data
