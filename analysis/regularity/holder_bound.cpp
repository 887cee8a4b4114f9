#include "holder_bound.hpp"

#include <subcert/analysis/difference/difference.hpp>
#include <subcert/analysis/difference/level_norms.hpp>
#include <subcert/analysis/symbol/matrices/rational_matrix.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <limits>

namespace subcert {

const HolderBound& HolderBounds::best() const {
  return *std::max_element(levels.begin(), levels.end(), [](const HolderBound& a, const HolderBound& b) {
    return *a.exponent.lower < *b.exponent.lower;
  });
}

namespace {

constexpr long ordinary_bits = 64;

/// The e for which 2^-e times the symbol has numbers that doubles hold; 0 where it has already.
long scaling_exponent(const LaurentPolynomial& symbol) {
  long largest = std::numeric_limits<long>::min();
  for (const Rational& c : symbol.coefficients())
    if (c != 0) largest = std::max(largest, binary_exponent(c));
  return std::abs(largest) > ordinary_bits ? largest : 0;
}

}  // namespace

HolderBound holder_bound(int level, const Rational& norm, int sum_rules, int arity) {
  const Enclosure logarithm = log_ratio(norm, arity);
  return {level, norm, {sum_rules - *logarithm.upper / level, sum_rules - *logarithm.lower / level}};
}

HolderBounds holder_bounds(const Mask& mask, int levels, const Deadline& deadline) {
  require(is_affine(mask), "holder_bounds: need coset sums 1, got {}", mask.symbol().to_mask_text());
  const int rules = sum_rules(mask);
  const Mask derived = divided_difference_scheme(mask, rules);
  const long exponent = scaling_exponent(derived.symbol());
  const Mask scaled(derived.symbol() * LaurentPolynomial(power(Rational(2), -exponent)), mask.arity());
  const LevelNorms powers = level_norms(scaled, levels, deadline);
  HolderBounds result{rules, {}, powers.visited};
  for (std::size_t l = 0; l < powers.norms.size(); ++l) {
    const int level = static_cast<int>(l) + 1;
    const Rational norm = powers.norms[l] * power(Rational(2), exponent * level);
    result.levels.push_back(holder_bound(level, norm, rules, mask.arity()));
  }
  return result;
}

}  // namespace subcert
