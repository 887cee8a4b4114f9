#include "theorem_checks.hpp"

#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/theorems/every_smoothness.hpp>
#include <subcert/proofs-checks/theorems/proofs.hpp>

#include <random>
#include <tuple>

using namespace subcert;
using namespace subcert::theorems;

namespace {

/// |m(w)| and |m(pi - w)| up to their signs, from the exact mask.
struct Symbol {
  Ball value, alias;
};

Symbol symbol_of(const Mask& mask, bool dual, const Ball& w) {
  const LaurentPolynomial& symbol = mask.symbol();
  Symbol result{Ball(proof_bits), Ball(proof_bits)};
  for (long j = symbol.lowest(); j <= symbol.highest(); ++j) {
    const Ball weight = exactly(symbol.coefficient(j)).scaled(-1);
    const Ball angle = w * (2 * j - symbol.lowest() - symbol.highest()) / 2;
    const Ball term = weight * (dual ? sin(angle) : cos(angle));
    result.value += weight * cos(angle);
    result.alias += j % 2 == 0 ? term : -term;
  }
  return result;
}

/// The largest share of each bound that the exact symbol takes, over points of [0, pi/2].
struct Shares {
  double near = 0, far = 0, decay = 0;
};

double share(const Ball& value, const Ball& bound) {
  const Ball quotient = abs(value) / bound;
  CHECK(quotient.is_less(Ball(1, proof_bits)));
  return quotient.enclosure().upper->convert_to<double>();
}

Shares shares(const SchemeFamily& family, int n, int degree) {
  const Mask mask = make_scheme(family.scheme(n, degree)).mask.curve();
  const bool dual = family.evaluation == Evaluation::dual;
  const EveryRule rule{family.evaluation, degree, Ball(2 * n + (family.odd ? 1 : 0) - (dual ? 0 : 1), proof_bits)};
  const Ball unit = rule.gamma() / rule.M, known = rule.root() * 9 / 5, slack = 3 / rule.M + 1;
  std::mt19937 generator(7);
  Shares result;
  for (int i = 0; i < 60; ++i) {
    const int bits = static_cast<int>(generator() % 11);
    const Ball w = exactly(Rational(static_cast<int>(generator() % 1000) + 1, 638)).scaled(-bits);
    const Symbol at = symbol_of(mask, dual, w);
    const Ball u = rule.M * sin(w), scaled = rule.M * w;
    if (scaled.is_less(rule.root().scaled(2)))
      result.near = std::max(result.near, share(at.alias, rule.near() * unit * scaled.pow(rule.order()) /
                                                              exactly(odd_factorial(rule.order()))));
    if (!known.is_less(u)) continue;
    result.far = std::max(result.far, share(at.alias, slack * rule.far() * unit));
    result.decay = std::max(result.decay, share(at.value, slack * (rule.gamma() * rule.amplitude(0) / u +
                                                                   unit * exactly(rule.constant()))));
  }
  return result;
}

}  // namespace

TEST_CASE("the symbols of single schemes lie below the bounds that hold for every degree") {
  for (const auto& [family, degree, n, near] : {std::tuple{"primal", 3, 170, 0.6},
                                                {"primal-odd", 3, 170, 0.6},
                                                {"primal", 5, 510, 0.6},
                                                {"dual", 3, 170, 0.2},
                                                {"dual-odd", 3, 170, 0.2},
                                                {"dual", 2, 170, 0.09},
                                                {"dual-odd", 2, 170, 0.09},
                                                {"dual", 4, 510, 0.09}}) {
    CAPTURE(family, n, degree);
    const Shares one = shares(scheme_family(family), n, degree);
    CHECK(one.near > near);
    CHECK(one.far > 0.03);
    CHECK(one.decay > 0.2);
  }
}

TEST_CASE("what the bounds for every degree add for small n tends to nothing") {
  for (int degree : {3, 4, 5}) {
    const EveryRule dual{Evaluation::dual, degree, Ball(1 << 20, proof_bits)};
    CHECK(dual.excess().is_less(exactly(Rational(1, 1000))));
    CHECK(dual.near().is_less(exactly(Rational(degree % 2 == 0 ? 5001 : 2001, 1000))));
  }
  const EveryRule primal{Evaluation::primal, 101, Ball(1 << 30, proof_bits)};
  CHECK(primal.near().is_less(exactly(Rational(502, 1000))));
  CHECK(primal.excess().is_at_most(Ball(proof_bits)));
}

TEST_CASE("smoothness for every degree: every inequality holds, and fails if its constant moves") {
  for (int degree : {5, 7, 31}) check_theorem("smoothness-all", degree);
  check_theorem("smoothness-all", 5, "primal-odd");
  for (int degree : {3, 4, 31}) check_theorem("smoothness-all", degree, "dual");
  check_theorem("smoothness-all", 6, "dual-odd");
  for (int degree : {101, largest_degree}) CHECK(proved("smoothness-all", degree).decision.is_yes());
  for (int degree : {199, 200}) {
    const Constants stated = proved("smoothness-all", degree, "dual").constants;
    CHECK(prove("smoothness-all", degree, stated, 1, "dual").decision.is_yes());
  }
}

TEST_CASE("smoothness for every degree: what is said for one degree, and where nothing is") {
  CHECK(proved("smoothness-all", 5).statement.at(2).find("C^5 for all n >= 0.949 4^5") != std::string::npos);
  Rational before = 1;
  for (int degree : {5, 7, 9, 13, 21, 51}) {
    const Rational start = every_smoothness_start(scheme_family("primal"), degree);
    CHECK(start < before);
    before = start;
  }
  for (const auto& [degree, family] : {std::pair{1, "primal"}, {3, "primal"}, {2, "dual"}, {201, "dual-odd"}}) {
    const Theorem theorem = prove("smoothness-all", degree, {}, 1, family);
    CHECK(theorem.decision.truth == Truth::unknown);
    CHECK_FALSE(theorem.missing.empty());
  }
}
