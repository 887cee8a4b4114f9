#pragma once
/// The data-dependent schemes of local l1 regression, as values; schemes/data/l1 applies them.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <vector>

namespace subcert {

/// The weights of the next fit are (r^2 + delta)^(-1/2), r the residuals of the last one, which begins with ordinary
/// least squares. Ref: [MLZD15, eq. (3), (6)].
struct L1Options {
  double delta = 1e-8;           ///< in squared units of the data, positive
  int iterations = 6;            ///< reweighted fits after the ordinary one; 0 leaves the ordinary one
  double tolerance = 0;          ///< a window stops once no fitted value at a node moves by more than this
  bool joint_residuals = false;  ///< r is the Euclidean norm over the coordinates of a point, else each has its own
  bool exact = false;            ///< the least absolute polynomials themselves, on curves; the other options are idle
};

/// points = {p}: windows of p consecutive data; {p, q}: p columns times q rows of a grid; {p, q, r}: the same in r
/// layers. Along each axis an even number 2n takes the data -n+1, ..., n and gives, for arity 2, the outputs at 1/4 and
/// 3/4, an odd number 2n+1 takes -n, ..., n and gives -1/4 and 1/4; for other arities they divide the middle cell as
/// those of ary() do. Ref: [MLZD15, eq. (4), (10), App. A.2, Lemma 1], [MH, sec. 2].
struct L1Scheme {
  std::vector<int> points;
  int degree = 1;
  L1Options options = {};
  int arity = 2;
};

/// Where output `phase` = 0, ..., arity - 1 of a window stands, from the centre of the window.
inline Rational output_place(int arity, int phase) { return Rational(2 * phase + 1 - arity, 2 * arity); }

}  // namespace subcert
