#include "l1_regression.hpp"

#include "reweighted_step.hpp"

#include <subcert/analysis/symbol/masks/dilation.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>

namespace subcert::data {
namespace {

constexpr int max_degree = 3;

/// The coordinates in which the nodes differ.
std::vector<std::size_t> free_coordinates(const std::vector<Position>& nodes) {
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < nodes.front().size(); ++v)
    if (std::any_of(nodes.begin(), nodes.end(), [&](const Position& node) { return node[v] != nodes.front()[v]; }))
      result.push_back(v);
  return result;
}

/// The monomials of total degree at most `degree` in these coordinates at the points, lower degrees first; about the
/// centre.
std::vector<std::vector<Rational>> monomials(const std::vector<Position>& points, int degree,
                                             const std::vector<std::size_t>& coordinates, const Position& centre) {
  std::vector<std::vector<Rational>> result;
  for (int total = 0; total <= (coordinates.empty() ? 0 : degree); ++total) {
    std::vector<LatticePoint> exponents{{}};
    if (!coordinates.empty()) exponents = exponents_of_degree(coordinates.size(), total);
    std::reverse(exponents.begin(), exponents.end());
    for (const LatticePoint& powers : exponents) {
      std::vector<Rational> values;
      for (const Position& p : points) {
        Rational value = 1;
        for (std::size_t k = 0; k < coordinates.size(); ++k)
          value *= power(p[coordinates[k]] - centre[coordinates[k]], powers[k]);
        values.push_back(value);
      }
      result.push_back(std::move(values));
    }
  }
  return result;
}

Rational dot(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void subtract(std::vector<Rational>& a, const Rational& factor, const std::vector<Rational>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= factor * b[i];
}

Position centre(const std::vector<Position>& nodes) {
  Position sum(nodes.front().size(), 0);
  for (const Position& node : nodes)
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += node[v] / Rational(nodes.size());
  return sum;
}

}  // namespace

RegressionWindow::RegressionWindow(std::vector<Position> nodes, int degree, std::vector<Position> outputs)
    : nodes_(std::move(nodes)), outputs_(std::move(outputs)), degree_(degree) {
  if (degree < 0 || degree > max_degree)
    fail(ErrorKind::domain, "RegressionWindow: need 0 <= degree <= 3, got {}", degree);
  if (nodes_.empty() || outputs_.empty())
    fail(ErrorKind::domain, "RegressionWindow: need at least one node and one output");
  for (const auto* points : {&nodes_, &outputs_})
    for (const Position& point : *points)
      require(point.size() == nodes_.front().size(), "RegressionWindow: need {} coordinates everywhere, got {}",
              nodes_.front().size(), point.size());
  const std::vector<std::size_t> coordinates = free_coordinates(nodes_);
  const Position c = centre(nodes_);
  at_nodes_ = monomials(nodes_, degree, coordinates, c);
  at_outputs_ = monomials(outputs_, degree, coordinates, c);
  for (std::size_t k = 0; k < at_nodes_.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l) {
      const Rational factor = dot(at_nodes_[k], at_nodes_[l]) / dot(at_nodes_[l], at_nodes_[l]);
      subtract(at_nodes_[k], factor, at_nodes_[l]);
      subtract(at_outputs_[k], factor, at_outputs_[l]);
    }
    Rational largest = 0;
    for (const Rational& value : at_nodes_[k]) largest = std::max(largest, Rational(abs(value)));
    require(largest != 0, "RegressionWindow: need nodes that determine polynomials of degree {}, got {} nodes", degree,
            nodes_.size());
    for (Rational& value : at_nodes_[k]) value /= largest;
    for (Rational& value : at_outputs_[k]) value /= largest;
  }
}

namespace {

/// The exact fitter of a window of a line.
LeastAbsoluteFitter exact_fitter(const RegressionWindow& window) {
  const std::vector<Position>& nodes = window.node_points();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    require(nodes[i].size() == 1 && nodes[i][0] == nodes[0][0] + Rational(i),
            "L1Fitter: exact fits need nodes of a line at distance 1");
  std::vector<Rational> outputs;
  for (const Position& output : window.output_points()) outputs.push_back(output[0] - nodes[0][0]);
  return {static_cast<int>(nodes.size()), window.degree(), std::move(outputs)};
}

template <class Number>
std::vector<Number> flat(const std::vector<std::vector<Rational>>& rows) {
  std::vector<Number> result;
  for (const auto& row : rows)
    for (const Rational& value : row) result.push_back(static_cast<Number>(value));
  return result;
}

}  // namespace

