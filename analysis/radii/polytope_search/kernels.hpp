#pragma once
/// Dense kernels of the simplex method: plain loops the compiler vectorises, compiled for wider registers as well where
/// the tool chain can choose between versions at load time.

#include <cstddef>

namespace subcert::polytope::kernels {

/// out = A x, A column major with `rows` rows (a multiple of 4) and `columns` columns.
void multiply(const double* a, std::size_t rows, std::size_t columns, const double* x, double* out);

/// out = A^T x for the same A.
void multiply_transposed(const double* a, std::size_t rows, std::size_t columns, const double* x, double* out);

/// out += A B for any numbers of rows and columns, B column major with `inner` rows. The arrays do not overlap.
void add_product(const double* a, std::size_t rows, std::size_t inner, const double* b, std::size_t columns,
                 double* out);

/// A -= u v^T for any A.
void rank_one(double* a, std::size_t rows, std::size_t columns, const double* u, const double* v);

double dot(const double* a, const double* b, std::size_t n);

/// One block of 16 vertices, coordinate major: out[l] = |sum over even coordinates| + |sum over odd coordinates|;
/// returns the largest.
float price_block(const float* block, std::size_t even, std::size_t odd, const float* y, float* out);

/// One block of 16 complex vertices, coordinate major, all real parts before all imaginary parts: out[l] = the largest
/// |<y, g v>| over g = identity, conjugation and, with `flip`, negation of the odd coordinates; returns the largest.
float price_complex_block(const float* block, std::size_t even, std::size_t odd, bool flip, const float* y, float* out);

}  // namespace subcert::polytope::kernels
