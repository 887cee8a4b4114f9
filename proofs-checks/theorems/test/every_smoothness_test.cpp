#include "theorem_checks.hpp"

#include <subcert/cmake/catch.hpp>
#include <subcert/proofs-checks/theorems/every_smoothness.hpp>
#include <subcert/proofs-checks/theorems/proofs.hpp>

#include <random>

using namespace subcert;
using namespace subcert::theorems;

namespace {

/// Half the sum of the coefficients at the indices of one parity times cos(j w), twice: the response of one rule.
Ball response(const Mask& mask, int parity, const Ball& w) {
  const LaurentPolynomial& symbol = mask.symbol();
  Ball sum(proof_bits);
  for (long j = symbol.lowest(); j <= symbol.highest(); ++j)
    if ((j - parity) % 2 == 0) sum += exactly(symbol.coefficient(j)) * cos(w * j);
  return sum;
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

Shares shares(const std::string& family, int n, int degree) {
  const Mask mask = make_scheme(scheme_family(family).scheme(n, degree)).mask.curve();
  const int points = family == "primal" ? 2 * n - 1 : 2 * n;
  const EveryRule rule{degree, Ball(points, proof_bits)};
  const Ball slack = 1 / rule.M * 3 + 1, known = rule.root() * exactly(chosen::known);
  std::mt19937 generator(7);
  Shares result;
  for (int i = 0; i < 200; ++i) {
    const int bits = static_cast<int>(generator() % 9);
    const Ball w = exactly(Rational(static_cast<int>(generator() % 1000) + 1, 638)).scaled(-bits);
    const Ball even = response(mask, 0, w), odd = response(mask, 1, w), alias = (even - odd).scaled(-1);
    const Ball u = rule.M * sin(w);
    if ((rule.M * w).is_less(rule.root().scaled(2)))
      result.near = std::max(result.near,
                             share(alias, rule.near() * rule.gamma() / rule.M.scaled(1) * (rule.M * w).pow(degree + 1) /
                                              exactly(double_factorial(degree))));
    if (!known.is_less(u)) continue;
    result.far = std::max(result.far, share(alias, slack * rule.far() * rule.gamma() / rule.M));
    const Ball bound = slack * rule.gamma() * (rule.amplitude(0) / u + 1 / rule.M);
    for (const Ball& one : {even, odd}) result.decay = std::max(result.decay, share(one, bound));
  }
  return result;
}

}  // namespace

TEST_CASE("the symbols of single schemes lie below the bounds that hold for every degree") {
  for (const char* family : {"primal", "primal-odd"})
    for (const auto& [n, degree] : {std::pair{60, 3}, {120, 5}, {200, 7}}) {
      CAPTURE(family, n, degree);
      const Shares one = shares(family, n, degree);
      CHECK(one.near > 0.6);
      CHECK(one.far > 0.1);
      CHECK(one.decay > 0.3);
    }
}

TEST_CASE("smoothness for every degree: every inequality holds, and fails if its constant moves") {
  for (int degree : {5, 7, 31}) check_theorem("smoothness-all", degree);
  check_theorem("smoothness-all", 5, "primal-odd");
  for (int degree : {101, largest_degree}) CHECK(prove("smoothness-all", degree).decision.is_yes());
}

TEST_CASE("smoothness for every degree: what is said for one degree, and where nothing is") {
  CHECK(prove("smoothness-all", 5).statement.at(1).find("C^5 for all n >= 0.954 4^5") != std::string::npos);
  Rational before = 1;
  for (int degree : {5, 7, 9, 13, 21, 51}) {
    const Rational start = every_smoothness_start(degree);
    CHECK(start < before);
    before = start;
  }
  for (const auto& [degree, family] : {std::pair{1, "primal"}, {3, "primal"}, {5, "dual"}, {6, "dual-odd"}}) {
    const Theorem theorem = prove("smoothness-all", degree, {}, 1, family);
    CHECK(theorem.decision.truth == Truth::unknown);
    CHECK_FALSE(theorem.missing.empty());
  }
}
