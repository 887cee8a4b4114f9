#pragma once
/// Where rows, or faces, stand in their file.

#include <cstddef>
#include <utility>
#include <vector>

namespace subcert::data {

/// Memory: that of the places where lines between rows are left out.
class RowLines {
 public:
  /// Of the next row.
  void add(std::size_t line);
  /// Domain: row < rows().
  std::size_t at(std::size_t row) const;
  std::size_t rows() const { return rows_; }

 private:
  std::vector<std::pair<std::size_t, std::size_t>> runs_;  // first row, its line
  std::size_t rows_ = 0;
};

}  // namespace subcert::data
