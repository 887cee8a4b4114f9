// Data that a scheme on vectors keeps, and what annihilates them: sections 6.7, 6.9 and 6.11 of
// ../../certificates/SPEC.md.
#pragma once

#include "transition.hpp"

namespace subcert_check {

/// Whether the sum over k of x_k . e_l(-k) is 0 for all l, e_l(j) = sum over s of y_s j^(l-s) / (l-s)! for the y_s of
/// `data`. Domain: one variable, or one y_0.
bool annihilates(const Transition& operators, const Sequence& x, const std::vector<Rationals>& data);

/// (q, p) for p + sqrt(root) q, times sqrt(root).
std::vector<Rationals> multiples(std::vector<Rationals> data, const mpz_class& root);

/// Section 6.11: rejects unless these are a basis of the vectors y with sum over k of P_k y = y in each class.
void check_all_kept(const Transition& operators, const std::vector<Rationals>& kept);

}  // namespace subcert_check
