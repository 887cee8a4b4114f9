#include "vector_operators.hpp"

#include <subcert/analysis/radii/joint/modular_meataxe.hpp>

#include <algorithm>

namespace subcert::vectors {
namespace {

constexpr std::size_t largest_mirrored = 80;  // rational dimension

using Matrices = std::vector<RationalMatrix>;

/// a + factor b
RationalMatrix plus_multiple(const RationalMatrix& a, const RationalMatrix& b, const Rational& factor) {
  RationalMatrix result = a;
  for (std::size_t r = 0; r < a.rows(); ++r)
    for (std::size_t c = 0; c < a.columns(); ++c) result(r, c) += factor * b(r, c);
  return result;
}

/// A J that is not 0 with J A_t = B_t J for all t, A the first list and B the second, if it is the only one up to
/// factors from the field; the last matrix of each is the product with the root. It maps a basis A_w e, w words, to B_w
/// x with x = J e: what combinations the A_t A_w e are says which x there may be.
std::optional<RationalMatrix> intertwiner(const Matrices& first, const Matrices& second, const Deadline& deadline) {
  const std::size_t size = first.front().rows();
  const auto modular = radius::modulo_prime(MatrixFamily(first));
  if (!modular) return std::nullopt;
  radius::ModVector start(size, 0);
  start.front() = 1;
  const std::vector<radius::SpinStep> steps = radius::spin(*modular, start);
  if (steps.size() < size) return std::nullopt;
  std::vector<std::vector<Rational>> basis{std::vector<Rational>(size, 0)};
  basis.front().front() = 1;
  Matrices words{RationalMatrix::identity(size)};  // B_w
  for (std::size_t k = 1; k < size; ++k) {
    basis.push_back(first[steps[k].letter] * basis[steps[k].parent]);
    words.push_back(second[steps[k].letter] * words[steps[k].parent]);
  }
  const RationalMatrix columns = from_columns(basis, size);
  std::vector<std::vector<Rational>> starts = kernel(RationalMatrix(1, size));  // the x that are left
  for (std::size_t t = 0; t < first.size() && starts.size() > 2; ++t) {
    const RationalMatrix images = solve(columns, first[t] * columns);
    for (std::size_t k = 0; k < size && starts.size() > 2; ++k) {
      if (deadline.expired()) return std::nullopt;
      RationalMatrix condition = second[t] * words[k];
      for (std::size_t j = 0; j < size; ++j)
        if (images(j, k) != 0) condition = plus_multiple(condition, words[j], -images(j, k));
      if (!binary_exponent(condition)) continue;
      const RationalMatrix left = from_columns(starts, size);
      std::vector<std::vector<Rational>> next;
      for (const std::vector<Rational>& combination : kernel(condition * left)) next.push_back(left * combination);
      starts = std::move(next);
    }
  }
  if (starts.size() != 2) return std::nullopt;
  std::vector<std::vector<Rational>> images;
  for (const RationalMatrix& word : words) images.push_back(word * starts.front());
  const RationalMatrix result = transposed(solve(transposed(columns), transposed(from_columns(images, size))));
  for (std::size_t t = 0; t < first.size(); ++t)
    if (!(result * first[t] == second[t] * result)) return std::nullopt;
  return result;
}

/// a + b sqrt(root) with the square c + d sqrt(root), if there is one; 0 has none here.
std::optional<std::pair<Rational, Rational>> root_in_field(const Rational& c, const Rational& d, const Rational& root) {
  const Rational norm = c * c - root * d * d;
  const auto of_norm = norm >= 0 ? exact_root(norm, 2) : std::nullopt;
  if (!of_norm) return std::nullopt;
  for (const Rational& n : {*of_norm, Rational(-*of_norm)}) {
    const Rational square = (c + n) / 2;
    if (const auto a = square > 0 ? exact_root(square, 2) : std::nullopt) return std::pair(*a, Rational(d / (2 * *a)));
  }
  const auto b = d == 0 && c > 0 ? exact_root(c / root, 2) : std::nullopt;
  return b ? std::optional(std::pair(Rational(0), *b)) : std::nullopt;
}

/// The multiple of J over the field whose square is 1. Domain: the root maps unit vector 0 to unit vector 1.
std::optional<RationalMatrix> of_order_two(const RationalMatrix& j, const RationalMatrix& root) {
  const RationalMatrix square = j * j, one = RationalMatrix::identity(j.rows());
  if (!(square == plus_multiple(square(0, 0) * one, root, square(1, 0)))) return std::nullopt;
  const auto factor = root_in_field(square(0, 0), square(1, 0), root(0, 1));
  if (!factor) return std::nullopt;
  return solve(plus_multiple(factor->first * one, root, factor->second), j);
}

}  // namespace

RationalMatrix basis_of_pairs(const RationalMatrix& columns, const RationalMatrix& root) {
  const RationalMatrix images = root * columns;
  const std::size_t size = root.rows();
  RationalMatrix both(size, 2 * columns.columns());
  for (std::size_t c = 0; c < columns.columns(); ++c)
    for (std::size_t r = 0; r < size; ++r) {
      both(r, 2 * c) = columns(r, c);
      both(r, 2 * c + 1) = images(r, c);
    }
  const std::vector<std::size_t> chosen = pivot_columns(both);  // with each the one of its image
  RationalMatrix result(size, chosen.size());
  for (std::size_t c = 0; c < chosen.size(); ++c)
    for (std::size_t r = 0; r < size; ++r) result(r, c) = both(r, chosen[c]);
  return result;
}

Operators in_basis(const Operators& operators, const RationalMatrix& basis) {
  Matrices result;
  for (const RationalMatrix& matrix : operators.matrices()) result.push_back(solve(basis, matrix * basis));
  RationalMatrix root = std::move(result.back());
  result.pop_back();
  return {MatrixFamily(std::move(result)), std::move(root)};
}

bool are_similar(const Operators& first, const Operators& second, const Deadline& deadline) {
  const std::size_t size = first.family.size();
  if (second.family.size() != size || size > largest_mirrored) return false;
  Matrices mirrored = second.matrices();
  std::reverse(mirrored.begin(), mirrored.end() - 1);
  for (const Matrices& other : {second.matrices(), std::move(mirrored)})
    if (const auto map = intertwiner(first.matrices(), other, deadline); map && kernel(*map).empty()) return true;
  return false;
}

std::optional<RationalMatrix> mirror_symmetric_basis(const Operators& given, const Deadline& deadline) {
  const std::size_t size = given.family.size();
  if (size > largest_mirrored) return std::nullopt;
  const RationalMatrix pairs = basis_of_pairs(RationalMatrix::identity(size), *given.root);
  const Operators operators = in_basis(given, pairs);
  const Matrices first = operators.matrices();
  Matrices second = first;
  std::reverse(second.begin(), second.end() - 1);
  const auto map = intertwiner(first, second, deadline);
  const auto mirror = map ? of_order_two(*map, *operators.root) : std::nullopt;
  if (!mirror) return std::nullopt;
  const auto eigenvectors = [&](long eigenvalue) {
    const RationalMatrix shifted = plus_multiple(*mirror, RationalMatrix::identity(size), -eigenvalue);
    return basis_of_pairs(from_columns(kernel(shifted), size), *operators.root);
  };
  RationalMatrix even = eigenvectors(1), odd = eigenvectors(-1);
  if (odd.columns() > even.columns()) std::swap(even, odd);  // the negative of the mirror is one, too
  if (even.columns() > odd.columns() + 2) return std::nullopt;
  // even + odd and, from behind, even - odd; in between what is left
  RationalMatrix basis(size, size);
  for (std::size_t r = 0; r < size; ++r)
    for (std::size_t c = 0; c < even.columns(); ++c) {
      const std::size_t opposite = size - 2 - c / 2 * 2 + c % 2;
      basis(r, c) = even(r, c);
      if (c >= odd.columns()) continue;
      basis(r, c) += odd(r, c);
      basis(r, opposite) = even(r, c) - odd(r, c);
    }
  return pairs * basis;
}

}  // namespace subcert::vectors
