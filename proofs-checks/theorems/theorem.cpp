#include "theorem.hpp"

#include "describe.hpp"
#include "kept_by_scheme.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <stdexcept>
#include <tuple>

namespace subcert::theorems {
namespace {

constexpr int most_degree = 21;  ///< to which section 7 is tried

/// The constants of a proof, and its inequalities with them.
struct Inequalities {
  Constants constants;
  std::vector<Check> checks;
};

/// One id and how each of its degrees is proved.
struct Proof {
  int degree;
  std::function<Inequalities(const Constants* given, int threads)> run;  ///< null: with the constants that it finds
  std::function<void(Theorem&)> describe;
};

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
               [=, &family](const Constants* given, int threads) {
                 Ledger ledger(given);
                 try {
                   run(ledger, family, degree, threads);
                 } catch (OutOfTime& late) {  // the inequalities so far are not lost
                   late.checks = ledger.checks();
                   throw;
                 }
                 return Inequalities{given ? *given : ledger.constants(), ledger.checks()};
               },
               [=, &family](Theorem& t) { describe(t, family); }};
}

/// A proof whose constants are known before its inequalities.
Proof by_constants(int degree, const std::function<Constants()>& constants,
                   const std::function<std::vector<Check>(const Constants&, int threads)>& checks,
                   void (*describe)(Theorem&)) {
  return {degree,
          [=](const Constants* given, int threads) {
            const Constants known = given ? *given : constants();
            return Inequalities{known, checks(known, threads)};
          },
          describe};
}

/// One whose functions take the degree.
Proof by_degree(int degree, Constants (*constants)(int), std::vector<Check> (*checks)(const Constants&, int, int),
                void (*describe)(Theorem&)) {
  return by_constants(
      degree, [=] { return constants(degree); },
      [=](const Constants& known, int threads) { return checks(known, degree, threads); }, describe);
}

Constants no_constants() { return {}; }

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
         {by_constants(1, degree_one_constants_7, degree_one_checks_7, describe_7_degree_one)},
         higher,
         false,
         [](int degree, const SchemeFamily& family) { return found(degree, family, uniform_7, describe_7); }});
    all.push_back(
        {{"conjecture-8-n", "psi_{n+1} < psi_n everywhere", every, degrees},
         {by_constants(1, degree_one_constants_8, degree_one_checks_8, describe_8_degree_one)},
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
                     return by_constants(
                         degree, no_constants,
                         [=](const Constants& known, int threads) { return every_n_checks(known, degree, threads); },
                         describe_every_n);
                   }});
    all.push_back(
        {{"limit-constants", "the limits C_d of n max psi_n, printed together", "n to infinity", {1, 3, 5, 7, 9}},
         {by_constants(1, limit_constants_stated, limit_constants_checks, describe_limit_constants)},
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
                    {1},
                    "dual"},
                   {},
                   {"for degrees other than 1 see smoothness --family dual, and smoothness-all"},
                   false,
                   [](int degree, const SchemeFamily& family) -> std::optional<Proof> {
                     if (degree != 1) return std::nullopt;
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
                     return by_constants(degree, no_constants, limits_grow_checks, describe_limits_grow);
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

namespace {

/// `given`: the constants, or null for those that the proof finds.
Theorem theorem_of(const std::string& id, int degree, const Constants* given, const std::string& family_id,
                   int threads) {
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
  Inequalities run = proof->run(given, threads);
  theorem.constants = std::move(run.constants);
  theorem.checks = std::move(run.checks);
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

}  // namespace

Theorem prove(const std::string& id, int degree, const Constants& constants, int threads, const std::string& family) {
  return theorem_of(id, degree, &constants, family, threads);
}

const Theorem& proved(const std::string& id, int degree, const std::string& family, int threads) {
  static Kept<std::tuple<std::string, int, std::string>, Theorem> known;
  return known({id, degree, family}, [&] { return theorem_of(id, degree, nullptr, family, threads); });
}

Theorem prove_in_time(const std::string& id, int degree, const std::string& family, int threads,
                      const Patience& patience) {
  const PatienceScope scope(&patience);
  try {
    return proved(id, degree, family, threads);
  } catch (OutOfTime& late) {
    Theorem theorem;
    theorem.id = id;
    theorem.degrees = {degree};
    theorem.title = find(id).entry.title;
    theorem.checks = std::move(late.checks);
    theorem.missing = {"time, before the step " + late.step};
    theorem.out_of_time = true;
    theorem.decision = {Truth::unknown, fmt::format("the budget ran out after {} inequalities", theorem.checks.size())};
    return theorem;
  }
}

}  // namespace subcert::theorems
