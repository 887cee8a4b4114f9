#include "rounded_regression.hpp"

#include <subcert/analysis/symbol/error.hpp>

#include <algorithm>
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
                                               int degree, double x, int derivative) {
  const std::size_t m = nodes.size();
  if (m == 0 || weights.size() != m || degree < 0 || derivative < 0)
    fail(ErrorKind::domain, "rounded_regression_weights: need nodes, as many weights, degree and derivative >= 0");
  degree = std::min(degree, static_cast<int>(m) - 1);
  if (static_cast<std::size_t>(degree) + 1 == m && derivative == 0) return interpolation_weights(nodes, x);
  // Orthonormal polynomials by Stieltjes' recurrence, as values at the nodes, and at x with their
  // derivatives.
  std::vector<double> previous(m, 0), current(m, 1), result(m, 0);
  std::vector<double> previous_x(static_cast<std::size_t>(derivative) + 1, 0), current_x = previous_x;
  current_x[0] = 1;
  double beta = 0;
  for (int k = 0;; ++k) {
    double norm = 0, moment = 0;
    for (std::size_t i = 0; i < m; ++i) {
      norm += weights[i] * current[i] * current[i];
      moment += weights[i] * current[i] * current[i] * nodes[i];
    }
    const double root = std::sqrt(norm), alpha = moment / norm;
    for (double& value : current) value /= root;
    for (double& value : current_x) value /= root;
    for (std::size_t i = 0; i < m; ++i) result[i] += weights[i] * current_x.back() * current[i];
    if (k == degree) return result;
    // The norm of the unnormed polynomial is the off-diagonal element of the recurrence.
    beta = k == 0 ? 0 : root;
    for (std::size_t i = 0; i < m; ++i) {
      const double next = (nodes[i] - alpha) * current[i] - beta * previous[i];
      previous[i] = current[i];
      current[i] = next;
    }
    for (std::size_t r = current_x.size(); r-- > 0;)
      previous_x[r] = (x - alpha) * current_x[r] - beta * previous_x[r] +
                      (r > 0 ? static_cast<double>(r) * current_x[r - 1] : 0);
    std::swap(previous_x, current_x);
  }
}

}  // namespace subcert::data
