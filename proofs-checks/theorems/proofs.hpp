#pragma once
/// The proofs behind theorem.hpp, one function each, for the sources of this floor.

#include "theorem.hpp"

#include <subcert/analysis/symbol/balls.hpp>
#include <subcert/schemes/specification.hpp>

namespace subcert::theorems {

constexpr slong proof_bits = 192;

inline Ball exactly(const Rational& value) { return Ball(value, proof_bits); }

/// For claims: the number, and ` at n = 5`.
inline std::string text(int n) { return std::to_string(n); }
inline std::string at(int n) { return " at n = " + text(n); }

/// S_n^d.
inline Mask primal_mask(int n, int degree) {
  return make_scheme("primal:n=" + std::to_string(n) + ",d=" + std::to_string(degree)).mask;
}

/// C_d to 40 digits, kept for the next call.
const Ball& limit_ball(int degree);

/// The inequality that makes the stated value of a constant right: the number it stands for lies on the proved side.
Check defining(const Constants& constants, const std::string& name, const std::string& formula, const Ball& number);

/// (1/2 pi) times the integral of s^4 M(s)^2 over the real line, and kappa_0. Ref: [LC, thm 10].
Ball degree_one_moment();
Ball degree_one_fourth_order();

/// The sum of u/sin u - 1 over u = pi 2^(-i-1), i >= 0; for u <= 1/2 a term is at most u^2/5.
Ball excess_of_shells();

Constants degree_one_constants_7();
Constants degree_one_constants_8();
std::vector<Check> degree_one_checks_7(const Constants& constants);
std::vector<Check> degree_one_checks_8(const Constants& constants);

/// Degrees 1, 3 and 5 by bounds that hold for all large n at once; 8_d compares a degree with the next odd one.
/// uniform_start: the n_1 of a degree; the theorem on slopes begins later.
int uniform_start(int degree, bool slopes);
Constants uniform_constants_7(int degree);
Constants uniform_constants_8_n(int degree);
Constants uniform_constants_8_d(int degree);
std::vector<Check> uniform_checks_7(const Constants& constants, int degree, int threads);
std::vector<Check> uniform_checks_8_n(const Constants& constants, int degree, int threads);
std::vector<Check> uniform_checks_8_d(const Constants& constants, int degree, int threads);

/// Theorems P to S: convergence, Conjecture 8 in d from degree 1, 3 or 5 to all higher degrees, C_d < C_{d+2}.
Constants convergence_constants(int degree);
std::vector<Check> convergence_checks(const Constants& constants, int degree, int threads);
Constants all_higher_constants(int degree);
std::vector<Check> all_higher_checks(const Constants& constants, int degree, int threads);
std::vector<Check> limits_grow_checks(const Constants& constants);

/// Theorem T: degree against degree + 2, for n >= large_n(degree), and for every n. Domain: odd degree >= 5.
Constants large_n_constants(int degree);
std::vector<Check> large_n_checks(const Constants& constants, int degree, int threads);
std::vector<Check> neighbour_checks(const Constants& constants, int degree, int threads);

Constants limit_constants_stated();
std::vector<Check> limit_constants_checks(const Constants& constants);

}  // namespace subcert::theorems
