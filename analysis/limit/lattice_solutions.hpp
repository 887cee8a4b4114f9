#pragma once
/// Linear systems at lattice points. Inner header.

#include "limit_values.hpp"

namespace subcert::limits {

constexpr std::size_t most_points = 2000;

/// The digit that is 0.
std::size_t digit_zero(const Dilation& dilation);

/// The component of x in the kernel of a matrix along its image; nothing where these do not span the space.
std::optional<std::vector<Rational>> component_in_kernel(const RationalMatrix& matrix, const std::vector<Rational>& x);

}  // namespace subcert::limits
