#pragma once
/// The data-dependent schemes D of local l1 regression, on curves and on grids.

#include "l1_regression.hpp"

#include <subcert/schemes/local_regression.hpp>

#include <vector>

namespace subcert {

/// points = {p}: windows of p consecutive data; points = {p, q}: p columns times q rows of a grid. Along each axis an even
/// number 2n takes the data -n+1, ..., n and gives the outputs at 1/4 and 3/4, an odd number 2n+1 takes -n, ..., n and
/// gives -1/4 and 1/4. Ref: [MLZD15, eq. (4), (10), App. A.2, Lemma 1], [MH, sec. 2].
struct L1Scheme {
  std::vector<int> points;
  int degree = 1;
  L1Options options = {};
};

/// The window of a scheme, about the datum at 0; its outputs are numbered with x running fastest.
/// Domain: one or two numbers of points, each >= 2 and > degree. Errors: throws std::invalid_argument.
RegressionWindow l1_window(const L1Scheme& scheme);

/// The linear scheme that has all weights 1, for curves: dual(n, degree) or dual_odd(n, degree).
LocalRegression l1_linear_part(const L1Scheme& scheme);

/// Points on a regular grid of `columns` times `rows` (a curve has one row): coordinate c of the point in column i and row
/// j is values[(j * columns + i) * dimension + c]; its parameters are first_x + i * step and first_y + j * step, in units
/// of the spacing of the first data.
struct DataGrid {
  std::vector<double> values;
  std::size_t columns = 0;
  std::size_t rows = 1;
  std::size_t dimension = 1;
  Rational first_x = 0;
  Rational first_y = 0;
  Rational step = 1;
};

/// One refinement, outputs of the complete windows alone: 2 (columns - p + 1) columns, and likewise rows on grids.
/// Domain: as many columns and rows as points; finite values. Errors: throws std::invalid_argument.
/// Cost: as L1Fitter::fit, linear in the windows, on `threads` threads.
DataGrid l1_refine_complete(const L1Scheme& scheme, const DataGrid& data, int threads = 1);

/// The values at this level from the data 1 at 0 and 0 elsewhere, over the whole support of the scheme.
/// Domain: a scheme for curves, 0 <= level <= 16. Ref: [MLZD15, sec. 2.4, Prop. 1].
DataGrid l1_impulse_response(const L1Scheme& scheme, int level);

}  // namespace subcert
