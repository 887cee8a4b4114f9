// Positivity of trigonometric polynomials of up to three variables, and of polynomials on an interval: sections 5.5 and
// 6.2 of ../certificates/SPEC.md.
#pragma once

#include "arithmetic.hpp"

#include <array>
#include <map>

namespace subcert_check {

/// A point of Z^s, s <= 3; the coordinates that are not used are 0.
using Point = std::array<std::int64_t, 3>;

/// Where a number of a sequence stands: a point, and a component of the vector there, or an entry of the matrix there.
struct Place {
  Point point{};
  std::size_t component = 0;

  auto operator<=>(const Place&) const = default;
};

/// Finitely many values on Z^s, none of them 0.
using Sequence = std::map<Place, mpz_class>;

/// Rejects unless it can show that sum_k g_k e^(ikx) > 0 for all x. Domain: g_{-k} = g_k, numbers.
void check_positive(const Sequence& g, std::size_t variables, Arithmetic& arithmetic);

/// Rejects unless it can show that the sum of form_j u^j (1-u)^(n-j) is positive for all u from 0 to 1; `what` is the
/// subject of the reason.
void check_positive_form(const Vector& form, const std::string& what, Arithmetic& arithmetic);

}  // namespace subcert_check
