#include "norm_of_products.hpp"

#include <algorithm>
#include <cmath>

namespace subcert {
namespace {

constexpr std::size_t most_products = 512;
constexpr double most_work = 2e7;  // products of numbers for one level; larger families have better bounds than norms
constexpr int longest = 24;

/// What matrices of this kind hold, roughly.
std::size_t bytes_of(const RationalMatrix& matrix) {
  constexpr std::size_t parts = 80;  // of a rational number with short numerator and denominator
  const long bits = std::max(binary_exponent(matrix).value_or(0), 0L);
  return matrix.rows() * matrix.columns() * (parts + static_cast<std::size_t>(bits) / 4);
}

}  // namespace

NormProof norm_of_products(const MatrixFamily& family, const Budget& budget, std::size_t count) {
  std::vector<RationalMatrix> products = family.matrices();
  const std::size_t letters = std::max(count, family.count());
  std::size_t words = letters;
  NormProof best;
  Rational best_bound = 0;
  for (int level = 1;; ++level) {
    NormProof proof{level, 0};
    for (const RationalMatrix& product : products) proof.norm = std::max(proof.norm, one_norm(product));
    const Rational bound = proof.bound();
    if (level == 1 || bound < best_bound) {
      best = proof;
      best_bound = bound;
    }
    const std::size_t next = products.size() * family.count();
    words *= letters;
    if (proof.norm == 0 || words > most_products ||
        static_cast<double>(words) * std::pow(static_cast<double>(family.size()), 3) > most_work || level >= longest ||
        next * bytes_of(products.front()) > budget.memory / 2)
      return best;
    std::vector<RationalMatrix> longer;
    for (const RationalMatrix& product : products)
      for (const RationalMatrix& m : family) {
        if (budget.deadline.expired()) return best;
        longer.push_back(product * m);
      }
    products = std::move(longer);
  }
}

}  // namespace subcert
