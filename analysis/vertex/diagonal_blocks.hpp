#pragma once
/// The blocks of a matrix and their characteristic polynomials, over any ring. Inner header.

#include <subcert/analysis/symbol/polynomials/laurent_polynomial.hpp>

#include <vector>

namespace subcert::vertex {

using Unknowns = std::vector<std::size_t>;

/// The strongly connected components: unknowns that depend on each other. In their order the matrix is triangular, with
/// their blocks on the diagonal.
template <class Matrix, class IsZero>
std::vector<Unknowns> diagonal_blocks(const Matrix& matrix, const IsZero& is_zero) {
  const std::size_t n = matrix.size();
  std::vector<std::vector<bool>> reaches(n, std::vector<bool>(n, false));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) reaches[i][j] = i == j || !is_zero(matrix[i][j]);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (reaches[i][k] && reaches[k][j]) reaches[i][j] = true;
  std::vector<Unknowns> blocks;
  std::vector<bool> done(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    if (done[i]) continue;
    blocks.emplace_back();
    for (std::size_t j = i; j < n; ++j)
      if (reaches[i][j] && reaches[j][i]) {
        done[j] = true;
        blocks.back().push_back(j);
      }
  }
  return blocks;
}

template <class Number>
std::vector<std::vector<Number>> restricted(const std::vector<std::vector<Number>>& matrix, const Unknowns& block) {
  std::vector<std::vector<Number>> result;
  for (const std::size_t i : block) {
    result.emplace_back();
    for (const std::size_t j : block) result.back().push_back(matrix[i][j]);
  }
  return result;
}

/// det(x - matrix), the lowest coefficient first. Domain: square; the ring holds the rational numbers and tells zeros.
/// Cost: a product of matrices per row.
template <class Ring>
std::vector<typename Ring::Number> characteristic_polynomial(
    const std::vector<std::vector<typename Ring::Number>>& matrix, const Ring& ring) {
  // M_1 = A, c_j = -tr(M_j)/j, M_(j+1) = A (M_j + c_j) [Faddeev and LeVerrier].
  using Number = typename Ring::Number;
  const std::size_t n = matrix.size();
  std::vector<Number> result(n + 1, ring.number(1));
  auto product = matrix;
  for (std::size_t j = 1; j <= n; ++j) {
    Number trace = ring.number(0);
    for (std::size_t i = 0; i < n; ++i) trace = trace + product[i][i];
    result[n - j] = ring.number(LaurentPolynomial(Rational(-1) / Rational(static_cast<long>(j)))) * trace;
    if (j == n) break;
    for (std::size_t i = 0; i < n; ++i) product[i][i] = product[i][i] + result[n - j];
    auto next = matrix;
    for (std::size_t r = 0; r < n; ++r)
      for (std::size_t c = 0; c < n; ++c) {
        next[r][c] = ring.number(0);
        for (std::size_t k = 0; k < n; ++k)
          if (!matrix[r][k].is_zero() && !product[k][c].is_zero())
            next[r][c] = next[r][c] + matrix[r][k] * product[k][c];
      }
    product = std::move(next);
  }
  return result;
}

}  // namespace subcert::vertex
