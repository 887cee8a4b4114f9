#pragma once
/// Certified maxima and minima of the variance curve and of its slope.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>

namespace subcert {

/// psi over a period: its maximum and minimum, its mean, and the largest |psi'|, or the best Lipschitz constant where
/// psi is not C^1 (slope_reason then says why). No slope: slope_reason says why nothing is proved.
struct VarianceRange {
  Enclosure maximum;
  Enclosure minimum;
  std::optional<Enclosure> slope;
  std::string slope_reason;
  Rational mean;
  bool complete = false;  ///< all enclosures have the relative width asked for; else time, memory or precision ran out
  std::uint64_t cells = 0;  ///< cells looked at
};

/// The budget ends, by default, 60 seconds after the options were made; it is that of the search over cells.
/// What is solved exactly, without which there is no answer, has half a second more, and throws Error of kind undecided
/// past that.
struct VarianceOptions {
  Rational relative_width = Rational(1, 1'000'000);
  Budget budget{Deadline::in(60)};
};

/// Branch and bound over arity-adic cells. Domain: convergence proved by contraction; relative_width > 0.
/// Error: none, the enclosures hold after all rounding; relative widths as asked for where `complete`.
/// Errors: throws Error, also as LimitCells. Cost: for primal n = 40 about a third of a second.
/// Ref: [DHHS15, sec. 3.1]; proofs: docs/limit-enclosures.md.
VarianceRange variance_range(const Mask& mask, const VarianceOptions& options = {});

}  // namespace subcert
