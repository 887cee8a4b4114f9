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

enum class At { each_level, some_level };

/// At each of the levels, or at some, `better` has a smaller mean error than `worse`: the mean of the paired
/// differences is negative with its whole interval. The contrary: it is positive at one of the levels, or at all.
Relation smaller_error(const std::string& better, const std::string& worse, const Levels& levels, At where);

/// The mean errors differ by at most `tolerance` times that of the second at each level; the contrary: by more at one.
Relation nearly_equal_error(const std::string& first, const std::string& second, double tolerance,
                            const Levels& levels);

}  // namespace subcert::experiments
