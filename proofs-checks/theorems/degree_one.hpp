#pragma once
/// The variance curve of the primal least squares schemes of degree 1: its mean, its ripple and its slope, with
/// explicit bounds for each n. Statements and proofs: docs/limit-constants.md, abbreviated [LC].
/// Notation: N = 2n - 1/2, phi_n the basic limit function, psi_n the variance curve, I_n the integral of phi_n^2.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <vector>

namespace subcert::theorems {

/// sup |cos x - sin(x)/x| over the real line. Error: width below 10^-20. Cost: one branch and bound. Ref: [LC, eq.
/// (9)].
Enclosure cosine_minus_sinc_supremum();

/// The numbers of [LC, sec. 3 and 5] for one n. Shell j is pi 2^(-j-1) < |xi| <= pi 2^-j. Each enclosure contains the
/// number that its formula defines; an absent upper end says that the hypothesis Y_0 < 1 or Z_0 < 1 is not proved.
struct DegreeOneBounds {
  int n;
  std::vector<Enclosure> x;      ///< |symbol / 2| on shell j + 1
  std::vector<Enclosure> e;      ///< |symbol / 2| at a distance of shell j + 1 from pi
  std::vector<Enclosure> big_x;  ///< X_j >= |transform of phi_n| on shell j
  std::vector<Enclosure> big_y;  ///< u_0 Y_j >= the sum of the aliases on shell j
  std::vector<Enclosure> big_z;  ///< v_0 Z_j pi 2^-j >= the sum of the aliases, each times its frequency
  Enclosure u0;
  Enclosure v0;
  Enclosure energy;  ///< rho: the integral of |transform|^2 / (2 pi) over |xi| > pi is at most this
  Enclosure ripple;  ///< O_n >= |psi_n(x) - I_n| for all x
  Enclosure slope;   ///< D_n >= |psi_n'(x)| for all x
};

/// Domain: 2 <= n <= 10^6. Errors: throws a domain error. Error: relative widths below 10^-15.
/// Cost: O(log n) operations on balls. Ref: [LC, thm 9].
DegreeOneBounds degree_one_bounds(int n);

/// |I_n - leading - next - rho| <= remainder, where leading = 2c/N, next = (13/18) c/N^3 and 0 <= rho <= aliases.
struct DegreeOneMean {
  int n;
  Enclosure leading;
  Enclosure next;
  Enclosure remainder;
  Enclosure aliases;
  Enclosure mean;  ///< contains I_n
};

/// The coefficient of 1/N^2 in N I_n / (2c). Ref: [LC, thm 10].
Rational degree_one_second_coefficient();

/// Domain: 2 <= n <= 10^6. Errors: throws a domain error. Ref: [LC, thm 10].
DegreeOneMean degree_one_mean(int n);

/// Contains max psi_n: from I_n below, I_n + O_n above, with I_n from degree_one_mean. Domain: 2 <= n <= 10^6.
Enclosure degree_one_maximum(int n);

}  // namespace subcert::theorems
