#pragma once
/// The true rate of smoothness of the primal schemes of degree 1: how far the exponent stays below 2. Statement and
/// proof: docs/theorems/rate.tex, Theorem W.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <string>

namespace subcert::theorems {

/// h_n(x) is the sum over odd k, |k| < N, of phi_b^(2 pi k) e^(2 pi i k x); beta_n the largest mean of h_n over a
/// measure that is invariant under x -> 2x modulo 1. Theorem W: (2 - s) ln 2 = beta_n + O(N^(C - log2 N)).
struct SmoothnessRate {
  int n;
  std::string word;     ///< of binary digits: a periodic point of x -> 2x
  Enclosure predicted;  ///< the mean of h_n over its orbit: at most beta_n
  Enclosure largest;    ///< contains beta_n
  Enclosure product;    ///< contains ln |lambda| / length for an eigenvalue lambda of the product of the word: at most
                        ///< (2 - s) ln 2
};

/// Of S_n. Domain: 2 <= n <= 64. Errors: throws a domain error. Error: `predicted` and `product` are narrow; `largest`
/// is about a part in a thousand wide. Cost: the matrices have 4n - 4 rows; for n = 43 a second.
SmoothnessRate smoothness_rate(int n);

}  // namespace subcert::theorems
