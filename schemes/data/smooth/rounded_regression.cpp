#include "rounded_regression.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <cmath>

namespace subcert::data {
namespace {

std::vector<double> interpolation_weights(const std::vector<double>& nodes, double x) {
  std::vector<double> result;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    double weight = 1;
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i) weight *= (x - nodes[j]) / (nodes[i] - nodes[j]);
    result.push_back(weight);
  }
  return result;
}

}  // namespace

std::vector<double> rounded_regression_weights(const std::vector<double>& nodes, const std::vector<double>& weights,
                                               int degree, double x) {
  const std::size_t m = nodes.size();
  if (m == 0 || weights.size() != m || degree < 0)
    fail(ErrorKind::domain, "rounded_regression_weights: need nodes, as many weights, and degree >= 0");
  if (static_cast<std::size_t>(degree) + 1 >= m) return interpolation_weights(nodes, x);
  // Orthonormal polynomials by Stieltjes' recurrence, as values at the nodes and at x.
  std::vector<double> previous(m, 0), current(m, 1), result(m, 0);
  double previous_x = 0, current_x = 1, beta = 0;
  for (int k = 0;; ++k) {
    double norm = 0, moment = 0;
    for (std::size_t i = 0; i < m; ++i) {
      norm += weights[i] * current[i] * current[i];
      moment += weights[i] * current[i] * current[i] * nodes[i];
    }
    const double root = std::sqrt(norm), alpha = moment / norm;
    for (double& value : current) value /= root;
    current_x /= root;
    for (std::size_t i = 0; i < m; ++i) result[i] += weights[i] * current_x * current[i];
    if (k == degree) return result;
    // The norm of the unnormed polynomial is the off-diagonal element of the recurrence.
    beta = k == 0 ? 0 : root;
    for (std::size_t i = 0; i < m; ++i) {
      const double next = (nodes[i] - alpha) * current[i] - beta * previous[i];
      previous[i] = current[i];
      current[i] = next;
    }
    const double next_x = (x - alpha) * current_x - beta * previous_x;
    previous_x = current_x;
    current_x = next_x;
  }
}

}  // namespace subcert::data
