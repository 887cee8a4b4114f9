#pragma once
/// The proofs behind theorem.hpp, one function each, for the sources of this floor.

#include "balls.hpp"
#include "theorem.hpp"

namespace subcert::theorems {

constexpr slong proof_bits = 192;

inline Real exactly(const Rational& value) { return Real(value, proof_bits); }

/// The inequality that makes the stated value of a constant right: the number it stands for lies on the proved side.
Check defining(const Constants& constants, const std::string& name, const std::string& formula, const Real& number);

/// (1/2 pi) times the integral of s^4 M(s)^2 over the real line, and kappa_0. Ref: [LC, thm 10].
Real degree_one_moment();
Real degree_one_fourth_order();

Constants degree_one_constants_7();
Constants degree_one_constants_8();
std::vector<Check> degree_one_checks_7(const Constants& constants);
std::vector<Check> degree_one_checks_8(const Constants& constants);

Constants limit_constants_stated();
std::vector<Check> limit_constants_checks(const Constants& constants);

}  // namespace subcert::theorems
