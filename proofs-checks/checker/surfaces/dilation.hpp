// Lattice points, matrices and dilations: sections 5 and 5.1 of ../certificates/SPEC.md.
#pragma once

#include "torus.hpp"

namespace subcert_check {

constexpr std::int64_t max_coordinate = 1'000'000'000;        // of points that are read
constexpr std::int64_t max_distance = std::int64_t{1} << 48;  // times 2^13, what adjugates hold, it is below 2^62

/// Rows; of one or two variables filled up by those of the unit matrix.
using Matrix = std::array<Point, 3>;

struct Dilation {
  std::size_t variables = 0;
  Matrix rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
};

/// a + factor b
Point combine(const Point& a, std::int64_t factor, const Point& b);
Point parse_point(std::string_view text, std::size_t variables, std::int64_t limit = max_coordinate);

std::int64_t determinant(const Matrix& m);
Matrix adjugate(const Matrix& m);
Matrix product(const Matrix& a, const Matrix& b);
/// a b^-1, which must have integer entries.
Matrix quotient(const Matrix& a, const Matrix& b);

/// [1,2;-2,-1]
Dilation parse_dilation(std::string_view text);

/// |det M|. Rejects M unless it is similar to a multiple of an orthogonal matrix and |det M| > 1 (section 5.1).
unsigned classes(const Dilation& dilation);

}  // namespace subcert_check
