#include "theorem.hpp"

#include "proofs.hpp"

#include <functional>
#include <stdexcept>

namespace subcert::theorems {
namespace {

/// One id and how each of its degrees is proved.
struct Proof {
  int degree;
  std::function<Constants()> constants;
  std::function<std::vector<Check>(const Constants&)> checks;
  std::function<void(Theorem&)> describe;
};

std::string plain(const Rational& value) { return to_decimal(value, 40, Rounding::nearest); }

void describe_7_degree_one(Theorem& t) {
  const auto number = [&](const char* name) { return plain(t.constants[name]); };
  t.title = "Conjecture 7 for degree 1 and every n";
  t.text = "docs/theorems/degree-one.tex, Theorems B and C";
  t.statement = {
      "First half. For all n >= 1 and all x, |(n - 1/4) psi_n(x)/c - 1| < " + number("beta") + "/n^2; for n >= 2 even < " +
          number("beta_2") + "/n^2. Here c = lim n max psi_n, " + number("c-") + " < c < " + number("c+") + ".",
      "So max psi_n = c/n (1 + 1/(4n) + O(1/n^2)): the rate 1/n is true, with its constant.",
      "Second half. For n >= 2, psi_n is C^1 and n^2 |psi_n'(x)| < " + number("s") + " for all x; for n >= 64, |psi_n'(x)| < " +
          number("Delta") + "/(2n - 1/2)^6.",
      "So max |psi_n'| = O(1/n^2) is true as a bound, and n^2 max |psi_n'| tends to 0: as a rate it is false."};
  t.ranges = {{"1 <= n < 24", "psi_n and psi_n' enclosed over all of [0, 1], from exact values"},
              {"24 <= n < 64", "mean with its proved remainder, ripple and slope of each n by the supersolution"},
              {"n >= 64", "the constants below, for all n at once"}};
}

void describe_8_degree_one(Theorem& t) {
  t.title = "Conjecture 8 in n for degree 1 and every n";
  t.text = "docs/theorems/degree-one.tex, Theorem A";
  t.statement = {"psi_{n+1}(x) < psi_n(x) for all n >= 1 and all x; even max psi_{n+1} < min psi_n."};
  t.ranges = {{"1 <= n < 24", "psi_n enclosed over all of [0, 1], from exact values"},
              {"24 <= n < 64", "mean with its proved remainder, ripple of each n by the supersolution"},
              {"n >= 64", "the constants below, for all n at once"}};
}

void describe_limit_constants(Theorem& t) {
  t.title = "The limits of n max psi_n";
  t.degrees = {1, 3, 5, 7, 9};
  t.text = "docs/limit-constants.md, theorems 5, 7 and 10";
  t.statement = {
      "For each odd d, n max psi_n^d tends to C_d, and so do n min psi_n^d and n times the mean of psi_n^d.",
      "For d = 1, with c = C_1 and N = 2n - 1/2, the mean is I_n = 2c/N (1 + nu/N^2 + O(1/N^4)), nu = 13/36: the next term is "
      "(13/18) c/N^3, an exact rational multiple of c."};
  for (const Constant& constant : t.constants.all())
    if (constant.name.starts_with("C_") && constant.side == Side::below)
      t.values.emplace_back(constant.name.substr(0, constant.name.size() - 1), to_fixed(constant.value, 32, Rounding::down) + "...");
  t.values.emplace_back("nu", to_text(t.constants["nu-"]));
}

struct Entry {
  TheoremEntry entry;
  std::vector<Proof> proofs;
  std::vector<std::string> missing;  ///< for the degrees without proof
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> list = [] {
    std::vector<Entry> all;
    all.push_back({{"conjecture-7", "max psi_n ~ 1/n and max |psi_n'| ~ 1/n^2", {}},
                   {{1, degree_one_constants_7, degree_one_checks_7, describe_7_degree_one}},
                   {"explicit bounds of the symbol for all large n", "bounds of the remainder of the mean"}});
    all.push_back({{"conjecture-8-n", "psi_{n+1} < psi_n everywhere", {}},
                   {{1, degree_one_constants_8, degree_one_checks_8, describe_8_degree_one}},
                   {"explicit bounds of the symbol for all large n", "bounds of the remainder of the mean"}});
    all.push_back({{"conjecture-8-d", "psi of degree d < psi of degree d + 2 everywhere", {}},
                   {},
                   {"explicit bounds of the symbol for all large n in both degrees"}});
    all.push_back({{"limit-constants", "the limits C_d of n max psi_n, d = 1, 3, 5, 7, 9", {}},
                   {{1, limit_constants_stated, limit_constants_checks, describe_limit_constants}},
                   {}});
    for (Entry& entry : all)
      for (const Proof& proof : entry.proofs) entry.entry.degrees.push_back(proof.degree);
    return all;
  }();
  return list;
}

const Entry& find(const std::string& id) {
  for (const Entry& entry : entries())
    if (entry.entry.id == id) return entry;
  throw std::out_of_range("unknown theorem '" + id + "'");
}

const Proof* find(const Entry& entry, int degree) {
  for (const Proof& proof : entry.proofs)
    if (proof.degree == degree) return &proof;
  return nullptr;
}

}  // namespace

Check defining(const Constants& constants, const std::string& name, const std::string& formula, const Real& number) {
  for (const Constant& constant : constants.all()) {
    if (constant.name != name) continue;
    const Enclosure stated = Enclosure::exactly(constant.value);
    return constant.side == Side::above ? less(constant.check, formula + " < " + name, number.enclosure(), stated)
                                        : less(constant.check, name + " < " + formula, stated, number.enclosure());
  }
  throw std::out_of_range("no constant is called '" + name + "'");
}

const std::vector<TheoremEntry>& theorem_list() {
  static const std::vector<TheoremEntry> list = [] {
    std::vector<TheoremEntry> result;
    for (const Entry& entry : entries()) result.push_back(entry.entry);
    return result;
  }();
  return list;
}

Constants stated_constants(const std::string& id, int degree) {
  const Proof* proof = find(find(id), degree);
  return proof ? proof->constants() : Constants();
}

Theorem prove(const std::string& id, int degree, const Constants& constants) {
  const Entry& entry = find(id);
  if (degree < 1 || degree > 99 || degree % 2 == 0)
    throw std::invalid_argument("prove: need an odd degree from 1 to 99, got " + std::to_string(degree));
  Theorem theorem;
  theorem.id = id;
  theorem.degrees = {degree};
  theorem.title = entry.entry.title;
  const Proof* proof = find(entry, degree);
  if (!proof) {
    theorem.missing = entry.missing;
    theorem.decision = {Truth::unknown, "nothing is proved for degree " + std::to_string(degree)};
    return theorem;
  }
  theorem.constants = constants;
  theorem.checks = proof->checks(constants);
  proof->describe(theorem);
  theorem.decision = verdict(theorem.checks);
  return theorem;
}

Theorem prove(const std::string& id, int degree) { return prove(id, degree, stated_constants(id, degree)); }

}  // namespace subcert::theorems