std::vector<Rational> weighted_fit(const RegressionWindow& window, const std::vector<Rational>& weights,
                                   const std::vector<Rational>& data) {
  if (weights.size() != window.nodes() || data.size() != window.nodes())
    fail(ErrorKind::domain, "weighted_fit: need as many weights and data as nodes, got {} and {} for {}",
         weights.size(), data.size(), window.nodes());
  require(std::all_of(weights.begin(), weights.end(), [](const Rational& w) { return w > 0; }),
          "weighted_fit: need weights > 0");
  std::vector<Rational> at_nodes = flat<Rational>(window.at_nodes()), at_outputs = flat<Rational>(window.at_outputs());
  std::vector<Rational> residuals = data, fits(window.outputs(), 0);
  project<Rational>({window.nodes(), window.outputs(), window.terms(), 1, weights.data(), at_nodes.data(),
                     at_outputs.data(), residuals.data(), fits.data()},
                    Rational(0), [](const Rational& norm) { return norm == 0 ? Rational(0) : Rational(1 / norm); });
  return fits;
}

L1Fitter::L1Fitter(const RegressionWindow& window, const L1Options& options)
    : window_(window),
      options_(options),
      at_nodes_(flat<double>(window.at_nodes())),
      at_outputs_(flat<double>(window.at_outputs())) {
  if (!(options.delta > 0) || !std::isfinite(options.delta))
    fail(ErrorKind::domain, "L1Fitter: need a finite delta > 0, got {}", options.delta);
  require(options.iterations >= 0, "L1Fitter: need iterations >= 0, got {}", options.iterations);
  require(options.tolerance >= 0, "L1Fitter: need tolerance >= 0, got {}", options.tolerance);
  for (const auto& row : window.at_nodes()) inverse_norms_.push_back(static_cast<double>(Rational(1 / dot(row, row))));
  if (!options.exact) return;
  require(!options.joint_residuals, "L1Fitter: exact fits need separate residuals");
  exact_ = exact_fitter(window);
}

void L1Fitter::fit_exactly(const double* data, std::size_t dimension, double* out) const {
  const std::size_t nodes = window_.nodes(), outputs = window_.outputs();
  std::vector<double> in(nodes), fits(outputs);
  for (std::size_t c = 0; c < dimension; ++c)
    for (std::size_t l = 0; l < lanes; ++l) {
      for (std::size_t i = 0; i < nodes; ++i) in[i] = data[(c * nodes + i) * lanes + l];
      exact_->fit(in.data(), fits.data());
      for (std::size_t o = 0; o < outputs; ++o) out[(c * outputs + o) * lanes + l] = fits[o];
    }
}

std::vector<double> L1Fitter::fit(const std::vector<double>& data, std::size_t dimension) const {
  const std::size_t nodes = window_.nodes(), outputs = window_.outputs();
  if (dimension == 0 || data.size() != nodes * dimension)
    fail(ErrorKind::domain, "L1Fitter::fit: need nodes * dimension = {} data, got {}", nodes * dimension, data.size());
  std::vector<double> in(nodes * dimension * lanes), out(outputs * dimension * lanes), result(outputs * dimension);
  for (std::size_t i = 0; i < nodes; ++i)
    for (std::size_t c = 0; c < dimension; ++c)
      std::fill_n(in.begin() + static_cast<std::ptrdiff_t>((c * nodes + i) * lanes), lanes, data[i * dimension + c]);
  Workspace workspace;
  fit(in.data(), dimension, out.data(), workspace);
  for (std::size_t o = 0; o < outputs; ++o)
    for (std::size_t c = 0; c < dimension; ++c) result[o * dimension + c] = out[(c * outputs + o) * lanes];
  return result;
}

double L1Fitter::objective(const std::vector<double>& data, const std::vector<double>& fitted,
                           std::size_t dimension) const {
  double sum = 0;
  for (std::size_t i = 0; i < window_.nodes(); ++i) {
    double square = 0;
    for (std::size_t c = 0; c < dimension; ++c) {
      const double r = data[i * dimension + c] - fitted[i * dimension + c];
      square += r * r;
      if (!options_.joint_residuals) sum += std::sqrt(r * r + options_.delta);
    }
    if (options_.joint_residuals) sum += std::sqrt(square + options_.delta);
  }
  return sum;
}

}  // namespace subcert::data
