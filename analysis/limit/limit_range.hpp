#pragma once
/// The basic limit function between grid points: certified extremes, norms, sign and monotonicity.

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/mask.hpp>

#include <cstdint>

namespace subcert {

/// The budget ends, by default, 60 seconds after the options were made; exact values as in variance_range.hpp.
struct LimitOptions {
  Rational relative_width = Rational(1, 1'000'000);
  Budget budget{Deadline::in(60)};
};

/// phi over the line: maximum, minimum (0 or below), largest |phi|, largest |phi'| (the best Lipschitz constant where
/// phi is not C^1 but a proved polynomial between integers; absent, with the reason, where nothing is proved), and the
/// integral of |phi|.
struct LimitRange {
  Enclosure maximum;
  Enclosure minimum;
  Enclosure sup_norm;
  std::optional<Enclosure> slope;
  std::string slope_reason;
  Enclosure l1_norm;
  bool complete = false;    ///< all widths are as asked for; else time, memory or precision ran out
  std::uint64_t cells = 0;  ///< cells looked at
};

/// Branch and bound over arity-adic cells. Domain: convergence proved by contraction. Error: widths at most
/// relative_width times the largest |phi| (times the largest |phi'|, the integral of |phi|) where `complete`. Errors:
/// throws Error, also as LimitCells. Proofs: docs/limit-enclosures.md.
LimitRange limit_range(const Mask& mask, const LimitOptions& options = {});

/// phi and phi' on one cell [index, index + 1] / arity^level; no slope where it is not proved to exist.
struct LimitCell {
  Enclosure value;
  std::optional<Enclosure> slope;
};

/// Domain: as LimitCells; |index| < 2^61, level as LimitCells::deepest_level(). For many cells use LimitCells.
LimitCell limit_cell(const Mask& mask, std::int64_t index, int level);

/// How far cells are split to decide something: the deepest level, and when to end undecided; by default 60 seconds
/// after this was made.
struct CellLimits {
  int levels = 20;
  Deadline deadline = Deadline::in(60);
};

/// Whether phi > 0 on [from, to]. `no` names a point. Positive masks are decided at once (docs/limit-enclosures.md,
/// section 8); else cells are split. Domain: as LimitCells; from < to.
Decision is_positive(const Mask& mask, const Rational& from, const Rational& to, const CellLimits& limits = {});

/// Whether phi' >= 0 on [from, to], so that phi does not decrease there. `no` names a cell where it decreases; unknown
/// where a zero of phi' is met that neither the enclosures nor the differences of the control data resolve, as at an
/// inner maximum. Domain: as LimitCells, slopes proved; from < to.
Decision is_increasing(const Mask& mask, const Rational& from, const Rational& to, const CellLimits& limits = {});

}  // namespace subcert
