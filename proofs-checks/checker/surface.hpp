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

/// The transition matrices on the space of the certificate; reads its lines from `digits` to `gram`. With `stability`
/// the shifts of phi are shown to be stable, provided that the scheme converges.
Family read_surface(const Mask& mask, const Dilation& dilation, std::size_t sum_rules, bool stability, Reader& reader,
                    Arithmetic& arithmetic);

}  // namespace subcert_check
