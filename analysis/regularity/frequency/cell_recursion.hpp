#pragma once
/// Supersolutions of the transfer operator that are given by one number for each cell of frequencies, for sources
/// (balls). Proofs: docs/theorems/variance-curves.tex, Proposition 1, and docs/theorems/smoothness.tex; their notation
/// is used: shell j is pi 2^(-j-1) < |xi| <= pi 2^-j, cut into equal cells (j, i).

#include "half_symbol.hpp"

#include <subcert/analysis/radii/polytope_search/dense.hpp>

#include <optional>
#include <vector>

namespace subcert::frequency {

constexpr slong cell_bits = 128;

/// A number for each cell (j, i), and one more row for what all shells beyond the last contribute.
using Cells = std::vector<std::vector<Ball>>;

/// x, e on the cells of the first shells; beyond them |m| <= 1 + b, |m(. + pi)| <= b with b = flatness (pi 2^(-j-1))^2.
struct CellBounds {
  std::size_t count, cells;
  Cells x, e;
  Ball beyond;        ///< the sum of b over the shells beyond
  int sum_rules;      ///< k
  Ball alias_beyond;  ///< there |m(w + pi)| <= alias_beyond w^k; absent (0) where it was not asked for
};

/// How near to pi the aliases are bounded: by their size, or relative to w^k.
enum class NearPi { absolute, relative };

CellBounds bounds_on_cells(const HalfSymbol& symbol, std::size_t cells, NearPi near_pi = NearPi::absolute);

/// X_ji, or its square.
Cells products(const CellBounds& shells, bool squared);

/// What a recursion sums: the aliases, or their squares, each times the ratio of the ends of two cells to the power
/// `order`; each step divides by 1 + excess. Domain: order 0, or 1 with excess 0, or the sum rules with excess > 0 and
/// bounds relative to w^k.
struct Terms {
  bool squared = false;
  int order = 0;
  Rational excess = 0;
};

/// Y_ji(w), E_ji(w), Z_ji(w) or V_ji(w).
class Recursion {
 public:
  Recursion(const CellBounds& shells, const Terms& terms);

  Cells operator()(const std::vector<Ball>& w) const;
  /// What the shells beyond the last add where w = 1 in the last cell, to which they all refer: their b fall by 4, and
  /// the ratios of ends are at most 2.
  Ball beyond() const;
  /// The matrix of w -> value on shell 0, near enough for a search, with any excess (where there is one at all).
  polytope::Matrix matrix(double excess) const;
  polytope::Matrix matrix() const { return matrix(terms_.excess.convert_to<double>()); }

 private:
  const CellBounds& shells_;
  Terms terms_;
  Ball step_;    ///< 1/(1 + excess)
  Cells x_, e_;  ///< of each step, without the division
};

/// The solution of w = first + matrix w where it is positive, which for positive `first` is so where the spectral
/// radius of the matrix is below 1.
std::optional<std::vector<double>> fixed_point(const polytope::Matrix& matrix, const std::vector<double>& first);

/// w > 0 with first_i + value_0i(w) <= w_i for all i: floating point proposes it, balls prove it.
std::optional<std::vector<Ball>> supersolution(const std::vector<Ball>& first, const Recursion& recursion);

}  // namespace subcert::frequency
