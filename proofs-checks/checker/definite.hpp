// Symmetric matrices that are shown to be positive semidefinite: Lemma 17 of ../certificates/SPEC.md. Matrices are
// stored row by row. Numbers are integers, or doubles that are integers below 2^53.
#pragma once

#include "arithmetic.hpp"

namespace subcert_check {

/// Adds factor number k times row number k, k < `count`, to the n numbers of a sum. Factors are `step` apart, rows
/// `row_step`. Here and below `arithmetic` counts the work with integers.
void add_multiples(mpz_class* sum, const mpz_class* factors, std::size_t step, const mpz_class* rows,
                   std::size_t row_step, std::size_t count, std::size_t n, Arithmetic& arithmetic);
void add_multiples(double* sum, const double* factors, std::size_t step, const double* rows, std::size_t row_step,
                   std::size_t count, std::size_t n, Arithmetic& arithmetic);

/// m^T m on and above the diagonal, row by row, of a matrix column by column.
Vector gram(const Vector& m, std::size_t n, Arithmetic& arithmetic);

/// Lemma 17: whether all x_kk are positive; `s` is (n 2^h + m) 1 - U, and what is below its diagonal is not looked at.
/// Doubles: for |U_kj| <= 4^h, h at most 24.
template <class Number>
bool is_decomposed(Number* s, std::size_t n, Arithmetic& arithmetic);

/// Section 4.8: whether an integer matrix is 0 or shown to be positive semidefinite; what is below its diagonal is 0
/// or that of a symmetric matrix.
bool is_positive(Vector s, std::size_t n, Arithmetic& arithmetic);

}  // namespace subcert_check
