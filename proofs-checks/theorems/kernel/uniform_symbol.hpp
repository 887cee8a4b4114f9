#pragma once
/// Bounds of the symbols of the least squares schemes of one degree d that hold for all sizes N >= N_1 at once, for the
/// sources of this floor. Proofs: docs/theorems/variance-curves.tex, section 7; its notation is used.

#include "bessel_sum.hpp"
#include "kernel_coefficients.hpp"

#include <vector>

namespace subcert::theorems {

/// Primal schemes fit on N - 1/2 and N + 1/2 points and evaluate in the middle; dual ones fit on N points and evaluate
/// a quarter of the distance of two points left and right of it.
enum class Evaluation { primal, dual };

/// k: the order of the zero of m at pi, the number of sum rules; it is even for primal and odd for dual schemes.
inline int alias_order(Evaluation evaluation, int degree) {
  return evaluation == Evaluation::dual && degree % 2 == 1 ? degree + 2 : degree + 1;
}

class UniformSymbol {
 public:
  /// Domain: degree >= 1, odd for primal schemes; first_N > degree + 1.
  UniformSymbol(Evaluation evaluation, int degree, const Rational& first_N, slong bits);

  /// |f(z)| <= bound |z|^order for |z| <= radius, radius >= 1; order d + 1 where it is not said.
  struct Disc {
    Ball bound;
    long radius;
  };
  Disc disc_difference() const;  ///< f = N^2 (m(z/N) - khat(z))
  /// f = M dD_M(z/M)/dM; dual: f = 2 N Im D(z/N), which is odd. Domain: f = O(z^order).
  Disc disc_slope(int order) const;
  Ball slope() const;  ///< E: the second f is at most E w/sin w on 0 <= w <= pi/2, where M w >= 1
  /// A: M sin(w) |D_M(w)| <= A for 0 < w <= pi/2, M w >= from; dual: N sin(w) |m(w)|.
  Ball decay(const Rational& from) const;

  /// On 2^octave (1 + [part, part + 1]/parts).
  struct Cell {
    Ball transform;   ///< |khat|
    Ball difference;  ///< N^2 |m(v/N) - khat(v)|
    Ball factor;      ///< both |m(v/N)| and |khat(v)|; absent (0) where it is transform + difference/N^2
  };
  static constexpr int parts = 16;
  Cell cell(int octave, int part) const;
  /// Cells are split into boxes below 2^boxed_octaves.
  int boxed_octaves() const { return boxed_octaves_; }

  /// Phase-free bounds on v >= from: N^2 |m(v/N) - khat(v)| <= first v + zeroth.
  struct Growth {
    Ball first, zeroth;
  };
  Growth growth(const Rational& from) const;

 private:
  bool is_dual() const { return evaluation_ == Evaluation::dual; }
  std::size_t orders() const { return full_.size(); }
  Ball difference_over(const Rational& low, const Rational& high) const;
  Ball slope_over(const Rational& low, const Rational& high) const;
  Ball weight(std::size_t r) const { return end_[r] / M_.pow(static_cast<long>(r)); }
  template <class Bound>
  Disc by_maximum_principle(int order, const Bound& bound) const;
  Ball difference_on_disc(const Ball& rho) const;
  Ball slope_on_disc(const Ball& rho) const;

  Evaluation evaluation_;
  int degree_, boxed_octaves_;
  slong bits_;
  Ball N_, M_;                                 ///< N_1 and the smallest number of points
  std::vector<BesselSum> full_, drift_, odd_;  ///< P_r of omega, of its derivative, of the odd part over t_0
  std::vector<BesselSum> steep_;               ///< P_r'
  std::vector<BesselSum> limit_, rise_;        ///< P_0 of omega(0) and of the slope, and the second derivative
  std::vector<Ball> end_;                      ///< b^(r)(pi/2)
};

}  // namespace subcert::theorems
