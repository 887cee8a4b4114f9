#pragma once
/// Local regression at vertices of any valence. Inner header.

#include <subcert/analysis/symbol/masks/sector_rules.hpp>
#include <subcert/schemes/grid_regression.hpp>

namespace subcert {

/// Throws Error outside of the domain of regression_rules_at().
void require_fan(const BallRegression& scheme);

/// The rules of the vertex and of its edges, those of a fit of the same degree to the same data in the flat fan: the
/// vertex at 0, its neighbours at w^j, w = exp(2 pi i/n), the other corners of the triangles across from an edge at
/// 1 + w, 2 and 1 + 1/w; weights by the distances there. For n = 6 these are the rules of the mask. The weights are
/// polynomials in c of a degree below that of Q(c). Domain: an equilateral lattice, 9/4 < L^2 <= 3, d <= 2, no weights
/// by distances but a power; 3 <= n <= 1000. Errors: throws Error. Cost: an inverse in Q(c).
std::map<LatticePoint, SectorRule> regression_rules_at(const BallRegression& scheme, long valence);

}  // namespace subcert
