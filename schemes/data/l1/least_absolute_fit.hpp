#pragma once
/// The polynomials of least absolute deviations themselves, without delta and without iterations: every decision is
/// exact, in double precision too.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <cstddef>
#include <vector>

namespace subcert::data {

template <class Number>
struct LeastAbsoluteFit {
  std::vector<Number> values;  ///< at the outputs
  bool unique;                 ///< whether no other polynomial has as small a sum of moduli
};

/// Fits windows of N data at 0, ..., N - 1 by the polynomial p of degree at most D with the least sum of |f_r - p(r)|.
/// Where there are several, those with the largest and with the smallest leading coefficient are unique, and their mean
/// is taken, again one of the least: reversing the data, multiplying them and adding polynomials of degree D to them
/// does the same to the fit. Ref: docs/l1.md, section 9.
class LeastAbsoluteFitter {
 public:
  /// Domain: 0 <= D <= 3, D < N <= 64; outputs anywhere. Errors: throws a domain error.
  LeastAbsoluteFitter(int points, int degree, std::vector<Rational> outputs);

  /// The fit of `data`, N numbers, at the outputs; returns whether it is unique. Which data it interpolates is decided
  /// without error, and an output is one of these plus a sum over the others: off by at most (D + 4) 2^-51 times the
  /// sum of |l_b(c)| |f_b - f_a|, l_b the Lagrange polynomials. Domain: finite data, else throws a domain error. Cost:
  /// a few passes over the window; some microseconds where data beyond 2^900 need rationals.
  bool fit(const double* data, double* out) const;

  /// The same exactly. Domain: N data, else throws a domain error.
  LeastAbsoluteFit<Rational> fit(const std::vector<Rational>& data) const;

 private:
  int points_, degree_;
  std::vector<Rational> outputs_;
  std::vector<double> at_;
};

}  // namespace subcert::data
