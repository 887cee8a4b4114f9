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

/// The names of two methods that are compared.
struct Pair {
  std::string first, second;
};

/// The first of each pair has a smaller mean error than the second: the mean of the paired differences is negative with
/// its whole interval; at some level of one pair where some is asked. The contrary: it is positive, for one pair at one
/// of the levels where each is asked, for all pairs at all levels where some is. Domain: at least one pair.
Relation smaller_error(const std::vector<Pair>& pairs, const Levels& levels, At where);

/// Of each pair neither mean error is more than `factor` times the other; the contrary: one of them is, at one of the
/// levels. Domain: at least one pair, factor > 1, where != some_level.
Relation nearly_equal_error(const std::vector<Pair>& pairs, double factor, const Levels& levels, At where);

}  // namespace subcert::experiments
