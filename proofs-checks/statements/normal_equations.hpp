#pragma once
/// Least squares by its textbook: design matrix and normal equations. Independent of regression_weights().

#include "formula.hpp"

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

namespace subcert::statements {

/// Entry (i, k) is basis[k] at nodes[i], a function of x.
RationalMatrix design_matrix(const std::vector<Rational>& nodes, const std::vector<Formula>& basis);

/// 1, x, ..., x^degree.
std::vector<Formula> monomials(int degree);

/// The x with a x = b. Domain: square a. Errors: throws Undefined for a singular one.
RationalMatrix solved(const RationalMatrix& a, const RationalMatrix& b);

/// (A^T A)^-1 A^T for the design matrix A. Domain: more rows than columns or as many, full rank. Errors: throws
/// Undefined for a singular A^T A.
RationalMatrix pseudo_inverse(const RationalMatrix& design);

/// The weights of the data in the value at x of the least squares fit by this basis. Errors: as pseudo_inverse.
std::vector<Rational> weights_by_normal_equations(const std::vector<Rational>& nodes, const std::vector<Formula>& basis,
                                                  const Rational& x);

/// first, first + step, ..., count of them.
std::vector<Rational> equidistant(const Rational& first, const Rational& step, int count);

}  // namespace subcert::statements
