#pragma once
/// Setup: what the cells of one mask share, exactly or in balls (docs/limit-enclosures.md, sections 1 to 3).
///   setup   cell_setup   the scheme that contracts, phi in balls, its interpolating polynomials, the sources
///   bounds  cell_bounds  the remainders, in doubles with proved errors
///   walk    limit_cells  forms on cells, their children, the ranges they prove

#include <subcert/analysis/outward_rounding/outward.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/transition/ball_transition.hpp>

#include <string>
#include <vector>

namespace subcert::cells {

inline constexpr std::size_t most_nodes = 9;

/// A divided difference scheme S_[m] one of whose powers contracts: norms[j] >= ||S_[m]^j||, and the norm of some j is
/// below arity^j.
struct Contraction {
  int order = 0;       // m: 2 where C^1 is proved, else 1
  std::string reason;  // why not C^1
  std::vector<double> norms;

  /// Above ||S_[m]^level||, by the submultiplicativity of norms.
  double norm_bound(int level) const;
};

/// v between its values at nodes of [0, 1], in powers of u = x - 1/2.
struct Interpolation {
  std::size_t degree = 0;
  std::vector<std::int64_t> node;                  // degree + 1 of them, node / arity^node_level, 0 and 1 included
  std::vector<BallVector> lagrange;                // lagrange[s][j]: coefficient of u^j in the s-th basis polynomial
  std::vector<BallVector> at_nodes;                // v at the nodes
  std::vector<outward::VectorPolynomial> sources;  // k_t

  std::size_t nodes() const { return degree + 1; }
  /// The coefficients of the polynomial with these values at the nodes.
  std::vector<BallVector> polynomial(const std::vector<BallVector>& values, slong bits) const;
};

/// v(x) = (phi(first + x), ..., phi(first + width - 1 + x)), 0 <= x <= 1.
struct CellSetup {
  CellSetup(const Mask& given, const Deadline& deadline);

  Mask mask;
  int arity;
  bool mirrored;  // psi(x) = psi(1 - x)
  Contraction contraction;
  int node_level;
  RefinementWindow window;
  std::size_t width;
  slong bits;
  Transition<Ball> refine;
  BallVector at_zero;  // v(0)

  int order() const { return contraction.order; }
  /// Of the vectors on which S_[m] acts.
  std::size_t rows_width() const { return width - static_cast<std::size_t>(contraction.order); }
  /// v(index / arity^level), 0 <= index <= arity^level.
  BallVector values(std::int64_t index, int level) const;
  /// Nodes near those of Chebyshev; no sources yet.
  Interpolation interpolation(std::size_t degree) const;
  /// k_t = sum over s of basis_s eta((t + node_s) / arity), where the m-th difference of eta is v minus its
  /// interpolating polynomial.
  std::vector<outward::VectorPolynomial> sources(const Interpolation& in) const;
  /// Whether v agrees with its interpolating polynomial at all nodes of all children, exactly.
  bool is_piecewise_polynomial(const Interpolation& in, const Deadline& deadline) const;

 private:
  Rational node_point(const Interpolation& in, std::size_t s) const;
};

/// The middle as a double; what is missing is added to `error`.
double to_double(const Ball& ball, double& error);

}  // namespace subcert::cells
