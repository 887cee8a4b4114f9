// Block triangular families: section 4.4 of ../certificates/SPEC.md.
#pragma once

#include "surfaces/component.hpp"

#include <utility>
#include <vector>

namespace subcert_check {

/// The line `blocks` of a family of this size.
std::vector<std::size_t> read_block_sizes(std::size_t n, Reader& reader);

/// How many of the blocks, the first ones, are of what the component does not show. Rejects unless these are all of it.
std::size_t unobservable_blocks(const std::vector<std::size_t>& sizes, const Component& component);

/// The diagonal blocks, and how many of them, the first ones, are of what the component does not show. Reads the lines
/// from `blocks` on.
std::pair<std::vector<Family>, std::size_t> read_blocks(const Family& family, const Component& component,
                                                        Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
