// Invariant polytopes: section 4.7 of ../certificates/SPEC.md.
#pragma once

#include "group.hpp"

#include <map>

namespace subcert_check {

/// Vertices hold the real parts of their coordinates, then, if complex, the imaginary ones: `parts` is 1 or 2.
struct Polytope {
  Family family;                   // transposed where the section says so
  std::size_t size, parts, count;  // count of the vertices
  bool nonnegative, symmetric, transposed;
  std::vector<Generator> generators;  // of the group: A, B, ...
  mpz_class vertex_one, weight_one;   // coordinates and weights are integers over these
  std::vector<Vector> vertices;
  std::map<TurnedIndex, Vector> turned;  // vertices under words of generators
  mpz_class unit_norm;                   // at least the norm of every unit vector
  struct Combination {
    mpz_class weights, residual;  // over weight_one, and over weight_one * vertex_one * the denominator of the matrices
  };
  std::vector<Combination> images;  // vertex by vertex, matrix by matrix
  mpq_class bound;                  // of the norms of all matrices

  /// The image of x, which holds one vector or several, under a matrix.
  Vector image(std::size_t letter, const Vector& x, Arithmetic& arithmetic) const {
    return arithmetic.multiply(family.matrix(letter), x, size);
  }
  /// The image under one generator, which a letter names; f is the flip. `x` holds one vector or several.
  Vector turn(char letter, Vector x, Arithmetic& arithmetic) const;
};

/// A section whose first line has these fields, up to the vertices: reads its group.
Polytope read_polytope_head(Family family, const Fields& fields, const mpq_class& entry_error, Reader& reader,
                            Arithmetic& arithmetic);

/// Reads the next vertex.
const Vector& read_vertex(Polytope& body, Reader& reader);

/// Reads a line `image J T`. The residual is that of the image less the terms for `side` 1, that of the terms less the
/// image for -1.
Polytope::Combination read_image(Polytope& body, std::size_t vertex, std::size_t matrix, int side, Reader& reader,
                                 Arithmetic& arithmetic);

/// Reads the lines of a section whose first line has these fields. `entry_error`: of the matrices, if they are rounded.
Polytope read_polytope(Family family, const Fields& fields, const mpq_class& entry_error, Reader& reader,
                       Arithmetic& arithmetic);

}  // namespace subcert_check
