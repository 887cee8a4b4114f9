#pragma once
/// The largest modulus of the zeros of a polynomial.

#include "laurent_polynomial.hpp"

#include <subcert/analysis/symbol/support/budget.hpp>

#include <optional>

namespace subcert {

/// p without its zero at 0 and with simple zeros only. Domain: p not zero.
LaurentPolynomial squarefree_part(const LaurentPolynomial& p);

/// Encloses the largest modulus of the roots. Domain: p not zero; 0 for a constant or monomial. Error: relative width
/// below 2^-bits, as the roots of the squarefree part are isolated by balls; none where only one rational number and
/// its negative are that large. Whether 1 or -1 is a root is decided exactly.
struct RootModulus {
  Enclosure largest;
  bool has_root_plus_or_minus_one = false;
};
RootModulus largest_root_modulus(const LaurentPolynomial& p, int bits = 64);
/// The same, or nothing past the deadline.
std::optional<RootModulus> largest_root_modulus(const LaurentPolynomial& p, int bits, const Deadline& deadline);

}  // namespace subcert
