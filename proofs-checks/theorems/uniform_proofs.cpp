// Conjectures 7 and 8 for one degree or two neighbouring ones and every n. The numbers of the checks are those of
// docs/theorems/variance-curves.tex.

#include "proofs.hpp"

#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include "kept_by_scheme.hpp"
#include "uniform_curve.hpp"
#include "variance_ends.hpp"

#include <algorithm>
#include <optional>

namespace subcert::theorems {

Ball shell_ratio(const Ball& N) { return N * N / (N * N - exactly(Rational(1, 4))); }

/// What the first part of section 7 bounds: what else is in it needs these.
SymbolConstants state_symbol(Ledger& ledger, const SchemeFamily& family, int degree, int start,
                             const std::string& end) {
  const Rational first = family.size(start), half(1, 2);
  const UniformNumbers& numbers = uniform_numbers(family.evaluation, degree, first);
  const bool dual = family.evaluation == Evaluation::dual;
  SymbolConstants result;
  result.N = exactly(first);
  result.fewest = dual ? result.N : exactly(first - half);
  result.most = dual ? result.N : exactly(first + half);
  const auto above = [&](const char* name, const char* id, const char* meaning, const std::string& formula,
                         const Ball& number) {
    return ledger.state(name + end, Side::above, id, meaning, formula, number);
  };
  result.H = above("H", "7.3", "N^2 |m(v/N) - khat(v)|/v^(d+1), near 0", "bound of N^2 |m(v/N) - khat(v)|/v^(d+1)",
                   numbers.difference_disc.bound);
  result.F = above("F", "7.4", "2 M_- |m(pi - v/M_+)|/v^(d+1), v <= 1", "bound of |M dD_M/dM|/v^(d+1), v <= 1",
                   numbers.slope_disc.bound);
  result.E = above("E", "7.5", "2 M_- |m(pi - w)| sin(w)/w", "F and the bound of |M dD_M/dM| sin(w)/w, v >= 1",
                   max(numbers.slope, result.F));
  ledger.need(less("7.6", "bound of |m| and |khat| on v >= 2^12 < 1/4", numbers.far.enclosure(),
                   Enclosure::exactly(Rational(1, 4))));
  ledger.need(less("7.21", "pi N_1 < 2^12", (Ball::pi(proof_bits) * result.N).enclosure(), Enclosure::exactly(4096)));
  if (!ledger.holds()) return result;
  result.B = above("B-1", "7.8", "products of |m| over different shells, without 1",
                   "bound of products of sup |m| over shells, without 1", numbers.products(result.H).upper_end() - 1) +
             1;
  return result;
}

namespace {

/// For n >= first, as stated: twice the mean is 4 C/N up to 2 K/N^3, ripple and aliases are at most Omega/N^5, and
/// |psi'| is at most Delta/N^5.
struct UniformBounds {
  Rational below, above;
  Ball K, Omega, Delta, N;

