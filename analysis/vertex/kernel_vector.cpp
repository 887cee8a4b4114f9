#include "kernel_vector.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>

#include <utility>

namespace subcert::vertex {

std::optional<std::vector<Ball>> kernel_vector(const std::vector<std::vector<Ball>>& matrix, const BallField& field) {
  const std::size_t n = matrix.size();
  const slong bits = field.bits();
  if (n == 1) return std::vector<Ball>{Ball(1, bits)};
  for (std::size_t one = 0; one < n; ++one)
    for (std::size_t dropped = n; dropped-- > 0;) {
      std::vector<std::vector<Ball>> rows;
      std::vector<Ball> right;
      for (std::size_t i = 0; i < n; ++i) {
        if (i == dropped) continue;
        rows.emplace_back();
        for (std::size_t j = 0; j < n; ++j)
          if (j != one) rows.back().push_back(matrix[i][j]);
        right.push_back(-matrix[i][one]);
      }
      auto solution = solve(rows, right, bits);
      if (!solution) continue;
      solution->insert(solution->begin() + static_cast<std::ptrdiff_t>(one), Ball(1, bits));
      return solution;
    }
  return std::nullopt;
}

std::optional<std::vector<CosineField::Number>> kernel_vector(std::vector<std::vector<CosineField::Number>> matrix,
                                                              const CosineField& field) {
  const std::size_t n = matrix.size();
  const std::vector<std::size_t> pivots = reduce(matrix);
  if (pivots.size() + 1 != n) return std::nullopt;
  std::size_t free = 0;
  while (free < pivots.size() && pivots[free] == free) ++free;
  std::vector<CosineField::Number> result(n, field.number(0));
  result[free] = field.number(1);
  for (std::size_t row = 0; row < pivots.size(); ++row) result[pivots[row]] = -matrix[row][free];
  std::size_t first = 0;
  while (result[first].is_zero()) ++first;
  const CosineField::Number inverse = result[first].inverse();
  for (CosineField::Number& entry : result) entry = inverse * entry;
  return result;
}

}  // namespace subcert::vertex
