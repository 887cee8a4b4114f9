#pragma once
/// Masks: a symbol together with its arity.

#include "dilation.hpp"
#include "interval.hpp"
#include "laurent_polynomial.hpp"
#include "multivariate_polynomial.hpp"

namespace subcert {

/// The mask of a linear, stationary subdivision scheme: f'_i = sum over j of a_{i - arity*j} f_j, with the coefficients
/// a_i of `symbol()`. Canonical: arity >= 2 and symbol != 0.
class Mask {
 public:
  /// Errors: throws Error for arity < 2 or a zero symbol.
  Mask(LaurentPolynomial symbol, int arity);

  const LaurentPolynomial& symbol() const { return symbol_; }
  int arity() const { return arity_; }
  bool operator==(const Mask& other) const { return arity_ == other.arity_ && symbol_ == other.symbol_; }

 private:
  LaurentPolynomial symbol_;
  int arity_;
};

/// Of a mask with rounded coefficients: those that are meant differ from them by at most `distance`, on the same
/// support, and have so many sum rules; so does the rounded mask.
struct MaskRounding {
  Rational distance;
  int sum_rules;
};

/// The same in up to three variables, where i and j are multi-indices and a dilation matrix M stands for the arity:
/// f'_i = sum over j of a_{i - Mj} f_j.
class MultivariateMask {
 public:
  /// Errors: throws Error for a zero symbol, or a dilation of another number of variables.
  MultivariateMask(MultivariatePolynomial symbol, Dilation dilation);
  /// With the dilation arity times the identity.
  MultivariateMask(const MultivariatePolynomial& symbol, int arity);

  const MultivariatePolynomial& symbol() const { return symbol_; }
  const Dilation& dilation() const { return dilation_; }
  /// Where the dilation is a multiple of the identity. Errors: throws Error otherwise.
  int arity() const;
  /// 1 for curves, 2 for surfaces, 3 for volumes.
  int dimension() const { return symbol_.variables(); }
  bool operator==(const MultivariateMask& other) const {
    return dilation_ == other.dilation_ && symbol_ == other.symbol_;
  }

 private:
  MultivariatePolynomial symbol_;
  Dilation dilation_;
};

/// The tensor product of univariate masks: the product of the symbols, and the diagonal dilation of the arities.
/// Domain: one to three masks, arities up to 64. Errors: throws Error.
MultivariateMask tensor_product(const std::vector<Mask>& masks);

/// sum over j of a_{residue + arity*j}, for residue = 0, ..., arity-1. A scheme that converges to non-zero limits has
/// all of them equal to 1.
std::vector<Rational> coset_sums(const Mask& mask);
/// The same over the classes modulo the dilation, digit by digit.
std::vector<Rational> coset_sums(const MultivariateMask& mask);

/// Whether all coset sums are 1.
bool is_affine(const Mask& mask);

/// The greatest common divisor of the cosets: 1 unless some z, zeta z, ..., zeta^(arity-1) z (zeta a primitive root of
/// unity of order arity) are all zeros of the symbol.
LaurentPolynomial common_factor_of_cosets(const Mask& mask);

/// Exponent range of the mask.
struct IndexRange {
  long first;
  long last;
  bool operator==(const IndexRange& other) const { return first == other.first && last == other.last; }
};

IndexRange support(const Mask& mask);

/// The closed, convex hull of the support of the basic limit function: first/(arity-1) to last/(arity-1).
Interval limit_support(const Mask& mask);

enum class Symmetry { odd, even, none };

/// odd: a_{c-i} = a_{c+i} about an integer c; even: about a half-integer c. `centre` is c for both, 0 for none.
struct SymmetryReport {
  Symmetry kind;
  Rational centre;
};

SymmetryReport symmetry(const Mask& mask);

}  // namespace subcert
