// Masks with rounded coefficients: section 7 of ../certificates/SPEC.md.
#pragma once

#include "scheme.hpp"

namespace subcert_check {

/// All masks whose coefficients differ from the given ones by at most `distance`, with so many sum rules.
struct Rounding {
  mpq_class distance;
  std::size_t sum_rules;
};

/// At least x > 0, with 128 binary digits.
mpq_class few_digits_up(const mpq_class& x);

/// EPS,M
Rounding parse_rounding(std::string_view text);

/// What the errors of the coefficients make of the entries of the transition matrices.
mpq_class entry_error(const Mask& mask, unsigned arity, const Rounding& rounding);

/// At least the change of a product of so many factors with norms up to `norm`, errors up to `error`: their number
/// times error times (norm + error)^(number - 1). Also that of a determinant by its columns. Rounded up.
mpq_class change_of_product(const mpq_class& norm, const mpq_class& error, std::size_t factors);

/// The largest 1-norm of a matrix of the family.
mpq_class largest_column_sum(const Family& family);

}  // namespace subcert_check
