#include "theorem.hpp"

#include "every_pair.hpp"
#include "proofs.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>

namespace subcert::theorems {
namespace {

constexpr int most_degree = 21;  ///< to which section 7 is tried

/// One id and how each of its degrees is proved.
struct Proof {
  int degree;
  std::function<Constants(int threads)> constants;
  std::function<std::vector<Check>(const Constants&, int threads)> checks;
  std::function<void(Theorem&)> describe;
};

std::string plain(const Rational& value) { return to_decimal(value, 40, Rounding::nearest); }

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

/// Contains s of S_n: from the bound by frequencies to that of the word.
Enclosure exponent_range(const SmoothnessRate& rate) {
  const Ball end = 2 - Ball::containing(rate.product, proof_bits) / log(Ball(2, proof_bits));
  return {exponent_bound(scheme_family("primal").scheme(rate.n, 1)), end.enclosure().upper};
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

struct Entry {
  TheoremEntry entry;
  std::vector<Proof> proofs;
  std::vector<std::string> missing;  ///< for the degrees without proof
  bool together = false;             ///< one proof for all its degrees
  /// The proof for a degree beyond those listed, or of another family, where there is one.
  std::function<std::optional<Proof>(int degree, const SchemeFamily&)> further = {};
};

/// A proof of section 7: its constants are found by the same run.
using Run = void (*)(Ledger&, const SchemeFamily&, int degree, int threads);
std::optional<Proof> found(int degree, const SchemeFamily& family, Run run,
                           void (*describe)(Theorem&, const SchemeFamily&), int most = most_degree) {
  if (degree > most) return std::nullopt;
  return Proof{degree,
               [=, &family](int threads) {
                 Ledger ledger;
                 run(ledger, family, degree, threads);
                 return ledger.constants();
               },
               [=, &family](const Constants& constants, int threads) {
                 Ledger ledger(&constants);
                 run(ledger, family, degree, threads);
                 return ledger.checks();
               },
               [=, &family](Theorem& t) { describe(t, family); }};
}

/// A proof without constants of its own.
Proof by_threads(int degree, std::vector<Check> (*checks)(const Constants&, int, int), void (*describe)(Theorem&)) {
  return {degree, [](int) { return Constants(); },
          [=](const Constants& c, int threads) { return checks(c, degree, threads); }, describe};
}

/// A proof whose functions take the degree.
Proof by_degree(int degree, Constants (*constants)(int), std::vector<Check> (*checks)(const Constants&, int, int),
                void (*describe)(Theorem&)) {
  return {degree, [=](int) { return constants(degree); },
          [=](const Constants& c, int threads) { return checks(c, degree, threads); }, describe};
}

const std::vector<Entry>& entries() {
  static const std::vector<Entry> list = [] {
    const std::vector<std::string> higher{"the machine of section 7 is run up to degree " + text(most_degree) +
                                          "; beyond, the curves below n_1 take minutes"};

    std::vector<Entry> all;
    const std::string every = "every n >= (d+1)/2";
    const auto primal = [](const SchemeFamily& family) { return family.id == "primal"; };
    const std::vector<int> degrees{1, 3, 5, 7, 9, 11, 13}, pairs{1, 3, 5, 7, 9, 11, 13, 15};
    all.push_back(
        {{"conjecture-7",
          "max psi_n ~ 1/n; of max |psi_n'| ~ 1/n^2 the upper bound, while the rate is false: n^2 max |psi_n'| tends "
          "to 0",
          every, degrees},
         {{1, [](int) { return degree_one_constants_7(); }, degree_one_checks_7, describe_7_degree_one}},
         higher,
         false,
         [](int degree, const SchemeFamily& family) { return found(degree, family, uniform_7, describe_7); }});
    all.push_back(
        {{"conjecture-8-n", "psi_{n+1} < psi_n everywhere", every, degrees},
         {{1, [](int) { return degree_one_constants_8(); }, degree_one_checks_8, describe_8_degree_one}},
         higher,
         false,
         [](int degree, const SchemeFamily& family) { return found(degree, family, uniform_8_n, describe_8_n); }});
    constexpr int most_neighbours = 41;
    all.push_back({{"conjecture-8-d", "psi of degree d < psi of degree d + 2 everywhere", "every n >= (d+3)/2", pairs},
                   {},
                   {"neighbours are compared up to degree " + text(most_neighbours) +
                    ", of other families the machine of section 7 is run up to degree " + text(most_degree) +
                    "; beyond, the curves for small n take minutes"},
                   false,
                   [=](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     if (!primal(family) || degree < 13) return found(degree, family, uniform_8_d, describe_8_d);
                     if (degree > most_neighbours) return std::nullopt;
                     return by_threads(degree, every_n_checks, describe_every_n);
                   }});
    all.push_back(
        {{"limit-constants", "the limits C_d of n max psi_n, printed together", "n to infinity", {1, 3, 5, 7, 9}},
         {{1, [](int) { return limit_constants_stated(); }, limit_constants_checks, describe_limit_constants}},
         {"stated digits for this degree"},
         true});
    all.push_back({{"convergence", "S_n^d converges", "every odd d, every n >= (d+1)/2", {1, 3, 5}},
                   {},
                   {"the lemma on the response, for another family"},
                   false,
                   [=](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     if (!primal(family)) return std::nullopt;
                     return by_degree(degree, convergence_constants, convergence_checks, describe_convergence);
                   }});
    all.push_back({{"conjecture-8-d-all",
                    "psi of degree d < psi of all higher degrees everywhere",
                    "every n",
                    {1, 3, 5, 7, 9, 11}},
                   {},
                   {"psi of degree d < psi of degree d + 2 for every n, from this degree up to 2 d + 1"},
                   false,
                   [=](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     if (!primal(family) || degree > 11) return std::nullopt;
                     return by_degree(degree, all_higher_constants, all_higher_checks, describe_all_higher);
                   }});
    all.push_back({{"smoothness",
                    "S_n^d is C^d, and its Hoelder exponent tends to d + 1 faster than every power of n",
                    "every n >= 2 for d = 1, every n >= 7 for d = 3",
                    {1, 3}},
                   {},
                   {"the bounds of section 7 are tried up to n_1 = 600; for n >= 4^d, or 4^(d+2), see smoothness-all"},
                   false,
                   [](int degree, const SchemeFamily& family) {
                     return found(degree, family, smoothness, describe_smoothness);
                   }});
    all.push_back({{"smoothness-all",
                    "S_n^d is C^d",
                    "every odd d >= 5, every n >= 4^d; dual schemes every d >= 3, "
                    "every n >= 4^(d+2)",
                    {5, 7, 9, 11, 13}},
                   {},
                   {"for the degrees 1, 2 and 3 see smoothness and smoothness-dual; beyond degree 200 of the dual "
                    "schemes the decimals of the constants are too long"},
                   false,
                   [](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     const bool dual = family.evaluation == Evaluation::dual;
                     if (degree < (dual ? 3 : 5)) return std::nullopt;
                     return found(degree, family, every_smoothness, describe_every_smoothness,
                                  dual ? 200 : largest_degree);
                   }});
    all.push_back({{"smoothness-dual",
                    "the dual schemes of degree 1 are C^2, and their Hoelder exponents tend to 3 faster than every "
                    "power of n",
                    "every n >= 2, of (2n+1) points every n >= 1",
                    {1}},
                   {},
                   {"the bounds of section 7 are tried up to n_1 = 600; for n >= 4^d, or 4^(d+2), see smoothness-all"},
                   false,
                   [](int degree, const SchemeFamily& family) {
                     return found(degree, scheme_family(family.id == "primal" ? "dual" : family.id), smoothness,
                                  describe_smoothness);
                   }});
    all.push_back({{"rate",
                    "2 - s of S_n is the largest mean of a function over an orbit of x -> 2x, up to its square",
                    "n to infinity, with certified numbers for n <= 43",
                    {1}},
                   {},
                   {"the symbols of other degrees and families"},
                   false,
                   [=](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     if (!primal(family) || degree != 1) return std::nullopt;
                     return found(degree, family, smoothness_table, describe_rate);
                   }});
    all.push_back({{"conjecture-8-d-large",
                    "psi of degree d < psi of degree d + 2 everywhere",
                    "every odd d >= 5, every n >= max(50, 4d+4), beyond d = 191 n >= (d^2+1)/2",
                    {5, 7, 9, 11, 13}},
                   {},
                   {"for the degrees 1 and 3, and for other families, see conjecture-8-d"},
                   false,
                   [=](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     if (!primal(family) || degree < 5) return std::nullopt;
                     return by_degree(degree, large_n_constants, large_n_checks, describe_large_n);
                   }});
    all.push_back({{"limit-constants-order", "C_d < C_{d+2}", "every odd d, n to infinity", {1}},
                   {},
                   {"the limits of another family"},
                   true,
                   [=](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     if (!primal(family)) return std::nullopt;
                     return Proof{degree, [](int) { return Constants(); }, limits_grow_checks, describe_limits_grow};
                   }});
    return all;
  }();
  return list;
}

const Entry& find(const std::string& id) {
  for (const Entry& entry : entries())
    if (entry.entry.id == id) return entry;
  fail(ErrorKind::domain, "unknown theorem '{}'", id);
}

std::optional<Proof> find(const Entry& entry, int degree, const SchemeFamily& family) {
  const std::vector<int>& degrees = entry.entry.degrees;
  if (family.id == "primal" && std::find(degrees.begin(), degrees.end(), degree) != degrees.end())
    for (const Proof& proof : entry.proofs)
      if (proof.degree == degree || entry.together) return proof;
  if (entry.further) return entry.further(degree, family);
  return std::nullopt;
}

}  // namespace

Check defining(const Constants& constants, const std::string& name, const std::string& formula, const Ball& number) {
  for (const Constant& constant : constants.all()) {
    if (constant.name != name) continue;
    const Enclosure stated = Enclosure::exactly(constant.value);
    return constant.side == Side::above ? less(constant.check, formula + " < " + name, number.enclosure(), stated)
                                        : less(constant.check, name + " < " + formula, stated, number.enclosure());
  }
  fail(ErrorKind::domain, "no constant is called '{}'", name);
}

const std::vector<TheoremEntry>& theorem_list() {
  static const std::vector<TheoremEntry> list = [] {
    std::vector<TheoremEntry> result;
    for (const Entry& entry : entries()) result.push_back(entry.entry);
    return result;
  }();
  return list;
}

Constants stated_constants(const std::string& id, int degree, const std::string& family, int threads) {
  const std::optional<Proof> proof = find(find(id), degree, scheme_family(family));
  return proof ? proof->constants(threads) : Constants();
}

Theorem prove(const std::string& id, int degree, const Constants& constants, int threads,
              const std::string& family_id) {
  const Entry& entry = find(id);
  const SchemeFamily& family = scheme_family(family_id);
  const bool primal = family.evaluation == Evaluation::primal;
  if (degree < 1 || degree > largest_degree || (primal && degree % 2 == 0))
    fail(ErrorKind::domain, "prove: need {} degree from 1 to {}, got {}", primal ? "an odd" : "a", largest_degree,
         degree);
  Theorem theorem;
  theorem.id = id;
  theorem.degrees = {degree};
  theorem.title = entry.entry.title;
  const std::optional<Proof> proof = find(entry, degree, family);
  if (!proof) {
    theorem.missing = entry.missing;
    theorem.decision = {Truth::unknown, "nothing is proved for degree " + std::to_string(degree) +
                                            (family.id == "primal" ? "" : " of the " + family.title + " schemes")};
    return theorem;
  }
  theorem.constants = constants;
  theorem.checks = proof->checks(constants, threads);
  theorem.decision = verdict(theorem.checks);
  if (theorem.decision.truth != Truth::unknown) {
    proof->describe(theorem);
    return theorem;
  }
  for (const Check& check : theorem.checks)
    if (!check.decision.is_yes())
      theorem.missing.push_back("(" + check.id + ") " + check.claim + ": " + check.left.upper_text(6) +
                                " is not below " + check.right.lower_text(6));
  return theorem;
}

Theorem prove(const std::string& id, int degree) { return prove(id, degree, stated_constants(id, degree)); }

}  // namespace subcert::theorems
