#include "integer_forms.hpp"

#include <algorithm>

namespace subcert::quadratic {
namespace {

constexpr std::size_t pivot_bits = 128;
constexpr long coordinate_bits = 48, form_guard_bits = 32;

/// The lower triangular R with R^T R = form, times 2^form_guard_bits, rounded to nearest; nothing where a pivot is not
/// positive.
std::optional<Integers> reverse_cholesky(Integers form, std::size_t n) {
  for (Integer& entry : form) entry <<= 2 * form_guard_bits;
  Integers root(n * n);
  for (std::size_t k = n; k-- > 0;) {
    if (form[k * n + k].sign() <= 0) return std::nullopt;
    const Integer pivot = sqrt(form[k * n + k]);
    for (std::size_t j = 0; j < k; ++j) {
      root[k * n + j] = form[j * n + k];
      floor_divide(root[k * n + j], pivot);
    }
    root[k * n + k] = pivot;
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = i; j < k; ++j) subtract_product(form[i * n + j], root[k * n + i], root[k * n + j]);
  }
  for (Integer& entry : root) {
    entry += Integer(1) << (form_guard_bits - 1);
    entry >>= form_guard_bits;
  }
  for (std::size_t k = 0; k < n; ++k)
    if (root[k * n + k].is_zero()) return std::nullopt;
  return root;
}

}  // namespace

Integers product(const Integers& a, const Integers& b, std::size_t n) {
  Integers result(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k)
      if (!a[i * n + k].is_zero())
        for (std::size_t j = 0; j < n; ++j) add_product(result[i * n + j], a[i * n + k], b[k * n + j]);
  return result;
}

Integers gram_matrix(const Integers& a, std::size_t n) {
  Integers result(n * n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j) add_product(result[i * n + j], a[k * n + i], a[k * n + j]);
  return result;
}

bool is_positive(Integers s, std::size_t n) {
  Integer largest = 0;
  for (const Integer& entry : s) largest = std::max(largest, abs(entry));
  if (largest == 0) return true;
  const std::size_t bits = msb(largest) + 1;
  for (Integer& entry : s) {
    if (bits <= 2 * pivot_bits)
      entry <<= 2 * pivot_bits - bits;
    else
      entry >>= bits - 2 * pivot_bits;
  }
  return has_root(s, n, (Integer(n) << pivot_bits) + Integer(n));
}

bool is_positive(const RationalMatrix& s) { return is_positive(integer_multiple(s, common_denominator(s)), s.rows()); }

std::optional<std::vector<Integers>> triangular_coordinates(const std::vector<polytope::Matrix>& to,
                                                            const radius::RoundFamily& round) {
  const std::size_t n = to.front().rows();
  std::vector<RationalMatrix> maps;
  for (const polytope::Matrix& map : to) {
    auto exact = radius::to_rational(map);
    if (!exact) return std::nullopt;
    maps.push_back(std::move(*exact));
  }
  long bits = coordinate_bits;
  if (const auto& [before, back] = round.coordinates; round.coordinates.differ()) {
    for (RationalMatrix& map : maps) map = map * before;
    // Of what is flat as many digits are left.
    bits += std::max(0L, binary_exponent(before).value_or(0) + binary_exponent(back).value_or(0));
  }
  long exponent = binary_exponent(maps.front()).value_or(0);
  for (const RationalMatrix& map : maps) exponent = std::max(exponent, binary_exponent(map).value_or(exponent));
  const Rational unit = power(Rational(2), bits - exponent);
  std::vector<Integers> result;
  for (const RationalMatrix& map : maps) {
    Integers rounded;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) rounded.push_back(to_integer(unit * map(i, j), Rounding::nearest));
    auto root = reverse_cholesky(gram_matrix(rounded, n), n);
    if (!root) return std::nullopt;
    result.push_back(std::move(*root));
  }
  return result;
}

}  // namespace subcert::quadratic
