// Schemes of two and three variables: section 5 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"
#include "torus.hpp"

namespace subcert_check {

/// An integer matrix of s rows, filled up by the rows of the unit matrix.
struct Dilation {
  std::size_t variables = 0;
  std::array<Point, 3> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// [1,2;-2,-1]
Dilation parse_dilation(std::string_view text);

/// |det M|. Rejects M unless it is similar to a multiple of an orthogonal matrix and |det M| > 1 (section 5.1).
unsigned classes(const Dilation& dilation);

/// The transition matrices on the space of the certificate; reads its lines from `digits` on. The differences have this
/// order; they are those of the scheme, or with `of_values` those of phi. With `upper` the radius is shown to tell the
/// exponent from above as well, provided that it tells it from below: the shifts are stable, or the differences of phi
/// span the space.
Family read_surface(const Mask& mask, const Dilation& dilation, std::size_t order, bool of_values, bool upper,
                    Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
