#pragma once
/// Many sets of data on one grid, refined together.

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <string>
#include <vector>

namespace subcert::experiments {

/// Sets of points with `dimension` coordinates on the same axes; sets[k] is ordered as GridData::values.
/// Canonical: every set has as many values.
struct Batch {
  std::vector<data::Axis> axes;
  std::size_t dimension = 1;
  std::vector<std::vector<double>> sets;
};

/// Applies the scheme of one or two variables, linear or of local l1 regression with separate residuals, `levels`
/// times; rules at open ends by regression. Each set is refined as if it were alone, to the bit; what is exact is done
/// once for all. Errors: throws SpecificationError, a domain error for three variables or joint residuals, else
/// as refine().
Batch refined(const std::string& specification, const Batch& data, int levels);

/// The parameters of the points of an axis.
std::vector<double> parameters(const data::Axis& axis);

}  // namespace subcert::experiments
