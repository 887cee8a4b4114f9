#pragma once
/// Values of functions with their slopes, as data that are smoothed together. Inner header.

#include "uniform_grid.hpp"

#include <cstddef>
#include <vector>

namespace subcert::data {

/// Each value followed by its slope, by the spacing. The noise of slopes has the standard deviation that is known, or
/// the geometric mean over the columns of that which is estimated, in units of the noise of their values; a slope
/// weighs as if it were a value of this noise, within 1e-8 and 1e8 times the weight of a value, and as a value where
/// one of the noises has no estimate, or none. `robust`: estimates are those of the bulk of the data. Domain:
/// samples.slopes. Errors: throws a data error for an odd number of columns.
Samples with_slopes_after_values(const Samples& samples, bool robust);

/// The data of a column, or their weights, that are derivatives of this order; 0: values. All where there are no
/// derivatives, and no weights where there are none.
std::vector<double> data_of_order(const Samples& samples, const std::vector<double>& data, int order);

/// The weights of all data, with 0 for all other orders; none where there are neither weights nor derivatives.
std::vector<double> weights_of_order(const Samples& samples, int order);

}  // namespace subcert::data
