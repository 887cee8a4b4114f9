// Masks with a parameter, for all its values from one number to another: section 6 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// Values of the parameter of this letter: w = (low v + high u) / (u + v) for u, v >= 0.
struct Range {
  char letter;
  mpq_class low, high;
};

/// w=LOW..HIGH
Range parse_range(std::string_view text);

/// The matrices at which Bernstein's polynomials of the range lead to those of the powers: for each matrix, those of
/// all powers, one after another.
Family control_family(const Family& powers, std::size_t degree, const Range& range, Arithmetic& arithmetic);

/// Conditions (i) and (ii) of Theorem 4 for all values of the range. Without a parameter: with an empty range.
void check_stability(const Mask& mask, unsigned arity, const Range& range, Arithmetic& arithmetic);

/// Rejects unless for all values of the range the product of the letters has a real eigenvalue beyond `re`, or two
/// eigenvalues whose product is above im^2. Domain: one of re and im is 0.
void check_eigenvalue(const Family& controls, std::size_t degree, const std::vector<std::size_t>& letters,
                      const mpq_class& re, const mpq_class& im, Arithmetic& arithmetic);

}  // namespace subcert_check
