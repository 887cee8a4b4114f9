#pragma once
/// Local l1 regression by iteratively reweighted least squares: the fit behind the data-dependent schemes.

#include "least_absolute_fit.hpp"

#include <subcert/analysis/symbol/numbers/numbers.hpp>
#include <subcert/schemes/l1_scheme.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace subcert::data {

/// Where a datum or an output stands: a coordinate for each variable, in spacings of the data.
using Position = std::vector<Rational>;

/// Data positions, polynomials and the positions at which a fit is evaluated, with a basis of the polynomials that is
/// orthogonal on the data positions. Canonical: the first basis polynomial is 1, each has largest modulus 1 on `nodes`.
class RegressionWindow {
 public:
  /// Polynomials of total degree at most `degree` in the coordinates that are not the same for all nodes.
  /// Domain: degree 0, ..., 3; at least one output; as many coordinates everywhere; the nodes determine the
  /// polynomials. Errors: throws a domain error that names the broken inequality.
  RegressionWindow(std::vector<Position> nodes, int degree, std::vector<Position> outputs);

  std::size_t nodes() const { return nodes_.size(); }
  std::size_t outputs() const { return outputs_.size(); }
  /// The number of basis polynomials.
  std::size_t terms() const { return at_nodes_.size(); }
  int degree() const { return degree_; }
  const std::vector<Position>& node_points() const { return nodes_; }
  const std::vector<Position>& output_points() const { return outputs_; }

  /// [k][i]: the k-th basis polynomial at node i, at output i.
  const std::vector<std::vector<Rational>>& at_nodes() const { return at_nodes_; }
  const std::vector<std::vector<Rational>>& at_outputs() const { return at_outputs_; }

 private:
  std::vector<Position> nodes_;
  std::vector<Position> outputs_;
  int degree_;
  std::vector<std::vector<Rational>> at_nodes_;
  std::vector<std::vector<Rational>> at_outputs_;
};

/// The exact fit with given weights, evaluated at the outputs: minimises sum of weights[i] (p(node_i) - data[i])^2.
/// Domain: as many positive weights and data as nodes. Errors: throws a domain error.
std::vector<Rational> weighted_fit(const RegressionWindow& window, const std::vector<Rational>& weights,
                                   const std::vector<Rational>& data);

/// Fits many windows of one shape in double precision.
class L1Fitter {
 public:
  /// Domain: delta > 0, iterations >= 0, tolerance >= 0; exact: at most 64 nodes of a line at distance 1 in increasing
  /// order, separate residuals. Errors: throws a domain error.
  L1Fitter(const RegressionWindow& window, const L1Options& options);

  const RegressionWindow& window() const { return window_; }
  const L1Options& options() const { return options_; }

  /// Windows that are fitted side by side: the width of a register of 256 bits.
  static constexpr std::size_t lanes = 4;

  /// Intermediate values of one thread; sized at its first use.
  class Workspace {
    friend class L1Fitter;
    std::vector<double> storage_;
  };

  /// Fits `lanes` windows of points with `dimension` coordinates: data[(c * nodes + i) * lanes + l] is coordinate c of
  /// the datum at node i of window l, out[(c * outputs + o) * lanes + l] the fit. A window's result does not depend on
  /// the others. Domain: finite data, refused otherwise where the fit is exact; where |residual| exceeds 1e150, or
  /// sqrt(delta) times 1e13, weights lose their meaning in double precision (docs/l1.md). Cost: (iterations + 1) *
  /// nodes * terms^2 operations for each coordinate and window.
  void fit(const double* data, std::size_t dimension, double* out, Workspace& workspace) const;

  /// One window: data[i * dimension + c] to the fits at out[o * dimension + c].
  std::vector<double> fit(const std::vector<double>& data, std::size_t dimension = 1) const;

  /// Smoothed objective: the sum over nodes and coordinates of (r^2 + delta)^(1/2), joint residuals summed over nodes,
  /// for the polynomials with values `fitted` at the nodes, both ordered as in fit(). Ref: [MLZD15, eq. (2)].
  double objective(const std::vector<double>& data, const std::vector<double>& fitted, std::size_t dimension = 1) const;

 private:
  void fit_exactly(const double* data, std::size_t dimension, double* out) const;

  RegressionWindow window_;
  L1Options options_;
  std::vector<double> at_nodes_;    // [k][i]
  std::vector<double> at_outputs_;  // [k][o]
  std::vector<double> inverse_norms_;
  std::optional<LeastAbsoluteFitter> exact_;
};

}  // namespace subcert::data
