#pragma once
/// Whether exact algebra that cannot be interrupted ends before a deadline, by measured times. Inner header.

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/rational_complex.hpp>

namespace subcert::radius {

/// Whether the characteristic polynomial takes longer than some hundredths of a second.
bool has_long_characteristic(const RationalMatrix& matrix);

/// An enclosure by balls of an eigenpair next to a number.
bool has_time_for_eigenpair(std::size_t size, const RationalComplex& near, const Deadline& deadline);

/// The zeros of a polynomial, its factors, or a greatest common divisor with its derivative.
bool has_time_for_roots(const LaurentPolynomial& p, const Deadline& deadline);

/// An elimination: a kernel, the pivot columns or a linear system with as many right hand sides.
bool has_time_for_elimination(const RationalMatrix& matrix, const Deadline& deadline);

}  // namespace subcert::radius
