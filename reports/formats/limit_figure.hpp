#pragma once
/// Pictures of basic limit functions.

#include "figure.hpp"
#include "surface_figure.hpp"

#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/transition/lattice_window.hpp>
#include <subcert/schemes/data/refine/grid_data.hpp>

namespace subcert::formats {

/// What is drawn: values of phi, exact before they are rounded to doubles, or, where nobody knows whether there are
/// limits, the unit sequence after as many steps.
enum class DrawnLimit { values, refined_delta };

/// phi over its support, at the points M^-k j, where they are for every dilation. The level k is as large as 20,000
/// points in the box of the support allow, and among the last ones one for which M^k keeps the axes, if there is one.
/// Where exact values would take too much memory, the unit sequence is drawn instead; the title says so. Domain: two
/// variables; for values a scheme that converges. Errors: throws Error, as limit_values. Cost: 20,000 * coefficients.
DrawnSurface limit_surface(const LatticeMask& mask, const std::string& title, DrawnLimit what = DrawnLimit::values);

/// The same for a curve, with some 2,000 points; or its derivative of this order, where that is continuous.
Panel limit_panel(const Mask& mask, const std::string& title, DrawnLimit what = DrawnLimit::values, int order = 0);

/// All functions of a vector of one variable that is continuous and unique up to a factor.
Panel vector_panel(const LatticeMask& mask, const std::optional<QuadraticMask>& meant, const LatticeSequence& values,
                   const std::string& title);

/// Values over their parameters, or points in the plane by their first two coordinates; a closed curve in the plane
/// that is `joined` ends where it begins. Domain: one axis.
Curve data_curve(const data::GridData<double>& data, const std::string& label, bool joined);

}  // namespace subcert::formats
