#pragma once
/// What reweighted fits leave of one outlier, in the limit of a far outlier and a small delta.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <optional>

namespace subcert {

/// The data 1 at one place of a window of N and 0 elsewhere, the outputs of `l1:points=N,d=D,a=ARITY` after
/// `iterations` fits for delta -> 0: the largest modulus over places and outputs. An outlier X among bounded data moves
/// the fit by this part of X, but for bounded terms. Domain: 0 <= D <= 3, D + 1 < N <= 64, 0 <= iterations <= 1000,
/// arity >= 2, else throws a domain error. Nothing where binom(N, D + 1) > 5000, or the precision does not do. Cost:
/// N^2 binom(N, D + 1) ball operations for each fit. Ref: docs/l1.md, section 3.
std::optional<Enclosure> outlier_remainder(int points, int degree, int iterations, int arity = 2);

/// The fewest fits whose remainder is at most this; nothing where 1000 are not proved to suffice.
std::optional<int> iterations_for_remainder(int points, int degree, const Rational& remainder, int arity = 2);

/// The largest |p(x_r)| / sum over s != r of |p(x_s)|, over places r and polynomials p: the factor by which further
/// fits shrink what is left. Below 1 exactly where the least absolute fit of any one outlier among zeros is 0 alone.
/// Domain: as outlier_remainder. Cost: N^2 binom(N, D) D operations.
Rational outlier_factor(int points, int degree);

}  // namespace subcert
