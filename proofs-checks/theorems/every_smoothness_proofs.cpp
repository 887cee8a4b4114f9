// Theorem X: smoothness for every degree, n >= 4^d. The numbers of the checks are those of
// docs/theorems/every-smoothness.tex.

#include "every_smoothness.hpp"
#include "kernel.hpp"
#include "proofs.hpp"

namespace subcert::theorems {
namespace {

/// The product of 1 + sin(w_q)/2 over all shells.
Ball constants_product() {
  constexpr int computed = 40;
  const Ball pi = Ball::pi(proof_bits);
  Ball product(1, proof_bits);
  for (int q = 0; q < computed; ++q) product *= sin(pi.scaled(-q - 2)).scaled(-1) + 1;
  return product.widened(product * (exp(pi.scaled(-computed - 2)) - 1));
}

/// The product of all G_i.
Ball amplitude_product(const EveryRule& rule) {
  constexpr int computed = 40;
  Ball product(1, proof_bits);
  for (int i = 0; i < computed; ++i) product *= rule.amplitude(i);
  return product.widened(product * (exp(Ball(8, proof_bits).scaled(-computed)) - 1));
}

/// 4^d.
Integer power_of_four(int degree) { return Integer(1) << (2 * degree); }

/// The chain of inequalities for all n >= `start`.
void state_chain(Ledger& ledger, int degree, const Integer& start) {
  const Ball M = exactly(Rational(2 * start - 1)), pi = Ball::pi(proof_bits);
  const EveryRule rule{degree, M};
  const Ball gamma = rule.gamma(), a = rule.root(), tau = log2(pi * M / a.scaled(2)), b = log2(a / gamma);
  const int r = degree + 1;
  const auto above = [&](const char* name, const char* id, const char* meaning, const char* formula,
                         const Ball& number) { return ledger.state(name, Side::above, id, meaning, formula, number); };
  const Ball p = above("p", "X.1", "1/Phi(pi/2)", "1/Phi(pi/2)", 1 / Kernel(1, proof_bits).product(pi.scaled(-1)));
  const Ball B = above("B*", "X.2", "the constants B in a product", "product of 1 + sin(pi 2^(-q-2))/2",
                       constants_product());
  const Ball K = above("K", "X.3", "what a product exceeds that of gamma/(M sin w_q) by", "product of the G_i",
                       amplitude_product(rule));
  const Ball E = above("E", "X.4", "M |m(pi - w)|/gamma, M sin w >= 9a/5", "(pi G_0/2 + (1 - 25/81)^(-1/2) + 13/4)/2",
                       rule.far());
  const Ball omega = above("omega", "X.5", "what is of the order 1 + 1/M or 1 + 1/d",
                           "(1 + epsilon) exp((2 tau_1 + 3)/M_1)", rule.near() * exp((tau.scaled(1) + 3) / M));
  ledger.need(less("X.6", "log2(a/gamma) + 2 < d", (b + 2).enclosure(), Enclosure::exactly(degree)));
  ledger.need(less("X.7", "d + 1 < tau_1", Enclosure::exactly(r), tau.enclosure()));
  // The terms 2^(r(l+1)) e_l X of the shells where the decay is used: the first, and bounds of the others.
  const Ball size = omega * E * gamma / M, ratio = gamma.scaled(2) / (pi * M), all = p * B * K;
  const Ball falling = tau * (tau + b.scaled(1) + 3) / 2;
  const Ball second = size * all * ratio.scaled(2 * r), third = size * all * (ratio * ratio).scaled(3 * r + 1);
  const Ball last = omega * E * all * pi.scaled(-1) * power_of_two(tau * r - falling);
  const Ball zeta = above("zeta", "X.8", "sum of 2^((d+1)(l+1)) e_l X over l < J",
                          "T_0 + T_1 + (tau_1 - 2) max(T_2, T)",
                          size.scaled(r) + second + (tau - 2) * max(third, last));
  ledger.need(less("X.9", "zeta < 1", Enclosure::exactly(ledger["zeta"]), Enclosure::exactly(1)));
  const Ball odd = exactly(double_factorial(degree)), four_a = a.scaled(2);
  const Ball Z = above("Z", "X.10", "sum of 2^(d(l+1)) e_l X over l >= J",
                       "omega p B* K (pi/2) (4a)^(d+1)/(2d+1)!! 2^(tau_1 d - tau_1 (tau_1 + 2b + 3)/2)",
                       omega * all * pi.scaled(-1) * four_a.pow(r) / odd * power_of_two(tau * degree - falling));
  ledger.need(
      less("X.11", "zeta/2 + Z < 1", Enclosure::exactly(ledger["zeta"] / 2 + ledger["Z"]), Enclosure::exactly(1)));
  if (!ledger.holds()) return;
  above("R", "X.12", "(d + 1 - s) y^(log2(y)/2 - r), y = pi M/(4a)",
        "omega p B* K (pi/4) (4a)^(d+1)/((2d+1)!! (1 - zeta) ln 2)",
        omega * all * pi.scaled(-2) * four_a.pow(r) / (odd * (1 - zeta) * log(Ball(2, proof_bits))));
  ledger.state("r", Side::above, "X.13", "d + 1 - s = O(y^(r - log2(y)/2))", "d - 1/2 - log2(a/gamma)",
               degree - exactly(Rational(1, 2)) - b, 6);
}

/// All bounds of the chain fall from one degree to the next: the largest factor but for the power of 2, and this power.
void check_next_degree(Ledger& ledger, int degree) {
  const Ball M = exactly(Rational(2 * power_of_four(degree) - 1)), pi = Ball::pi(proof_bits);
  const EveryRule rule{degree, M};
  const Ball a = rule.root(), step = log2(EveryRule{degree + 2, M}.root() / a);
  const Ball rho = log2(pi * M / a.scaled(2)) + log2(a / rule.gamma()).scaled(1) + 3 - 2 * degree;
  const Rational share((degree + 2) * (degree + 3), (2 * degree + 3) * (2 * degree + 5));
  ledger.need(less("X.14", "16 (d + 2)(d + 3)/((2d + 3)(2d + 5)) e^(2 + 3/d) < 2^((4 - log2(a'/a)) rho/2)",
                   (exactly(16 * share) * exp(exactly(2 + Rational(3, degree)))).enclosure(),
                   power_of_two((4 - step) * rho / 2).enclosure()));
  ledger.need(less("X.15", "log2(a'/a) < 1/2", step.enclosure(), Enclosure::exactly(Rational(1, 2))));
  ledger.need(less("X.16", "4 < rho", Enclosure::exactly(4), rho.enclosure()));
}

}  // namespace

Ball EveryRule::gamma() const { return exactly(gamma_of(degree)); }

Ball EveryRule::root() const { return sqrt(exactly(Rational(degree) * (degree + 1))); }

Ball EveryRule::amplitude(int i) const {
  const Ball square = exactly(chosen::known * chosen::known).scaled(2 * i), less_one = square - 1;
  const Ball eta = (square + 1) / (root() * less_one * sqrt(less_one));
  return square / less_one * (sqrt(eta * eta + 1) + eta);
}

Ball EveryRule::far() const {
  const Rational square = chosen::known * chosen::known;
  return (Ball::pi(proof_bits) * amplitude(0).scaled(-1) + sqrt(exactly(square / (square - 1))) +
          exactly(Rational(13, 4)))
      .scaled(-1);
}

Ball EveryRule::near() const {
  const Ball widest = root().scaled(2) / M;
  return 1 / M.scaled(2) + (exactly(Rational(1, 4)) + widest * widest * M) / (cos(widest) * (degree + 1)) + 1;
}

Rational double_factorial(int degree) {
  Rational result = 1;
  for (int i = 3; i <= 2 * degree + 1; i += 2) result *= i;
  return result;
}

void every_smoothness(Ledger& ledger, const SchemeFamily&, int degree, int) {
  state_chain(ledger, degree, power_of_four(degree));
  if (ledger.holds()) check_next_degree(ledger, degree);
}

Rational every_smoothness_start(int degree) {
  constexpr int parts = 1000;
  // The bounds fall with n; they hold at 4^d.
  int low = parts / 16, high = parts;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    Ledger ledger;
    state_chain(ledger, degree, power_of_four(degree) * middle / parts);
    (ledger.holds() ? high : low) = middle;
  }
  return Rational(high, parts);
}

}  // namespace subcert::theorems
