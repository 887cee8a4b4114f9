#pragma once
/// The variance curve psi(x) = sum over j of phi(x - j)^2: the variance of the limit at x for data with independent
/// noise of variance 1.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

namespace subcert {

/// values[i] = psi(i / arity^level), i = 0, ..., arity^level, exact; slopes[i] = psi'(i / arity^level) where C^1 limits
/// are promised, empty otherwise.
struct VarianceGrid {
  int arity;
  int level;
  std::vector<Rational> values;
  std::vector<Rational> slopes;

  Rational step() const { return power(Rational(arity), -level); }
  /// The largest value on the grid: a lower bound for the maximum of psi.
  const Rational& largest() const;
  /// The smallest value on the grid: an upper bound for the minimum of psi.
  const Rational& smallest() const;
  /// The largest |slope| on the grid and the largest |divided difference| of neighbours: by the mean value theorem a
  /// lower bound for the largest |slope|.
  Rational steepest() const;
};

/// Domain: the scheme converges; differentiable only where its limits are C^1. Errors and cost: as limit_values.
/// Ref: [DHHS15, eq. (17)].
VarianceGrid variance_grid(const Mask& mask, int level, bool differentiable, const Deadline& deadline = {});

/// 1 / K <= psi, where K integer shifts of the closed support can meet in one point: the shifts of phi sum to 1.
Rational variance_floor(const Mask& mask);

/// psi <= 1 for masks without negative coefficients, whose shifts of phi are non-negative and sum to 1; nothing for
/// the others. Domain: the scheme converges. Ref: [DHHS15, eq. (18)].
std::optional<Rational> variance_ceiling(const Mask& mask);

}  // namespace subcert
