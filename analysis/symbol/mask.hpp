#pragma once
/// Masks: a symbol together with its arity.

#include "interval.hpp"
#include "laurent_polynomial.hpp"
#include "multivariate_polynomial.hpp"

#include <type_traits>

namespace subcert {

/// The precondition of masks. Errors: throws Error for arity < 2 or a zero symbol.
void check_mask(int arity, bool is_zero);

/// The mask of a linear, stationary subdivision scheme: f'_i = sum over j of a_{i - arity*j} f_j, with the coefficients
/// a_i of `symbol()`; in several variables i and j are multi-indices.
/// Canonical: arity >= 2 and symbol != 0.
template <class Symbol>
class BasicMask {
 public:
  /// Errors: throws Error for arity < 2 or a zero symbol.
  BasicMask(Symbol symbol, int arity) : symbol_(std::move(symbol)), arity_(arity) {
    check_mask(arity, symbol_.is_zero());
  }

  const Symbol& symbol() const { return symbol_; }
  int arity() const { return arity_; }
  /// The number of variables: 1 for curves, 2 for surfaces, 3 for volumes.
  int dimension() const {
    if constexpr (std::is_same_v<Symbol, LaurentPolynomial>)
      return 1;
    else
      return symbol_.variables();
  }
  bool operator==(const BasicMask& other) const { return arity_ == other.arity_ && symbol_ == other.symbol_; }

 private:
  Symbol symbol_;
  int arity_;
};

using Mask = BasicMask<LaurentPolynomial>;
using MultivariateMask = BasicMask<MultivariatePolynomial>;

/// The tensor product of univariate masks of one arity. Domain: two or three masks. Errors: throws Error.
MultivariateMask tensor_product(const std::vector<Mask>& masks);

/// sum over j of a_{residue + arity*j}, for residue = 0, ..., arity-1. A scheme that converges to non-zero limits has
/// all of them equal to 1.
std::vector<Rational> coset_sums(const Mask& mask);

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
