// Conjectures 7 and 8 for degrees 1, 3 and 5 and every n. The numbers of the checks are those of
// docs/theorems/variance-curves.tex.

#include "proofs.hpp"
#include "uniform_curve.hpp"
#include "variance_ends.hpp"

#include <subcert/analysis/symbol/interval.hpp>

#include <algorithm>

namespace subcert::theorems {
namespace {

/// As stated for one degree, in the order of section 7.
struct Stated {
  const char *below, *above, *H, *F, *E, *A, *B, *K, *Y, *W, *Omega;
  const char *A_three = nullptr, *Z = nullptr, *zeta = nullptr, *Delta = nullptr;
};

/// With slopes the bounds begin later.
Stated stated(int degree, bool slopes) {
  if (slopes)
    return degree == 3 ? Stated{"1.044637310", "1.044637311", "1.110", "0.3963", "1.861", "16.98", "1.0004", "8.69",
                                "0.1051",      "7860",        "15730", "4.56",   "10.75", "0.261", "4120000"}
                       : Stated{"1.685820151", "1.685820152", "0.5385", "0.09153", "2.534", "114",    "1.0002",  "37.2",
                                "0.0992",      "49500",       "99100",  "13",      "12.92", "0.2361", "32100000"};
  switch (degree) {
    case 1:
      return {"0.404436767", "0.404436769", "0.2518", "0.5617", "1.114", "1.093",
              "1.0003",      "0.572",       "0.1023", "492",    "985"};
    case 3:
      return {"1.044637310", "1.044637311", "1.132", "0.3974", "1.929", "25.4",
              "1.0011",      "9.21",        "0.168", "20300",  "40700"};
    default:
      return {"1.685820151", "1.685820152", "0.5474", "0.09181", "2.656", "189.8",
              "1.0005",      "42.1",        "0.1468", "129000",  "258500"};
  }
}

/// The constants of section 7 for one degree; their names end in the degree.
std::vector<Constant> uniform_constants(int degree, bool slopes) {
  const Stated s = stated(degree, slopes);
  const std::string end = "_" + text(degree);
  std::vector<Constant> list{
      {"c-" + end, decimal(s.below), Side::below, "7.1", "the limit C_d of n max psi_n, from below"},
      {"c+" + end, decimal(s.above), Side::above, "7.2", "the limit C_d of n max psi_n, from above"},
      {"H" + end, decimal(s.H), Side::above, "7.3", "N^2 |m(v/N) - khat(v)|/v^(d+1), v <= 1"},
      {"F" + end, decimal(s.F), Side::above, "7.4", "|M dD_M/dM|/v^(d+1), v <= 1"},
      {"E" + end, decimal(s.E), Side::above, "7.5", "|M dD_M/dM| sin(w)/w, v >= 1"},
      {"A" + end, decimal(s.A), Side::above, "7.7", "product of sup M sin(w) |D_M(w)| over the first 5 shells"},
      {"B" + end, decimal(s.B), Side::above, "7.8", "products of |m| over different shells"},
      {"K" + end, decimal(s.K), Side::above, "7.9", "N^3 times the remainder of the mean"},
      {"sigma" + end, decimal("0.717"), Side::above, "7.10", "sum of u/sin u - 1 over the shells"},
      {"Y" + end, decimal(s.Y), Side::above, "7.11", "all Y_j"},
      {"W" + end, decimal(s.W), Side::above, "7.13", "N^5 u_0 Y_j"},
      {"Omega" + end, decimal(s.Omega), Side::above, "7.14", "N^5 (O_n + rho_n)"}};
  if (!slopes) return list;
  const std::vector<Constant> more{
      {"A'" + end, decimal(s.A_three), Side::above, "7.15", "the same product over the first 3 shells"},
      {"Z" + end, decimal(s.Z), Side::above, "7.16", "all Z_j"},
      {"zeta" + end, decimal(s.zeta), Side::above, "7.17", "Z_0"},
      {"Delta" + end, decimal(s.Delta), Side::above, "7.19", "N^5 D_n"}};
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

Ball first_N(int n) { return exactly(Rational(4 * n - 1, 2)); }

/// G^count times the product of 1/sin(pi 2^(-j-2)) over j < count, G = N_1^2/(N_1^2 - 1/4).
Ball shell_factors(const Ball& N, int count) {
  const Ball pi = Ball::pi(proof_bits);
  Ball product = (N * N / (N * N - exactly(Rational(1, 4)))).pow(count);
  for (int j = 0; j < count; ++j) product = product / sin(pi.scaled(-j - 2));
  return product;
}

Ball product_of(const std::vector<Ball>& values, int count) {
  Ball product(1, proof_bits);
  for (int j = 0; j < count; ++j) product = product * values[static_cast<std::size_t>(j)];
  return product;
}

/// The number of shells with 2 n u > 1 is at most log2(n pi) + 1.
Ball shells_at_most(int n) { return log2(Ball::pi(proof_bits) * n) + 1; }

std::vector<Check> uniform_checks(const Constants& c, int degree, bool slopes) {
  const int n = uniform_start(degree, slopes), factors = kept_factors;
  const UniformNumbers& numbers = uniform_numbers(degree, n);
  const std::string end = "_" + text(degree);
  const auto name = [&](const char* head) { return head + end; };
  const auto value = [&](const char* head) { return exactly(c[head + end]); };
  const Ball pi = Ball::pi(proof_bits), N = first_N(n), one(1, proof_bits);
  const Ball limit = limit_ball(degree);
  std::vector<Check> checks{
      defining(c, name("c-"), "C" + end, limit),
      defining(c, name("c+"), "C" + end, limit),
      defining(c, name("H"), "bound of sup of N^2 |m(v/N) - khat(v)|/v^(d+1), v <= 1", numbers.near_zero_difference),
      defining(c, name("F"), "bound of sup of |M dD_M/dM|/v^(d+1), v <= 1", numbers.near_zero_slope),
      defining(c, name("E"), "bound of sup of |M dD_M/dM| sin(w)/w, v >= 1", numbers.slope),
      less("7.6", name("F") + " < " + name("E"), Enclosure::exactly(c[name("F")]), Enclosure::exactly(c[name("E")])),
      defining(c, name("A"), "product of the bounds A_j, j < 5", product_of(numbers.decays, factors)),
      defining(c, name("B"), "bound of products of sup |m| over shells", numbers.products),
      defining(c, name("K"), "bound of (2/pi) integral of M L + (1/pi) integral of (s/pi)^2 M^2", numbers.mean),
      defining(c, name("sigma"), "sum of u_i/sin u_i - 1", excess_of_shells()),
      defining(c, name("Y"), "B (E (log2(n_1 pi) + 1 + sigma) + F/(1 - 2^(-d-1)))/(2 (2 n_1 - 1))",
               value("B") *
                   (value("E") * (shells_at_most(n) + value("sigma")) + value("F") / (one - one.scaled(-degree - 1))) /
                   (2 * (2 * n - 1))),
      less("7.12", name("Y") + " < 1", Enclosure::exactly(c[name("Y")]), Enclosure::exactly(1)),
      defining(c, name("W"), "A B G^5 xi_5 Y/(1 - Y)",
               value("A") * value("B") * shell_factors(N, factors) * value("Y") / (1 - value("Y"))),
      defining(c, name("Omega"), "2 B W + 2 W^2/N_1^5",
               (value("B") * value("W") + value("W").pow(2) / N.pow(factors)).scaled(1))};
  if (!slopes) return checks;
  const std::vector<Check> more{
      defining(c, name("A'"), "product of the bounds A_j, j < 3", product_of(numbers.decays, 3)),
      defining(c, name("Z"), "B (4 pi n_1/(2 (2 n_1 - 1))) (pi E/2 + F/(1 - 2^-d))",
               value("B") * pi * (4 * n) / (2 * (2 * n - 1)) *
                   (pi * value("E") / 2 + value("F") / (one - one.scaled(-degree)))),
      defining(c, name("zeta"), "B (14 (pi/2) E/(2 (2 n_1 - 1)) + A' G^3 xi_3 Z/N_1^3)",
               value("B") * (pi * value("E") * 7 / (2 * (2 * n - 1)) +
                             value("A'") * shell_factors(N, 3) * value("Z") / N.pow(3))),
      less("7.18", name("zeta") + " < 1", Enclosure::exactly(c[name("zeta")]), Enclosure::exactly(1)),
      defining(
          c, name("Delta"), "(4 pi/3) (B W + V Z (B + W/N_1^5)), V = A B G^5 xi_5/(1 - zeta)",
          pi.scaled(2) / 3 *
              (value("B") * value("W") + value("A") * value("B") * shell_factors(N, factors) / (1 - value("zeta")) *
                                             value("Z") * (value("B") + value("W") / N.pow(factors))))};
  checks.insert(checks.end(), more.begin(), more.end());
  return checks;
}

/// What mean, aliases and ripple of the degree can deviate by from 2 C/N, at any N >= N_1.
Ball deviation(const Constants& c, int degree, const Ball& N) {
  const std::string end = "_" + text(degree);
  return exactly(c["K" + end]) / N.pow(3) + exactly(c["Omega" + end]) / N.pow(kept_factors);
}

int least_n(int degree) { return (degree + 1) / 2; }

}  // namespace

int uniform_start(int degree, bool slopes) {
  if (slopes) return degree == 3 ? 40 : 60;
  return degree == 5 ? 40 : 24;
}

Constants uniform_constants_8_n(int degree) { return Constants(uniform_constants(degree, false)); }

Constants uniform_constants_8_d(int degree) {
  std::vector<Constant> list = uniform_constants(degree, false), more = uniform_constants(degree + 2, false);
  list.insert(list.end(), more.begin(), more.end());
  return Constants(list);
}

Constants uniform_constants_7(int degree) {
  std::vector<Constant> list = uniform_constants(degree, true);
  const bool three = degree == 3;
  const std::string first = text(least_n(degree)), second = text(least_n(degree) + 1);
  const std::vector<Constant> more{
      {"beta", decimal(three ? "2.71" : "5.69"), Side::above, "9.1", "n^2 |(n - 1/4) psi_n/C_d - 1|, n >= " + first},
      {"beta_2", decimal(three ? "1.36" : "3.31"), Side::above, "9.3", "the same for n >= n_1"},
      {"s", decimal(three ? "4.38" : "8.15"), Side::above, "9.4", "n^2 |psi_n'|, n >= " + first}};
  list.insert(list.end(), more.begin(), more.end());
  return Constants(list);
}

std::vector<Check> uniform_checks_8_n(const Constants& c, int degree, int threads) {
  const int start = uniform_start(degree, false);
  std::vector<Check> checks = uniform_checks(c, degree, false);
  prepare_variance_ends(least_n(degree), start, {degree}, threads);
  for (int n = least_n(degree); n < start; ++n)
    checks.push_back(less("8.1", "max psi_" + text(n + 1) + " < min psi_" + text(n),
                          variance_ends(n + 1, degree).maximum, variance_ends(n, degree).minimum));
  const Ball N = first_N(start);
  checks.push_back(less("8.2", "N_1 (N_1 + 2) (2 K/N_1^3 + 2 Omega/N_1^5) < 4 c-",
                        (deviation(c, degree, N).scaled(1) * N * (N + 2)).enclosure(),
                        Enclosure::exactly(4 * c["c-_" + text(degree)])));
  return checks;
}

std::vector<Check> uniform_checks_8_d(const Constants& c, int degree, int threads) {
  const int next = degree + 2, start = std::max(uniform_start(degree, false), uniform_start(next, false));
  std::vector<Check> checks = uniform_checks(c, degree, false), more = uniform_checks(c, next, false);
  checks.insert(checks.end(), more.begin(), more.end());
  prepare_variance_ends(least_n(next), start - 1, {degree, next}, threads);
  for (int n = least_n(next); n < start; ++n)
    checks.push_back(less("10.1", "max psi^" + text(degree) + " < min psi^" + text(next) + at(n),
                          variance_ends(n, degree).maximum, variance_ends(n, next).minimum));
  const Ball N = first_N(start);
  checks.push_back(
      less("10.2",
           "N (K + K')/N^3 + N (Omega + Omega')/N^5 < 2 (c-_" + text(next) + " - c+_" + text(degree) + ")" + at(start),
           (N * (deviation(c, degree, N) + deviation(c, next, N))).enclosure(),
           Enclosure::exactly(2 * (c["c-_" + text(next)] - c["c+_" + text(degree)]))));
  return checks;
}

std::vector<Check> uniform_checks_7(const Constants& c, int degree, int threads) {
  const int start = uniform_start(degree, true), first = least_n(degree);
  const std::string end = "_" + text(degree);
  std::vector<Check> checks = uniform_checks(c, degree, true);
  prepare_variance_ends(first, start - 1, {degree}, threads);
  const Rational below = c["c-" + end], above = c["c+" + end];
  const auto excess = [](int n, const Rational& value, const Rational& C) -> Rational {
    return Rational(n) * n * (Rational(4 * n - 1, 4) * value / C - 1);
  };
  for (int n = first; n < start; ++n) {
    const Enclosure& maximum = variance_ends(n, degree).maximum;
    checks.push_back(less("9.1", "n^2 ((n - 1/4) max psi_n/C - 1) < beta" + at(n),
                          {excess(n, *maximum.lower, above), excess(n, *maximum.upper, below)},
                          Enclosure::exactly(c["beta"])));
  }
  for (int n = first; n < start; ++n) {
    const Enclosure& minimum = variance_ends(n, degree).minimum;
    checks.push_back(less("9.2", "n^2 (1 - (n - 1/4) min psi_n/C) < beta" + at(n),
                          {-excess(n, *minimum.upper, below), -excess(n, *minimum.lower, above)},
                          Enclosure::exactly(c["beta"])));
  }
  const Ball N = first_N(start), ratio = (1 / N.scaled(1) + 1).pow(2).scaled(-2);  // n^2/N^2
  checks.push_back(defining(c, "beta_2", "(1 + 1/(2 N_1))^2/4 (K + Omega/N_1^2)/(2 C)",
                            ratio * deviation(c, degree, N) * N.pow(3) / exactly(2 * below)));
  for (int n = first; n < start; ++n) {
    Enclosure slope = Enclosure::at_least(0);
    if (variance_ends(n, degree).slope) slope = scaled(*variance_ends(n, degree).slope, Rational(n) * n);
    checks.push_back(less("9.4", "n^2 max |psi_n'| < s" + at(n), slope, Enclosure::exactly(c["s"])));
  }
  checks.push_back(less("9.5", "n_1^2 Delta/N_1^5 < s",
                        (exactly(c["Delta" + end]) * (start * start) / N.pow(kept_factors)).enclosure(),
                        Enclosure::exactly(c["s"])));
  checks.push_back(less("9.6", "beta_2 < beta", Enclosure::exactly(c["beta_2"]), Enclosure::exactly(c["beta"])));
  return checks;
}

}  // namespace subcert::theorems
