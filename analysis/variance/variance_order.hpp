#pragma once
/// Variance curves compared at all points.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>

namespace subcert {

/// Whether psi_first(x) < psi_second(x) for all x. `no` comes with a point where it fails, confirmed with exact values:
/// difference = psi_second(witness) - psi_first(witness) <= 0. `yes` comes with a positive lower bound of the
/// difference at all x; unknown with the reason and with a lower bound that is not positive.
struct VarianceOrder {
  Truth below = Truth::unknown;
  std::string reason;
  Rational witness;
  Rational difference;
  Enclosure smallest_difference;  ///< of psi_second - psi_first over all x; the upper end is attained up to rounding
  std::uint64_t cells = 0;
};

/// The search over cells ends, by default, 60 seconds after the options were made.
struct VarianceOrderOptions {
  int levels = 40;  ///< deepest cells
  Deadline deadline = Deadline::in(60);
};

/// Bisection of [0, 1] into cells on which the difference is enclosed. Domain: masks of one arity, convergence of both
/// proved by contraction. Errors: throws Error, also as LimitCells. Equal curves, or curves that touch
/// without a common point on the grid, end as unknown. Cost: mostly the setup of both masks.
/// Ref: [DHHS15, conj. 8]; proofs: docs/limit-enclosures.md.
VarianceOrder compare_variance(const Mask& first, const Mask& second, const VarianceOrderOptions& options = {});

/// psi(index / arity^level), exact. Domain: 0 <= index <= arity^level < 2^62. Errors: as limit_values.
Rational variance_at(const Mask& mask, std::int64_t index, int level);

}  // namespace subcert
