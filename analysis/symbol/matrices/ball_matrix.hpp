#pragma once
/// Matrices of complex balls, for sources (never for public headers).

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/numbers/rational_complex.hpp>
#include "rational_matrix.hpp"

namespace subcert {

/// An eigenvalue of a matrix and an eigenvector of it, both inside.
struct EigenpairEnclosure {
  ComplexBall value;
  std::vector<ComplexBall> vector;
};

/// Encloses a simple eigenpair next to an approximation, as exactly as `bits` bits allow; the largest entry of the
/// vector is 1, and all is real where the approximation is. Domain: a square matrix, a vector of its size that is not 0
/// (its Rayleigh quotient is taken as the approximate eigenvalue) or a number. Nothing where none
/// is isolated, or the deadline passes before the last step. Cost: two inverses of numbers of 128 bits, or `bits` where
/// that is not enough, a product and some images of vectors. Ref: [Rum10].
std::optional<EigenpairEnclosure> enclose_eigenpair(const RationalMatrix& matrix, const ComplexVector& approximation,
                                                    slong bits, const Deadline& deadline = {});
std::optional<EigenpairEnclosure> enclose_eigenpair(const RationalMatrix& matrix, const RationalComplex& near,
                                                    slong bits, const Deadline& deadline = {});

/// All eigenvalues of a matrix, in disjoint balls that hold so many each, with multiplicity.
struct EigenvalueGroup {
  ComplexBall value;
  std::size_t count;
};

/// Domain: square, given row by row. Nothing where `bits` bits do not separate them to balls. Error: that of a simple
/// eigenvalue about the width of the entries, of a multiple one about the root of it of that order. Cost: a QR
/// iteration and a few products. Ref: [Rum10].
std::optional<std::vector<EigenvalueGroup>> eigenvalues(const std::vector<std::vector<Ball>>& matrix, slong bits);

/// The columns of (point - matrix)^(-1), about. Domain: a square matrix. Nothing is proved; nothing where numbers of
/// `bits` bits find no pivot. Cost: one inverse of such numbers.
std::optional<std::vector<ComplexVector>> inverse_columns(const RationalMatrix& matrix, const RationalComplex& point,
                                                          slong bits);

}  // namespace subcert