  /// What mean, aliases and ripple can deviate by from 2 C/N at one N >= N_1.
  Ball deviation(const Ball& at) const { return K / at.pow(3) + Omega / at.pow(kept_factors); }
  Ball deviation() const { return deviation(N); }
};

/// G^count times the product of 1/sin(pi 2^(-j-2)) over j < count, G = N_1^2/(N_1^2 - 1/4).
Ball shell_factors(const Ball& N, int count) {
  const Ball pi = Ball::pi(proof_bits);
  Ball product = shell_ratio(N).pow(count);
  for (int j = 0; j < count; ++j) product = product / sin(pi.scaled(-j - 2));
  return product;
}

Ball product_of(const std::vector<Ball>& values, std::size_t first, std::size_t count) {
  Ball product(1, proof_bits);
  for (std::size_t j = first; j < first + count; ++j) product = product * values[j];
  return product;
}

/// The chain of section 7 from N_1 = size(start) on; it ends early where one of its inequalities fails.
UniformBounds section_7(Ledger& ledger, const SchemeFamily& family, int degree, int start) {
  const UniformNumbers& numbers = uniform_numbers(family.evaluation, degree, family.size(start));
  const Rational half(1, 2);
  const Ball pi = Ball::pi(proof_bits), one(1, proof_bits);
  const std::string end = "_" + text(degree), C = "C" + end;
  const auto above = [&](const char* name, const char* id, const char* meaning, const std::string& formula,
                         const Ball& number, int digits = 4) {
    return ledger.state(name + end, Side::above, id, meaning, formula, number, digits);
  };
  const Ball limit = limit_ball(degree);
  UniformBounds result;
  result.N = exactly(family.size(start));
  ledger.state("c-" + end, Side::below, "7.1", "the limit " + C + " of N psi/2, from below", C, limit, 10);
  above("c+", "7.2", "the limit of N psi/2, from above", C, limit, 10);
  result.below = ledger["c-" + end];
  result.above = ledger["c+" + end];
  const SymbolConstants symbol = state_symbol(ledger, family, degree, start, end);
  if (!ledger.holds()) return result;
  const Ball &N = symbol.N, &fewest = symbol.fewest, &most = symbol.most, &H = symbol.H, &F = symbol.F, &E = symbol.E,
             &B = symbol.B;
  const Ball A = above("A", "7.7", "product of M sin(w) |D_M(w)| over the first 5 shells",
                       "product of the bounds A_j, j < 5", product_of(numbers.decays, 0, kept_factors));
  result.K = above("K", "7.9", "N^3 times the remainder of the mean",
                   "bound of (2/pi) integral of M L + (1/pi) integral of (s/pi)^2 M^2", numbers.mean(H).upper_end());
  const Ball sigma = above("sigma", "7.10", "sum of u/sin u - 1 over the shells", "sum of u_i/sin u_i - 1",
                           excess_of_shells());
  const Ball Y = above(
      "Y", "7.11", "all Y_j", "B (E (log2(pi M_+/2) + 1 + sigma) + F/(1 - 2^(-d-1)))/(2 M_-)",
      B * (E * (log2(pi * most / 2) + 1 + sigma) + F / (one - one.scaled(-degree - 1))) / fewest.scaled(1));
  ledger.need(less("7.12", "Y" + end + " < 1", Enclosure::exactly(ledger["Y" + end]), Enclosure::exactly(1)));
  if (!ledger.holds()) return result;
  const Ball five = shell_factors(N, kept_factors), three = shell_factors(N, 3);
  const Ball W = above("W", "7.13", "N^5 u_0 Y_j", "A B G^5 xi_5 Y/(1 - Y)", A * B * five * Y / (1 - Y));
  result.Omega = above("Omega", "7.14", "N^5 (O_n + rho_n)", "2 B W + 2 W^2/N_1^5",
                       (B * W + W.pow(2) / N.pow(kept_factors)).scaled(1));
  Ball triple(0, proof_bits);
  for (std::size_t j = 0; j < 3; ++j) triple = max(triple, product_of(numbers.decays, j, 3));
  const Ball A_row = above("A'", "7.15", "the same product over 3 of these shells in a row",
                           "largest A_j A_{j+1} A_{j+2}, j < 3", triple);
  const Ball Z = above("Z", "7.16", "all Z_j", "B (pi M_+/M_-) (pi E/2 + F/(1 - 2^-d))",
                       B * pi * most / fewest * (pi * E / 2 + F / (one - one.scaled(-degree))));
  const Ball head = B * pi * E * 7 / fewest.scaled(1), kept = A_row * three * Z / N.pow(3);
  const Ball zeta = above("zeta", "7.17", "Z_0", "14 B (pi/2) E/(2 M_-) + A' G^3 xi_3 Z/N_1^3", head + kept);
  ledger.need(less("7.18", "zeta" + end + " < 1", Enclosure::exactly(ledger["zeta" + end]), Enclosure::exactly(1)));
  if (!ledger.holds()) return result;
  const Ball S = above("S", "7.19", "sum of 2^(-2j-1) Z_j",
                       "(7/8) 14 B (pi/2) E/(2 M_-) + (7/2) A' G^3 xi_3 Z/N_1^3 + Z/96",
                       head * 7 / 8 + kept * 7 / 2 + Z / 96);
  result.Delta = above("Delta", "7.20", "N^5 D_n", "2 pi ((2/3) B W + V S (B + W/N_1^5)), V = A B G^5 xi_5/(1 - zeta)",
                       pi.scaled(1) * (B * W * 2 / 3 + A * B * five / (1 - zeta) * S * (B + W / N.pow(kept_factors))));
  const Ball two(2, proof_bits), log_2 = log(two), ratio = shell_ratio(N);
  const Ball r = above("r", "7.22", "log2 of the bound of M sin(w) |D_M(w)|, v >= 1", "log2(a G)",
                       log2(numbers.any_decay * ratio));
  // J = log2 N + delta shells are kept; the exponent is convex in delta.
  const auto power = [&](const Ball& delta) {
    return exp((delta * (r + exactly(half)) + delta * (delta - 1) / 2) * log_2);
  };
  const Ball kept_shells = B * max(power(log2(pi / 2)), power(log2(pi * (1 - 1 / N.scaled(1)) / 2) - 1));
  above("R", "7.23", "N^(log2(N)/2 - r) D_n", "2 pi ((2/3) B Y/(1 - Y) + S (B + W/N_1^5)/(1 - zeta)) P",
        pi.scaled(1) * kept_shells * (B * Y / (1 - Y) * 2 / 3 + S * (B + W / N.pow(kept_factors)) / (1 - zeta)));
  return result;
}

/// (8.2): what makes the step from N to N + 2 larger than the remainders.
Check step_check(const UniformBounds& bounds) {
  return less("8.2", "N_1 (N_1 + 2) (2 K/N_1^3 + 2 Omega/N_1^5) < 4 c-",
              (bounds.deviation().scaled(1) * bounds.N * (bounds.N + 2)).enclosure(),
              Enclosure::exactly(4 * bounds.below));
}

/// n^2 times the bounds of |N psi_n/(2 C) - 1| and of |psi_n'|; absent where there is none.
struct Scaled {
  std::optional<Rational> deviation, slope;
};

Scaled scaled_bounds(const SchemeFamily& family, int degree, int n, const UniformBounds& limit) {
  const VarianceEnds& ends = variance_ends(family.scheme(n, degree));
  const Rational square = Rational(n) * n, scale = family.size(n) / 2;
  Scaled result;
  if (ends.maximum.upper)
    result.deviation = square * std::max(Rational(scale * *ends.maximum.upper / limit.below - 1),
                                         Rational(1 - scale * *ends.minimum.lower / limit.above));
  if (ends.slope.upper) result.slope = square * *ends.slope.upper;
  return result;
}

/// The bound of n^2 |N psi_n/(2 C) - 1| for n >= n_1.
Ball tail_deviation(const UniformBounds& bounds) {
  const Ball ratio = (1 / bounds.N.scaled(1) + 1).pow(2).scaled(-2);  // n^2/N^2
  return ratio * bounds.deviation() * bounds.N.pow(3) / exactly(2 * bounds.below);
}

Ball tail_slope(const UniformBounds& bounds, int start) {
  return bounds.Delta * (start * start) / bounds.N.pow(kept_factors);
}

/// How good n_1 is: whether the inequalities of the proofs hold, and whether the bounds for n >= n_1 are also below
/// those of the first n, which then are those for all n.
enum class Start { too_small, enough, sharp };

Start judged(const SchemeFamily& family, int degree, int start) {
  Ledger ledger;
  const UniformBounds bounds = section_7(ledger, family, degree, start);
  if (!ledger.holds() || !step_check(bounds).decision.is_yes()) return Start::too_small;
  // For degree 1 of the primal family sections 5 and 6 stand for section 9.
  if (degree == 1 && family.id == "primal") return Start::sharp;
  const Scaled first = scaled_bounds(family, degree, family.least_n(degree), bounds);
  const auto below = [](const Ball& left, const std::optional<Rational>& right) {
    return right && (left * 51 / 50).is_less(exactly(*right));  // both sides will be rounded
  };
  return below(tail_deviation(bounds), first.deviation) && below(tail_slope(bounds, start), first.slope)
             ? Start::sharp
             : Start::enough;
}

constexpr int starts[] = {24, 28, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 384, 448, 512};

int find_start(const SchemeFamily& family, int degree) {
  int enough = 0, last = 0;
  for (int start : starts) {
    if (start < 5 * degree) continue;  // never good enough
    last = start;
    const Start judgement = judged(family, degree, start);
    if (judgement == Start::sharp) return start;
    if (judgement == Start::enough && enough == 0) enough = start;
    // Beyond this the single n cost more than sharpness is worth.
    if (enough > 0 && start > 12 * degree + 32) break;
  }
  return enough > 0 ? enough : last;
}

}  // namespace

int uniform_start(const SchemeFamily& family, int degree) {
  static Kept<std::pair<std::string, int>, int> known;
  return known({family.id, degree}, [&] { return find_start(family, degree); });
}

void uniform_8_n(Ledger& ledger, const SchemeFamily& family, int degree, int threads) {
  const int start = uniform_start(family, degree), first = family.least_n(degree);
  const UniformBounds bounds = section_7(ledger, family, degree, start);
  if (!ledger.holds()) return;
  prepare_variance_ends(family.schemes(first, start, degree), threads);
  const auto ends = [&](int n) -> const VarianceEnds& { return variance_ends(family.scheme(n, degree)); };
  for (int n = first; n < start; ++n)
    ledger.check(less("8.1", "max psi_" + text(n + 1) + " < min psi_" + text(n), ends(n + 1).maximum, ends(n).minimum));
  ledger.need(step_check(bounds));
}

void uniform_8_d(Ledger& ledger, const SchemeFamily& family, int degree, int threads) {
  const int next = degree + 2, first = family.least_n(next);
  const int low_start = uniform_start(family, degree), high_start = uniform_start(family, next),
            start = std::max(low_start, high_start);
  const UniformBounds low = section_7(ledger, family, degree, low_start);
  if (!ledger.holds()) return;
  const UniformBounds high = section_7(ledger, family, next, high_start);
  if (!ledger.holds()) return;
  std::vector<std::string> schemes = family.schemes(first, start - 1, degree),
                           more = family.schemes(first, start - 1, next);
  schemes.insert(schemes.end(), more.begin(), more.end());
  prepare_variance_ends(schemes, threads);
  for (int n = first; n < start; ++n)
    ledger.check(less("10.1", "max psi^" + text(degree) + " < min psi^" + text(next) + at(n),
                      variance_ends(family.scheme(n, degree)).maximum, variance_ends(family.scheme(n, next)).minimum));
  const Ball N = exactly(family.size(start));
  ledger.need(
      less("10.2",
           "N (K + K')/N^3 + N (Omega + Omega')/N^5 < 2 (c-_" + text(next) + " - c+_" + text(degree) + ")" + at(start),
           (N * (low.deviation(N) + high.deviation(N))).enclosure(), Enclosure::exactly(2 * (high.below - low.above))));
}

void uniform_7(Ledger& ledger, const SchemeFamily& family, int degree, int threads) {
  const int start = uniform_start(family, degree), first = family.least_n(degree);
  const UniformBounds bounds = section_7(ledger, family, degree, start);
  if (!ledger.holds()) return;
  prepare_variance_ends(family.schemes(first, start - 1, degree), threads);
  // The largest over n < n_1; what a constant bounds is the bound computed.
  Scaled largest = scaled_bounds(family, degree, first, bounds);
  for (int n = first + 1; n < start; ++n) {
    const Scaled one = scaled_bounds(family, degree, n, bounds);
    for (auto member : {&Scaled::deviation, &Scaled::slope})
      largest.*member = largest.*member && one.*member ? std::max(largest.*member, one.*member) : std::nullopt;
  }
  const auto ball = [](const std::optional<Rational>& value) {
    return value ? exactly(*value) : Ball::indeterminate(proof_bits);
  };
  const std::string n_from = ", n >= " + text(first);
  // The constants for all n also bound what is stated for n >= n_1.
  ledger.state("beta_2", Side::above, "9.1", "n^2 |N psi_n/(2 C_d) - 1|, n >= n_1",
               "(1 + 1/(2 N_1))^2/4 (K + Omega/N_1^2)/(2 C)", tail_deviation(bounds), 3);
  ledger.state("beta", Side::above, "9.2", "the same" + n_from,
               "the left side of (9.1), and n^2 times the bounds for n < n_1",
               max(tail_deviation(bounds), ball(largest.deviation)), 3);
  ledger.state("s", Side::above, "9.3", "n^2 |psi_n'|" + n_from, "n_1^2 Delta/N_1^5 and n^2 D_n, n < n_1",
               max(tail_slope(bounds, start), ball(largest.slope)), 3);
}

Constants uniform_constants_7(int degree) {
  Ledger ledger;
  uniform_7(ledger, scheme_family("primal"), degree, 1);
  return ledger.constants();
}

}  // namespace subcert::theorems
