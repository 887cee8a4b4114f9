#pragma once
/// Eigenvalues in their irreducible factors, and vectors that prove them: SPEC.md, 4.10. Inner header.

#include <subcert/analysis/radii/polytope_proof/attained_number.hpp>

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>

#include <optional>

namespace subcert::radius {

/// A zero of a polynomial that is not 0, in its irreducible factor.
struct LeadingFactor {
  LaurentPolynomial factor, others;  ///< the polynomial is factor^multiplicity others
  int multiplicity;
  ComplexBall zero;
  std::vector<ComplexBall> zeros;  ///< all but 0, each once

  /// The polynomial of the negative matrix, of that of a matrix.
  LeadingFactor negated() const;
  /// |zero|^(1/length)
  AttainedNumber number(std::size_t length) const;
};

/// The zero of p next to a point. Nothing where all are 0. Domain: lowest exponent 0 or more; zeros about as large as
/// 1. Cost: a factorisation and the balls of all zeros.
std::optional<LeadingFactor> nearest_factor(const LaurentPolynomial& p, const RationalComplex& near, slong bits);

/// Of the characteristic polynomial of a matrix. Nothing past the deadline, too.
std::optional<LeadingFactor> leading_factor(const RationalMatrix& matrix, const RationalComplex& near, slong bits,
                                            const Deadline& deadline);

/// Towards the zero of p near a start, by Newton's method.
ComplexBall refined_zero(const LaurentPolynomial& p, ComplexBall start);

/// A vector on which the factor vanishes at the matrix, so that an eigenvector of the zero is a sum of its images. Of
/// several eigenvectors the one near `start` is meant; where the factor divides the minimal polynomial more than once,
/// or without a start, there is none. Domain: `factor` is of this matrix.
std::optional<std::vector<Integer>> seed_of(const RationalMatrix& matrix, const LeadingFactor& factor,
                                            const ComplexVector& start);

}  // namespace subcert::radius
