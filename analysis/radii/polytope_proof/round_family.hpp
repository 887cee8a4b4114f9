#pragma once
/// A family in doubles, in coordinates in which its orbits are round: the way from exact matrices to the search. Inner
/// header.

#include <subcert/analysis/radii/polytope_search/product_search.hpp>
#include <subcert/analysis/symbol/matrices/matrix_family.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

namespace subcert::radius {

/// Coordinates y = to x of a search, where those of the family are x = from y. Without rows both are the same.
struct SearchCoordinates {
  RationalMatrix to{0, 0}, from{0, 0};
  bool differ() const { return to.rows() > 0; }
};

struct RoundFamily {
  polytope::SearchFamily family;  ///< in the coordinates of the search: to A from, rounded
  SearchCoordinates coordinates = {};
};

/// Domain: entries whose doubles are finite.
polytope::Matrix to_double(const RationalMatrix& matrix);

/// Nothing where an entry is not finite.
std::optional<RationalMatrix> to_rational(const polytope::Matrix& matrix);

/// The family in doubles, with its group. Domain: entries whose doubles are finite.
polytope::SearchFamily to_search_family(const MatrixFamily& family);

/// The same, but where orbits are so flat that doubles would lose what distinguishes their points, as for families that
/// nearly have an invariant subspace, in other coordinates, which are found step by step and applied to the exact
/// matrices, the first step in long numbers where products are hidden. Where they stay flat, coordinates stay what they
/// are. They commute with the flip; a family with another group keeps its coordinates. Cost: for each step, which makes
/// orbits rounder by a factor of 10^4, an inverse in balls and three exact products for each matrix.
RoundFamily round_family(const MatrixFamily& family, const Deadline& deadline);

/// Whether products are so much smaller than their factors that doubles may not see them: never of sizes above 24.
/// Domain: entries whose doubles are finite.
bool has_hidden_products(const MatrixFamily& family, const Deadline& deadline);

/// Coordinates y = to x in which orbits are round up to small factors, triangular, from a shape of orbits in long
/// numbers. Nothing where the shape is not positive up to rounding, or the deadline passes. Cost: 60 sums of two exact
/// products with numbers of 512 bits for each matrix.
std::optional<RationalMatrix> long_rounding(const MatrixFamily& family, const Deadline& deadline);

/// Goes on to the coordinates step y, exactly; false, with nothing changed, where the step is not finite, where balls
/// do not resolve the way back or doubles do not hold the family there. Domain: no symmetry but the flip, with which
/// the step commutes up to rounding.
bool change_coordinates(RoundFamily& round, const MatrixFamily& family, const polytope::Matrix& step);

}  // namespace subcert::radius
