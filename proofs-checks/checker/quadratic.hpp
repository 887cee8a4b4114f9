// Upper bounds by quadratic forms: section 4.8 of ../certificates/SPEC.md.
#pragma once

#include "graph.hpp"

namespace subcert_check {

/// What a section `quadratic` proves; `fields` are those of its first line. `exact`: the number that the radius may be,
/// or nullptr.
GraphBound read_quadratic(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                          Arithmetic& arithmetic);

}  // namespace subcert_check
