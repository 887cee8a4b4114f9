#pragma once
/// Affine maps of the lattice that leave a polynomial unchanged.

#include <subcert/analysis/symbol/polynomials/multivariate_polynomial.hpp>
#include "dilation.hpp"

namespace subcert {

/// x -> linear x + shift.
struct LatticeMap {
  std::vector<LatticePoint> linear;  ///< rows
  LatticePoint shift;

  LatticePoint operator()(const LatticePoint& point) const;
  bool operator==(const LatticeMap& other) const { return linear == other.linear && shift == other.shift; }
};

/// The maps with entries -1, 0, 1 in the linear part that permute the exponents of p and keep the coefficients, the
/// identity first: a group. Larger entries occur only where the lattice is written in a slanted basis. Domain: p(1) !=
/// 0. Cost: 3^(s^2) candidates in s variables, nearly all dropped at the first coefficient.
std::vector<LatticeMap> lattice_symmetries(const MultivariatePolynomial& p);

/// The largest subgroup whose linear parts the dilation permutes, G -> M G M^-1. Domain: a group.
std::vector<LatticeMap> symmetries_along(std::vector<LatticeMap> group, const Dilation& dilation);

}  // namespace subcert
