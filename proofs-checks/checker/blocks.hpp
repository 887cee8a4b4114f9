// Block triangular families: section 4.4 of ../certificates/SPEC.md.
#pragma once

#include "surfaces/component.hpp"

#include <utility>

namespace subcert_check {

/// The diagonal blocks, and how many of them, the first ones, are of what the component does not show. Reads the lines
/// from `blocks` on.
std::pair<std::vector<Family>, std::size_t> read_blocks(const Family& family, const Component& component,
                                                        Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
