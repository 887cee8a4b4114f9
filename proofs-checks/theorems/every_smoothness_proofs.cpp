// Theorem X: smoothness for every degree and all n from a power of 4 on. The numbers of the checks are those of
// docs/theorems/every-smoothness.tex.

#include "every_smoothness.hpp"
#include "proofs.hpp"

#include "kernel/kernel.hpp"

namespace subcert::theorems {
namespace {

const Rational decaying(9, 5);  ///< from M sin w = 9a/5 on the decay of the responses is used

/// The product of 1 + C sin(w_q) over all shells.
Ball constants_product(const Rational& C) {
  constexpr int computed = 40;
  const Ball pi = Ball::pi(proof_bits), factor = exactly(C);
  Ball product(1, proof_bits);
  for (int q = 0; q < computed; ++q) product *= factor * sin(pi.scaled(-q - 2)) + 1;
  return product.widened(product * (exp(factor * pi.scaled(-computed - 1)) - 1));
}

/// The product of all G_i.
Ball amplitude_product(const EveryRule& rule) {
  constexpr int computed = 40;
  Ball product(1, proof_bits);
  for (int i = 0; i < computed; ++i) product *= rule.amplitude(i);
  return product.widened(product * (exp(Ball(8, proof_bits).scaled(-computed)) - 1));
}

bool is_dual(Evaluation evaluation) { return evaluation == Evaluation::dual; }

Integer power_of_four(int exponent) { return Integer(1) << (2 * exponent); }

EveryRule rule_from(Evaluation evaluation, int degree, const Integer& n) {
  return {evaluation, degree, exactly(Rational(is_dual(evaluation) ? 2 * n : 2 * n - 1))};
}

/// The chain of inequalities for all schemes with at least as many points.
void state_chain(Ledger& ledger, const EveryRule& rule) {
  const Ball &M = rule.M, pi = Ball::pi(proof_bits), gamma = rule.gamma(), a = rule.root(), four_a = a.scaled(2),
             tau = log2(pi * M / four_a), b = log2(a / gamma);
  const int k = rule.order(), degree = rule.kernel_degree();
  const auto above = [&](const char* name, const char* id, const char* meaning, const char* formula,
                         const Ball& number) { return ledger.state(name, Side::above, id, meaning, formula, number); };
  const Ball p = above("p_1", "X.1", "1/Phi(pi/2)", "1/Phi(pi/2)", 1 / Kernel(1, proof_bits).product(pi.scaled(-1)));
  const Ball B = above("B*", "X.2", "the constants in a product", "product of 1 + C sin(pi 2^(-q-2))",
                       constants_product(rule.constant()));
  const Ball K = above("K", "X.3", "what a product exceeds that of gamma/(M sin w_q) by", "product of the G_i",
                       amplitude_product(rule));
  const Ball E = above("E", "X.4", "M |m(pi - w)|/gamma, M sin w >= 9a/5", "the bound of M |m(pi - w)|/gamma",
                       rule.far());
  const Ball omega = above("omega", "X.5", "what tends to 1 as M grows", "exp((3 tau_1 + 3)/M_1 + chi)",
                           exp((tau * 3 + 3) / M + rule.excess()));
  const Ball S = above("S", "X.6", "M |m(pi - w)| (2k-1)!!/(gamma (M w)^k), M w <= 4a",
                       "the bound of M |m(pi - w)| (2k-1)!!/(gamma (M w)^k)", rule.near());
  ledger.need(less("X.18", "4 (p + 1)^2 (p + 2) < M_1",
                   Enclosure::exactly(4 * power(Rational(degree + 1), 2) * (degree + 2)), M.enclosure()));
  ledger.need(less("X.7", "log2(a/gamma) + 3 < k", (b + 3).enclosure(), Enclosure::exactly(k)));
  ledger.need(less("X.8", "max(k, 6) < tau_1", Enclosure::exactly(std::max(k, 6)), tau.enclosure()));
  // The terms 2^(k(l+1)) e_l X of the shells where the decay is used: the first, and bounds of the others.
  const Ball size = omega * E * gamma / M, ratio = gamma.scaled(2) / (pi * M), all = p * B * K;
  const Ball falling = tau * (tau + b.scaled(1) + 3) / 2;
  const Ball second = size * all * ratio.scaled(2 * k), third = size * all * (ratio * ratio).scaled(3 * k + 1);
  const Ball last = omega * E * all * pi.scaled(-1) * power_of_two(tau * k - falling);
  const Ball zeta = above("zeta", "X.9", "sum of 2^(k(l+1)) e_l X over l < J", "T_0 + T_1 + (tau_1 - 2) max(T_2, T)",
                          size.scaled(k) + second + (tau - 2) * max(third, last));
  ledger.need(less("X.10", "zeta < 1", Enclosure::exactly(ledger["zeta"]), Enclosure::exactly(1)));
  const Ball share = omega * S * all * pi * four_a.pow(k) / exactly(odd_factorial(k));
  const Ball Z = above("Z", "X.11", "sum of 2^((k-1)(l+1)) e_l X over l >= J",
                       "omega S p_1 B* K pi (4a)^k/(2k-1)!! 2^(tau_1 (k - 1) - tau_1 (tau_1 + 2b + 3)/2)",
                       share * power_of_two(tau * (k - 1) - falling));
  ledger.need(
      less("X.12", "zeta/2 + Z < 1", Enclosure::exactly(ledger["zeta"] / 2 + ledger["Z"]), Enclosure::exactly(1)));
  if (!ledger.holds()) return;
  above("R", "X.13", "(k - s) y^(log2(y)/2 - r), y = pi M/(4a)",
        "omega S p_1 B* K (pi/2) (4a)^k/((2k-1)!! (1 - zeta) ln 2)",
        share.scaled(-1) / ((1 - zeta) * log(Ball(2, proof_bits))));
  ledger.state("r", Side::above, "X.14", "k - s = O(y^(r - log2(y)/2))", "k - 3/2 - log2(a/gamma)",
               k - exactly(Rational(3, 2)) - b, 6);
}

/// All bounds of the chain fall from one degree to the one above it by 2: the largest factor but for the power of 2,
/// and this power.
void check_next_degree(Ledger& ledger, const EveryRule& rule) {
  const int p = rule.kernel_degree(), k = rule.order();
  const Ball a = rule.root(), step = log2(EveryRule{rule.evaluation, rule.degree + 2, rule.M}.root() / a);
  const Ball rho = log2(Ball::pi(proof_bits) * rule.M / a.scaled(2)) + log2(a / rule.gamma()).scaled(1) + 3 -
                   2 * (k - 1);
  const Rational power(k * (2 * p + 3), p * (p + 1));
  ledger.need(less("X.15", "8 e^(k (2p + 3)/(p (p + 1))) < 2^((4 - log2(a'/a)) rho/2)",
                   exp(exactly(power)).scaled(3).enclosure(), power_of_two((4 - step) * rho / 2).enclosure()));
  ledger.need(less("X.16", "log2(a'/a) < 1", step.enclosure(), Enclosure::exactly(1)));
  ledger.need(less("X.17", "4 < rho", Enclosure::exactly(4), rho.enclosure()));
}

/// 1/(1 - nu/u^2) at u = 9a/5.
Rational beyond() { return decaying * decaying / (decaying * decaying - 1); }

}  // namespace

int EveryRule::kernel_degree() const { return is_dual(evaluation) ? degree + 1 - degree % 2 : degree; }

int EveryRule::order() const { return alias_order(evaluation, degree); }

Ball EveryRule::gamma() const { return exactly(gamma_of(kernel_degree())); }

Ball EveryRule::root() const { return sqrt(exactly(Rational(kernel_degree()) * (kernel_degree() + 1))); }

Ball EveryRule::amplitude(int i) const {
  const Ball square = exactly(decaying * decaying).scaled(2 * i), less_one = square - 1;
  const Ball eta = (square + 1) / (root() * less_one * sqrt(less_one));
  return square / less_one * (sqrt(eta * eta + 1) + eta);
}

Rational EveryRule::constant() const { return is_dual(evaluation) ? Rational(4) : Rational(1, 2); }

Ball EveryRule::far() const {
  const Ball mu = sqrt(exactly(beyond()));
  if (!is_dual(evaluation))
    return (Ball::pi(proof_bits) * amplitude(0).scaled(-1) + mu + exactly(Rational(13, 4))).scaled(-1);
  const Rational p = kernel_degree(), more = p + Rational(3, 2);
  return sqrt(exactly(2)) * exactly(beyond()) + exactly(2 * beyond() / (decaying * decaying) * more / p) +
         mu.scaled(1) * exactly(more / decaying) / root() + 2;
}

Ball EveryRule::near() const {
  const Ball widest = root().scaled(2) / M;
  if (is_dual(evaluation)) return (2 / M + 1) * (degree % 2 == 0 ? 5 : 2) / cos(widest);
  return (1 / M.scaled(2) + (exactly(Rational(1, 4)) + widest * widest * M) / (cos(widest) * order()) + 1).scaled(-1);
}

Ball EveryRule::excess() const {
  if (!is_dual(evaluation)) return Ball(proof_bits);
  const int p = kernel_degree();
  return gamma() * root().scaled(2).pow(p + 1) * exactly(Rational(9 * (p + 2) * (p + 2), p + 1)) /
         (exactly(odd_factorial(p + 1)) * M * M);
}

Rational odd_factorial(int k) {
  Rational result = 1;
  for (int i = 3; i < 2 * k; i += 2) result *= i;
  return result;
}

int every_smoothness_power(Evaluation evaluation, int degree) { return is_dual(evaluation) ? degree + 2 : degree; }

void every_smoothness(Ledger& ledger, const SchemeFamily& family, int degree, int) {
  const EveryRule rule = rule_from(family.evaluation, degree,
                                   power_of_four(every_smoothness_power(family.evaluation, degree)));
  state_chain(ledger, rule);
  if (ledger.holds()) check_next_degree(ledger, rule);
}

Rational every_smoothness_start(const SchemeFamily& family, int degree) {
  constexpr int parts = 1000;
  const Integer whole = power_of_four(every_smoothness_power(family.evaluation, degree));
  // The bounds fall with n; they hold for the whole.
  int low = parts / 16, high = parts;
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    Ledger ledger;
    state_chain(ledger, rule_from(family.evaluation, degree, whole * middle / parts));
    (ledger.holds() ? high : low) = middle;
  }
  return Rational(high, parts);
}

}  // namespace subcert::theorems
