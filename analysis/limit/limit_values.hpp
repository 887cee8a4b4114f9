#pragma once
/// Exact values of the basic limit function.

#include <subcert/analysis/symbol/budget.hpp>
#include <subcert/analysis/symbol/mask.hpp>

namespace subcert {

/// values[i] = phi^(order)((first_index + i) / arity^level), for all grid points in the closed support.
struct LimitValues {
  int arity;
  int level;
  int order;
  long first_index;
  std::vector<Rational> values;

  /// The value at index / arity^level, 0 outside the support.
  Rational at(long index) const;
  Rational point(std::size_t i) const;
};

/// The values of the basic limit function or of its derivative of this order at the arity-adic points of this level.
/// Domain: the divided difference scheme of this order converges (decide with proved_smoothness(): order <= its order);
/// at most 1,500 integers inside the support, at most 10^7 values. Errors: throws Error, of kind domain where the
/// refinement equation does not determine the values at the integers, of kind size beyond the sizes, of kind undecided
/// past the deadline. Cost: one exact solution at the integers, then one product for each level. Ref: [DHHS15,
/// sec. 2.2].
LimitValues limit_values(const Mask& mask, int level, int order = 0, const Deadline& deadline = {});

/// [k] = the integral of phi(x) phi(x + k), k = 0, 1, ..., up to the last that is not zero for its support: the values
/// at the integers of the autocorrelation of phi, which the mask a(z) a(1/z) / arity refines.
/// Domain: the scheme converges. Errors: as limit_values. Cost: one exact solution of half the size of that mask.
std::vector<Rational> l2_inner_products(const Mask& mask, const Deadline& deadline = {});

/// The integral of phi^2, l2_inner_products(mask)[0].
Rational squared_l2_norm(const Mask& mask, const Deadline& deadline = {});

}  // namespace subcert
