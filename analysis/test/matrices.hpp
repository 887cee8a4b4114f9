#pragma once
/// Matrices as they are written.

#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>

#include <initializer_list>

namespace subcert::testing {

/// Of square matrices: row by row.
inline RationalMatrix square_matrix(std::initializer_list<std::initializer_list<Rational>> rows) {
  RationalMatrix result(rows.size(), rows.size());
  std::size_t i = 0;
  for (const auto& row : rows) {
    std::size_t j = 0;
    for (const Rational& entry : row) result(i, j++) = entry;
    ++i;
  }
  return result;
}

}  // namespace subcert::testing
