#pragma once
/// Supersolutions of the transfer operator that are given by one number for each cell of frequencies, for sources
/// (balls). Proofs: docs/theorems/variance-curves.tex, Proposition 1; its notation is used: shell j is pi 2^(-j-1) <
/// |xi| <= pi 2^-j, cut into equal cells (j, i).

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
  Ball beyond;  ///< the sum of b over the shells beyond
};

CellBounds bounds_on_cells(const HalfSymbol& symbol, std::size_t cells);

/// X_ji, or its square.
Cells products(const CellBounds& shells, bool squared);

/// What a recursion sums: the aliases, or their squares, or each times the ratio of the ends of two cells.
struct Terms {
  bool squared = false;
  bool frequencies = false;
};

/// Y_ji(w), E_ji(w) or Z_ji(w).
class Recursion {
 public:
  Recursion(const CellBounds& shells, const Terms& terms);

  Cells operator()(const std::vector<Ball>& w) const;
  /// What the shells beyond the last add where w = 1 in the last cell, to which they all refer: their b fall by 4, and
  /// the ratios of ends are at most 2.
  Ball beyond() const;
  /// The matrix of w -> value on shell 0, near enough for a search.
  polytope::Matrix matrix() const;

 private:
  const CellBounds& shells_;
  Terms terms_;
  Cells x_, e_;  ///< of each step
};

/// w > 0 with first_i + value_0i(w) <= w_i for all i: floating point proposes it, balls prove it.
std::optional<std::vector<Ball>> supersolution(const std::vector<Ball>& first, const Recursion& recursion);

}  // namespace subcert::frequency
