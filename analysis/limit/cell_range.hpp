#pragma once
/// What a polynomial and bounds for the rest say about a function on a cell.

#include "limit_cells.hpp"

#include <vector>

namespace subcert {

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
