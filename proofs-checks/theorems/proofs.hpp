#pragma once
/// The proofs behind theorem.hpp, for the sources of this floor.

#include "ledger.hpp"
#include "scheme_family.hpp"
#include "theorem.hpp"

namespace subcert::theorems {

/// For claims: the number, and ` at n = 5`.
inline std::string text(int n) { return std::to_string(n); }
inline std::string at(int n) { return " at n = " + text(n); }

/// C_d to 40 digits, kept for the next call.
const Ball& limit_ball(int degree);

/// The inequality that makes the stated value of a constant right: the number it stands for lies on the proved side.
Check defining(const Constants& constants, const std::string& name, const std::string& formula, const Ball& number);

/// (1/2 pi) times the integral of s^4 M(s)^2 over the real line, and kappa_0. Ref: [LC, thm 10].
Ball degree_one_moment();
Ball degree_one_fourth_order();

/// The sum of u/sin u - 1 over u = pi 2^(-i-1), i >= 0; for u <= 1/2 a term is at most u^2/5.
Ball excess_of_shells();

/// The integral that the first Fourier coefficient of psi_n tends to for n = 3, 11, 43, ..., scaled, and with a minus.
/// Ref: docs/theorems/variance-curves.tex, the proof of Theorem I. Cost: a second.
Ball first_harmonic();

Constants degree_one_constants_7();
Constants degree_one_constants_8();
std::vector<Check> degree_one_checks_7(const Constants& constants, int threads);
std::vector<Check> degree_one_checks_8(const Constants& constants, int threads);

/// Of section 7 of the text, for one degree of one family; 8_d compares a degree with the one above it by 2. A ledger
/// that does not hold ends with the inequality that misses. Domain: odd degree for the primal families.
void uniform_7(Ledger& ledger, const SchemeFamily& family, int degree, int threads);
void uniform_8_n(Ledger& ledger, const SchemeFamily& family, int degree, int threads);
void uniform_8_d(Ledger& ledger, const SchemeFamily& family, int degree, int threads);
/// What uniform_7 states for the primal family.
Constants uniform_constants_7(int degree);
/// The n_1 of a degree: the first of a few sizes for which the inequalities hold, or the last of them; kept for the
/// next call.
int uniform_start(const SchemeFamily& family, int degree);

Constants limit_constants_stated();
std::vector<Check> limit_constants_checks(const Constants& constants, int threads);

}  // namespace subcert::theorems
