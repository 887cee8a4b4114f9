#pragma once
/// Errors of two methods compared over levels of noise, 1 to 20 dB.

#include "measured.hpp"

namespace subcert::experiments {

inline constexpr int loudest = 1, quietest = 20;  ///< decibel

/// Decibel. Domain: loudest <= from <= to <= quietest.
struct Levels {
  int from = loudest, to = quietest;
  std::size_t count() const { return static_cast<std::size_t>(to - from) + 1; }
};

/// Of a method at a level of noise.
Quantity error_at(const std::string& method, int decibel);

/// mean_over_levels: the errors are averaged over the levels first, as one looks at a whole curve of errors.
enum class At { each_level, some_level, mean_over_levels };

/// `better` has a smaller mean error than `worse`: the mean of the paired differences is negative with its whole
/// interval. The contrary: it is positive, at one of the levels where each is asked, at all where some is.
Relation smaller_error(const std::string& better, const std::string& worse, const Levels& levels, At where);

/// Neither mean error is more than `factor` times the other; the contrary: one of them is, at one of the levels.
/// Domain: factor > 1, where != some_level.
Relation nearly_equal_error(const std::string& first, const std::string& second, double factor, const Levels& levels,
                            At where);

}  // namespace subcert::experiments
