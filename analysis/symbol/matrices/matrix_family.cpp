#include "matrix_family.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <numeric>

namespace subcert {
namespace {

bool is_flipped_by_reversal(const std::vector<RationalMatrix>& matrices) {
  const std::size_t n = matrices.front().rows(), count = matrices.size();
  for (std::size_t t = 0; t < count; ++t)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (matrices[t](n - 1 - i, n - 1 - j) != matrices[count - 1 - t](i, j)) return false;
  return true;
}

std::vector<std::size_t> in_order(std::size_t size) {
  std::vector<std::size_t> result(size);
  std::iota(result.begin(), result.end(), std::size_t{0});
  return result;
}

}  // namespace

SparseMap::SparseMap(const RationalMatrix& matrix) : rows_(matrix.rows()) {
  require(matrix.rows() == matrix.columns(), "sparse map: need a square matrix, got {} x {}", matrix.rows(),
          matrix.columns());
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j) {
      const Rational& entry = matrix(i, j);
      if (entry == 0) continue;
      require(denominator(entry) == 1 && abs(entry) < Rational(1L << 62), "sparse map: need integer entries, got {}",
              entry);
      rows_[i].emplace_back(j, numerator(entry).convert_to<long>());
    }
}

SparseMap SparseMap::identity(std::size_t size) {
  SparseMap result(size);
  for (std::size_t i = 0; i < size; ++i) result.rows_[i].emplace_back(i, 1);
  return result;
}

SparseMap SparseMap::reversal(std::size_t size) {
  SparseMap result(size);
  for (std::size_t i = 0; i < size; ++i) result.rows_[i].emplace_back(size - 1 - i, 1);
  return result;
}

RationalMatrix SparseMap::matrix() const {
  RationalMatrix result(size(), size());
  for (std::size_t i = 0; i < size(); ++i)
    for (const auto& [j, entry] : rows_[i]) result(i, j) = entry;
  return result;
}

SparseMap SparseMap::inverse() const {
  if (*this == reversal(size())) return *this;
  return SparseMap(solve(matrix(), RationalMatrix::identity(size())));
}

SparseMap SparseMap::transposed() const {
  SparseMap result(size());
  for (std::size_t i = 0; i < size(); ++i)
    for (const auto& [j, entry] : rows_[i]) result.rows_[j].emplace_back(i, entry);
  return result;
}

MatrixFamily::MatrixFamily(std::vector<RationalMatrix> matrices) : matrices_(std::move(matrices)) {
  require(!matrices_.empty(), "matrix family: need at least one matrix, got none");
  require(size() >= 1, "matrix family: need matrices of size 1 or more, got {}", size());
  for (const RationalMatrix& m : matrices_)
    require(m.rows() == size() && m.columns() == size(), "matrix family: need square matrices of one size, got {} x {}",
            m.rows(), m.columns());
  group_.push_back({SparseMap::identity(size()), in_order(count())});
  if (!is_flipped_by_reversal(matrices_)) return;
  group_.push_back({SparseMap::reversal(size()), in_order(count())});
  std::reverse(group_.back().letters.begin(), group_.back().letters.end());
}

MatrixFamily::MatrixFamily(std::vector<RationalMatrix> matrices, std::vector<FamilySymmetry> group)
    : matrices_(std::move(matrices)), group_(std::move(group)) {}

bool MatrixFamily::is_flip_symmetric() const {
  if (group_.size() != 2 || !(group_[1].map == SparseMap::reversal(size()))) return false;
  // Where equal matrices were merged the reversal of the coordinates may permute them in another order.
  std::vector<std::size_t> letters = group_[1].letters;
  std::reverse(letters.begin(), letters.end());
  return letters == in_order(count());
}

RationalMatrix MatrixFamily::product(const std::vector<int>& word) const { return *product(word, Deadline::never()); }

std::optional<RationalMatrix> MatrixFamily::product(const std::vector<int>& word, const Deadline& deadline) const {
  const auto of_letters = [&](auto& self, std::size_t first, std::size_t count) -> std::optional<RationalMatrix> {
    if (count == 1) return matrices_[static_cast<std::size_t>(word[first])];
    const auto left = self(self, first, count / 2);
    const auto right = left ? self(self, first + count / 2, count - count / 2) : std::nullopt;
    return right && !deadline.expired() ? std::optional(*left * *right) : std::nullopt;
  };
  return of_letters(of_letters, 0, word.size());
}

Integer common_denominator(const MatrixFamily& family) {
  Integer result = 1;
  for (const RationalMatrix& m : family) result = lcm(result, common_denominator(m));
  return result;
}

bool is_nonnegative(const MatrixFamily& family) {
  for (const RationalMatrix& matrix : family)
    for (std::size_t i = 0; i < matrix.rows(); ++i)
      for (std::size_t j = 0; j < matrix.columns(); ++j)
        if (matrix(i, j) < 0) return false;
  return true;
}

MatrixFamily transposed(const MatrixFamily& family) {
  std::vector<RationalMatrix> matrices;
  for (const RationalMatrix& m : family) matrices.push_back(transposed(m));
  std::vector<FamilySymmetry> group;
  for (const FamilySymmetry& element : family.group())
    group.push_back({element.map.inverse().transposed(), element.letters});
  return {std::move(matrices), std::move(group)};
}

MatrixFamily operator*(const Rational& factor, const MatrixFamily& family) {
  std::vector<RationalMatrix> matrices;
  for (const RationalMatrix& m : family) matrices.push_back(factor * m);
  return {std::move(matrices), family.group()};
}

}  // namespace subcert
