// Eigenvectors of all products near one: section 7.1 of ../certificates/SPEC.md.
#pragma once

#include "polytope.hpp"

namespace subcert_check {

/// A product of matrices that are known up to an error, and a vector that is near an eigenvector.
struct NearProduct {
  Vector matrix;  // column by column, times scale
  mpz_class scale;
  mpq_class error, eigenvalue;  // of the matrix, in the 1-norm; near that of the product
  Vector vector;                // times vertex_one
  std::size_t kept;             // the coordinate that the eigenvector shares with the vector
  mpz_class vertex_one;
};

/// Reads the lines `inverse` and `column`. Each of these products has one eigenvalue so near to the given one as is
/// returned, a simple one, and an eigenvector for it with that distance, in the 1-norm, from the given one.
mpq_class distance_to_eigenvector(const NearProduct& product, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
