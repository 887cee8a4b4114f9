// Eigenvectors of all products near one: section 7.1 of ../certificates/SPEC.md.
#pragma once

#include "polytope.hpp"

namespace subcert_check {

/// A product of matrices that are known up to an error, and a vector that is near an eigenvector.
struct NearProduct {
  Vector matrix;  // column by column, times scale
  mpz_class scale;
  mpq_class error;                // of the matrix, in the norm of the largest column sum
  mpq_class re, im;               // near its eigenvalue
  Vector vector;                  // times vertex_one; the real parts and, for two parts, the imaginary ones
  std::size_t size, parts, kept;  // `kept`: the coordinate that the eigenvector shares with the vector
  mpz_class vertex_one;
};

/// Reads the lines `inverse` and `column`. Each of these products has one eigenvalue so near to the given one as is
/// returned, a simple one, and an eigenvector for it with that distance, a sum of |re| + |im|, from the given one.
mpq_class distance_to_eigenvector(const NearProduct& product, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
