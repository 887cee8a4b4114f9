#include "matrix_family.hpp"

#include "error.hpp"

#include <algorithm>

namespace subcert {
namespace {

bool permutes(const std::vector<RationalMatrix>& matrices, const FamilySymmetry& symmetry) {
  const std::size_t n = matrices.front().rows();
  for (std::size_t t = 0; t < matrices.size(); ++t)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (matrices[t](symmetry.coordinates[i], symmetry.coordinates[j]) != matrices[symmetry.letters[t]](i, j))
          return false;
  return true;
}

std::vector<std::size_t> reversal(std::size_t size) {
  std::vector<std::size_t> result(size);
  for (std::size_t i = 0; i < size; ++i) result[i] = size - 1 - i;
  return result;
}

}  // namespace

MatrixFamily::MatrixFamily(std::vector<RationalMatrix> matrices) : matrices_(std::move(matrices)) {
  require(!matrices_.empty(), "matrix family: need at least one matrix, got none");
  require(size() >= 1, "matrix family: need matrices of size 1 or more, got {}", size());
  for (const RationalMatrix& m : matrices_)
    require(m.rows() == size() && m.columns() == size(), "matrix family: need square matrices of one size, got {} x {}",
            m.rows(), m.columns());
  FamilySymmetry flip{reversal(size()), reversal(count())};
  if (permutes(matrices_, flip)) symmetries_.push_back(std::move(flip));
}

RationalMatrix MatrixFamily::product(const std::vector<int>& word) const {
  RationalMatrix product = matrices_[static_cast<std::size_t>(word.front())];
  for (std::size_t k = 1; k < word.size(); ++k) product = product * matrices_[static_cast<std::size_t>(word[k])];
  return product;
}

MatrixFamily transposed(const MatrixFamily& family) {
  std::vector<RationalMatrix> result;
  for (const RationalMatrix& m : family) result.push_back(transposed(m));
  return result;
}

MatrixFamily operator*(const Rational& factor, const MatrixFamily& family) {
  std::vector<RationalMatrix> result;
  for (const RationalMatrix& m : family) result.push_back(factor * m);
  return result;
}

}  // namespace subcert
