#pragma once
/// Bounds of the symbols of the primal least squares schemes of one odd degree d that hold for all n >= n_1 at
/// once, for the sources of this floor. Proofs: docs/theorems/variance-curves.tex, section 7; its notation is used.

#include "kernel_coefficients.hpp"
#include "sinc_sum.hpp"

#include <vector>

namespace subcert::theorems {

class UniformSymbol {
 public:
  UniformSymbol(int degree, int first_n, slong bits);

  /// Cells begin at v = R; below it the zero of order d + 1 at 0 is used.
  static constexpr long radius = 1;

  /// H_R: N^2 |m(z/N) - khat(z)| <= H_R |z|^(d+1) for |z| <= R.
  Ball disc_difference() const;
  /// E_R: |M dD_M(z/M)/dM| <= E_R |z|^(d+1) for |z| <= R.
  Ball disc_slope() const;
  Ball slope() const;  ///< E: |M dD_M(w)/dM| <= E w/sin w on 0 <= w <= pi/2, where M w >= R
  /// A: M sin(w) |D_M(w)| <= A for 0 < w <= pi/2, M w >= from.
  Ball decay(const Rational& from) const;

  /// On R 2^octave (1 + [part, part + 1]/parts).
  struct Cell {
    Ball transform;   ///< |khat|
    Ball difference;  ///< N^2 |m(v/N) - khat(v)|
    Ball factor;      ///< both |m(v/N)| and |khat(v)|
  };
  static constexpr int parts = 16;
  Cell cell(int octave, int part) const;

  /// Phase-free bounds on v >= from: N^2 |m(v/N) - khat(v)| <= first v + zeroth.
  struct Growth {
    Ball first, zeroth;
  };
  Growth growth(const Rational& from) const;

 private:
  SincSum sum(const std::vector<Ball>& coefficients, int r) const;
  Ball average(int r, const SincTable& table, const Ball& rho) const;
  Ball difference_over(const Rational& low, const Rational& high) const;
  Ball weight(int r) const;
  template <class Bound>
  Ball by_maximum_principle(const Bound& bound) const;
  Ball difference_on_disc(const Ball& rho) const;
  Ball slope_on_disc(const Ball& rho) const;

  int degree_;
  slong bits_;
  Ball N_, M_;  ///< 2 n_1 - 1/2 and 2 n_1 - 1
  KernelCoefficients kappa_;
  std::vector<SincSum> full_, limit_, rise_, drift_;  ///< P_r of kappa, kappa(0), slope, derivative
  std::vector<Ball> end_;                             ///< b^(r)(pi/2)
};

}  // namespace subcert::theorems
