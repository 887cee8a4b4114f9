#include "fixed_vector.hpp"

#include <subcert/analysis/symbol/error.hpp>

namespace subcert {
namespace {

constexpr std::size_t small_size = 30;  // up to which an elimination is as fast

/// The solution with the weights in place of the last row, which is mostly a combination of the others; nothing where
/// it is not, or where that matrix is singular. Where there is one there is no other: the other rows have one solution
/// up to a factor.
std::optional<std::vector<Rational>> solution(const RationalMatrix& matrix, const std::vector<Rational>& weights) {
  const std::size_t n = matrix.rows(), last = n - 1;
  RationalMatrix left = matrix, right(n, 1);
  for (std::size_t j = 0; j < n; ++j) left(last, j) = weights[j];
  right(last, 0) = 1;
  try {
    right = solve(left, right);
  } catch (const Error&) {  // singular
    return std::nullopt;
  }
  Rational rest = 0;
  std::vector<Rational> result;
  for (std::size_t j = 0; j < n; ++j) {
    rest += matrix(last, j) * right(j, 0);
    result.push_back(right(j, 0));
  }
  return rest == 0 ? std::optional(std::move(result)) : std::nullopt;
}

}  // namespace

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const std::vector<Rational>& weights) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) matrix(i, i) -= 1;
  if (matrix.rows() > small_size)
    if (auto found = solution(matrix, weights)) return found;
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
