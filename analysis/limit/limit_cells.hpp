#pragma once
/// The basic limit function and the variance curve on arity-adic cells, as polynomials with proved remainders.

#include <subcert/analysis/symbol/masks/mask.hpp>
#include <subcert/analysis/symbol/support/budget.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace subcert {

/// A function f on the cell [index, index + 1] / arity^level. With u in [-1/2, 1/2] the position in the cell,
///   f = sum of (middle[j] +- radius[j]) u^j + factor arity^(-m level) sum of u^j row_j . eta(u + 1/2) + rest,
/// where |rest| <= value_slack, |rest'| <= slope_slack, the derivative taken by x, and where eta, common to all cells,
/// is bounded in LimitCells (docs/limit-enclosures.md, section 4). The square of a remainder adds to f a number from
/// 0 to square, and to f' one of modulus at most square_slope.
/// Canonical: middle and radius have one length; `rows` holds all rows one after the other, row_losses for each step so
/// far and each row a bound of what the step lost by rounding; all bounds are non-negative.
struct CellForm {
  int level = 0;
  std::int64_t index = 0;
  double factor = 1;
  std::vector<double> middle;
  std::vector<double> radius;
  std::vector<double> rows;
  std::vector<double> row_losses;
  double value_slack = 0;
  double slope_slack = 0;
  double square = 0;
  double square_slope = 0;

  /// That it holds, in bytes.
  std::size_t memory() const {
    return sizeof(CellForm) + sizeof(double) * (middle.size() + radius.size() + rows.size() + row_losses.size());
  }
};

/// What a form says about its function on the cell: value_lower <= f <= value_upper; slope_lower <= f' <= slope_upper
/// (where C^1 is proved); left and right enclose the values at the ends; some |f'| in the cell, and so the Lipschitz
/// constant there, is at least steepness; f differs from its polynomial by at most remainder. square_share is the part
/// of the width of the slope range (without C^1: of the value range) that the square of the remainder causes;
/// value_rounding and slope_rounding are the parts of both widths that rounding causes: a cell is not worth splitting
/// where they are large.
struct CellRange {
  double value_lower, value_upper;
  double slope_lower, slope_upper;
  double left_lower, left_upper;
  double right_lower, right_upper;
  double steepness;
  double remainder;
  double square_share;
  double value_rounding;
  double slope_rounding;
};

/// Refines forms of one mask. Domain: convergence proved by a contractive power of the difference scheme; at most 1,500
/// integers in the support. Errors: the constructor throws Error where contraction is not found, with the reason, and
/// as limit_values(), past the deadline too. Bounds hold after all rounding (docs/limit-enclosures.md, section 6).
/// Cost: the norms of at most two divided difference schemes, 10 s each at most, one exact elimination and about 30
/// products with the mask in ball arithmetic, then for each cell one product of transition matrix and rows in double
/// precision.
class LimitCells {
 public:
  explicit LimitCells(const Mask& mask, const Deadline& deadline = {});
  LimitCells(LimitCells&&) noexcept;
  LimitCells& operator=(LimitCells&&) noexcept;
  ~LimitCells();

  int arity() const;
  /// Whether slopes are meaningful: C^1 is proved, or phi is proved to be a polynomial on each interval between
  /// integers. If not, slope_reason() says why.
  bool has_slopes() const;
  const std::string& slope_reason() const;
  /// Whether psi(x) = psi(1 - x): the mask is symmetric and twice the centre of phi is an integer.
  bool is_mirrored() const;
  /// phi vanishes outside [first_integer(), last_integer()].
  long first_integer() const;
  long last_integer() const;
  /// The deepest level whose cells can be numbered.
  int deepest_level() const;

  /// phi on [k, k + 1].
  CellForm limit_form(long k) const;
  /// psi on [index, index + 1] / arity^level. Domain: 0 <= index < arity^level, and arity^(level + 8) <= 2^61.
  CellForm variance_form(std::int64_t index, int level) const;
  /// What may be added to the slack of a form to have fewer rows: to the slack of the value and of the slope.
  struct Spare {
    double value = 0;
    double slope = 0;
  };
  /// The same function on one of the arity equal parts of the cell. Slack grows by at most 8 times what is spare for a
  /// form and all that descend from it.
  CellForm child(const CellForm& form, int digit, const Spare& spare) const;
  /// The same for psi; a new form where the square of the remainder matters.
  CellForm variance_child(const CellForm& form, const CellRange& range, int digit, const Spare& spare) const;
  CellRange range(const CellForm& form) const;
  /// first - second, on one cell of both. Bounds of the result hold for the difference. Domain: one level and index.
  static CellRange difference(const LimitCells& first, const CellForm& form, const LimitCells& second,
                              const CellForm& other);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// f = sum of (middle[j] +- radius[j]) u^j + rest + a part that vanishes at the ends of the cell, |u| <= 1/2;
/// derivatives are taken by x with du/dx = speed.
struct CellParts {
  std::vector<double> middle;
  std::vector<double> radius;
  double speed;
  double value_rest, slope_rest;      ///< bounds for the slack and for what vanishes at the ends, together
  double value_slack, slope_slack;    ///< bounds for the slack alone
  double square_below, square_above;  ///< the squares add a number between -square_below and square_above
  double square_slope;                ///< and to f' one of at most this modulus
  bool slopes;
};

/// Error: none, all bounds are rounded outward (docs/limit-enclosures.md, sections 5 and 6).
CellRange range_of(const CellParts& parts);

}  // namespace subcert
