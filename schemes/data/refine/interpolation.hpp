#pragma once
/// Values between the points of a curve.

#include "grid_data.hpp"

namespace subcert::data {

/// The piecewise linear function through the points at these parameters. Domain: one axis with at least two points of
/// one coordinate; beyond the ends of an open one the first or last piece goes on. Errors: throws a domain error. Cost:
/// linear.
std::vector<double> interpolate(const GridData<double>& curve, const std::vector<Rational>& parameters);

}  // namespace subcert::data
