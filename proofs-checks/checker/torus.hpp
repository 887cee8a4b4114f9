// Trigonometric polynomials of up to three variables: section 5.5 of ../certificates/SPEC.md.
#pragma once

#include "arithmetic.hpp"

#include <array>
#include <map>

namespace subcert_check {

/// A point of Z^s, s <= 3; the coordinates that are not used are 0.
using Point = std::array<std::int64_t, 3>;

/// Finitely many values on Z^s, none of them 0.
using Sequence = std::map<Point, mpz_class>;

/// Rejects unless it can show that sum_k g_k e^(ikx) > 0 for all x. Domain: g_{-k} = g_k.
void check_positive(const Sequence& g, std::size_t variables, Arithmetic& arithmetic);

}  // namespace subcert_check
