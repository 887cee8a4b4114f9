#pragma once
/// Polynomials in several letters, and their Bernstein coefficients on boxes.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <functional>
#include <numeric>
#include <vector>

namespace subcert {

/// One value for each letter.
using Values = std::vector<Rational>;

/// low[v] <= w_v <= high[v] for each letter. Canonical: as many of both, low[v] < high[v].
struct Box {
  Values low, high;

  std::size_t letters() const { return low.size(); }
  /// 2^letters().
  unsigned corners() const { return 1U << letters(); }
  Rational width(std::size_t letter = 0) const { return high[letter] - low[letter]; }
  Values middle() const;
  /// The bits of the number say of which letters the value is the high one.
  Values corner(unsigned number) const;
  /// What lies between that corner and the middle.
  Box part(unsigned corner) const;
  Rational volume() const;
};

/// Of numbers, polynomials or matrices: the factors of w_1^k_1 w_2^k_2 ..., or of products of Bernstein polynomials,
/// for 0 <= k_v < sizes[v]; k_1 runs fastest. Canonical: as many entries as that, one at least.
template <class T>
struct Powers {
  std::vector<std::size_t> sizes;
  std::vector<T> entries;

  bool operator==(const Powers& other) const = default;
  /// Between the entries of two powers of a letter that follow each other.
  std::size_t stride(std::size_t letter) const {
    return std::accumulate(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(letter), std::size_t{1},
                           std::multiplies<>());
  }
};

/// [i][k]: the factor of w^k in the i-th Bernstein coefficient of degree n on [low, high].
std::vector<Values> bernstein_factors(long n, const Rational& low, const Rational& high);

/// In the place of the powers of one letter, for each row: their sum with these factors.
template <class T, class Factor>
Powers<T> along(const Powers<T>& powers, std::size_t letter, const std::vector<std::vector<Factor>>& rows) {
  Powers<T> result{powers.sizes, {}};
  const std::size_t size = powers.sizes[letter], stride = powers.stride(letter);
  result.sizes[letter] = rows.size();
  for (std::size_t block = 0; block < powers.entries.size(); block += size * stride)
    for (const std::vector<Factor>& factors : rows)
      for (std::size_t at = block; at < block + stride; ++at) {
        T sum = factors[0] * powers.entries[at];
        for (std::size_t k = 1; k < size; ++k)
          if (factors[k] != 0) sum += factors[k] * powers.entries[at + k * stride];
        result.entries.push_back(std::move(sum));
      }
  return result;
}

/// The value of a polynomial.
template <class T>
T value_at(Powers<T> powers, const Values& values) {
  for (std::size_t v = 0; v < values.size(); ++v) {
    Values row{1};
    while (row.size() < powers.sizes[v]) row.push_back(row.back() * values[v]);
    powers = along(powers, v, std::vector<Values>{row});
  }
  return std::move(powers.entries.front());
}

/// The Bernstein coefficients of a polynomial on a box, as one of degrees below these. Their products with Bernstein
/// polynomials, which are not negative there and sum to 1, sum to the polynomial. Domain: degrees >= powers.sizes.
template <class T>
Powers<T> bernstein(Powers<T> powers, const Box& box, const std::vector<std::size_t>& sizes) {
  for (std::size_t v = 0; v < sizes.size(); ++v)
    powers = along(powers, v, bernstein_factors(static_cast<long>(sizes[v]) - 1, box.low[v], box.high[v]));
  return powers;
}

}  // namespace subcert
