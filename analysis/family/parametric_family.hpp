#pragma once
/// Families of matrices whose entries are polynomials in one parameter.

#include <subcert/analysis/symbol/matrix_family.hpp>
#include <subcert/analysis/symbol/parametric_mask.hpp>

namespace subcert {

/// T_t(w) = sum over k of w^k powers[t][k]. Canonical: as many powers for each t, square matrices of one size.
struct ParametricFamily {
  std::vector<std::vector<RationalMatrix>> powers;

  std::size_t size() const { return powers.front().front().rows(); }
  int degree() const { return static_cast<int>(powers.front().size()) - 1; }
  std::size_t count() const { return powers.size(); }

  MatrixFamily at(const Rational& w) const;
  /// T_t(w) = sum over i of B_i(w) C_{t,i} with the Bernstein polynomials B_i of [low, high], which are not negative
  /// and sum to 1: for each w there the T_t(w) lie in the convex hull of the C_{t,i}, so that their joint spectral
  /// radius is at most that of the family of all C_{t,i}.
  MatrixFamily controls(const Rational& low, const Rational& high) const;
};

/// Those of transition_matrices(mask.at(w)), on a window that holds all coefficients for all w.
ParametricFamily transition_matrices(const ParametricMask& mask);

}  // namespace subcert
