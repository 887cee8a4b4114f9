#include "subspace.hpp"

namespace subcert::radius {

std::vector<Integer> primitive(const Vector& vector) {
  Integer den = 1, content = 0;
  for (const Rational& x : vector) den = lcm(den, denominator(x));
  std::vector<Integer> result;
  for (const Rational& x : vector) {
    result.push_back(numerator(x) * (den / denominator(x)));
    content = gcd(content, result.back());
  }
  if (content > 1)
    for (Integer& x : result) x /= content;
  return result;
}

Subspace annihilator(const Subspace& rows) {
  RationalMatrix matrix(rows.size(), rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = 0; j < rows[i].size(); ++j) matrix(i, j) = rows[i][j];
  return kernel(matrix);
}

Subspace with_short_vectors(const Subspace& rows) {
  // The complement of the complement has the echelon basis, whose numbers are no larger than the subspace demands.
  const Subspace complement = annihilator(rows);
  std::vector<std::vector<Integer>> lattice;
  for (const Vector& row : complement.empty() ? rows : annihilator(complement)) lattice.push_back(primitive(row));
  Subspace result;
  for (const std::vector<Integer>& row : reduced_lattice(lattice)) result.emplace_back(row.begin(), row.end());
  return result;
}

}  // namespace subcert::radius
