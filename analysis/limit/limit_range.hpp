#pragma once
/// The basic limit function between grid points: certified extremes, norms and sign.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>
#include <vector>

namespace subcert {

/// The budget ends, by default, 60 seconds after the options were made; exact values as in variance_range.hpp.
struct LimitOptions {
  Rational relative_width = Rational(1, 1'000'000);
  Budget budget{Deadline::in(60)};
};

/// phi over R^s: maximum, minimum (0 or below) and largest |phi|. In one variable also the largest |phi'| (the best
/// Lipschitz constant where phi is not C^1 but a proved polynomial between integers; absent, with the reason, where
/// nothing is proved) and the integral of |phi|.
struct LimitRange {
  Enclosure maximum;
  Enclosure minimum;
  Enclosure sup_norm;
  /// In several variables where phi has the end of the maximum, and of the minimum, that faces 0; empty where that is
  /// 0, outside the support.
  std::optional<std::vector<Rational>> highest = {}, lowest = {};
  Decision nonnegative;  ///< phi everywhere; in several variables `no` names a point
  std::optional<Enclosure> slope;
  std::string slope_reason;
  Enclosure l1_norm;        ///< no ends in several variables
  bool complete = false;    ///< all widths are as asked for; else time, memory or precision ran out
  std::uint64_t cells = 0;  ///< cells looked at
};

/// Branch and bound over arity-adic cells. Domain: convergence proved by contraction. Error: widths at most
/// relative_width times the largest |phi| (times the largest |phi'|, the integral of |phi|) where `complete`. Errors:
/// throws Error, also as LimitCells. Proofs: docs/limit-enclosures.md.
LimitRange limit_range(const Mask& mask, const LimitOptions& options = {});

/// Of a mask of one variable that is its own factor the same; of others branch and bound over the tiles M^-n (i +
/// Gamma) of a set of digits, in exact arithmetic. Domain: a scheme that converges, with any dilation. Error: widths at
/// most relative_width times the largest |phi| where `complete`. Errors: throws Error, as limit_values of several
/// variables. Cost: a few hundred cells a level where phi is C^1 with sum rules of order 2 and its extremes are
/// isolated, each with a sparse product. Proof: docs/surfaces.md.
LimitRange limit_range(const LatticeMask& mask, const LimitOptions& options = {});

/// How far cells are split to decide something: the deepest level, and when to end undecided; by default 60 seconds
/// after this was made.
struct CellLimits {
  int levels = 20;
  Deadline deadline = Deadline::in(60);
};

/// Whether phi > 0 on [from, to]. `no` names a point. Positive masks are decided at once (docs/limit-enclosures.md,
/// section 8); else cells are split. Domain: as LimitCells; from < to.
Decision is_positive(const Mask& mask, const Rational& from, const Rational& to, const CellLimits& limits = {});

}  // namespace subcert
