#pragma once
/// Masks of all families, with negative coefficients, without symmetry, of several arities.

#include <subcert/schemes/specification.hpp>

#include <string>
#include <vector>

namespace subcert::testing {

inline Mask mask_of(const std::string& specification) { return make_scheme(specification).mask.curve(); }

inline const std::vector<std::string>& specimens() {
  static const std::vector<std::string> list{"primal:n=1",
                                             "primal:n=2",
                                             "primal:n=5",
                                             "primal:n=9",
                                             "dual:n=2",
                                             "primal-odd:n=3",
                                             "dual-odd:n=2",
                                             "primal:n=4,d=3",
                                             "dd:n=2",
                                             "dd:n=3",
                                             "bspline:degree=3",
                                             "bspline:degree=2,a=3",
                                             "ary:a=3,points=4,d=3",
                                             "ary:a=3,points=3",
                                             "ary:a=4,points=5,d=1",
                                             "ary:a=5,points=6,d=3",
                                             "four-point:w=1/9",
                                             "four-point:w=1/5",
                                             "mask:[1,2,1,2,4,2,1,2,1]/8"};
  return list;
}

inline std::vector<Mask> masks() {
  std::vector<Mask> result;
  for (const std::string& text : specimens()) result.push_back(mask_of(text));
  // Without symmetry: products of smoothing factors and a positive factor.
  const LaurentPolynomial two({Rational(1, 2), Rational(1, 2)}, 0),
      three({Rational(1, 3), Rational(1, 3), Rational(1, 3)}, 0);
  const LaurentPolynomial uneven({Rational(3, 5), Rational(1, 2), Rational(-1, 10)}, -4);
  result.push_back({two.pow(4) * uneven * LaurentPolynomial(2), 2});
  result.push_back({three.pow(3) * uneven * LaurentPolynomial(3), 3});
  return result;
}

}  // namespace subcert::testing
