// Upper bounds by many words, checked with few digits: sections 4.13 and 4.14 of ../certificates/SPEC.md.
#pragma once

#include "exact_radius.hpp"
#include "scheme.hpp"

namespace subcert_check {

struct GraphBound {
  mpq_class bound;
  bool attained;  // some product has the exact radius, which is that of the block
};

/// What a section `graph` proves; `fields` are those of its first line. `exact`: the number that the radius may be, or
/// nullptr.
GraphBound read_graph(const Family& family, const Fields& fields, const ExactRadius* exact, Reader& reader,
                      Arithmetic& arithmetic);

}  // namespace subcert_check
