// Theorems U and V: how smooth the schemes are, for every n. The numbers of the checks are those of
// docs/theorems/smoothness.tex.

#include "proofs.hpp"

#include <subcert/analysis/regularity/frequency/frequency_bound.hpp>
#include "degree_one.hpp"
#include "kept_by_scheme.hpp"
#include "kernel/kernel.hpp"
#include "uniform_curve.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace subcert::theorems {
namespace {

// Single schemes.

std::optional<FrequencyBound> bound_of(const std::string& scheme) {
  const Mask mask = make_scheme(scheme).mask.curve();
  std::optional<FrequencyBound> best;
  // More cells where an integer is near.
  for (int cells : {32, 128}) {
    std::optional<FrequencyBound> one = frequency_bound(mask, cells);
    if (one && (!best || one->exponent > best->exponent)) best = std::move(one);
    if (!best) continue;
    const double exponent = best->exponent.convert_to<double>();
    if (std::ceil(exponent) - exponent > 0.2 || std::ceil(exponent) >= best->sum_rules) break;
  }
  return best;
}

KeptByScheme<std::optional<FrequencyBound>>& known_bounds() {
  static KeptByScheme<std::optional<FrequencyBound>> result(bound_of);
  return result;
}

// Theorem U.

constexpr int first_of_tail = 64;

/// For n >= 64: the coefficient of 2^(-t(t-1)/2), t = log2(pi N/4), and what it is made of.
void degree_one_tail(Ledger& ledger) {
  const Ball pi = Ball::pi(proof_bits), N = exactly(Rational(4 * first_of_tail - 1, 2));
  const auto above = [&](const char* name, const char* id, const char* meaning, const std::string& formula,
                         const Ball& number) { return ledger.state(name, Side::above, id, meaning, formula, number); };
  const Ball kappa = above("kappa", "2.1", "sup |cos x - sin(x)/x|", "sup |cos x - sin(x)/x|",
                           Ball::containing(cosine_minus_sinc_supremum(), proof_bits));
  const Ball p = above("p", "U.1", "1/Phi(pi/2)", "1/Phi(pi/2)", 1 / Kernel(1, proof_bits).product(pi.scaled(-1)));
  const Ball t = log2(pi * N / 4), G = shell_ratio(N);
  // G^J with J <= t + 1.
  const Ball g = above("g-1", "U.2", "G^J, without 1", "(N_1^2/(N_1^2 - 1/4))^(t_1 + 1) - 1",
                       exp((t + 1) * log(G)) - 1) +
                 1;
  const Ball near = 4 / N;
  const Ball h = above("h-1", "U.3", "u/sin u on the shells from J - 1 on, without 1", "(4/N_1)/sin(4/N_1) - 1",
                       near / sin(near) - 1) +
                 1;
  const Ball size = kappa / (N - exactly(Rational(1, 2))).scaled(1);
  const Ball last = size * h * (pi * N / 4).pow(2).scaled(2) * p * g * power_of_two(1 - t * (t + 1) / 2);
  std::vector<Ball> terms;
  Ball product(1, proof_bits);
  for (int l = 0; l < 4; ++l) {
    const Ball u = pi.scaled(-l - 1);
    terms.push_back(size * product * (u / sin(u)).scaled(2 * (l + 1)));
    product *= G / N / sin(pi.scaled(-l - 2));
  }
  // Those from 3 to J - 1 are at most the larger one of the first and the last.
  const Ball head = terms[0] + terms[1] + terms[2] + max(terms[3], last) * (t - 2);
  const Ball zeta = above("zeta", "U.4", "sum of 4^(l+1) e_l X over l < J",
                          "t_0 + t_1 + t_2 + (t_1 - 2) max(t_3, t_{J-1})", head);
  ledger.need(less("U.5", "zeta < 1", Enclosure::exactly(ledger["zeta"]), Enclosure::exactly(1)));
  if (!ledger.holds()) return;
  const Ball c = above("c", "U.6", "2^(t(t-1)/2) (2 - s), n >= 64", "2 pi h g p/(3 (1 - zeta) ln 2)",
                       pi.scaled(1) / 3 * h * g * p / ((1 - zeta) * log(Ball(2, proof_bits))));
  // t(t-1)/2 - (L^2/2 - L) with t = L + b, b = log2(pi/4): (b + 1/2) L + b (b - 1)/2.
  const Ball b = log2(pi / 4), L = log2(N);
  above("C", "U.7", "N^(log2(N)/2 - 1) (2 - s)", "c 2^(-(b + 1/2) L_1 - b (b - 1)/2), b = log2(pi/4)",
        c * power_of_two(-(b + exactly(Rational(1, 2))) * L - b * (b - 1) / 2));
}

/// 2 - s of one n is below the bound for all n, s above 1, and above more than that for n >= 4.
void degree_one_single(Ledger& ledger, const SchemeFamily& family) {
  const Ball C = exactly(ledger["C"]);
  std::optional<Rational> least;
  for (int n = 2; n < first_of_tail; ++n) {
    const std::optional<FrequencyBound>& bound = known_bounds()(family.scheme(n, 1));
    const Ball N = exactly(family.size(n)), L = log2(N);
    const Ball right = C * power_of_two(L - L * L / 2);
    ledger.need(less("U.8", "2 - s < C N^(1 - log2(N)/2)" + at(n),
                     bound ? Enclosure::exactly(2 - bound->exponent) : Enclosure::at_least(0), right.enclosure()));
    const Rational exponent = bound ? bound->exponent : Rational(0);
    if (n >= 4) least = least ? std::min(*least, exponent) : exponent;
  }
  const Ball N = exactly(family.size(first_of_tail)), L = log2(N);
  ledger.need(
      less("U.9", "C N_1^(1 - log2(N_1)/2) < 1", (C * power_of_two(L - L * L / 2)).enclosure(), Enclosure::exactly(1)));
  const Ball all = min(exactly(*least), 2 - C * power_of_two(L - L * L / 2));
  ledger.state("s", Side::below, "U.10", "the Hoelder exponent, n >= 4", "the least lower end over n >= 4", all, 3);
  for (int n = 2; n < 4; ++n)  // there the bound for all n does not say so
    ledger.need(
        less("U.11", "1 < s" + at(n), Enclosure::exactly(1), Enclosure::at_least(exponent_bound(family.scheme(n, 1)))));
}

// Theorem V.

/// What both parts of Theorem V need for N >= N_1.
struct Chain {
  SymbolConstants symbol;
  Ball alias;               ///< F of order k
  Ball factor;              ///< A*: the factor q of a product is at most A* 2^q/N
  Ball kept;                ///< K: what the first factors are smaller by
  std::vector<Ball> first;  ///< B times the product of the first l factors, at N_1, l <= 3
  int k = 0;                ///< the sum rules

