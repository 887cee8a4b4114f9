#include "describe.hpp"

#include "every_pair.hpp"

#include <algorithm>

namespace subcert::theorems {
namespace {

std::string plain(const Rational& value) { return to_decimal(value, 40, Rounding::nearest); }

std::string with_degree(const char* name, int degree) { return name + ("_" + std::to_string(degree)); }

/// The two ranges of a proof of section 7.
void describe_ranges(Theorem& t, int first, int start) {
  const std::string n_1 = std::to_string(start);
  t.ranges = {{std::to_string(first) + " <= n < " + n_1,
               "mean, ripple and slope of each n by the supersolution, for small n with exact values"},
              {"n >= " + n_1, "the constants below, for all n at once"}};
}

/// `conjecture` for degree d, of this family where it is not the one of the conjectures.
std::string title_of(const std::string& conjecture, const SchemeFamily& family, const std::string& degrees) {
  return conjecture + " for " + degrees + (family.id == "primal" ? "" : " of the " + family.title + " schemes") +
         " and every n";
}

std::string proof_text(const SchemeFamily& family, const std::string& theorem) {
  return "docs/theorems/variance-curves.tex, Theorem " + theorem + (family.id == "primal" ? "" : " and Theorem G");
}

std::string size_text(const SchemeFamily& family) {
  if (family.offset == 0) return "2n";
  return "(2n " + std::string(family.offset < 0 ? "- " : "+ ") + to_text(abs(family.offset)) + ")";
}

/// What is proved of the schemes before the smoothest class begins, in front of the ranges.
void describe_small(Theorem& t, const SchemeFamily& family, const SmoothnessRange& range) {
  const int degree = t.degrees.front();
  std::vector<std::pair<std::string, std::string>> small;
  for (int n = family.least_n(degree); n < range.first; ++n) {
    const Rational exponent = exponent_bound(family.scheme(n, degree));
    small.emplace_back("n = " + std::to_string(n),
                       exponent > 0 ? "only s >= " + to_decimal(exponent, 5, Rounding::down) : "not bounded");
  }
  t.ranges.insert(t.ranges.begin(), small.begin(), small.end());
}

/// Contains s of S_n: from the bound by frequencies to that of the word.
Enclosure exponent_range(const SmoothnessRate& rate) {
  const Ball end = 2 - Ball::containing(rate.product, proof_bits) / log(Ball(2, proof_bits));
  return {exponent_bound(scheme_family("primal").scheme(rate.n, 1)), end.enclosure().upper};
}

}  // namespace

void describe_7_degree_one(Theorem& t) {
  const auto number = [&](const char* name) { return plain(t.constants[name]); };
  t.title = "Conjecture 7 for degree 1 and every n";
  t.text = "docs/theorems/variance-curves.tex, Theorems B, C and I";
  t.statement = {
      "First half. For all n >= 1 and all x, |(n - 1/4) psi_n(x)/c - 1| < " + number("beta") +
          "/n^2; for n >= 2 even < " + number("beta_2") + "/n^2. Here c = lim n max psi_n, " + number("c-") +
          " < c < " + number("c+") + ".",
      "So max psi_n = c/n (1 + 1/(4n) + O(1/n^2)): the rate 1/n is true, with its constant.",
      "Second half. For n >= 2, psi_n is C^1 and n^2 |psi_n'(x)| < " + number("s") +
          " for all x; for n >= 64, |psi_n'(x)| < " + number("Delta") + "/(2n - 1/2)^6.",
      "So max |psi_n'| = O(1/n^2) is true as a bound, and n^2 max |psi_n'| tends to 0: as a rate it is false.",
      "The true rate: log max |psi_n'| / (log n)^2 has the upper limit -1/(2 log 2), by (12.1) and conjecture-8-d."};
  t.ranges = {{"n = 1", "psi_1 = 1 - 2x + 2x^2 on [0, 1]"},
              {"2 <= n < 64", "mean, ripple and slope of each n by the supersolution, for small n with exact values"},
              {"n >= 64", "the constants below, for all n at once"}};
}

void describe_8_degree_one(Theorem& t) {
  t.title = "Conjecture 8 in n for degree 1 and every n";
  t.text = "docs/theorems/variance-curves.tex, Theorem A";
  t.statement = {"psi_{n+1}(x) < psi_n(x) for all n >= 1 and all x; even max psi_{n+1} < min psi_n."};
  t.ranges = {{"n = 1", "psi_1 = 1 - 2x + 2x^2 on [0, 1]"},
              {"2 <= n < 64", "mean and ripple of each n by the supersolution, for small n with exact values"},
              {"n >= 64", "the constants below, for all n at once"}};
}

void describe_7(Theorem& t, const SchemeFamily& family) {
  const int degree = t.degrees.front();
  const std::string d = std::to_string(degree), first = std::to_string(family.least_n(degree)),
                    start = std::to_string(uniform_start(family, degree)), N = size_text(family);
  const auto number = [&](const std::string& name) { return plain(t.constants[name]); };
  t.title = title_of("Conjecture 7", family, "degree " + d);
  t.text = proof_text(family, "E");
  t.statement = {
      "First half. For all n >= " + first + " and all x, |" + N + " psi_n(x)/(2 C) - 1| < " + number("beta") +
          "/n^2; for n >= " + start + " even < " + number("beta_2") + "/n^2. Here C = lim n max psi_n, " +
          number(with_degree("c-", degree)) + " < C < " + number(with_degree("c+", degree)) + ".",
      "So max psi_n = 2 C/" + N + " (1 + O(1/n^2)): the rate 1/n is true, with its constant.",
      "Second half. For n >= " + first + ", psi_n is C^1 and n^2 |psi_n'(x)| < " + number("s") +
          " for all x; for n >= " + start + ", |psi_n'(x)| < " + number(with_degree("Delta", degree)) + "/N^5 and < " +
          number(with_degree("R", degree)) + " N^(" + number(with_degree("r", degree)) + " - log2(N)/2), N = " + N +
          ".",
      "So max |psi_n'| = O(1/n^2) is true as a bound, and n^2 max |psi_n'| tends to 0: as a rate it is false.",
      "For smaller n the scheme is the one of a smaller degree."};
  describe_ranges(t, family.least_n(degree), uniform_start(family, degree));
}

void describe_8_n(Theorem& t, const SchemeFamily& family) {
  const int degree = t.degrees.front();
  const std::string first = std::to_string(family.least_n(degree));
  t.title = title_of("Conjecture 8 in n", family, "degree " + std::to_string(degree));
  t.text = proof_text(family, "D");
  t.statement = {"psi_{n+1}(x) < psi_n(x) for all n >= " + first + " and all x; even max psi_{n+1} < min psi_n.",
                 "For smaller n the scheme is the one of a smaller degree."};
  describe_ranges(t, family.least_n(degree), uniform_start(family, degree));
}

void describe_8_d(Theorem& t, const SchemeFamily& family) {
  const int degree = t.degrees.front(), next = degree + 2;
  const std::string low = std::to_string(degree), high = std::to_string(next),
                    first = std::to_string(family.least_n(next));
  t.degrees = {degree, next};
  t.title = title_of("Conjecture 8 in d", family, "the degrees " + low + " and " + high);
  t.text = proof_text(family, "F");
  t.statement = {"psi_n of degree " + low + " is smaller than psi_n of degree " + high +
                     " at all x, for all n >= " + first + "; even max psi_n^" + low + " < min psi_n^" + high + ".",
                 "For smaller n the two schemes are the same, and so are the curves."};
  describe_ranges(t, family.least_n(next), std::max(uniform_start(family, degree), uniform_start(family, next)));
}

void describe_smoothness_degree_one(Theorem& t) {
  const auto number = [&](const char* name) { return plain(t.constants[name]); };
  t.title = "Smoothness for degree 1 and every n";
  t.text = "docs/theorems/variance-curves.tex, Theorem U";
  t.statement = {"For all n >= 2 the Hoelder exponent s of S_n lies in 2 - " + number("C") +
                     " N^(1 - log2(N)/2) < s <= 2, N = 2n - 1/2.",
                 "So all limits are C^1, s tends to 2 faster than every power of n, and no S_n is C^2.",
                 "For all n >= 4, s > " + number("s") + "."};
  t.ranges = {{"2 <= n < 64", "a supersolution on cells of frequencies for each n"},
              {"n >= 64", "the constants below, for all n at once"}};
}

void describe_smoothness(Theorem& t, const SchemeFamily& family) {
  if (family.id == "primal" && t.degrees.front() == 1) return describe_smoothness_degree_one(t);
  const SmoothnessRange range = smoothness_range(family, t.degrees.front());
  const std::string d = std::to_string(t.degrees.front()), order = std::to_string(range.order),
                    rules = std::to_string(range.order + 1), first = std::to_string(range.first),
                    start = std::to_string(range.start);
  t.title = title_of("Smoothness", family, "degree " + d);
  t.text = "docs/theorems/variance-curves.tex, Theorem V";
  t.statement = {"For all n >= " + first + " all limits are C^" + order + ": their Hoelder exponent s is above " +
                 order + ", and at most " + rules + "."};
  t.ranges = {{first + " <= n < " + start, "a supersolution on cells of frequencies for each n"},
              {"n >= " + start, "the constants below, for all n at once"}};
  const std::string tends = "s tends to " + rules + " faster than every power of n.";
  if (range.rate) {
    const auto number = [&](const std::string& name) { return plain(t.constants[name + "_" + d + "'"]); };
    t.statement.push_back("For n >= " + std::to_string(*range.rate) + ", " + rules + " - s < " + number("R*") + " N^(" +
                          number("r*") + " - log2(N)/2), N = " + size_text(family) + ": " + tends);
    t.ranges.emplace_back("n >= " + std::to_string(*range.rate), "those with a prime, for the rate");
  } else {
    t.statement.push_back("As n grows, " + tends);
    t.ranges.emplace_back("n to infinity", "Theorem V (c), without constants");
  }
  describe_small(t, family, range);
}

void describe_every_smoothness(Theorem& t, const SchemeFamily& family) {
  const int degree = t.degrees.front(), k = alias_order(family.evaluation, degree);
  const bool dual = family.evaluation == Evaluation::dual;
  const int odd = dual ? degree + 1 - degree % 2 : degree;
  const std::string d = text(degree), order = text(k - 1), rules = text(k),
                    power = "4^" + text(every_smoothness_power(family.evaluation, degree)),
                    start = plain(every_smoothness_start(family, degree)) + " " + power,
                    M = dual ? (family.odd ? "2n + 1" : "2n") : (family.odd ? "2n" : "2n - 1");
  const auto number = [&](const char* name) { return plain(t.constants[name]); };
  t.title = "Smoothness for every degree and large n, here degree " + d + " of the " + family.title + " schemes";
  t.text = "docs/theorems/least-squares-schemes.tex, Theorem X";
  t.statement = {
      "For every odd d and all n >= 4^d all limits of the primal 2n-point scheme of degree d are C^d; for d "
      ">= 5 those of the (2n+1)-point scheme too.",
      "For every d >= 3 and all n >= 4^(d+2) all limits of the dual 2n-point and (2n+1)-point schemes are "
      "C^d for even and C^(d+1) for odd d.",
      "Here all limits are C^" + order + " for all n >= " + start + ": their Hoelder exponent s is above " + order +
          ", and at most " + rules + ".",
      "For n >= " + power + ", " + rules + " - s < " + number("R") + " y^(" + number("r") +
          " - log2(y)/2), y = pi M/(4 sqrt(" + text(odd * (odd + 1)) + ")), M = " + M + ": s tends to " + rules +
          " faster than every power of n."};
  t.ranges = {{"n >= " + power, "the constants below, for all n at once"},
              {"n >= " + start, "the same inequalities, but for those of the next degree"},
              {"all d",
               "(X.1) to (X.18) for the first degree of each kind; from one degree to the next but one the "
               "bounds fall"}};
}

void describe_rate(Theorem& t, const SchemeFamily&) {
  const auto number = [&](const char* name) { return plain(t.constants[name]); };
  t.title = "The true rate of smoothness for degree 1";
  t.text = "docs/theorems/least-squares-schemes.tex, Theorem W";
  t.statement = {
      "There is a constant C with |(2 - s) ln 2 - beta_n| <= N^(C - log2(N)) for all n >= 2, N = 2n - 1/2: beta_n is "
      "the "
      "largest mean of h_n over a measure that is invariant under x -> 2x modulo 1, h_n(x) the sum of "
      "phi_b^(2 pi k) exp(2 pi i k x) over odd |k| < N.",
      "For n = 3, 11, 43, ... = (2^(2m+1) + 4)/12 it is a sharp rate: (2 - s)/(kappa (pi^2 (4n - 1)/(12 ln 2)) "
      "|phi^(pi)|) tends to 1, kappa = 1 for even m and 2 for odd m; log(2 - s)/(log n)^2 has the upper limit "
      "-1/(2 log 2).",
      "For 2 <= n <= 43: the mean over the orbit of the word below is beta_n up to " + number("delta") +
          " of it. (2 - s) ln 2 is at least ln|lambda|, by an eigenvalue of the word's product; that is the mean up "
          "to " +
          number("e_5") + " of it for n >= 5 and up to " + number("e_20") + " for n >= 20."};
  t.ranges = {{"n to infinity", "a proof without a computer; C is not named"},
              {"2 <= n <= 43", "the numbers above, each for one n"}};
  for (const SmoothnessRate& rate : smoothness_rates(1))
    t.values.emplace_back("s_" + text(rate.n), enclosure_text(exponent_range(rate), 13) + ", word " + rate.word +
                                                   ", mean " + enclosure_text(rate.predicted, 7) + ", ln|lambda| " +
                                                   enclosure_text(rate.product, 5));
}

void describe_limit_constants(Theorem& t) {
  t.title = "The limits of n max psi_n";
  t.degrees = {1, 3, 5, 7, 9};
  t.text = "docs/limit-constants.md, theorems 5, 7 and 10";
  t.statement = {"For each odd d, n max psi_n^d tends to C_d, and so do n min psi_n^d and n times the mean of psi_n^d.",
                 "For d = 1, with c = C_1 and N = 2n - 1/2, the mean is I_n = 2c/N (1 + nu/N^2 + O(1/N^4)), nu = "
                 "13/36: the next term is "
                 "(13/18) c/N^3, an exact rational multiple of c."};
  for (const Constant& constant : t.constants.all())
    if (constant.name.starts_with("C_") && constant.side == Side::below)
      t.values.emplace_back(constant.name.substr(0, constant.name.size() - 1),
                            to_fixed(constant.value, 32, Rounding::down) + "...");
  t.values.emplace_back("nu", to_text(t.constants["nu-"]));
}

void describe_convergence(Theorem& t) {
  const int degree = t.degrees.front();
  t.title = "Convergence for every degree and every n";
  t.text = "docs/theorems/least-squares-schemes.tex, Theorem P";
  t.statement = {"S_n^d converges for all n >= 1 and all d <= 2n - 1.",
                 "The response D_M of one fit of degree d on M > d points, read off in the middle, is below 1 in "
                 "modulus except where sin w = 0, and the moduli of the transform of phi at xi + 2 pi k sum to at most "
                 "max(|D_{2n-1}|, |D_{2n}|)(xi/2) <= 1.",
                 "So the mean of psi_n is at most (K_{2n-1}(0) + K_{2n}(0))/2, K_M(0) the central weight."};
  const std::string first = std::to_string((degree + 1) / 2);
  t.ranges = {{"all d, all n", "the proof, with the numbers (P.1), (P.2), (P.5) to (P.15)"},
              {"d = " + std::to_string(degree) + ", n >= " + first,
               "for confirmation only: (P.3), (P.4) for the six smallest n"}};
}

void describe_large_n(Theorem& t) {
  const int degree = t.degrees.front();
  const std::string low = std::to_string(degree), high = std::to_string(degree + 2),
                    start = std::to_string(large_n(degree));
  t.degrees = {degree, degree + 2};
  t.title = "Conjecture 8 in d for the degrees " + low + " and " + high + " and large n";
  t.text = "docs/theorems/variance-curves.tex, Theorem T (b)";
  t.statement = {
      "max psi_n^d < min psi_n^{d+2} for every odd d from 5 to 191 and all n >= max(50, 4d + 4), for d >= 193 and all "
      "n >= (d^2 + 1)/2; here max psi_n^" +
      low + " < min psi_n^" + high + " for all n >= " + start + "."};
  t.ranges = {{"n >= " + start, "bounds of mean and ripple that fall with n"}};
  if (degree > 11)
    t.ranges.emplace_back("all d >= 13", "(T.5) for 13 <= d <= 193; from 193 on they fall with d, 2n = d^2 + 1");
}

void describe_every_n(Theorem& t) {
  const int degree = t.degrees.front(), next = degree + 2;
  const std::string low = std::to_string(degree), high = std::to_string(next), first = std::to_string((degree + 3) / 2),
                    start = std::to_string(large_n(degree));
  t.degrees = {degree, next};
  t.title = "Conjecture 8 in d for the degrees " + low + " and " + high + " and every n";
  t.text = "docs/theorems/variance-curves.tex, Theorem T (b) and (c)";
  t.statement = {"max psi_n^" + low + " < min psi_n^" + high + " for all n >= " + first + ".",
                 "For smaller n the two schemes are the same, and so are the curves."};
  t.ranges = {{first + " <= n < " + start, "the responses of the two rules, and a lower bound of the mean, for each n"},
              {"n >= " + start, "bounds of mean and ripple that fall with n, (T.5)"}};
}

void describe_all_higher(Theorem& t) {
  const int degree = t.degrees.front();
  const std::string low = std::to_string(degree);
  t.title = "Conjecture 8 in d from degree " + low + " to all higher degrees and every n";
  if (degree == 1) {
    t.text = "docs/theorems/least-squares-schemes.tex, Theorem Q";
    t.statement = {"psi_n^1(x) <= 1/(2n - 1) < psi_n^d(x') for all n >= 2, all odd 3 <= d <= 2n - 1 and all x, x'."};
    t.ranges = {{"all d, all n", "a proof without a computer"},
                {"2 <= n <= 8", "for confirmation only: exact values on a grid against the bounds of the proof"}};
    return;
  }
  t.text = "docs/theorems/variance-curves.tex, Theorem R";
  t.statement = {"max psi_n^" + low + " < min psi_n^d for all odd d > " + low + " and all n >= (d+1)/2."};
  const int from = all_higher_from(degree);
  for (int next = degree + 2; next < from; next += 2) {
    std::string runs = "conjecture-8-d --d " + low;
    for (int between = degree + 2; between < next; between += 2) runs += ", " + std::to_string(between);
    t.ranges.emplace_back("d = " + std::to_string(next), runs);
  }
  const std::string lemma = "d >= " + std::to_string(from) + ", ", first = std::to_string((from + 1) / 2),
                    start = degree == 3   ? "6"
                            : degree == 5 ? "10"
                                          : "60";
  t.ranges.emplace_back(lemma + first + " <= n < " + start,
                        "psi_n^" + low + " bounded for each n, psi_n^d from its polynomials");
  t.ranges.emplace_back(lemma + "n >= " + start, degree >= 7 ? "the bounds of conjecture-8-d-large --d " + low
                                                             : "conjecture-7 --d " + low + ", and one inequality");
}

void describe_limits_grow(Theorem& t) {
  t.title = "The limits of n max psi_n grow with the degree";
  t.text = "docs/theorems/least-squares-schemes.tex, Theorem S";
  t.statement = {"C_d < gamma_d^2/2 < C_{d+2} for every odd d, gamma_d = d binom(d-1, (d-1)/2)/2^(d-1).",
                 "C_d = d/pi + 1/(2 pi) - 1/(sqrt(3) pi^2) + o(1) as d grows.",
                 "So for each pair d_1 > d_2 and all sufficiently large n, max psi_n^{d_2} < min psi_n^{d_1}."};
  t.ranges = {{"d >= 9", "the proof, with one inequality at d = 9"},
              {"d <= 7", "the digits of C_3, C_5, C_7"},
              {"d <= 21", "for confirmation only: (S.3), (S.4)"}};
}

}  // namespace subcert::theorems
