#include "transition.hpp"

#include <algorithm>
#include <stdexcept>

namespace subcert {

std::vector<RationalMatrix> transition_matrices(const Mask& mask) {
  const std::vector<Rational> coefficients = mask.symbol().coefficients();
  const long arity = mask.arity(), degree = static_cast<long>(coefficients.size()) - 1;
  const long width = std::max(1L, (degree + arity - 2) / (arity - 1));
  std::vector<RationalMatrix> result;
  for (long t = 0; t < arity; ++t) {
    RationalMatrix matrix(static_cast<std::size_t>(width), static_cast<std::size_t>(width));
    for (long j = 0; j < width; ++j)
      for (long k = 0; k < width; ++k) {
        const long index = arity * j + t - k;
        if (index >= 0 && index <= degree)
          matrix(static_cast<std::size_t>(j),
                 static_cast<std::size_t>(k)) = coefficients[static_cast<std::size_t>(index)];
      }
    result.push_back(std::move(matrix));
  }
  return result;
}

RationalMatrix central_matrix(const LaurentPolynomial& symbol, int arity) {
  if (symbol.is_zero() || !(symbol.reversed() == symbol))
    throw std::invalid_argument("central_matrix: need b(z) = b(1/z), not zero, got " + symbol.to_text());
  const long reach = symbol.highest() / (arity - 1);
  const auto size = static_cast<std::size_t>(reach) + 1;
  RationalMatrix matrix(size, size);
  for (long j = 0; j <= reach; ++j)
    for (long k = 0; k <= reach; ++k) {
      Rational entry = symbol.coefficient(arity * j - k);
      if (k > 0) entry += symbol.coefficient(arity * j + k);
      matrix(static_cast<std::size_t>(j), static_cast<std::size_t>(k)) = entry;
    }
  return matrix;
}

}  // namespace subcert