  /// L_1 = log2 N_1 and the exponent c of N in N^(c - L/2), that of a product.
  Ball L() const { return log2(symbol.N); }
  Ball slope() const { return log2(factor) - exactly(Rational(1, 2)); }
  /// B times the product of the first L + delta factors at N_1, the larger one for both delta.
  Ball product(const Ball& low, const Ball& high) const {
    const auto power = [&](const Ball& delta) { return power_of_two(delta * slope() + delta * delta / 2); };
    return symbol.B * kept * max(power(low), power(high)) * power_of_two(L() * slope() - L() * L() / 2);
  }
  /// Of the J' shells where the factors are known.
  Ball product() const {
    const Ball half_pi = Ball::pi(proof_bits).scaled(-1);
    return product(log2(half_pi * symbol.fewest / symbol.N) - 1, log2(half_pi));
  }
};

std::optional<Chain> state_chain(Ledger& ledger, const SchemeFamily& family, int degree, int start,
                                 const std::string& end) {
  Chain chain;
  chain.symbol = state_symbol(ledger, family, degree, start, end);
  chain.k = alias_order(family.evaluation, degree);
  if (!ledger.holds()) return std::nullopt;
  const UniformNumbers& numbers = uniform_numbers(family.evaluation, degree, family.size(start));
  const Ball pi = Ball::pi(proof_bits), &N = chain.symbol.N;
  chain.alias = chain.k == degree + 1
                    ? chain.symbol.F
                    : ledger.state("F*" + end, Side::above, "V.1", "2 M_- |m(pi - v/M_+)|/v^(d+2), v <= 1",
                                   "bound of |2 N Im D(v/N)|/v^(d+2), v <= 1", numbers.alias_disc.bound);
  std::vector<Ball> decays = numbers.decays;
  for (std::size_t q = 1; q < decays.size(); ++q) decays[q] = max(decays[q], decays[q - 1]);
  const Ball any = max(numbers.any_decay, decays.back()), G = shell_ratio(N);
  // 1/sin(pi 2^(-q-2)) <= (4/pi) b 2^q with b = x/sin x at q = 3.
  const Ball x = pi.scaled(-5);
  chain.factor = ledger.state("A*" + end, Side::above, "V.2", "the factor q >= 3 of a product is at most A* 2^q/N",
                              "a G (4/pi) x/sin x, x = pi/32", any * G * 4 / pi * x / sin(x));
  const int most_kept = static_cast<int>(std::floor((log2(pi * N / 2) - 3).enclosure().lower->convert_to<double>()));
  ledger.need(less("V.3", "6 < log2(pi N_1/2)", Enclosure::exactly(6), log2(pi * N / 2).enclosure()));
  if (!ledger.holds()) return std::nullopt;
  Ball kept(1, proof_bits), product = chain.symbol.B;
  const int count = std::clamp(most_kept, 3, kept_factors);
  for (int q = 0; q < count; ++q) {
    const Ball factor = decays[static_cast<std::size_t>(q)] * G / sin(pi.scaled(-q - 2));
    if (q < 4) chain.first.push_back(product);
    product *= factor / N;
    kept *= factor / chain.factor.scaled(q);
  }
  if (chain.first.size() < 4) chain.first.push_back(product);
  chain.kept = ledger.state("K*" + end, Side::above, "V.4", "what the first factors are smaller by than A* 2^q/N",
                            "product of A_q G/(A* 2^q sin(pi 2^(-q-2))) over the first factors", kept);
  return chain;
}

/// The sum of 2^(r(l+1)) e_l X over l < J, for N >= N_1.
Ball head(const Chain& chain, int r) {
  const Ball pi = Ball::pi(proof_bits), half_pi = pi.scaled(-1), &N = chain.symbol.N;
  const Ball size = chain.symbol.E / chain.symbol.fewest.scaled(1), far = pi.scaled(-4) / sin(pi.scaled(-4));
  Ball sum(proof_bits), third(proof_bits);
  for (int l = 0; l < 4; ++l) {
    const Ball u = pi.scaled(-l - 1),
               term = (size * u / sin(u) * chain.first[static_cast<std::size_t>(l)]).scaled(r * (l + 1));
    if (l < 3)
      sum += term;
    else
      third = term;
  }
  // From the last on: l = J - 1 - i.
  const auto from_end = [&](int i) {
    const Ball low = log2(half_pi) - (i == 0 ? 2 : i + 1), high = log2(half_pi * chain.symbol.most / N) - i;
    return ((pi * chain.symbol.most).pow(r) * far * size * chain.product(low, high)).scaled(-r * i);
  };
  const Ball between = max(exactly(Rational(0)), log2(half_pi * chain.symbol.most) - 4);
  return sum + from_end(0) + from_end(1) + between * max(third, from_end(2));
}

/// (V.5): the bounds of the products fall from N_1 on, with two more powers of N to spare.
Check falls(const Chain& chain, int r) {
  return less("V.5", text(r) + " + log2(A*) + 1/2 < log2 N_1",
              (log2(chain.factor) + r + exactly(Rational(1, 2))).enclosure(), chain.L().enclosure());
}

/// All limits are C^(k-1) for N >= N_1.
void state_class(Ledger& ledger, const SchemeFamily& family, int degree, int start) {
  const std::string end = "_" + text(degree);
  const std::optional<Chain> chain = state_chain(ledger, family, degree, start, end);
  if (!chain) return;
  const int r = chain->k - 1;
  const Ball pi = Ball::pi(proof_bits);
  ledger.need(falls(*chain, r));
  const Ball beyond = chain->alias * (pi * chain->symbol.most).pow(r) / chain->symbol.fewest * chain->product();
  const Ball Z = ledger.state("Z*" + end, Side::above, "V.6", "sum of 2^((k-1)(l+1)) e_l X over all l",
                              "its terms l < J, and F* (pi M_+)^(k-1)/M_- X", head(*chain, r) + beyond);
  ledger.need(less("V.7", "Z*" + end + " < 1", Enclosure::exactly(ledger["Z*" + end]), Enclosure::exactly(1)));
}

/// k - s < V N^(k - 1 + c - log2(N)/2) for N >= N_2.
void state_rate(Ledger& ledger, const SchemeFamily& family, int degree, int start, const std::string& end) {
  const std::optional<Chain> chain = state_chain(ledger, family, degree, start, end);
  if (!chain) return;
  const int k = chain->k;
  const Ball pi = Ball::pi(proof_bits), L = chain->L();
  ledger.need(falls(*chain, k));
  const Ball zeta = ledger.state("zeta*" + end, Side::above, "V.8", "sum of 2^(k(l+1)) e_l X over l < J",
                                 "its bound for N >= N_2", head(*chain, k));
  ledger.need(less("V.9", "zeta*" + end + " < 1", Enclosure::exactly(ledger["zeta*" + end]), Enclosure::exactly(1)));
  if (!ledger.holds()) return;
  const Ball r = ledger.state("r*" + end, Side::above, "V.10", "k - s = O(N^(r* - log2(N)/2))", "k + log2(A*) - 3/2",
                              chain->slope() + (k - 1));
  const Ball defect = chain->alias * (pi * chain->symbol.most).pow(k) / chain->symbol.fewest.scaled(1) *
                      chain->product() / ((1 - zeta) * log(Ball(2, proof_bits)));
  ledger.state("R*" + end, Side::above, "V.11", "N^(log2(N)/2 - r*) (k - s)",
               "N_2^(log2(N_2)/2 - r*) F* (pi M_+)^k X/(2 M_- (1 - zeta*) ln 2)",
               defect * power_of_two(L * L / 2 - r * L));
}

// Theorem W.

SmoothnessRate rate_of(const std::string& n) { return smoothness_rate(std::stoi(n)); }

KeptByScheme<SmoothnessRate>& known_rates() {
  static KeptByScheme<SmoothnessRate> result(rate_of);
  return result;
}

/// The larger distance of a quotient of positive numbers from 1.
Ball distance_from_one(const Enclosure& above, const Enclosure& below) {
  if (!above.is_bounded() || !below.is_bounded()) return Ball::indeterminate(proof_bits);
  return abs(Ball::containing(above, proof_bits) / Ball::containing(below, proof_bits) - 1);
}

constexpr int tried[] = {24, 28, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 384, 448, 512, 600};

/// The first start for which the chain holds; it then holds for all later ones. Nothing if it never does.
template <class State>
std::optional<int> first_start(int degree, const State& state) {
  const auto holds = [&](int start) {
    if (start < 4 * degree) return false;
    Ledger ledger;
    state(ledger, start);
    return ledger.holds();
  };
  if (!holds(*std::rbegin(tried))) return std::nullopt;
  return *std::partition_point(std::begin(tried), std::prev(std::end(tried)), [&](int start) { return !holds(start); });
}

bool is_degree_one(const SchemeFamily& family, int degree) { return family.id == "primal" && degree == 1; }

SmoothnessRange find_range(const SchemeFamily& family, int degree) {
  SmoothnessRange range{alias_order(family.evaluation, degree) - 1, 2, first_of_tail, 2};
  if (is_degree_one(family, degree)) return range;
  const auto start = first_start(degree, [&](Ledger& ledger, int from) { state_class(ledger, family, degree, from); });
  range.is_found = start.has_value();
  range.start = start.value_or(*std::rbegin(tried));
  range.rate = first_start(degree, [&](Ledger& ledger, int from) { state_rate(ledger, family, degree, from, ""); });
  return range;
}

/// From where on the chain holds, with `first` the same: single schemes are not looked at.
const SmoothnessRange& range_of_chain(const SchemeFamily& family, int degree) {
  static Kept<std::pair<std::string, int>, SmoothnessRange> known;
  return known({family.id, degree}, [&] {
    SmoothnessRange range = find_range(family, degree);
    range.first = range.start;
    return range;
  });
}

}  // namespace

