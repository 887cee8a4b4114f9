// Fits of least absolute deviations: section 4.16 of ../certificates/SPEC.md.
#pragma once

#include "arithmetic.hpp"

namespace subcert_check {

/// The rule that fits polynomials of a degree to so many equispaced data and takes `arity` values of each. Domain: 2 <=
/// points <= 16, degree <= points - 2, few enough vertices, 2 <= arity <= 16.
struct L1Rule {
  std::size_t points = 0, degree = 0, arity = 2;
};

L1Rule parse_l1_rule(std::string_view text);

/// |D^order S^steps f| <= bound |D^order f| for all data and all minimisers. Domain: 1 <= order <= degree + 1,
/// arity^steps
/// <= 256.
struct Contraction {
  std::size_t steps = 0, order = 0;
  mpq_class bound;

  bool operator==(const Contraction&) const = default;
};

/// Of the fields STEPS, ORDER and BOUND.
Contraction parse_contraction(const Fields& fields, const L1Rule& rule);

/// Reads what follows the line `bounds`, and shows the contraction that its first line says.
Contraction read_contraction(const L1Rule& rule, Reader& reader, Arithmetic& arithmetic);

/// Data that are met again, times the factor, after so many steps; the factor is not a power of 1/2, up to its sign.
struct L1Orbit {
  std::size_t steps = 0;
  mpq_class factor;
};

/// Reads an orbit, and shows that it is one whose limit is not 0. Domain: the limits exist, arity 2.
L1Orbit read_orbit(const L1Rule& rule, Reader& reader, Arithmetic& arithmetic);

}  // namespace subcert_check
