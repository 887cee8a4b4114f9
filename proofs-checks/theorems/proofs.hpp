#pragma once
/// The proofs behind theorem.hpp, for the sources of this floor.

#include <subcert/schemes/specification.hpp>
#include "ledger.hpp"
#include "scheme_family.hpp"
#include "smoothness_rate.hpp"
#include "theorem.hpp"

#include <optional>
#include <vector>

namespace subcert::theorems {

/// For claims: the number, and ` at n = 5`.
inline std::string text(int n) { return std::to_string(n); }
inline std::string at(int n) { return " at n = " + text(n); }

inline Ball power_of_two(const Ball& exponent) { return exp(exponent * log(Ball(2, proof_bits))); }

/// S_n^d.
inline Mask primal_mask(int n, int degree) {
  return make_scheme(scheme_family("primal").scheme(n, degree)).mask.curve();
}

/// C_d to 40 digits for d <= 9, to 8 beyond, kept for the next call. Errors: OutOfTime before it.
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

/// G = N^2/(N^2 - 1/4).
Ball shell_ratio(const Ball& N);

/// What section 7 bounds of the symbol for all N >= N_1 = family.size(start), as stated with `end` at their names.
/// N is N_1, `fewest` and `most` its M_- and M_+.
struct SymbolConstants {
  Ball N, fewest, most, H, F, E, B;
};

/// (7.3) to (7.8) but for (7.7). A ledger that does not hold ends with the inequality that misses.
SymbolConstants state_symbol(Ledger& ledger, const SchemeFamily& family, int degree, int start, const std::string& end);

/// Smoothness for every n: Theorem U for degree 1 of the primal family, else Theorem V. Domain: as uniform_7.
void smoothness(Ledger& ledger, const SchemeFamily& family, int degree, int threads);

/// The table of Theorem W, n = 2 ... last_rate of the primal family, degree 1; its rows, kept for the next call.
constexpr int last_rate = 43;
std::vector<SmoothnessRate> smoothness_rates(int threads);
void smoothness_table(Ledger& ledger, const SchemeFamily& family, int degree, int threads);

/// What `smoothness` proves of the smoothest class for every n >= `first`, and of those before.
struct SmoothnessRange {
  int order;                ///< of the derivatives: sum rules - 1
  int first;                ///< the least n from which on all limits have them
  int start;                ///< n_1: from here on for all n at once
  std::optional<int> rate;  ///< n_2: from here on the rate holds with constants
  bool is_found = true;     ///< else the inequalities fail at `start` as at all numbers tried before
};
SmoothnessRange smoothness_range(const SchemeFamily& family, int degree);

/// Theorem X: smoothness for every degree and all n from a power of 4 on, with a bound of the rate; the two primal
/// families at once, and the two dual ones. Domain: odd degree >= 5 for primal, degree >= 3 for dual schemes.
void every_smoothness(Ledger& ledger, const SchemeFamily& family, int degree, int threads);
/// The exponent of this power.
int every_smoothness_power(Evaluation evaluation, int degree);
/// For all n from this multiple of the power on, the least of three decimals above 1/16, they show the smoothest class.
Rational every_smoothness_start(const SchemeFamily& family, int degree);

/// The proved lower end of the Hoelder exponent of one scheme, 0 where there is none; kept for the next call.
Rational exponent_bound(const std::string& scheme);

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

/// Theorems P to S: convergence, Conjecture 8 in d from degree 1, 3, ..., 11 to all higher degrees, C_d < C_{d+2}.
Constants convergence_constants(int degree);
std::vector<Check> convergence_checks(const Constants& constants, int degree, int threads);
Constants all_higher_constants(int degree);
std::vector<Check> all_higher_checks(const Constants& constants, int degree, int threads);
/// The least degree that all_higher_checks compares with; those between follow from neighbours. Domain: 3 to 11, odd.
int all_higher_from(int degree);
std::vector<Check> limits_grow_checks(const Constants& constants, int threads);

/// Theorem T: degree against degree + 2, for n >= large_n(degree). Domain: odd degree >= 5.
Constants large_n_constants(int degree);
std::vector<Check> large_n_checks(const Constants& constants, int degree, int threads);

/// Theorem T (c): degree against degree + 2, for all n. Domain: odd degree from 13 to 191. Cost: for degree 13 five
/// seconds on one thread, for 31 some minutes.
std::vector<Check> every_n_checks(const Constants& constants, int degree, int threads);

Constants limit_constants_stated();
std::vector<Check> limit_constants_checks(const Constants& constants, int threads);

}  // namespace subcert::theorems