Rational exponent_bound(const std::string& scheme) {
  const std::optional<FrequencyBound>& bound = known_bounds()(scheme);
  return bound ? std::max(bound->exponent, Rational(0)) : Rational(0);
}

std::vector<SmoothnessRate> smoothness_rates(int threads) {
  std::vector<std::string> all;
  for (int n = 2; n <= last_rate; ++n) all.push_back(text(n));
  known_rates().prepare(all, threads);
  std::vector<SmoothnessRate> rates;
  for (const std::string& n : all) rates.push_back(known_rates()(n));
  return rates;
}

void smoothness_table(Ledger& ledger, const SchemeFamily& family, int, int threads) {
  known_bounds().prepare(family.schemes(2, last_rate, 1), threads);
  Ball width(proof_bits), distance(proof_bits), late(proof_bits);
  for (const SmoothnessRate& rate : smoothness_rates(threads)) {
    width = max(width, distance_from_one(rate.largest, rate.predicted));
    const Ball gap = distance_from_one(rate.product, rate.predicted);
    if (rate.n >= 5) distance = max(distance, gap);
    if (rate.n >= 20) late = max(late, gap);
  }
  const auto state = [&](const char* name, const char* id, const char* meaning, const char* formula,
                         const Ball& number) { ledger.state(name, Side::above, id, meaning, formula, number); };
  state("delta", "W.1", "beta_n/(mean over the orbit of the word) - 1", "the largest of the bounds over n", width);
  state("e_5", "W.2", "|ln|lambda|/mean - 1|, n >= 5", "the largest over n >= 5", distance);
  state("e_20", "W.3", "|ln|lambda|/mean - 1|, n >= 20", "the largest over n >= 20", late);
}

