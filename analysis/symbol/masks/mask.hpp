#pragma once
/// Masks: a symbol together with its arity.

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>
#include <subcert/analysis/symbol/polynomials/multivariate_polynomial.hpp>
#include "dilation.hpp"

#include <memory>

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
/// support, and have so many sum rules; so does the rounded mask. `symmetric`: both are their own mirror images.
struct MaskRounding {
  Rational distance;
  int sum_rules;
  bool symmetric = false;
};

/// A mask on the lattice Z^s, s = 1, 2, 3, where i and j are multi-indices and a dilation matrix M stands for the
/// arity: f'_i = sum over j of a_{i - Mj} f_j. One that is made as a tensor product knows its factors, and one that is
/// made of a mask of one variable is its own only factor: what is asked of such masks is answered factor by factor.
///
/// Its coefficients are numbers or, with r > 1 components, r x r matrices A_k: those of a vector of functions,
/// phi(x) = sum over k of A_k phi(Mx - k).
class LatticeMask {
 public:
  /// A coefficient that is not 0, or an entry of a matrix.
  struct Term {
    LatticePoint exponents;
    std::size_t row, column;
    Rational coefficient;
  };

  /// Without factors. Errors: throws Error for a zero symbol, or a dilation of another number of variables.
  LatticeMask(MultivariatePolynomial symbol, Dilation dilation);
  /// Of the entries of the matrices, row by row: entries[r*i + j] is the sum over k of (A_k)_{ij} z^k. Errors: the
  /// same, and throws Error unless there are as many rows as columns.
  LatticeMask(std::vector<MultivariatePolynomial> entries, Dilation dilation);
  /// With the dilation arity times the identity.
  LatticeMask(const MultivariatePolynomial& symbol, int arity);
  LatticeMask(const Mask& mask);  // NOLINT(google-explicit-constructor): one variable is a case of several

  /// r; 1 where the coefficients are numbers.
  std::size_t components() const { return components_; }
  const std::vector<MultivariatePolynomial>& entries() const { return entries_; }
  /// Row by row of the matrices, those of an entry in the order of its polynomial. Cost: made once, shared by copies.
  const std::vector<Term>& terms() const& { return *terms_; }
  std::vector<Term> terms() && { return *terms_; }
  /// Of numbers. Errors: throws Error for more than one component.
  const MultivariatePolynomial& symbol() const;
  const Dilation& dilation() const { return dilation_; }
  /// Where the dilation is a multiple of the identity. Errors: throws Error otherwise.
  int arity() const;
  /// 1 for curves, 2 for surfaces, 3 for volumes.
  int dimension() const { return entries_.front().variables(); }
  /// Of a tensor product, first variable first; none where it was not made as one.
  const std::vector<Mask>& factors() const& { return factors_; }
  std::vector<Mask> factors() && { return std::move(factors_); }
  bool has_factors() const { return !factors_.empty(); }
  /// The same mask, of which no factors are known.
  LatticeMask without_factors() const { return with_dilation(dilation_); }
  /// The same coefficients with another dilation, or other digits; without factors.
  LatticeMask with_dilation(Dilation dilation) const { return {entries_, std::move(dilation)}; }
  /// The only factor. Errors: throws Error unless there is one.
  const Mask& curve() const&;
  Mask curve() && { return curve(); }
  /// Whether they are the same mask, with or without factors.
  bool operator==(const LatticeMask& other) const { return dilation_ == other.dilation_ && entries_ == other.entries_; }

 private:
  friend LatticeMask tensor_product(const std::vector<Mask>& masks);

  std::vector<MultivariatePolynomial> entries_;
  std::size_t components_;
  Dilation dilation_;
  std::shared_ptr<const std::vector<Term>> terms_;
  std::vector<Mask> factors_;
};

/// The tensor product of masks of one variable: the product of the symbols, and the diagonal dilation of the arities.
/// Its factors are these masks, scaled such that the coefficients of all but the first sum to the arity where they do
/// not sum to 0: the product has coset sums 1 if and only if all of them have. Domain: one to three masks, arities up
/// to
/// 64. Errors: throws Error.
LatticeMask tensor_product(const std::vector<Mask>& masks);

/// sum over j of a_{residue + arity*j}, for residue = 0, ..., arity-1. A scheme that converges to non-zero limits has
/// all of them equal to 1.
std::vector<Rational> coset_sums(const Mask& mask);
/// The same over the classes modulo the dilation, digit by digit.
std::vector<Rational> coset_sums(const LatticeMask& mask);

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
/// A closed box that contains the support of the basic limit function: the sum of the boxes of M^-n supp(a), n = 1, 2,
/// .... Error: none where a power of M up to the 24th is diagonal with positive entries, otherwise an outer box, wider
/// by at most a part in 1000.
std::vector<Interval> limit_support(const LatticeMask& mask);

enum class Symmetry { odd, even, none };

/// odd: a_{c-i} = a_{c+i} about an integer c; even: about a half-integer c. `centre` is c for both, 0 for none.
struct SymmetryReport {
  Symmetry kind;
  Rational centre;
};

SymmetryReport symmetry(const Mask& mask);

}  // namespace subcert
