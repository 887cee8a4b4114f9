#pragma once
/// What the floating point search proposes, in words that the proof uses: the border between search and proof. Inner
/// header. Nothing here is to be trusted.

#include "polytope_proof.hpp"
#include "round_family.hpp"

#include <subcert/analysis/radii/polytope_search/polytope_search.hpp>

#include <complex>
#include <vector>

namespace subcert::radius {

/// An invariant polytope, perhaps, of a family or of its transposed matrices: what the search found, of which products
/// is not empty, with the coordinates of the values of its vertices.
struct PolytopeCandidate : polytope::SearchResult {
  using Vertex = polytope::Vertex;
  using Image = polytope::VertexImage;
  using Term = polytope::CombinationTerm;

  SearchCoordinates coordinates;

  /// The product with this index, as matrices of the family from left to right; products[index].word are the letters
  /// in the order in which the matrices of the polytope are applied.
  std::vector<int> word(std::size_t index) const;
  /// The scale is the averaged radius of the first product.
  bool scale_is_radius() const { return scale == radius; }
};

/// Searches a product and a polytope. `cones`: also those of a cone, where no entry is negative; `exact`: of the very
/// radius of the product, where one closes; `more_products`: SearchOptions. Domain: entries whose doubles are finite
/// and not far from 1 in size.
PolytopeCandidate find_polytope(const MatrixFamily& family, const Budget& budget, bool cones = true, bool exact = true,
                                const polytope::ProductSource& more_products = {});

/// A product of large averaged radius: a quick look.
polytope::Candidate find_product(const MatrixFamily& family, const Deadline& deadline);

/// value * 2^exponent, near an eigenvalue of largest modulus; 0 for the zero matrix. Domain: any entries.
struct FloatingEigenvalue {
  std::complex<double> value;
  long exponent = 0;
  double distance = 0;  ///< of the nearest other one, over its modulus
};
FloatingEigenvalue leading_eigenvalue(const RationalMatrix& matrix);

}  // namespace subcert::radius
