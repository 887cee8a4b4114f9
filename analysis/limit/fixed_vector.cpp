#include "fixed_vector.hpp"

#include <subcert/analysis/symbol/error.hpp>
#include <subcert/analysis/symbol/lifted_solution.hpp>

namespace subcert {
namespace {

/// The solution with the sum of weights in place of the last equation, where that follows from the others.
std::optional<std::vector<Rational>> regular_solution(const RationalMatrix& matrix,
                                                      const std::vector<Rational>& weights, const Deadline& deadline) {
  const std::size_t last = matrix.rows() - 1;
  RationalMatrix regular = matrix;
  std::vector<Rational> right(matrix.rows(), 0);
  right[last] = 1;
  for (std::size_t j = 0; j <= last; ++j) regular(last, j) = weights[j];
  auto solution = lifted_solution(regular, right, deadline);
  if (!solution) return std::nullopt;
  Rational rest = 0;
  for (std::size_t j = 0; j <= last; ++j) rest += matrix(last, j) * (*solution)[j];
  return rest == 0 ? std::move(solution) : std::nullopt;
}

}  // namespace

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const std::vector<Rational>& weights,
                                                  const Deadline& deadline) {
  for (std::size_t i = 0; i < matrix.rows(); ++i) matrix(i, i) -= 1;
  if (matrix.rows() > 0)
    if (auto solution = regular_solution(matrix, weights, deadline)) return solution;
  if (deadline.expired())
    fail(ErrorKind::undecided, "the exact solution of {} refinement equations takes more than the budget",
         matrix.rows());
  auto basis = kernel(matrix);
  if (basis.size() != 1) return std::nullopt;
  std::vector<Rational> result = std::move(basis.front());
  Rational sum = 0;
  for (std::size_t i = 0; i < result.size(); ++i) sum += weights[i] * result[i];
  if (sum == 0) return std::nullopt;
  for (Rational& x : result) x /= sum;
  return result;
}

std::optional<std::vector<Rational>> fixed_vector(RationalMatrix matrix, const Rational& weight,
                                                  const Deadline& deadline) {
  std::vector<Rational> weights(matrix.rows(), weight);
  if (!weights.empty()) weights.front() = 1;
  return fixed_vector(std::move(matrix), weights, deadline);
}

}  // namespace subcert