SmoothnessRange smoothness_range(const SchemeFamily& family, int degree) {
  static Kept<std::pair<std::string, int>, SmoothnessRange> known;
  return known({family.id, degree}, [&] {
    SmoothnessRange range = range_of_chain(family, degree);
    // Without a start there is no theorem, and single schemes need not be looked at.
    while (range.is_found && range.first > family.least_n(degree) &&
           exponent_bound(family.scheme(range.first - 1, degree)) > range.order)
      --range.first;
    return range;
  });
}

void smoothness(Ledger& ledger, const SchemeFamily& family, int degree, int threads) {
  if (is_degree_one(family, degree)) {
    degree_one_tail(ledger);
    if (!ledger.holds()) return;
    known_bounds().prepare(family.schemes(2, first_of_tail - 1, 1), threads);
    degree_one_single(ledger, family);
    return;
  }
  state_class(ledger, family, degree, range_of_chain(family, degree).start);
  if (!ledger.holds()) return;
  const SmoothnessRange range = smoothness_range(family, degree);
  known_bounds().prepare(family.schemes(range.first, range.start - 1, degree), threads);
  for (int n = range.first; n < range.start; ++n) {
    const std::string scheme = family.scheme(n, degree);
    ledger.need(less("V.12", text(range.order) + " < s" + at(n), Enclosure::exactly(range.order),
                     Enclosure::at_least(exponent_bound(scheme))));
    if (!ledger.holds()) return;  // a scheme without a bound
    ledger.need(less("V.13", "sum rules - 1 < " + text(range.order + 1) + at(n),
                     Enclosure::exactly(known_bounds()(scheme)->sum_rules - 1), Enclosure::exactly(range.order + 1)));
  }
  if (range.rate) state_rate(ledger, family, degree, *range.rate, "_" + text(degree) + "'");
}

}  // namespace subcert::theorems
