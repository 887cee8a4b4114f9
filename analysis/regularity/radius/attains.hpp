#pragma once
/// That a named product attains the joint spectral radius.

#include "certified_polytope.hpp"

namespace subcert {

/// Whether the maximizing products of the search attain the joint spectral radius exactly: yes, with the argument of
/// docs/joint-spectral-radius.md ('Exactly'), or unknown with the step that is missing. The true polytope has algebraic
/// vertices near the rational ones of `polytope`; each of its images is a vertex by construction, or by the mirror
/// symmetry of the product, or lies inside with a margin that exact and ball arithmetic confirm.
/// Domain: `polytope` was made from `result` and these matrices; `lower` <= radius of the first product, proved; all
/// maximizing products have exactly that radius, proved.
Decision product_attains_radius(const std::vector<RationalMatrix>& matrices, const SearchResult& result,
                                const CertifiedPolytope& polytope, const Rational& lower);

}  // namespace subcert
