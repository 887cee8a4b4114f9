#include "kernel_vector.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>

#include <algorithm>
#include <utility>

namespace subcert::vertex {
namespace {

using Vector = std::vector<CosineField::Number>;
using Matrix = std::vector<Vector>;

bool is_zero(const Vector& vector) {
  return std::ranges::all_of(vector, [](const CosineField::Number& entry) { return entry.is_zero(); });
}

/// Its first entry that is not 0 is 1. Domain: not 0.
Vector normed(Vector vector) {
  std::size_t first = 0;
  while (vector[first].is_zero()) ++first;
  const CosineField::Number inverse = vector[first].inverse();
  for (CosineField::Number& entry : vector) entry = inverse * entry;
  return vector;
}

Vector product(const Vector& row, const Matrix& matrix, const CosineField& field) {
  Vector result(matrix.size(), field.number(0));
  for (std::size_t i = 0; i < row.size(); ++i)
    if (!row[i].is_zero())
      for (std::size_t j = 0; j < result.size(); ++j) result[j] = result[j] + row[i] * matrix[i][j];
  return result;
}

Vector product(const Matrix& matrix, const Vector& column, const CosineField& field) {
  Vector result(matrix.size(), field.number(0));
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < column.size(); ++j) result[i] = result[i] + matrix[i][j] * column[j];
  return result;
}

/// A basis of the kernel.
std::vector<Vector> kernel(Matrix matrix, const CosineField& field) {
  const std::size_t n = matrix.size();
  const std::vector<std::size_t> pivots = reduce(matrix);
  std::vector<Vector> basis;
  for (std::size_t free = 0; free < n; ++free) {
    if (std::ranges::find(pivots, free) != pivots.end()) continue;
    basis.emplace_back(n, field.number(0));
    basis.back()[free] = field.number(1);
    for (std::size_t row = 0; row < pivots.size(); ++row) basis.back()[pivots[row]] = -matrix[row][free];
  }
  return basis;
}

}  // namespace

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

std::optional<std::vector<CosineField::Number>> kernel_vector(Matrix matrix, const CosineField& field) {
  std::vector<Vector> basis = kernel(std::move(matrix), field);
  if (basis.size() != 1) return std::nullopt;
  return normed(std::move(basis.front()));
}

NilpotentPart nilpotent_part(const Matrix& matrix, const CosineField& field) {
  const std::size_t n = matrix.size();
  Matrix power(n, Vector(n, field.number(0)));
  for (std::size_t i = 0; i < n; ++i) power[i][i] = field.number(1);
  NilpotentPart result{0, {}};
  for (std::size_t defect = 0; result.size <= n; ++result.size) {
    Matrix next;
    for (const Vector& row : power) next.push_back(product(row, matrix, field));
    const std::vector<Vector> ends = kernel(next, field);
    if (ends.size() == defect) break;
    result.last.clear();
    if (ends.size() == defect + 1)
      for (const Vector& end : ends)
        if (Vector image = product(power, end, field); !is_zero(image)) result.last = normed(std::move(image));
    defect = ends.size();
    power = std::move(next);
  }
  return result;
}

}  // namespace subcert::vertex
