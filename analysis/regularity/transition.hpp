#pragma once
/// Transition matrices of a mask.

#include <subcert/analysis/symbol/mask.hpp>
#include <subcert/analysis/symbol/rational_matrix.hpp>

namespace subcert {

/// (T_t)_{jk} = b_{first + arity*j + t - k} for t = 0, ..., arity-1 and 0 <= j, k < max(1, ceil(N / (arity-1))), where
/// b_first, ..., b_{first+N} are the coefficients of the mask. The sums of absolute values in the columns of the
/// products of L of them are the sums of |coefficients| of the L-th power of the scheme over residue classes
/// (docs/level-norms.md), so that their joint spectral radius is the limit of ||S^L||^(1/L).
std::vector<RationalMatrix> transition_matrices(const Mask& mask);

/// C_{jk} = b_{arity*j - k} + b_{arity*j + k} (one term where k = 0), 0 <= j, k <= N/(arity-1), for coefficients
/// b_{-N}, ..., b_N with b_{-i} = b_i: the powers of C hold the coefficients about the centre of the powers of the
/// scheme, (C^n)_{00} is the coefficient of z^0 of b(z) b(z^arity) ... b(z^(arity^(n-1))). Domain: symbol(1/z) =
/// symbol(z), not zero. Errors: throws std::invalid_argument. Ref: docs/single-radius.md.
RationalMatrix central_matrix(const LaurentPolynomial& symbol, int arity);

}  // namespace subcert
