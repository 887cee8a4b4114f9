#pragma once
/// Vectors of functions of the literature: Hermite schemes, B-splines with multiple knots, orthogonal multiwavelets.
/// All masks are those of the equation phi(x) = sum over k of A_k phi(ax - k).

#include <subcert/analysis/symbol/masks/matrix_masks.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace subcert {

/// The polynomial of at most this degree that is nearest to values and derivatives, `order` data at each integer from
/// `first` to `last`: it has them where its coefficients are as many, and else the sum of all squares is least.
class HermiteFit {
 public:
  /// Domain: order >= 1, 0 <= degree < the number of data. Errors: throws Error. Cost: a linear system of as many rows
  /// as coefficients.
  HermiteFit(long first, long last, int order, int degree);

  /// What the data weigh in value and derivatives at x, `order` of them, per unit of a spacing of 1/arity: a row for
  /// each of these, the data in the order of points and derivatives. Cost: coefficients times data times order.
  RationalMatrix weights(const Rational& x, int arity) const;

 private:
  RationalMatrix coefficients_;  // a row for each, from the constant on; a column for each datum
  int order_;
};

/// Merrien's interpolatory 2-point scheme on values and slopes: between data at 0 and 1 it sets f(1/2) = (f0 + f1)/2 +
/// lambda (f1' - f0') and f'(1/2) = (1 - mu)(f1 - f0) + mu (f0' + f1')/2. Cubic for lambda = -1/8, mu = -1/2; quadratic
/// splines for mu = -1. The specification of its matrices, with the two as they are typed. Ref: [Mer92].
std::string merrien_matrices(std::string_view lambda, std::string_view mu);

/// The interpolatory Hermite scheme whose new values and derivatives, `order` of them at j/arity, are those of the
/// polynomial that has the `order` data at the 2n points -n+1, ..., n. For order 1 the scheme of Deslauriers and Dubuc.
/// Domain: n >= 1, order >= 1, arity >= 2. Errors: throws Error. Cost: a linear system of 2n order rows for each j.
LatticeMask hermite_interpolation_mask(int n, int order, int arity = 2);

/// The B-splines of this degree whose knots are the integers, each so many times: as many functions, in the order of
/// their first knots. Their exponent is degree - multiplicity + 1. Domain: 1 <= multiplicity <= degree, arity >= 2.
/// Errors: throws Error. Cost: quadratic in the degree for each coefficient. Method: the new knots are inserted all at
/// once. Ref: [CLR80].
LatticeMask multiple_knot_bspline_mask(int degree, int multiplicity, int arity = 2);

/// The two functions of Geronimo, Hardin and Massopust, the first times the root of 2: their shifts are orthogonal.
/// Ref: [GHM94].
LatticeMask geronimo_hardin_massopust_mask();

/// Chui and Lian's symmetric orthogonal multiwavelets on [0, 2] and [0, 3], with approximation order 2 and 3; on [0, 3]
/// the second function times the root of 6. Domain: 2 or 3. Errors: throws Error. Ref: [CL96].
QuadraticMask chui_lian_mask(int length);

/// The symmetric and antisymmetric orthogonal multiwavelet of Shen, Tan and Tham on [0, 3]. Ref: [STT00].
QuadraticMask shen_tan_tham_mask();

/// Lebrun and Vetterli's balanced orthogonal multiwavelets, mirror images of each other. Domain: orders 1 to 3. Errors:
/// throws Error. Ref: [LV01].
QuadraticMask balanced_mask(int order);

/// The products of a component of each factor, the component of the last factor running fastest. Domain: two or three
/// factors, of three variables together at most. Errors: throws Error.
LatticeMask vector_tensor_product(const std::vector<LatticeMask>& factors);

}  // namespace subcert
