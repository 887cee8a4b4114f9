#pragma once
/// Masks of matrices by their entries, also where these are numbers p + q sqrt(D) with p and q rational.

#include "mask.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

namespace subcert {

/// The mask with these entries, which add up where they come twice. Domain: rows and columns below `size`. Errors:
/// throws Error where all are 0.
LatticeMask matrix_mask(const std::vector<LatticeMask::Term>& terms, std::size_t size, const Dilation& dilation);

/// (sum over k of A_k) / |det M|, which maps the integral of a solution of the refinement equation to itself.
RationalMatrix mean_matrix(const LatticeMask& mask);

/// Whether a scheme with these terms, each entry once, keeps its data: of the A_k with k in M Z^s only A_0 is not 0,
/// and is `one` times the identity, or with `derivatives`, which are per unit of the spacing, times diag(1, 1/a, 1/a^2,
/// ...). Domain: rows and columns below `size`; with derivatives a dilation a.
bool keeps_data(const std::vector<LatticeMask::Term>& terms, std::size_t size, const Dilation& dilation,
                bool derivatives, const Rational& one = 1);

/// The matrices A_k = P_k + sqrt(root) Q_k by masks of rational matrices of twice as many rows.
struct QuadraticMask {
  long root;  ///< positive, no square
  /// [P, root Q; Q, P]: the rows of x and y for x + sqrt(root) y, of which the functions phi_c = x_c + sqrt(root) y_c.
  LatticeMask doubled;

  std::size_t components() const { return doubled.components() / 2; }
  /// The matrices with a rational number in the place of the square root.
  LatticeMask at(const Rational& number) const;
};

/// A term P_k or Q_k times its rational coefficient: that of 1, and that of the square root.
struct QuadraticTerm {
  LatticePoint exponents;
  std::size_t row, column;
  Rational rational, root;
};

/// Domain: rows and columns below `size`; root positive, no square. Errors: throws Error.
QuadraticMask quadratic_mask(const std::vector<QuadraticTerm>& terms, std::size_t size, long root,
                             const Dilation& dilation);

/// The square root rounded to so many bits behind the point; it differs by at most 2^-bits.
Rational rounded_root(long root, long bits);

}  // namespace subcert
