#pragma once
/// Exact questions about trigonometric polynomials of several variables: Laurent polynomials on the torus |z_v| = 1.

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/analysis/symbol/polynomials/multivariate_polynomial.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>
#include <string>

namespace subcert {

/// A zero whose coordinates are roots of unity of an order up to 12, as `2 pi (1/2, 0)`: proved by division by a
/// cyclotomic polynomial. Domain: p is its own reversal, so that the values are real. Cost: 12^s values in doubles, and
/// an exact one where that is near 0.
std::optional<std::string> zero_on_torus(const MultivariatePolynomial& p);

/// Whether p(e^(i x)) > 0 for all real x. `yes` and `no` are exact, `unknown` where the budget or the number of cells
/// ends the work, as it does for zeros that are no roots of unity. Domain: as above. Cost: the tensor product Bernstein
/// form in tan(x_v / 2) and its bisection, until all coefficients of each cell are positive. Proof: docs/surfaces.md.
Decision is_positive_on_torus(const MultivariatePolynomial& p, const Budget& budget = {});

}  // namespace subcert
