#pragma once
/// Families of matrices whose entries are polynomials in one parameter, or quotients of them.

#include <subcert/analysis/symbol/matrix_family.hpp>
#include <subcert/analysis/symbol/parametric_mask.hpp>

#include <array>
#include <optional>

namespace subcert {

/// T_t(w) = sum over k of w^k powers[t][k] / denominator(w). Canonical: as many powers for each t, square matrices of
/// one size.
struct ParametricFamily {
  std::vector<std::vector<RationalMatrix>> powers;
  LaurentPolynomial denominator = 1;
  int degree = 0;  ///< in w, of numerators and denominator

  std::size_t size() const { return powers.front().front().rows(); }
  std::size_t count() const { return powers.size(); }

  /// T_t(w) times the denominator.
  MatrixFamily numerators_at(const Rational& w) const;
  /// Domain: the denominator is not zero there.
  MatrixFamily at(const Rational& w) const;
  /// With the Bernstein polynomials B_i of [low, high], which are not negative, numerator and denominator are sums of
  /// B_i(w) N_{t,i} and B_i(w) q_i. Where all q_i are positive T_t(w) is in the convex hull of the C_{t,i} =
  /// N_{t,i}/q_i for each w, so that the joint spectral radius is at most that of the family of all C_{t,i}. Nothing
  /// where some q_i is not positive.
  std::optional<MatrixFamily> controls(const Rational& low, const Rational& high) const;
};

/// Matrices with entries that are polynomials in v and w: the factor of v^i w^j is powers[t][i + columns * j].
/// Canonical: as many powers for each t, a multiple of `columns`; square matrices of one size.
struct BiparametricFamily {
  std::vector<std::vector<RationalMatrix>> powers;
  std::size_t columns;

  std::size_t size() const { return powers.front().front().rows(); }
  /// One more than the degree in w.
  std::size_t rows() const { return powers.front().size() / columns; }
  /// The family in v for one w.
  ParametricFamily slice(const Rational& w) const;
  /// As those of one parameter, with products of two Bernstein polynomials.
  MatrixFamily controls(const std::array<Rational, 2>& low, const std::array<Rational, 2>& high) const;
};

/// [i][k]: the factor of w^k in the i-th Bernstein coefficient of degree n on [low, high].
std::vector<std::vector<Rational>> bernstein_factors(long n, const Rational& low, const Rational& high);

/// Those of transition_matrices(mask.at(w)), on a window that holds all coefficients for all w; the denominator is
/// positive at `inside`.
ParametricFamily transition_matrices(const ParametricMask& mask, const Rational& inside);

/// The one matrix central_matrix(b(z) b(1/z)) for b = mask.at(w), which gives the Sobolev exponent.
ParametricFamily central_matrices(const ParametricMask& mask);

}  // namespace subcert
