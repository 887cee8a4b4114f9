#include "root_modulus.hpp"

#include "complex_roots.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert {

LaurentPolynomial squarefree_part(const LaurentPolynomial& p) {
  const LaurentPolynomial q = p.shifted(-p.lowest());
  return *q.exact_quotient(gcd(q, q.derivative()));
}

namespace {

constexpr slong spare_bits = 8;  // of zeros, for their moduli

/// Of those of a polynomial without multiple zeros.
RootModulus largest_modulus(const LaurentPolynomial& squarefree, const std::vector<ComplexBall>& zeros, int bits) {
  RootModulus result;
  result.largest = Enclosure::exactly(0);
  if (zeros.empty()) return result;
  result.has_root_plus_or_minus_one = squarefree(1) == 0 || squarefree(-1) == 0;
  // The radius, not the width, is held to these bits.
  std::vector<Enclosure> moduli;
  for (const ComplexBall& root : zeros) {
    moduli.push_back(abs(ComplexBall(root.get(), bits + 32)).enclosure(bits + 192));
    result.largest.lower = std::max(*result.largest.lower, *moduli.back().lower);
    result.largest.upper = std::max(*result.largest.upper, *moduli.back().upper);
  }
  const Rational number = simplest_between(*result.largest.lower, *result.largest.upper);
  auto others = std::ranges::count_if(
      moduli, [&](const Enclosure& modulus) { return *modulus.upper >= *result.largest.lower; });
  for (const Rational& root : {number, Rational(-number)})
    if (squarefree(root) == 0) --others;
  if (others == 0) result.largest = Enclosure::exactly(number);
  return result;
}

}  // namespace

RootModulus largest_root_modulus(const LaurentPolynomial& p, int bits) {
  require(!p.is_zero(), "largest_root_modulus: need a non-zero polynomial, got 0");
  const LaurentPolynomial squarefree = squarefree_part(p);
  return largest_modulus(squarefree, complex_roots(squarefree, bits + spare_bits), bits);
}

std::optional<RootModulus> largest_root_modulus(const LaurentPolynomial& p, int bits, const Deadline& deadline) {
  require(!p.is_zero(), "largest_root_modulus: need a non-zero polynomial, got 0");
  const LaurentPolynomial squarefree = squarefree_part(p);
  const auto zeros = complex_roots(squarefree, bits + spare_bits, deadline);
  return zeros ? std::optional(largest_modulus(squarefree, *zeros, bits)) : std::nullopt;
}

}  // namespace subcert
