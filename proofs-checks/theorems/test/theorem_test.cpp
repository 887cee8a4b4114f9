#include "theorem_checks.hpp"

#include <subcert/analysis/regularity/holder_regularity.hpp>
#include <subcert/analysis/variance/variance.hpp>
#include <subcert/cmake/catch.hpp>
#include <subcert/cmake/error_kind.hpp>
#include <subcert/proofs-checks/theorems/ledger.hpp>
#include <subcert/proofs-checks/theorems/limit_constant.hpp>
#include <subcert/proofs-checks/theorems/proofs.hpp>
#include <subcert/proofs-checks/theorems/theorem.hpp>
#include <subcert/proofs-checks/theorems/variance_ends.hpp>
#include <subcert/schemes/specification.hpp>

#include <algorithm>
#include <cmath>

using namespace subcert;
using namespace subcert::theorems;

// One case, so that what several theorems compute is computed once.
TEST_CASE("every inequality holds, and fails if its constant moves by a part in a hundred in the wrong direction",
          "[long]") {
  for (const TheoremEntry& entry : theorem_list())
    for (int degree : entry.degrees)
      if (degree <= 5 || entry.id == "limit-constants" || entry.id == "conjecture-8-d-all" ||
          entry.id == "conjecture-8-d-large")
        check_theorem(entry.id, degree);
}

TEST_CASE("the theorems agree with exact values on a grid") {
  const Rational c = *limit_constant(1, 30).lower;
  VarianceGrid before;
  for (int n = 1; n <= 12; ++n) {
    const VarianceGrid grid = variance_grid(make_scheme("primal:n=" + std::to_string(n)).mask.curve(), 4, n > 1);
    const Rational bound = proved("conjecture-7", 1).constants[n == 1 ? "beta" : "beta_2"] / (n * n);
    for (std::size_t i = 0; i < grid.values.size(); ++i) {
      const Rational deviation = grid.values[i] * Rational(4 * n - 1, 4) / c - 1;
      CHECK(deviation < bound);
      CHECK(-deviation < bound);
      if (n > 1) CHECK(grid.values[i] < before.values[i]);
    }
    if (n > 1) CHECK(grid.steepest() * (n * n) < proved("conjecture-7", 1).constants["s"]);
    before = grid;
  }
}

TEST_CASE("exponents that are known otherwise lie within the bounds of the theorems on smoothness") {
  const Rational C = proved("smoothness", 1).constants["C"];
  for (int n = 2; n <= 9; ++n) {
    CAPTURE(n);
    const Enclosure s = holder_regularity(make_scheme("primal:n=" + std::to_string(n)).mask.curve(), 4, {}).exponent;
    const double N = 2 * n - 0.5, bound = C.convert_to<double>() * std::pow(N, 1 - std::log2(N) / 2);
    CHECK(*s.upper <= 2);
    CHECK((2 - *s.lower).convert_to<double>() < bound);
    CHECK(exponent_bound("primal:n=" + std::to_string(n)) <= *s.upper);
  }
  for (const char* scheme : {"dual:n=2", "dual:n=4", "dual-odd:n=1", "dual-odd:n=3", "primal:n=3,d=3"}) {
    CAPTURE(scheme);
    const Enclosure s = holder_regularity(make_scheme(scheme).mask.curve(), 4, {}).exponent;
    CHECK(exponent_bound(scheme) <= *s.upper);
    CHECK(*s.lower > 2);
  }
}

TEST_CASE("where nothing is proved the answer is unknown and says what is missing") {
  const Theorem theorem = proved("conjecture-7", 99);
  CHECK(theorem.decision.truth == Truth::unknown);
  CHECK_FALSE(theorem.missing.empty());
  for (const auto& [id, degree] : {std::pair{"conjecture-8-d-all", 13}, {"conjecture-8-d-large", 3}}) {
    CHECK(proved(id, degree).decision.truth == Truth::unknown);
    CHECK_FALSE(proved(id, degree).missing.empty());
  }
  for (const char* id : {"convergence", "conjecture-8-d-all", "conjecture-8-d-large", "limit-constants-order"}) {
    const Theorem other = prove(id, 5, {}, 1, "dual");
    CHECK(other.decision.truth == Truth::unknown);
    CHECK_FALSE(other.missing.empty());
  }
  CHECK_FAILS(proved("conjecture-9", 1), domain);
  CHECK_FAILS(proved("conjecture-7", 2), domain);
  CHECK_FAILS(proved("conjecture-7", 1).constants["nobody"], domain);
}

TEST_CASE("bounds that do not suffice refute nothing, and the answer says which inequality misses") {
  Ledger ledger;
  const Ball Y = ledger.state("Y", Side::above, "1", "", "two", exactly(Rational(2)));
  ledger.need(less("2", "Y < 1", Enclosure::exactly(ledger["Y"]), Enclosure::exactly(1)));
  CHECK_FALSE(ledger.holds());
  CHECK(verdict(ledger.checks()).truth == Truth::unknown);
  CHECK(Y.is_less(exactly(Rational(201, 100))));
}

