#pragma once
/// Errors of two methods compared over levels of noise, 1 to 20 dB.

#include "measured.hpp"

namespace subcert::experiments {

inline constexpr int loudest = 1, quietest = 20;  ///< decibel

/// Of a method at a level of noise.
Quantity error_at(const std::string& method, int decibel);

enum class At { each_level, some_level };

/// From `from` to `to` decibel, `better` has a smaller mean error than `worse`: the mean of the paired differences is
/// negative with its whole interval. Domain: loudest <= from <= to <= quietest.
Relation smaller_error(const std::string& better, const std::string& worse, int from, int to, At where);

/// The ratio of the mean errors is at most `tolerance` away from 1 at each level.
Relation nearly_equal_error(const std::string& first, const std::string& second, double tolerance);

}  // namespace subcert::experiments
