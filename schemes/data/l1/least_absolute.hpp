#pragma once
/// The rule of least absolute deviations, the limit of l1 regression for many iterations and small delta, by its
/// pieces.

#include <subcert/analysis/piecewise/piecewise_rule.hpp>

#include <optional>

namespace subcert::data {

/// The windows and outputs of `l1:points=N,d=D,a=A`. A polynomial p of degree D is a minimiser for the data f exactly
/// where some vertex u of U = { |u_r| <= 1, sum u_r x_r^j = 0 for j <= D } has u_r (f_r - p(x_r)) >= 0 where |u_r| = 1
/// and f_r = p(x_r) elsewhere. The signs of a piece are the u_r of modulus 1, which determine u; pieces stand in the
/// lexicographic order of their signs, 1 before -1 before 0. A piece without D + 1 zeros has residuals as variables of
/// its own. Domain: 0 <= D <= 3, D < N <= 64, A >= 2. Errors: throws a domain error. Nothing where more than
/// `most_pieces` pieces or 1000 times as many steps would be needed. Cost: a step for each sign pattern of N - D - 1
/// data that the other ones may balance.
std::optional<piecewise::Rule> least_absolute_rule(int points, int degree, int arity = 2,
                                                   std::size_t most_pieces = 20'000);

/// Whether every datum has one minimiser. Proved for degrees 0 and 1 (docs/l1.md, Theorem 1) and by the pieces where
/// there are not too many; else unknown.
Decision unique_minimiser(int points, int degree, const std::optional<piecewise::Rule>& rule);

}  // namespace subcert::data
