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
/// masks of `period` again and again, of numbers alone.
struct MaskList {
  std::vector<Mask> masks;
  unsigned arity;
  std::vector<std::size_t> period;
  std::vector<std::pair<std::size_t, std::size_t>> follows;
};

/// MASK;MASK;... and `any`, `period=0,1,...` or `follows=0-1,1-0,...`.
MaskList parse_mask_list(std::string_view masks, unsigned arity, std::string_view order);

/// The same of masks of matrices of one size. Masks in a period are each as often in the list as in the period, and
/// each is followed by the next one.
MaskList parse_matrix_mask_list(std::string_view masks, unsigned arity, std::string_view order);

/// All masks of matrices on the same points, the numbers of the masks in place of the powers of a parameter.
Mask masks_as_powers(const MaskList& list);

/// The arity of so many levels as one. Rejects more classes than 64.
unsigned arity_in_one(const MaskList& list, std::size_t levels);

/// The first mask, then the next one, and so on, as one mask of the arity to the power of their number. Rejects more
/// than 1000 coefficients.
Mask masks_in_one(const MaskList& list, const std::vector<std::size_t>& sequence, Arithmetic& arithmetic);

/// Of the sequence of the masks of a product of matrices of list_family again and again, that of the first level first:
/// rejects unless its limits have stable shifts, for so many sum rules of each mask.
void check_stability(const MaskList& list, const std::vector<std::size_t>& product, std::size_t sum_rules,
                     Arithmetic& arithmetic);

/// Rejects unless each mask keeps constant data.
void check_constants(const MaskList& list);

/// T_0, T_1, ... of the masks in any order, or the matrices of the pairs.
Family list_family(const MaskList& list, std::size_t sum_rules);

/// The same of masks of matrices, from those of masks_as_powers: T_0 of all masks, T_1 of all masks, ....
Family along(const MaskList& list, const Family& by_powers);

/// The T_t with an end of the range for each new point, of a mask whose coefficients are of degree 1 in the parameter.
/// Rejects unless each rule takes polynomials of degrees below `sum_rules` to their values, at places that do not
/// depend on the parameter.
Family each_point_family(const Mask& mask, unsigned arity, const Range& range, std::size_t sum_rules,
                         Arithmetic& arithmetic);

/// The coefficients of symbol(z) factor(z^step).
Vector product_of_symbols(const Vector& symbol, const Vector& factor, std::size_t step, Arithmetic& arithmetic);

}  // namespace subcert_check
