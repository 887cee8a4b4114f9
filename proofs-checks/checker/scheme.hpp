// Families of matrices, and masks. Section numbers refer to ../certificates/SPEC.md, which proves each step.
#pragma once

#include "arithmetic.hpp"

namespace subcert_check {

/// Square matrices of one size, one after another, each column by column; all entries over one denominator > 0.
struct Family {
  std::size_t size = 1;
  Vector entries;
  mpz_class denominator = 1;

  std::size_t count() const { return entries.size() / (size * size); }
  std::span<const mpz_class> matrix(std::size_t t) const { return {&entries.at(t * size * size), size * size}; }
  void transpose();
};

/// The matrices with these entries.
Family clear_denominators(std::size_t size, const Rationals& values);

/// Reads matrices row by row, each row after the head.
Family read_family(Reader& reader, const std::string& head, std::size_t count, std::size_t size);

/// Coefficients on a box of lattice points, the first variable running fastest, over one denominator > 0.
struct Mask {
  std::vector<std::size_t> sizes;  // along the variables
  Vector first;                    // the lowest point
  Vector coefficients;
  mpz_class denominator;
};

/// [c0,c1,...]/D@first, or nested lists, the last variable outermost.
Mask parse_mask(std::string_view text);

/// The family of section 4.1: divides the symbol by sigma, `sum_rules` times.
Family transition_family(const Mask& mask, unsigned arity, std::size_t sum_rules);

/// Conditions (i) and (ii) of Theorem 4.
void check_stability(const Mask& mask, unsigned arity);

}  // namespace subcert_check
