#include "fixed_vector.hpp"

namespace subcert {

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const Rational& weight) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) matrix(i, i) -= 1;
  auto basis = kernel(matrix);
  if (basis.size() != 1) return std::nullopt;
  std::vector<Rational> result = std::move(basis.front());
  Rational sum = result.front();
  for (std::size_t i = 1; i < result.size(); ++i) sum += weight * result[i];
  if (sum == 0) return std::nullopt;
  for (Rational& x : result) x /= sum;
  return result;
}

}  // namespace subcert
