#include "box.hpp"

#include "laurent_polynomial.hpp"

namespace subcert {

Values Box::middle() const {
  Values result;
  for (std::size_t v = 0; v < letters(); ++v) result.push_back((low[v] + high[v]) / 2);
  return result;
}

Values Box::corner(unsigned number) const {
  Values result = low;
  for (std::size_t v = 0; v < letters(); ++v)
    if (number >> v & 1) result[v] = high[v];
  return result;
}

Box Box::part(unsigned corner) const {
  Box result{low, high};
  const Values centre = middle();
  for (std::size_t v = 0; v < letters(); ++v) (corner >> v & 1 ? result.low : result.high)[v] = centre[v];
  return result;
}

Rational Box::volume() const {
  Rational result = 1;
  for (std::size_t v = 0; v < letters(); ++v) result *= width(v);
  return result;
}

std::vector<Values> bernstein_factors(long n, const Rational& low, const Rational& high) {
  std::vector<Values> result;
  for (long i = 0; i <= n; ++i) {
    // The blossom of w^k with n - i arguments `low` and i arguments `high`: their elementary symmetric polynomials over
    // binomials.
    const LaurentPolynomial product = LaurentPolynomial({1, low}, 0).pow(n - i) *
                                      LaurentPolynomial({1, high}, 0).pow(i);
    result.emplace_back();
    Rational binomial = 1;
    for (long k = 0; k <= n; ++k) {
      result.back().push_back(product.coefficient(k) / binomial);
      binomial *= Rational(n - k, k + 1);
    }
  }
  return result;
}

}  // namespace subcert
