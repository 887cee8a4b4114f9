#pragma once
/// Bounds of the two symbols that a primal least squares scheme of any degree has, for the sources of this floor.
/// Proofs: docs/theorems/every-smoothness.tex, Theorem X; its notation is used.

#include <subcert/analysis/symbol/balls.hpp>

namespace subcert::theorems {

/// What the proof of Theorem X fixes.
namespace chosen {
inline const Rational known(9, 5);  ///< from u = known a on the decay of the responses is used
}  // namespace chosen

/// One degree, and all schemes whose shorter rule has at least M points. Domain: odd degree >= 3, M >= 4 d (d + 1).
struct EveryRule {
  int degree;
  Ball M;

  Ball gamma() const;
  Ball root() const;  ///< a = sqrt(d (d + 1))
  /// G_i: M sin w |D_M(w) - B_M| <= gamma G_i up to 1 + 1/M, where M sin w >= 9/5 2^i a.
  Ball amplitude(int i) const;
  /// E: |m(pi - w)| <= E gamma/M up to 1 + 3/M, where M sin w >= 9/5 a.
  Ball far() const;
  /// 1 + epsilon: |m(pi - w)| <= (1 + epsilon) gamma/(2M) (M w)^(d+1)/(2d+1)!!, where M w <= 4a.
  Ball near() const;
};

/// (2d+1)!!.
Rational double_factorial(int degree);

}  // namespace subcert::theorems
