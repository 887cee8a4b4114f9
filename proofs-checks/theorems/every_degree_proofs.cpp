// What holds for every degree: convergence, the order of the limits C_d, and Conjecture 8 in d from a low degree to all
// higher ones. The numbers of the checks are those of docs/theorems/.

#include "every_pair.hpp"
#include "proofs.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/support/parallel.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include "kernel/kernel.hpp"
#include "kernel/kernel_coefficients.hpp"
#include "variance_ends.hpp"

#if __has_include(<flint/arb_hypgeom.h>)
#include <flint/arb_hypgeom.h>
#else
#include <arb_hypgeom.h>
#endif

#include <algorithm>
#include <iterator>

namespace subcert::theorems {
namespace {

int least_n(int degree) { return (degree + 1) / 2; }

Enclosure exact(const Rational& value) { return Enclosure::exactly(value); }

Rational tiny() { return power(Rational(10), -30); }

/// The modulus of the first zero of the Airy function Ai.
Ball first_airy_zero() {
  Ball zero(proof_bits);
  arb_hypgeom_airy_zero(zero.get(), nullptr, nullptr, nullptr, flint::Whole(Integer(1)).get(), proof_bits);
  return -zero;
}

/// The coefficients of z^-p, z^(2-p), ..., z^p in the ultraspherical polynomial C_p^(l+1), z = e^(iw), times
/// (z - 1/z)^l: the transform of a discrete Chebyshev polynomial on p + l + 1 points, without its factor.
std::vector<Rational> chebyshev_transform(int p, int l) {
  std::vector<Rational> result;
  for (int y = 0; y <= p; ++y) result.push_back(binomial(y + l, l) * binomial(p - y + l, l));
  for (int i = 0; i < l; ++i) {
    result.push_back(0);
    for (std::size_t k = result.size(); k-- > 0;) result[k] = (k > 0 ? result[k - 1] : Rational(0)) - result[k];
  }
  return result;
}

/// The sum over x of |x K_M(x) - its value by the lemma on the derivative of the response|. Domain: M >= degree + 1.
Rational derivative_error(const Mask& mask, int M, int degree) {
  const int m = (degree - 1) / 2;
  Rational factor = gamma_of(degree) / M;  // c/2^d
  for (int i = 1; i <= degree; ++i) factor *= i;
  for (int i = 1; i <= m; ++i) factor /= M * M - 4 * i * i;
  if (m % 2 == 1) factor = -factor;  // i D' = - sum of x K z^x, and (2i sin w)^d = (z - 1/z)^d
  const std::vector<Rational> values = chebyshev_transform(M - 1 - degree, degree);
  Rational error = 0;
  for (int k = 0; k < M; ++k) {
    const int x = 2 * k - (M - 1);
    error += absolute(x * mask.symbol().coefficient(x) - factor * values[static_cast<std::size_t>(k)]);
  }
  return error;
}

/// The largest |D_M| at w = pi i/64, 1 <= i <= 32; it differs from 1 by as little as w^(d+1).
Ball largest_response(const Mask& mask, int M, int degree) {
  const slong bits = proof_bits + 6 * degree;
  Ball largest(bits);
  for (int i = 1; i <= 32; ++i) {
    Ball value(bits);
    for (int x = 1 - M; x <= M - 1; x += 2)
      value += Ball(mask.symbol().coefficient(x), bits) * cos(Ball::pi(bits) * (x * i) / 64);
    largest = max(largest, abs(value));
  }
  return largest;
}

/// chi_d(M). Domain: M > degree.
Rational reproduction_bound(int degree, int M) {
  Rational sum = 0, product = 1;
  for (int q = 0; 2 * q < degree; ++q) {
    if (q > 0) product *= Rational(M * M - 4 * q * q) / (M * M - (2 * q - 1) * (2 * q - 1));
    sum += (4 * q + 1) * power(central(q), 2) * product;
  }
  return sum;
}

/// What is proved to lie below psi_n^d everywhere.
Rational variance_below(int n, int degree) { return reproduction_bound(degree, 4 * n - 2) / (4 * n - 2); }

std::vector<Check> checks_from_one() {
  std::vector<Check> checks;
  const int last = 8;
  const auto between = [](int n) { return exact(Rational(1, 2 * n - 1)); };
  for (int n = 2; n <= last; ++n)
    checks.push_back(less("Q.1", "max psi^1 < 1/(2n - 1) on a grid" + at(n),
                          exact(variance_grid(primal_mask(n, 1), 4, false).largest()), between(n)));
  for (int n = 2; n <= last; ++n)
    checks.push_back(less("Q.2", "1/(2n - 1) < chi_3/(4n - 2)" + at(n), between(n), exact(variance_below(n, 3))));
  for (int n = 2; n <= last; ++n)
    for (int degree = 3; degree < 2 * n; degree += 2)
      checks.push_back(less("Q.3", "chi_d/(4n - 2) < min psi^d on a grid, d = " + text(degree) + at(n),
                            exact(variance_below(n, degree)),
                            exact(variance_grid(primal_mask(n, degree), 4, false).smallest())));
  return checks;
}

/// From degree 7 on: every larger degree >= all_higher_from(degree), by U_n and Lemma 10.
std::vector<Check> checks_by_ceiling(int degree, int threads) {
  const int next = all_higher_from(degree), first = least_n(next), middle = degree == 7 ? 18 : first, start = 60;
  std::vector<std::vector<Check>> of_n(static_cast<std::size_t>(start - first));
  parallel_for_each(of_n.size(), threads, [&](std::size_t i) {
    const int n = start - 1 - static_cast<int>(i);  // those that cost most first
    std::vector<Check>& checks = of_n[of_n.size() - 1 - i];
    const Enclosure ceiling = exact(curve_ceiling(n, degree));
    if (n >= middle)
      checks.push_back(less("R.4", "U of degree " + text(degree) + " < chi_" + text(next) + "/(4n - 2)" + at(n),
                            ceiling, exact(variance_below(n, next))));
    for (int higher = next; n < middle && higher < 2 * n; higher += 2)
      checks.push_back(less("R.3", "U of degree " + text(degree) + " < 2 I - U of degree " + text(higher) + at(n),
                            ceiling, exact(2 * squared_l2_norm(primal_mask(n, higher)) - curve_ceiling(n, higher))));
  });
  std::vector<Check> checks;
  for (std::vector<Check>& some : of_n) std::ranges::move(some, std::back_inserter(checks));
  const int points = 2 * start;
  const Ball weights = exactly((points - 1) * central_weight(degree, points - 1) +
                               points * central_weight(degree, points));
  checks.push_back(less("R.5", "(2n - 1) K_{2n-1}(0) + 2n K_2n(0) + 4n Z < chi_" + text(next) + at(start),
                        (weights + large_bounds(degree, start).ripple * (2 * points)).enclosure(),
                        exact(reproduction_bound(next, 2 * points - 2))));
  return checks;
}

/// The numbers that the proof of Theorem P rounds, (P.5) to (P.15); the least degree, 3, decides where one stands.
std::vector<Check> rounded_checks() {
  const Ball pi = Ball::pi(proof_bits);
  const auto stated = [](const char* value) { return exact(decimal(value)); };
  const Rational rho = 16 * power(Rational(1 + rounded::turning), 2) * rounded::gammas,
                 odd_rho = rho * power(Rational(1 + rounded::excess), 2);
  const Ball share = 4 / (pi * pi);
  const Rational least(44, 10);  // of X/d
  return {less("P.5", "4/pi - 1 < 0.28", (4 / pi - 1).enclosure(), exact(rounded::rise)),
          less("P.6", "(5/16)(4/51) + 4/25 < 0.19", exact(Rational(5, 204) + Rational(4, 25)), exact(rounded::turning)),
          less("P.7", "0.28 (d + 4)/(7d + 16) < 0.053 at d = 3", exact(rounded::rise * 7 / 37), exact(rounded::excess)),
          less("P.8", "16 (1.19)^2 1.08 (4/pi^2) < 10", (exactly(rho) * share).enclosure(), exact(10)),
          less("P.9", "the same times 1.053^2 < 11", (exactly(odd_rho) * share).enclosure(), exact(11)),
          less("P.10", "(4.4 d)^3 < 25.5 nu^2 (5d + 9)/(d + 3)^2 at d = 3", exact(power(least * 3, 3)),
               exact(Rational(51, 2) * 144 * 24 / 36)),
          less("P.11", "3 nu/(2 (4.4 d)^2) < 0.11 at d = 3", exact(18 / power(least * 3, 2)), stated("0.11")),
          less("P.12", "0.46 < sqrt(nu) - d at d = 3", stated("0.46"), (sqrt(exactly(12)) - 3).enclosure()),
          less("P.13", "10 + 51 nu/(5d + 9) < 10.2 d + 5 at d = 3", exact(10 + Rational(51 * 12, 24)), stated("35.6")),
          less("P.13", "11 + 51 nu/(7d + 16) < 7.3 d + 6 at d = 3", exact(11 + Rational(51 * 12, 37)), stated("27.9")),
          less("P.14", "11.6^2 < 41^3/510", exact(power(decimal("11.6"), 2)), exact(Rational(68921, 510))),
          less("P.15", "10.6^2 < 40^3/561", exact(power(decimal("10.6"), 2)), exact(Rational(64000, 561)))};
}

/// s^2 integral of h^2, and the factor (sqrt(1 + eta^2) + eta)^2, at beta = 7/5.
Ball beyond_turning_point(const Ball& a) {
  const Ball beta = exactly(Rational(7, 5)), square = beta * beta - 1;
  const Ball integral = beta / square.scaled(1) + log((beta + 1) / (beta - 1)).scaled(-2);
  const Ball eta = (beta * beta + 1) / (a * square * sqrt(square));
  return integral / a * (sqrt(eta * eta + 1) + eta).pow(2);
}

}  // namespace

Constants convergence_constants(int) {
  return Constants({{"alpha-", decimal("2.338"), Side::below, "P.1", "the first zero of the Airy function is -alpha"}});
}

std::vector<Check> convergence_checks(const Constants& c, int degree, int) {
  const Rational alpha = c["alpha-"];
  std::vector<Check> checks{defining(c, "alpha-", "alpha", first_airy_zero()),
                            less("P.2", "51 < 4 alpha-^3", exact(51), exact(4 * alpha * alpha * alpha))};
  std::vector<Check> responses;
  for (int n = least_n(degree); n < least_n(degree) + 6; ++n) {
    const Mask mask = primal_mask(n, degree);
    for (int M = std::max(2 * n - 1, degree + 1); M <= 2 * n; ++M) {
      checks.push_back(less("P.3", "|coefficients of D_M' - those of the lemma| < 10^-30 at M = " + text(M),
                            exact(derivative_error(mask, M, degree)), exact(tiny())));
      responses.push_back(less("P.4", "|D_M(pi i/64)| < 1, i <= 32, at M = " + text(M),
                               largest_response(mask, M, degree).enclosure(), exact(1)));
    }
  }
  const std::vector<Check> more = rounded_checks();
  checks.insert(checks.end(), responses.begin(), responses.end());
  checks.insert(checks.end(), more.begin(), more.end());
  return checks;
}

int all_higher_from(int degree) {
  switch (degree) {
    case 3: return 7;
    case 9: return 21;
    case 11: return 25;
    default: return 2 * degree + 1;
  }
}

Constants all_higher_constants(int degree) {
  if (degree == 1 || degree >= 7) return Constants();
  const std::string name = "c+_" + text(degree);
  for (const Constant& constant : uniform_constants_7(degree).all())
    if (constant.name == name) return Constants({constant});
  return Constants();
}

std::vector<Check> all_higher_checks(const Constants& c, int degree, int threads) {
  if (degree == 1) return checks_from_one();
  if (degree >= 7) return checks_by_ceiling(degree, threads);
  const int next = all_higher_from(degree), start = degree == 3 ? 6 : 10;
  const std::string name = "c+_" + text(degree);
  std::vector<Check> checks{defining(c, name, "C_" + text(degree), limit_ball(degree))};
  prepare_variance_ends(least_n(next), start - 1, {degree}, threads);
  for (int n = least_n(next); n < start; ++n)
    checks.push_back(less("R.1", "max psi^" + text(degree) + " < chi_" + text(next) + "/(4n - 2)" + at(n),
                          variance_ends(n, degree).maximum, exact(variance_below(n, next))));
  const Rational beta = uniform_constants_7(degree)["beta"];
  checks.push_back(less("R.2", name + " (1 + beta/n_2^2) < chi_" + text(next) + "(4 n_2 - 2)/4 at n_2 = " + text(start),
                        exact(c[name] * (1 + beta / (start * start))),
                        exact(reproduction_bound(next, 4 * start - 2) / 4)));
  return checks;
}

std::vector<Check> limits_grow_checks(const Constants&, int) {
  const int first = 9;
  const Ball d(first, proof_bits), a = sqrt(d * (first + 1)), gamma = exactly(gamma_of(first));
  const Ball beta = exactly(Rational(7, 5)), e = exp(Ball(1, proof_bits)), one(1, proof_bits);
  const Ball before = gamma * beta.scaled(1) / (first + 2) * (beta * e).scaled(-2).pow(first + 1) /
                      (sqrt(e.scaled(1)) * (one - one.scaled(-first - 1)));
  std::vector<Check> checks{less("S.1", "the bound of pi (k_d(0) - C_d) < 2 - 1/d at d = 9",
                                 (gamma * gamma * beyond_turning_point(a) + before).enclosure(),
                                 exact(2 - Rational(1, first)))};
  const auto half_square = [](int degree) -> Rational { return power(gamma_of(degree), 2) / 2; };
  for (int degree = 1; degree < 7; degree += 2)
    checks.push_back(less("S.2", "gamma^2/2 < C_" + text(degree + 2) + ", gamma of degree " + text(degree),
                          exact(half_square(degree)), limit_ball(degree + 2).enclosure()));
  const Ball pi = Ball::pi(proof_bits), shift = one / (sqrt(exactly(3)) * pi * pi) - one / pi.scaled(1);
  std::vector<Check> expansions;
  for (int degree = 1; degree <= 21; degree += 2) {
    const Ball& limit = limit_ball(degree);
    if (degree >= first) {
      checks.push_back(less("S.3", "gamma^2/2 < C_" + text(degree) + ", gamma of degree " + text(degree - 2),
                            exact(half_square(degree - 2)), limit.enclosure()));
      checks.push_back(less("S.3", "C_" + text(degree) + " < gamma^2/2, gamma of the same degree", limit.enclosure(),
                            exact(half_square(degree))));
    }
    expansions.push_back(less("S.4", "d |C_d - d/pi - 1/(2 pi) + 1/(sqrt(3) pi^2)| < 1/10 at d = " + text(degree),
                              (abs(limit - Ball(degree, proof_bits) / pi + shift) * degree).enclosure(),
                              exact(Rational(1, 10))));
  }
  checks.insert(checks.end(), expansions.begin(), expansions.end());
  return checks;
}

}  // namespace subcert::theorems
