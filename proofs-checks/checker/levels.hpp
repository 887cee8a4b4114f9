// Schemes whose mask changes from level to level: section 6.5 of ../certificates/SPEC.md, which proves each step.
#pragma once

#include "parameter.hpp"
#include "scheme.hpp"

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace subcert_check {

/// Masks of one arity and what may follow what: nothing said, each may follow each; or the pairs BEFORE, AFTER; or the
/// masks of `period` again and again.
struct MaskList {
  std::vector<Mask> masks;
  unsigned arity;
  std::vector<std::size_t> period;
  std::vector<std::pair<std::size_t, std::size_t>> follows;
};

/// MASK;MASK;... and `any`, `period=0,1,...` or `follows=0-1,1-0,...`.
MaskList parse_mask_list(std::string_view masks, unsigned arity, std::string_view order);

/// The first mask, then the next one, and so on, as one mask of the arity to the power of their number.
Mask masks_in_one(const MaskList& list, const std::vector<std::size_t>& sequence, Arithmetic& arithmetic);

/// Rejects unless each mask keeps constant data.
void check_constants(const MaskList& list);

/// T_0, T_1, ... of the masks in any order, or the matrices of the pairs.
Family list_family(const MaskList& list, std::size_t sum_rules);

/// The T_t with an end of the range for each new point, of a mask whose coefficients are of degree 1 in the parameter.
/// Rejects unless each rule takes polynomials of degrees below `sum_rules` to their values, at places that do not
/// depend on the parameter.
Family each_point_family(const Mask& mask, unsigned arity, const Range& range, std::size_t sum_rules,
                         Arithmetic& arithmetic);

/// The coefficients of symbol(z) factor(z^step).
Vector product_of_symbols(const Vector& symbol, const Vector& factor, std::size_t step, Arithmetic& arithmetic);

}  // namespace subcert_check
