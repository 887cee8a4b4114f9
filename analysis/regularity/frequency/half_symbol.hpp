#pragma once
/// Suprema of the symbol of one scheme on cells of frequencies, for sources (balls). Proofs:
/// docs/theorems/variance-curves.tex, section 1; its notation is used.

#include <subcert/analysis/symbol/balls.hpp>
#include <subcert/analysis/symbol/mask.hpp>

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
  static constexpr int order = 8;  ///< of Taylor's polynomials
  /// cos and sin of w times each distance from the centre.
  struct Waves {
    BallVector cosine, sine;
  };
  Waves waves(const Ball& w) const;
  void expand(const Ball& centre, std::vector<Ball>& plain, std::vector<Ball>& alias) const;

  slong bits_;
  bool half_;  ///< the centre lies between two indices
  double reach_;
  Ball flatness_;
  Ball second_, fourth_;  ///< m''(0) and a bound of the fourth derivative
  Ball remainder_;        ///< of Taylor's polynomials on an interval of radius 1
  std::vector<Ball> coefficients_;
  std::vector<BallVector> plain_, alias_;  ///< coefficients of the derivatives, divided by factorials
};

}  // namespace subcert::frequency
