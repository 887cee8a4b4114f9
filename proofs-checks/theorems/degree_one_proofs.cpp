// Conjectures 7 and 8 in n for degree 1 and every n. The numbers of the checks are those of docs/theorems/.

#include "proofs.hpp"

#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include "degree_one.hpp"
#include "kernel/kernel.hpp"
#include "variance_ends.hpp"

#include <algorithm>

namespace subcert::theorems {
namespace {

/// The bounds of each n below `tail`, all n at once from there on.
constexpr int tail = 64;
constexpr int factors = 6;  // of X_0 that are kept

const Rational N_after_tail(4 * tail - 1, 2);

/// The constants of section 3, on which both conjectures rest.
std::vector<Constant> common_constants() {
  return {
      {"c-", decimal("0.404436767"), Side::below, "1.1", "the limit of n max psi_n, from below"},
      {"c+", decimal("0.404436769"), Side::above, "1.2", "the limit of n max psi_n, from above"},
      {"kappa", decimal("1.0632"), Side::above, "2.1", "sup |cos x - sin(x)/x|"},
      {"kappa_0", decimal("0.01196"), Side::above, "2.2", "(Phi(pi)^-2 - 1 - pi^2/9) / pi^4"},
      {"mu", decimal("214.6"), Side::above, "2.3", "1/(2 pi) times the integral of s^4 M(s)^2"},
      {"K", decimal("197.3"), Side::above, "3.1", "N^5 times the remainder of the mean, n >= n_1"},
      {"G-1", decimal("0.00001538"), Side::above, "3.2", "N g - 1, n >= n_1"},
      {"sigma", decimal("0.717"), Side::above, "3.3", "sum of u/sin u - 1 over the shells"},
      {"h", decimal("1.111"), Side::above, "3.4", "(pi/4)/sin(pi/4)"},
      {"Y", decimal("0.0513"), Side::above, "3.5", "all Y_j, n >= n_1"},
      {"xi", decimal("160500"), Side::above, "3.7", "product of 1/sin(pi 2^(-j-2)) over j < 6"},
      {"W", decimal("8690"), Side::above, "3.8", "N^6 u_0 Y_j, n >= n_1"},
      {"Omega", decimal("17400"), Side::above, "3.9", "N^6 (O_n + rho_n), n >= n_1"},
  };
}

/// log base 2 of n.
Ball log2(int n) { return log2(exactly(n).with_bits(proof_bits)); }

/// The product of 1/sin(pi 2^(-j-2)) over j < count.
Ball inverse_sines(int count) {
  const Ball pi = Ball::pi(proof_bits);
  Ball product(1, proof_bits);
  for (int j = 0; j < count; ++j) product = product / sin(pi.scaled(-j - 2));
  return product;
}

std::vector<Check> common_checks(const Constants& c) {
  const Ball pi = Ball::pi(proof_bits), N = exactly(N_after_tail), square = N * N;
  const Ball limit = limit_ball(1);
  const auto stated = [&](const char* name) { return exactly(c[name]); };
  return {
      defining(c, "c-", "C_1", limit),
      defining(c, "c+", "C_1", limit),
      defining(c, "kappa", "sup |cos x - sin(x)/x|", Ball::containing(cosine_minus_sinc_supremum(), proof_bits)),
      defining(c, "kappa_0", "(Phi(pi)^-2 - 1 - pi^2/9) / pi^4", degree_one_fourth_order()),
      defining(c, "mu", "1/(2 pi) integral of s^4 M(s)^2", degree_one_moment()),
      defining(c, "K", "(8/9 + kappa_0) (1 - 1/(2 N_1))^-5 mu",
               (exactly(Rational(8, 9)) + stated("kappa_0")) * stated("mu") / (1 - 1 / N.scaled(1)).pow(5)),
      defining(c, "G-1", "N_1^2 / (N_1^2 - 1/4) - 1", square / (square - exactly(Rational(1, 4))) - 1),
      defining(c, "sigma", "sum of u_i/sin u_i - 1", excess_of_shells()),
      defining(c, "h", "(pi/4)/sin(pi/4)", pi.scaled(-2) / sin(pi.scaled(-2))),
      defining(c, "Y", "kappa (log2 n_1 + 1 + sigma)/(2 (2 n_1 - 1)) + h pi^2 (4 n_1 - 1)/(36 n_1^2)",
               stated("kappa") * (log2(tail) + 1 + stated("sigma")) / (2 * (2 * tail - 1)) +
                   stated("h") * pi * pi * (4 * tail - 1) / (36 * tail * tail)),
      less("3.6", "Y < 1", Enclosure::exactly(c["Y"]), Enclosure::exactly(1)),
      defining(c, "xi", "product of 1/sin(pi 2^(-j-2)), j < 6", inverse_sines(factors)),
      defining(c, "W", "xi G^6 Y/(1 - Y)",
               stated("xi") * (stated("G-1") + 1).pow(factors) * stated("Y") / (1 - stated("Y"))),
      defining(c, "Omega", "2 W + 2 W^2/N_1^6", (stated("W") + stated("W").pow(2) / N.pow(factors)).scaled(1)),
  };
}

/// Of psi_n; psi_1 = 1 - 2x + 2x^2 on [0, 1].
const VarianceEnds& ends(int n) {
  static const VarianceEnds first{Enclosure::exactly(Rational(1, 2)), Enclosure::exactly(1), Enclosure::at_least(0)};
  return n == 1 ? first : variance_ends(n, 1);
}

/// n^2 |(n - 1/4) psi/c - 1| for the larger and the smaller end of psi_n.
std::vector<Check> deviation_checks(const Constants& c, const std::string& id, int n, const char* bound) {
  const VarianceEnds& psi = ends(n);
  const Rational scale(4 * n - 1, 4), square = Rational(n) * n;
  // What the constants bound is the bound computed: the outer ends.
  const Rational excess = square * (scale * *psi.maximum.upper / c["c-"] - 1),
                 lack = square * (1 - scale * *psi.minimum.lower / c["c+"]);
  return {less(id, "n^2 ((n - 1/4) max psi_n/c - 1) < " + std::string(bound) + at(n), Enclosure::exactly(excess),
               Enclosure::exactly(c[bound])),
          less(id, "n^2 (1 - (n - 1/4) min psi_n/c) < " + std::string(bound) + at(n), Enclosure::exactly(lack),
               Enclosure::exactly(c[bound]))};
}

void append(std::vector<Check>& all, std::vector<Check> more) {
  for (Check& check : more) all.push_back(std::move(check));
}

/// What the theorem on slopes adds.
std::vector<Check> slope_checks(const Constants& c) {
  std::vector<Check> checks;
  const Ball pi = Ball::pi(proof_bits), N = exactly(N_after_tail);
  const auto stated = [&](const char* name) { return exactly(c[name]); };
  for (int n = 2; n < tail; ++n) {
    const std::optional<Rational>& slope = ends(n).slope.upper;
    checks.push_back(less("6.1", "n^2 D_n < s" + at(n),
                          slope ? Enclosure::exactly(*slope * (n * n)) : Enclosure::at_least(0),
                          Enclosure::exactly(c["s"])));
  }
  append(checks, {defining(c, "Z", "pi kappa n_1/(2 n_1 - 1) + h pi^2/3",
                           pi * stated("kappa") * tail / (2 * tail - 1) + stated("h") * pi * pi / 3),
                  defining(c, "xi_3", "product of 1/sin(pi 2^(-j-2)), j < 3", inverse_sines(3)),
                  defining(c, "zeta", "14 pi kappa/(4 (2 n_1 - 1)) + xi_3 G^3 Z/N_1^3",
                           pi * stated("kappa") * 14 / (4 * (2 * tail - 1)) +
                               stated("xi_3") * (stated("G-1") + 1).pow(3) * stated("Z") / N.pow(3)),
                  less("6.5", "zeta < 1", Enclosure::exactly(c["zeta"]), Enclosure::exactly(1)),
                  defining(c, "Delta", "(4 pi/3) (W + xi G^6 Z (1 + W/N_1^6)/(1 - zeta))",
                           pi.scaled(2) / 3 *
                               (stated("W") + stated("xi") * (stated("G-1") + 1).pow(factors) * stated("Z") *
                                                  (stated("W") / N.pow(factors) + 1) / (1 - stated("zeta")))),
                  less("6.7", "n_1^2 Delta/N_1^6 < s", (stated("Delta") * (tail * tail) / N.pow(6)).enclosure(),
                       Enclosure::exactly(c["s"]))});
  return checks;
}

}  // namespace

Ball excess_of_shells() {
  const Ball pi = Ball::pi(proof_bits);
  Ball sum(proof_bits);
  for (int i = 0; i < 10; ++i) sum += pi.scaled(-i - 1) / sin(pi.scaled(-i - 1)) - 1;
  return sum + (pi * pi).scaled(-20) / 15;
}

Ball first_harmonic() {
  constexpr slong bits = 80;
  constexpr int octaves = 9, factors_of_psi = 60;
  const Ball pi = Ball::pi(bits);
  const Kernel kernel(1, bits);
  std::vector<Ball> cotangents;  // of theta_j + (pi/6) 2^-j
  for (int j = 1; j <= factors_of_psi; ++j) {
    const Ball angle = pi * (j % 2 == 0 ? 1 : 2) / 3 + (pi / 6).scaled(-j);
    cotangents.push_back(cos(angle) / sin(angle));
  }
  const auto integrand = [&](const ComplexBall& s) {
    const ComplexBall half = s.scaled(-1), one(Ball(1, bits));
    ComplexBall value = kernel.product(s) * (cos(half) + kernel.transform(half) * Ball(-1, bits)).scaled(-1);
    for (int j = 1; j <= factors_of_psi; ++j) {
      const ComplexBall shift = s.scaled(-j - 1);
      value *= cos(shift) + sin(shift) * -cotangents[static_cast<std::size_t>(j - 1)];
    }
    // The other factors: |cos e - cot(theta) sin e - 1| <= 2 |e| for |e| <= 1/4, |cot(theta)| <= 1.
    const Ball rest = abs(s).scaled(-factors_of_psi);
    if (!rest.is_less(Ball(1, bits).scaled(-4))) return ComplexBall::indeterminate(bits);
    return value * one.widened(rest.scaled(1));
  };
  const Ball end = Ball(1, bits).scaled(octaves);
  const Ball inside = integral(integrand, ComplexBall(-end), ComplexBall(end), 30, bits).real();
  // Beyond 2^k |Phi| <= 2^(-k(k-1)/2), the middle factor is at most 0.54, |Psi| <= (2 e |s|)^(1/2); the octaves fall by
  // more than a half.
  const Ball first = (sqrt(exp(Ball(1, bits)).scaled(octaves + 2)) * exactly(Rational(54, 100)).with_bits(bits))
                         .scaled(octaves - octaves * (octaves - 1) / 2);
  return -inside.widened(first.scaled(2));
}

Constants degree_one_constants_8() { return Constants(common_constants()); }

Constants degree_one_constants_7() {
  std::vector<Constant> list = common_constants();
  const std::vector<Constant> more{
      {"beta", decimal("0.855"), Side::above, "5.1", "n^2 |(n - 1/4) psi_n/c - 1|, n >= 1"},
      {"beta_2", decimal("0.151"), Side::above, "5.2", "n^2 |(n - 1/4) psi_n/c - 1|, n >= 2"},
      {"s", decimal("0.139"), Side::above, "6.1", "n^2 |psi_n'|, n >= 2"},
      {"Z", decimal("5.34"), Side::above, "6.2", "all Z_j, n >= n_1"},
      {"xi_3", decimal("18.95"), Side::above, "6.3", "product of 1/sin(pi 2^(-j-2)) over j < 3"},
      {"zeta", decimal("0.0922"), Side::above, "6.4", "Z_0, n >= n_1"},
      {"Delta", decimal("4000000"), Side::above, "6.6", "N^6 D_n, n >= n_1"},
      {"j", decimal("0.63"), Side::below, "12.1", "pi N^2/|transform of phi_n at pi| times |c_1|, n = 3, 11, 43, ..."}};
  list.insert(list.end(), more.begin(), more.end());
  return Constants(list);
}

std::vector<Check> degree_one_checks_8(const Constants& c, int threads) {
  prepare_variance_ends(2, tail, {1}, threads);
  std::vector<Check> checks = common_checks(c);
  for (int n = 1; n < tail; ++n) {
    checks.push_back(less(n == 1 ? "4.1" : "4.2", "max psi_" + text(n + 1) + " < min psi_" + text(n),
                          ends(n + 1).maximum, ends(n).minimum));
  }
  const Ball N = exactly(N_after_tail);
  checks.push_back(
      less("4.3", "N_1 (N_1 + 2) (2 K/N_1^5 + 2 Omega/N_1^6) < 4 c-",
           ((exactly(c["K"]) / N.pow(5) + exactly(c["Omega"]) / N.pow(factors)).scaled(1) * N * (N + 2)).enclosure(),
           Enclosure::exactly(4 * c["c-"])));
  return checks;
}

std::vector<Check> degree_one_checks_7(const Constants& c, int threads) {
  prepare_variance_ends(2, tail, {1}, threads);
  std::vector<Check> checks = common_checks(c);
  append(checks, deviation_checks(c, "5.1", 1, "beta"));
  for (int n = 2; n < tail; ++n) append(checks, deviation_checks(c, "5.2", n, "beta_2"));
  const Ball N = exactly(N_after_tail), twice = exactly(2 * c["c-"]);
  const Ball inside = exactly(degree_one_second_coefficient()) + exactly(c["K"]) / twice / N.pow(2) +
                      exactly(c["Omega"]) / twice / N.pow(3);
  checks.push_back(less("5.3", "(1 + 1/(2 N_1))^2/4 (13/36 + K/(2c N_1^2) + Omega/(2c N_1^3)) < beta_2",
                        ((1 / N.scaled(1) + 1).pow(2).scaled(-2) * inside).enclosure(),
                        Enclosure::exactly(c["beta_2"])));
  checks.push_back(less("5.4", "beta_2 < beta", Enclosure::exactly(c["beta_2"]), Enclosure::exactly(c["beta"])));
  append(checks, slope_checks(c));
  static const Ball harmonic = first_harmonic();
  checks.push_back(defining(c, "j", "-J", harmonic));
  return checks;
}

}  // namespace subcert::theorems
