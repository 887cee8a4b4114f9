#include "fixed_vector.hpp"

namespace subcert {

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const std::vector<Rational>& weights) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) matrix(i, i) -= 1;
  auto basis = kernel(matrix);
  if (basis.size() != 1) return std::nullopt;
  std::vector<Rational> result = std::move(basis.front());
  Rational sum = 0;
  for (std::size_t i = 0; i < result.size(); ++i) sum += weights[i] * result[i];
  if (sum == 0) return std::nullopt;
  for (Rational& x : result) x /= sum;
  return result;
}

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const Rational& weight) {
  std::vector<Rational> weights(matrix.rows(), weight);
  if (!weights.empty()) weights.front() = 1;
  return fixed_vector(std::move(matrix), weights);
}

}  // namespace subcert
