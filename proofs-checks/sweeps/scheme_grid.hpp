#pragma once
/// Many schemes in one text: lists of values where a specification has one, and all small masks.

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace subcert::sweeps {

inline constexpr std::size_t most_schemes = 1'000'000;  ///< of a grid, and of a plan

/// The specifications that a text names, the last key changing first. A value is `A..B` (integers and what lies between
/// in steps of 1), `A..B step S` (rational numbers), or a list `{V,W,A..B}` of values and ranges: as
/// `primal:n=1..60,d={1,3}` or `four-point:w=0..1/4 step 1/64`. What stands in brackets or parentheses stays as it is,
/// and a text without lists names itself. `masks:length=1..5,numerators=3,denominator=2` are all masks of so many
/// coefficients p/2 with |p| <= 3, the first and last of them not 0, of which each class modulo `arity` (2 without it)
/// sums to 1; of a mask and its mirror image, one. Domain: at most a million schemes, and for masks at most 10^8
/// combinations. Errors: throws ParseError. Cost: the combinations.
std::vector<std::string> schemes_of_grid(std::string_view text);

/// The keys of one specification and their values, as they stand there: n and 3 of `primal:n=3,d=1`.
std::vector<std::pair<std::string, std::string>> keys_of_scheme(std::string_view specification);

}  // namespace subcert::sweeps
