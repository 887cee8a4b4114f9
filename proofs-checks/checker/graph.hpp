// Upper bounds by many words, checked with few digits: section 4.13 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// The bound that a section `graph` proves; `fields` are those of its first line.
mpq_class read_graph(const Family& family, const Fields& fields, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
