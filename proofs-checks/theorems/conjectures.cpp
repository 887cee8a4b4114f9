#include "conjectures.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/schemes/specification.hpp>

#include "degree_one.hpp"
#include "kernel.hpp"
#include "limit_constant.hpp"

namespace subcert::theorems {
namespace {

/// Exact means up to here, estimates from here on.
constexpr int turn = 24;
constexpr slong precision = 192;

Check less(const std::string& id, const std::string& meaning, const Enclosure& left, const Enclosure& right) {
  const std::string numbers = " [" + left.lower_text(8) + ", " + left.upper_text(8) + "] < [" + right.lower_text(8) +
                              ", " + right.upper_text(8) + "]";
  Decision decision{Truth::unknown, "the enclosures overlap:" + numbers};
  if (left.upper && right.lower && *left.upper < *right.lower)
    decision = {Truth::yes, "enclosures"};
  else if (left.lower && right.upper && *left.lower >= *right.upper)
    decision = {Truth::no, "enclosures:" + numbers};
  return {id, meaning + ":" + numbers, decision};
}

Real ball(const Enclosure& enclosure) {
  const Real half(Rational((*enclosure.upper - *enclosure.lower) / 2), precision);
  return Real(Rational((*enclosure.upper + *enclosure.lower) / 2), precision).widened(half);
}

Real exactly(const Rational& value) { return Real(value, precision); }

/// lower <= psi_n(x) <= upper for all x, from the exact mean.
struct Range {
  Rational mean, lower, upper;
};

Range range(int n) {
  const Mask mask = make_scheme("primal:n=" + std::to_string(n)).mask;
  Range result{squared_l2_norm(mask), variance_floor(mask), Rational(1, 2 * n - 1)};
  if (n == 1) return result;
  const Rational ripple = *degree_one_bounds(n).ripple.upper;
  result.lower = std::max(result.lower, Rational(result.mean - ripple));
  result.upper = std::min(result.upper, Rational(result.mean + ripple));
  return result;
}

/// The constants of section 3 of the text, which hold for all n >= turn.
struct Tail {
  Real N, c, remainder, ripple, slope, sigma, big_y, big_z, zeta;
};

Tail tail() {
  const Real pi = Real::pi(precision), kappa = ball(cosine_minus_sinc_supremum());
  Tail result;
  result.N = exactly(Rational(4 * turn - 1, 2));
  result.c = ball(limit_constant(1, 40));
  const Real N = result.N, square = N * N;
  const Real G = square / (square - exactly(Rational(1, 4)));

  Real three = G.pow(3), four(precision);
  for (int j = 0; j < 3; ++j) three = three / sin(pi.scaled(-j - 2));
  four = three * G / sin(pi.scaled(-5));
  // sigma: u / sin u - 1 <= u^2 / 5 for u <= 1/2.
  Real sigma(precision);
  for (int i = 0; i < 10; ++i) sigma += pi.scaled(-i - 1) / sin(pi.scaled(-i - 1)) - 1;
  result.sigma = sigma + (pi * pi).scaled(-20) / 15;

  const Real h = pi.scaled(-2) / sin(pi.scaled(-2));
  Real log2(precision);
  arb_log_base_ui(log2.get(), exactly(turn).get(), 2, precision);
  result.big_y = kappa * (log2 + 2) / (2 * (2 * turn - 1)) + h * pi * pi * (4 * turn - 1) / (36 * turn * turn);
  result.big_z = pi * kappa * turn / (2 * turn - 1) + h * pi * pi / 3;
  result.zeta = pi * kappa * 14 / (4 * (2 * turn - 1)) + three / N.pow(3) * result.big_z;

  const Real aliases = four / N.pow(4) * result.big_y / (1 - result.big_y);
  result.ripple = N.pow(4) * (aliases + aliases * aliases).scaled(1);
  const Real v0 = four / N.pow(4) / (1 - result.zeta);
  result.slope = N.pow(4) * pi.scaled(2) / 3 * (aliases + v0 * result.big_z * (aliases + 1));
  result.remainder = ball(degree_one_mean(turn).remainder) * N.pow(5);
  return result;
}

std::vector<Check> tail_checks(const Tail& t) {
  return {less("3.1", "sigma < 1", t.sigma.enclosure(), Enclosure::exactly(1)),
          less("3.2", "bound of all Y_j < 1", t.big_y.enclosure(), Enclosure::exactly(1))};
}

std::string text(int n) { return std::to_string(n); }

}  // namespace

Decision verdict(const std::vector<Check>& checks) {
  for (const Check& check : checks)
    if (check.decision.is_no()) return {Truth::no, check.id + " fails: " + check.claim};
  for (const Check& check : checks)
    if (!check.decision.is_yes()) return {Truth::unknown, check.id + " is undecided: " + check.claim};
  return {Truth::yes, text(static_cast<int>(checks.size())) + " inequalities hold"};
}

std::vector<Check> conjecture_8_in_n_degree_one() {
  const Tail t = tail();
  std::vector<Check> checks = tail_checks(t);
  Range here = range(1);
  for (int n = 1; n < turn; ++n) {
    const Range next = range(n + 1);
    checks.push_back(less("4.1", "max psi_" + text(n + 1) + " < min psi_" + text(n), Enclosure::exactly(next.upper),
                          Enclosure::exactly(here.lower)));
    here = next;
  }
  const Real loss = (t.remainder / t.N.pow(5) + t.ripple / t.N.pow(4)).scaled(1) * t.N * (t.N + 2);
  checks.push_back(less("4.2", "N (N+2) (2 K/N^5 + 2 Omega/N^4) < 4c at n = " + text(turn), loss.enclosure(),
                        t.c.scaled(2).enclosure()));
  return checks;
}

std::vector<Check> conjecture_7_degree_one() {
  const Tail t = tail();
  std::vector<Check> checks = tail_checks(t);
  for (int n = 1; n < turn; ++n) {
    const Range psi = range(n);
    const Real scale = exactly(Rational(4 * n - 1, 4)) / t.c;
    checks.push_back(less("5.1", "(n - 1/4) max psi_n / c - 1 < 2/n^2 at n = " + text(n),
                          (exactly(psi.upper) * scale - 1).enclosure(), Enclosure::exactly(Rational(2, n * n))));
    checks.push_back(less("5.1", "1 - (n - 1/4) min psi_n / c < 2/n^2 at n = " + text(n),
                          (1 - exactly(psi.lower) * scale).enclosure(), Enclosure::exactly(Rational(2, n * n))));
  }
  const Real inside = exactly(Rational(13, 36)) + t.remainder / t.N.pow(2) / t.c.scaled(1) +
                      t.ripple / t.N / t.c.scaled(1);
  const Real ratio = (1 / t.N.scaled(1) + 1).pow(2).scaled(-2);  // n^2 / N^2
  checks.push_back(less("5.2", "n^2/N^2 (13/36 + K/(2c N^2) + Omega/(2c N)) < 2 at n = " + text(turn),
                        (ratio * inside).enclosure(), Enclosure::exactly(2)));

  for (int n = 3; n < turn; ++n) {
    Enclosure scaled = degree_one_bounds(n).slope;
    if (scaled.upper) *scaled.upper *= n * n;
    *scaled.lower *= n * n;
    checks.push_back(less("6.1", "n^2 D_n < 5 at n = " + text(n), scaled, Enclosure::exactly(5)));
  }
  checks.push_back(less("6.2", "bound of all Z_0 < 1", t.zeta.enclosure(), Enclosure::exactly(1)));
  checks.push_back(less("6.3", "n^2/N^2 Delta/N^2 < 5 at n = " + text(turn), (ratio * t.slope / t.N.pow(2)).enclosure(),
                        Enclosure::exactly(5)));
  return checks;
}

}  // namespace subcert::theorems