TEST_CASE("a found constant is the number, rounded to its proved side, and depends on the constants as stated") {
  Ledger found;
  const Ball pi = Ball::pi(proof_bits);
  const Ball first = found.state("a", Side::above, "1", "", "pi", pi);
  found.state("b", Side::below, "2", "", "2 a", first.scaled(1), 3);
  CHECK(found["a"] == decimal("3.142"));
  CHECK(found["b"] == decimal("6.28"));
  const Constants broken = found.constants().broken("a");
  Ledger again(&broken);
  CHECK(again.state("a", Side::above, "1", "", "pi", pi).is_less(pi));
  CHECK_FALSE(again.holds());
}

TEST_CASE("a verdict is only as good as its weakest check") {
  const auto exact = [](int value) { return Enclosure::exactly(value); };
  const Check yes = less("1", "", exact(1), exact(2)), no = less("2", "", exact(2), exact(2)),
              unknown = less("3", "", {Rational(0), Rational(2)}, exact(1)),
              open = less("4", "", Enclosure::at_least(0), exact(1));
  CHECK(yes.decision.is_yes());
  CHECK(no.decision.is_no());
  CHECK(unknown.decision.truth == Truth::unknown);
  CHECK(open.decision.truth == Truth::unknown);
  CHECK(verdict({yes, yes}).is_yes());
  CHECK(verdict({yes, unknown, no}).is_no());
  CHECK(verdict({yes, unknown}).truth == Truth::unknown);
}

TEST_CASE("decimals") {
  CHECK(decimal("193.31") == Rational(19331, 100));
  CHECK(decimal("7") == 7);
  CHECK(decimal("7.25e-8") == Rational(725, 100) / power(Rational(10), 8));
  for (const char* wrong : {"", ".", "1/2", "1.2.3", "x", "1e", "e5"}) CHECK_FAILS(decimal(wrong), usage);
}

const Check& check_of(const Theorem& theorem, const std::string& id) {
  return *std::find_if(theorem.checks.begin(), theorem.checks.end(), [&](const Check& one) { return one.id == id; });
}

TEST_CASE("the slopes of the theorem are the bounds of single curves") {
  int n = 2;
  for (const Check& check : proved("conjecture-7", 1).checks)
    if (check.id == "6.1") {
      CAPTURE(n);
      CHECK(*check.left.lower == *variance_ends(n, 1).slope.upper * (n * n));
      ++n;
    }
  CHECK(n > 20);
}

TEST_CASE("the step of x_- is that of its formula") {
  // At n = (d^2 + 1)/2.
  const auto x = [](const Rational& d) -> Rational {
    return 16 * d * (d + 1) / (25 * (2 * d + 3)) * (1 - power((d + 1) / (d * d), 2));
  };
  CHECK(*check_of(proved("conjecture-8-d-large", 97), "T.15").right.lower == x(195) - x(193));
}

TEST_CASE("the bound beyond the turning point is that of its formula") {
  // The square of binom(8, 4) 9/2^8, and nu = 90.
  const double nu = 90, gamma = std::pow(9 * 70 / 256.0, 2), beta = 1.4, square = beta * beta - 1, e = std::exp(1.0);
  const double eta = (beta * beta + 1) / std::sqrt(nu * std::pow(square, 3));
  const double beyond = (beta / square / 2 + std::log((beta + 1) / (beta - 1)) / 4) / std::sqrt(nu) *
                        std::pow(std::sqrt(eta * eta + 1) + eta, 2);
  const double before = std::sqrt(gamma) * 2 * beta / 11 * std::pow(beta * e / 4, 10) /
                        (std::sqrt(2 * e) * (1 - std::pow(2.0, -10)));
  CHECK(check_of(proved("limit-constants-order", 1), "S.1").left.upper->convert_to<double>() ==
        Approx(gamma * beyond + before));
}

TEST_CASE("what holds for every degree can be asked for every degree") {
  CHECK(proved("convergence", 33).decision.is_yes());
  CHECK(proved("conjecture-8-d-large", 97).decision.is_yes());
  CHECK(proved("convergence", 101).decision.is_yes());
}

void check_dual_schemes(const char* family) {
  const Theorem theorem = proved("smoothness-dual", 1, family);
  CHECK(theorem.decision.is_yes());
  CHECK(theorem.statement.front().find("all limits are C^2") != std::string::npos);
}

TEST_CASE("all dual schemes of degree 1 are C^2, all primal ones C^1") {
  check_dual_schemes("dual");
  CHECK(proved("smoothness", 1).decision.is_yes());
}

TEST_CASE("all variants of dual schemes of degree 1 are C^2", "[long]") { check_dual_schemes("dual-odd"); }

TEST_CASE("a degree for which the bounds do not suffice: what fails is said", "[long]") {
  const Theorem open = proved("smoothness", 21);
  CHECK(open.decision.truth == Truth::unknown);
  CHECK_FALSE(open.missing.empty());
}
