#pragma once
/// Supersolutions of the transfer operator that are given by one number for each cell of frequencies, for sources
/// (balls). Proofs: docs/theorems/variance-curves.tex, Proposition 1; its notation is used: shell j is pi 2^(-j-1) <
/// |xi| <= pi 2^-j, cut into equal cells (j, i).

#include <subcert/analysis/radii/polytope_search/dense.hpp>
#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>

#include <optional>
#include <vector>

namespace subcert::frequency {

/// m(w), half the symbol without its phase, of a symmetric binary mask.
class HalfSymbol {
 public:
  /// Errors: throws a domain error where the mask is not symmetric with arity 2 and two sum rules.
  HalfSymbol(const Mask& mask, slong bits);

  slong bits() const { return bits_; }
  /// Largest distance of an index from the centre of the mask.
  double reach() const { return reach_; }
  /// mu: |m(w) - 1| and |m(w + pi)| are at most mu w^2.
  const Ball& flatness() const { return flatness_; }
  /// Error: some units of the last place times the square of the reach. Cost: a product for each coefficient, near
  /// 0 27.
  Ball value(const Ball& w) const;
  /// The product of m(xi/2^k) over k >= 1. Domain: mu xi^2 <= 1/2. Error: at most of the order (reach xi)^4.
  Ball product_near_zero(const Ball& xi) const;

  /// Bounds of |m(w)| and |m(w + pi)| for w in one interval.
  struct Suprema {
    Ball plain, alias;
  };
  /// For the intervals into which [low, high] is cut by equal steps. Domain: 0 <= low < high, `count` a power of two.
  std::vector<Suprema> suprema(const Ball& low, const Ball& high, int count) const;

 private:
  static constexpr int order = 8;                       ///< of Taylor's polynomials
  static constexpr int moments = 27, moment_reach = 4;  ///< of the expansion around 0, for |w| <= moment_reach / reach
  /// cos and sin of w times each distance from the centre.
  struct Waves {
    BallVector cosine, sine;
  };
  Waves waves(const Ball& w) const;
  BallVector cosines(const Ball& w) const;
  void expand(const Ball& centre, std::vector<Ball>& plain, std::vector<Ball>& alias) const;

  slong bits_;
  bool half_;  ///< the centre lies between two indices
  double reach_;
  Ball flatness_;
  Ball second_, fourth_;  ///< m''(0) and a bound of the fourth derivative
  Ball remainder_;        ///< of Taylor's polynomials on an interval of radius 1
  std::vector<Ball> coefficients_;
  std::vector<Ball> moments_;              ///< derivatives of even order at 0, divided by factorials
  Ball moment_remainder_;                  ///< of their Taylor polynomial, over w^(2 moments)
  std::vector<BallVector> plain_, alias_;  ///< coefficients of the derivatives, divided by factorials
};

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
