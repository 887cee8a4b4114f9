// Upper bounds by quadratic forms: section 4.8 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// The bound that a section `quadratic` proves; `fields` are those of its first line.
mpq_class read_quadratic(const Family& family, const Fields& fields, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
