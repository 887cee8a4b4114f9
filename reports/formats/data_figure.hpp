#pragma once
/// Data of one direction as curves.

#include "figure.hpp"

#include <subcert/schemes/data/refine/grid_data.hpp>

namespace subcert::formats {

/// Values over their parameters, or points in the plane by their first two coordinates; a closed curve in the plane
/// that is `joined` ends where it begins. Domain: one axis.
Curve data_curve(const data::GridData<double>& data, const std::string& label, bool joined);

}  // namespace subcert::formats
