#include "classical.hpp"

#include "local_regression.hpp"

#include <subcert/analysis/symbol/error.hpp>

namespace subcert {

Mask bspline_mask(int degree, int arity) {
  require(degree >= 1, "bspline_mask: need degree >= 1, got {}", degree);
  require(arity >= 2, "bspline_mask: need arity >= 2, got {}", arity);
  const LaurentPolynomial power_of_ones = LaurentPolynomial::all_ones(arity).pow(degree + 1);
  return {(power_of_ones * LaurentPolynomial(power(Rational(arity), -degree))).shifted(-(power_of_ones.length() / 2)),
          arity};
}

Mask deslauriers_dubuc_mask(int n) { return regression_mask(primal(n, 2 * n - 1)); }

Mask four_point_mask(const Rational& w) {
  const Rational inner = Rational(1, 2) + w;
  return {LaurentPolynomial({-w, 0, inner, 1, inner, 0, -w}, -3), 2};
}

}  // namespace subcert
