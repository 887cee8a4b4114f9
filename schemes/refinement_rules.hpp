#pragma once
/// Refinement rules as papers print them.

#include <subcert/analysis/symbol/masks/mask.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace subcert {

/// `f_{2i}^{k+1} = f_i^k, f_{2i+1}^{k+1} = 1/2 f_i^k + 1/2 f_{i+1}^k` as `symbol:` of the mask; nothing for a text that
/// has no such left side. Rules stand in any order, with commas, semicolons, `\\`, line ends or `and` between them;
/// data may be called by any letter, on the left by another one, with primes and powers for the level, and `f[2i]` is
/// `f_{2i}`. Domain: at most 30,000 characters. Errors: throws SpecificationError where rules are missing or the same,
/// and for a right side that is not a sum of data, each times a number or a letter.
std::optional<std::string> rules_as_written(std::string_view text);

/// The rules of a mask, a line each, as `f_{2i} = 3/4 f_i + 1/4 f_{i+1}`, which rules_as_written() reads; with
/// `decimals` the weights as the shortest decimal numbers that read back as the nearest doubles.
std::string rules_text(const Mask& mask, bool decimals = false);

}  // namespace subcert
