#pragma once
/// Bounds of the symbols that the least squares schemes of any degree have, for the sources of this floor.
/// Proofs: docs/theorems/every-smoothness.tex, Theorem X; its notation is used.

#include <subcert/analysis/symbol/numbers/balls.hpp>
#include "kernel/uniform_symbol.hpp"

namespace subcert::theorems {

/// One degree of one kind of scheme, and all schemes of it whose shorter rule has at least M points. Domain: odd
/// degree >= 3 for primal schemes, degree >= 2 for dual ones; M > 4 (p + 1)^2 (p + 2).
struct EveryRule {
  Evaluation evaluation;
  int degree;
  Ball M;

  int kernel_degree() const;  ///< p: the odd one of degree and degree + 1 for dual schemes, else the degree
  int order() const;          ///< k: the sum rules
  Ball gamma() const;         ///< of p, as a = sqrt(p (p + 1))
  Ball root() const;
  /// G_i: |m(w)| <= (1 + 3/M) gamma/(M sin w) (G_i + C sin w), where M sin w >= 9/5 2^i a.
  Ball amplitude(int i) const;
  Rational constant() const;  ///< C
  /// E: |m(pi - w)| <= (1 + 3/M) E gamma/M, where M sin w >= 9/5 a.
  Ball far() const;
  /// |m(pi - w)| <= near gamma/M (M w)^k/(2k - 1)!!, where M w <= 4a.
  Ball near() const;
  /// chi: the product of |m| over all shells with M w < 4a is at most exp(chi).
  Ball excess() const;
};

/// (2k - 1)!!.
Rational odd_factorial(int k);

}  // namespace subcert::theorems
