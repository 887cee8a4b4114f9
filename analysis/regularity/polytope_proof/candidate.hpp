#pragma once
/// What the floating point search proposes, in words that the proof uses: the border between search and proof. Inner
/// header. Nothing here is to be trusted.

#include "polytope_proof.hpp"
#include "round_family.hpp"

#include <subcert/analysis/regularity/polytope_search/polytope_search.hpp>

#include <complex>

namespace subcert::radius {

/// An invariant polytope, perhaps, of a family or of its transposed matrices.
struct PolytopeCandidate {
  struct Product {
    std::vector<int> word;   ///< of matrices of the family, from left to right
    std::vector<int> cycle;  ///< the letters in the order in which the matrices of the polytope are applied
  };
  struct Vertex {
    std::vector<std::complex<double>> value;  ///< in the coordinates of the search; real unless kind == complex
    int parent = -1;                          ///< value = A_letter vertices[parent] / scale; -1: a root
    int letter = -1;
    int cycle = -1;  ///< roots: index into products, or -1 for an extra vertex
    int place = -1;  ///< roots: letters of that cycle applied to its first root so far
  };
  struct Term {
    int vertex = 0;
    std::size_t element = 0;  ///< of the group of the family
    bool conjugated = false;
    std::complex<double> coefficient;
  };
  /// A_letter vertices[vertex] / scale is the sum of the terms.
  struct Image {
    int vertex = 0;
    int letter = 0;
    bool identity = false;  ///< it is terms[0], a vertex up to symmetry, conjugation, sign or phase
    std::vector<Term> terms;
  };

  PolytopeKind kind = PolytopeKind::real;
  bool transposed = false;        ///< the polytope belongs to the transposed matrices
  SearchCoordinates coordinates;  ///< of the values of the vertices
  bool closed = false;            ///< every image is a vertex or inside
  double scale = 0;               ///< what images are divided by
  bool scale_is_radius = false;   ///< the scale is the averaged radius of the first product
  std::vector<Product> products;  ///< not empty; first `maximizing` ones of equal radius
  std::size_t maximizing = 0;
  std::vector<Vertex> vertices;
  std::vector<Image> images;  ///< one for every vertex and letter, ordered by vertex, then letter
};

/// Searches a product and a polytope. `cones`: also those of a cone, where no entry is negative; `exact`: of the very
/// radius of the product, where one closes; `more_products`: SearchOptions. Domain: entries whose doubles are finite
/// and not far from 1 in size.
PolytopeCandidate find_polytope(const MatrixFamily& family, const Budget& budget, bool cones = true, bool exact = true,
                                const polytope::ProductSource& more_products = {});

/// The word, from left to right, of a product of large averaged radius: a quick look.
std::vector<int> find_product(const MatrixFamily& family, const Deadline& deadline);

/// value * 2^exponent, near an eigenvalue of largest modulus; 0 for the zero matrix. Domain: any entries.
struct FloatingEigenvalue {
  std::complex<double> value;
  long exponent = 0;
};
FloatingEigenvalue leading_eigenvalue(const RationalMatrix& matrix);

}  // namespace subcert::radius
