// Masks of matrices: function vectors.

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/regularity/component_support.hpp>
#include <subcert/analysis/regularity/multivariate_regularity.hpp>
#include <subcert/analysis/regularity/regularity.hpp>
#include <subcert/analysis/regularity/scheme_convergence.hpp>
#include <subcert/analysis/regularity/value_space.hpp>
#include <subcert/analysis/transition/lattice_window.hpp>

#include <catch2/catch.hpp>

namespace subcert {
namespace {

using Matrix = std::vector<std::vector<Rational>>;

/// Of one variable, A_first, A_{first + 1}, ...
LatticeMask of_matrices(const std::vector<Matrix>& matrices, long first, int arity = 2) {
  const std::size_t size = matrices.front().size();
  std::vector<MultivariatePolynomial> entries;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      std::vector<Monomial> terms;
      for (std::size_t k = 0; k < matrices.size(); ++k)
        terms.push_back({matrices[k][i][j], {first + static_cast<long>(k)}});
      entries.emplace_back(1, terms);
    }
  return {std::move(entries), Dilation::multiple(1, arity)};
}

Rational q(long p, long d = 1) { return {p, d}; }

/// Merrien's scheme on values and slopes of two points.
LatticeMask merrien(const Rational& lambda, const Rational& mu) {
  return of_matrices({{{q(1, 2), (1 - mu) / 2}, {lambda, mu / 4}},
                      {{1, 0}, {0, q(1, 2)}},
                      {{q(1, 2), -(1 - mu) / 2}, {-lambda, mu / 4}}},
                     -1);
}

/// Of a mask of numbers: phi(x), phi(x - 1) beside each other, whose matrices are diagonal with shifts between.
LatticeMask beside_its_shift(const LaurentPolynomial& symbol) {
  // phi_2(x) = phi(x - 1): phi_2(x) = sum a_k phi(2x - 2 - k) = sum a_k phi_2(2x - 1 - k).
  const MultivariatePolynomial a = MultivariatePolynomial::in_variable(1, 0, symbol), zero(1);
  return {{a, zero, zero, a.shifted({1})}, Dilation::multiple(1, 2)};
}

bool is_exactly(const Enclosure& exponent, const Rational& value) {
  return exponent.lower == value && exponent.upper == value;
}

const Budget budget{Deadline::in(20)};

TEST_CASE("Sequences of vectors are sums over components") {
  const LatticeMask mask = of_matrices({{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}}, 0);
  CHECK(mask.components() == 2);
  CHECK(mask.terms().size() == 8);
  CHECK_THROWS(mask.symbol());
  const auto moved = transitions(mask, {{{0, 1}, 1}});  // the second unit vector at 0
  CHECK(moved[0] == LatticeSequence{{{0, 0}, 2}, {{0, 1}, 4}});
  CHECK(moved[1] == LatticeSequence{{{0, 0}, 6}, {{0, 1}, 8}});
  CHECK_THROWS(
      LatticeMask(std::vector{MultivariatePolynomial(1, 1), MultivariatePolynomial(1, 1)}, Dilation::multiple(1, 2)));
}

TEST_CASE("Hermite cubics have the exponent 2, with both components") {
  const MultivariateRegularity found = vector_regularity(merrien(q(-1, 8), q(-1, 2)), budget);
  REQUIRE(found.vector);
  CHECK(found.vector->solutions == 1);
  CHECK(found.vector->continuous.is_yes());
  CHECK(found.exact.is_yes());
  CHECK(is_exactly(found.exponent, 2));
  REQUIRE(found.vector->components.size() == 2);
  for (const ComponentRegularity& one : found.vector->components) CHECK(is_exactly(one.exponent, 2));
  REQUIRE(found.sobolev);
  CHECK(*found.sobolev->lower <= q(5, 2));
  CHECK(*found.sobolev->upper >= q(5, 2));
  CHECK(*found.sobolev->upper - *found.sobolev->lower < power(Rational(10), -12));
}

TEST_CASE("A spline beside its own shift, which are dependent, has the exponent of the spline") {
  const LaurentPolynomial cubic = LaurentPolynomial::parse_mask("[1,4,6,4,1]/8@0");
  const MultivariateRegularity found = vector_regularity(beside_its_shift(cubic), budget);
  REQUIRE(found.vector);
  CHECK(found.vector->solutions == 2);  // multiples of each
  CHECK(is_exactly(found.exponent, 3));
}

TEST_CASE("Each component has its own exponent") {
  // The hat function on [0, 2] and a function on [0, 1] with one half of itself on each half: psi(x) = hat(2x) +
  // (psi(2x) + psi(2x - 1)) / 2 + ... is Takagi's function, of exponent 1 with a logarithm.
  const LatticeMask mask = of_matrices({{{q(1, 2), 0}, {1, q(3, 4)}}, {{1, 0}, {0, q(3, 4)}}, {{q(1, 2), 0}, {0, 0}}},
                                       0);
  const MultivariateRegularity found = vector_regularity(mask, budget);
  REQUIRE(found.vector);
  CHECK(found.vector->continuous.is_yes());
  REQUIRE(found.vector->components.size() == 2);
  CHECK(is_exactly(found.vector->components[0].exponent, 1));
  // psi = sum of (3/4)^n hat(2^(n+1) x), folded: log2(4/3).
  const Enclosure& rough = found.vector->components[1].exponent;
  REQUIRE(rough.is_bounded());
  CHECK(*rough.lower > q(4150374, 10'000'000));
  CHECK(*rough.upper < q(4150375, 10'000'000));
  CHECK(found.exponent.lower == rough.lower);
  const MultivariateRegularity first = vector_regularity(mask, budget, {.component = 0});
  CHECK(is_exactly(first.exponent, 1));
  CHECK(first.vector->components.size() == 1);
  CHECK_THROWS(vector_regularity(mask, budget, {.component = 2}));
}

TEST_CASE("What has no continuous solution") {
  const LatticeMask boxes = of_matrices({{{1, 0}, {0, 1}}, {{1, 0}, {0, 1}}}, 0);
  const MultivariateRegularity none = vector_regularity(boxes, budget);
  CHECK(none.vector->solutions == 0);
  CHECK(none.vector->continuous.is_no());
  CHECK_FALSE(none.exponent.lower);
  // Values at the integers, and differences that do not shrink.
  const LatticeMask rough = of_matrices({{{q(1, 2), 0}, {1, q(3, 2)}}, {{1, 0}, {0, q(3, 2)}}, {{q(1, 2), 0}, {0, 0}}},
                                        0);
  const MultivariateRegularity found = vector_regularity(rough, budget);
  CHECK(found.vector->solutions == 1);
  CHECK(found.vector->continuous.is_no());
}

/// Beside each other, without a link.
LatticeMask beside(const LatticeMask& a, const LatticeMask& b) {
  std::vector<LatticeMask::Term> terms = a.terms();
  for (LatticeMask::Term term : b.terms()) {
    term.row += a.components();
    term.column += a.components();
    terms.push_back(term);
  }
  return matrix_mask(terms, a.components() + b.components(), a.dilation());
}

/// S A_k S^-1.
LatticeMask in_basis(const LatticeMask& mask, const Matrix& s, const Matrix& inverse) {
  std::vector<LatticeMask::Term> terms;
  for (const LatticeMask::Term& term : mask.terms())
    for (std::size_t i = 0; i < s.size(); ++i)
      for (std::size_t j = 0; j < s.size(); ++j)
        terms.push_back({term.exponents, i, j, s[i][term.row] * term.coefficient * inverse[term.column][j]});
  return matrix_mask(terms, s.size(), mask.dilation());
}

/// B-splines of degree 1 on [-1, 1] and of degree 2 on [-1, 2].
LatticeMask hat_beside_spline() {
  const auto numbers = [](const char* text) {
    const LaurentPolynomial symbol = LaurentPolynomial::parse_mask(text);
    return LatticeMask({MultivariatePolynomial::in_variable(1, 0, symbol)}, Dilation::multiple(1, 2));
  };
  return beside(numbers("[1,2,1]/2@-1"), numbers("[1,3,3,1]/4@-1"));
}

TEST_CASE("Of several solutions the integral chooses one") {
  const LatticeMask both = hat_beside_spline();
  using Numbers = std::vector<Rational>;
  const auto with = [&](Numbers integral) {
    return vector_regularity(both, budget, {.integral = std::move(integral)});
  };
  const MultivariateRegularity all = vector_regularity(both, budget);
  CHECK(all.vector->solutions == 2);
  CHECK(all.vector->integrals == std::vector<Numbers>{{1, 0}, {0, 1}});
  CHECK_FALSE(all.vector->values);
  const MultivariateRegularity spline = with({0, 3});
  CHECK(spline.vector->solutions == 1);
  CHECK(is_exactly(spline.exponent, 2));
  CHECK(spline.vector->components[0].is_zero);
  CHECK(spline.vector->values == LatticeSequence{{{0, 1}, q(3, 2)}, {{1, 1}, q(3, 2)}});
  const MultivariateRegularity mixed = with({-1, 2});
  CHECK(is_exactly(mixed.exponent, 1));
  CHECK(is_exactly(mixed.vector->components[1].exponent, 2));
  CHECK(mixed.vector->values == LatticeSequence{{{0, 0}, -1}, {{0, 1}, 1}, {{1, 1}, 1}});
  CHECK_THROWS(with({0, 0}));
  CHECK_THROWS(with({1}));
  // none; a combination that no solution has
  const MultivariateRegularity none = vector_regularity(merrien(q(-1, 8), q(-1, 2)), budget,
                                                        {.integral = Numbers{1, 1}});
  CHECK(none.vector->solutions == 0);
  CHECK(none.vector->continuous.is_no());
  // In a basis of the two in which all entries of B are other ones, the integral goes with it.
  const LatticeMask mixed_basis = in_basis(both, {{1, 2}, {1, 3}}, {{3, -2}, {-1, 1}});
  const Numbers integral{2, 3};  // of the spline
  CHECK(is_exactly(vector_regularity(mixed_basis, budget, {.integral = integral}).exponent, 2));
}

TEST_CASE("What the integral does not choose is said to be open") {
  // Hats of lattice points three apart have two fixed sequences of integral 1.
  const LaurentPolynomial apart = LaurentPolynomial::parse_mask("[1,0,0,2,0,0,1]/2@-3");
  const LatticeMask mask = beside(
      LatticeMask({MultivariatePolynomial::in_variable(1, 0, apart)}, Dilation::multiple(1, 2)),
      merrien(q(-1, 8), q(-1, 2)));
  const MultivariateRegularity found = vector_regularity(mask, budget, {.integral = std::vector<Rational>{1, 0, 0}});
  CHECK(found.vector->solutions == 2);
  CHECK(vector_regularity(mask, budget, {.integral = std::vector<Rational>{0, 1, 0}}).vector->solutions == 2);
}

TEST_CASE("Integrals are limits of Riemann sums") {
  // The parabola 4 x (1 - x) on [0, 1], which is 0 at the integers, beside a hat; Merrien's scheme; three with letters.
  const LatticeMask bubble = of_matrices({{{q(1, 2), 0}, {0, 0}}, {{1, 0}, {0, q(1, 4)}}, {{q(1, 2), 0}, {1, q(1, 4)}}},
                                         -1);
  const auto integral = [](const LatticeMask& mask) {
    return integral_of_solution(mask, solutions_at_lattice_points(mask).front());
  };
  CHECK(integral(bubble) == std::vector<Rational>{1, q(2, 3)});
  for (const LatticeMask& mask : {bubble, merrien(q(-1, 8), q(1, 2)), merrien(q(-1, 7), q(1, 3))}) {
    const LatticeSequence start = solutions_at_lattice_points(mask).front();
    constexpr int level = 12;
    std::vector<Rational> sums(2, 0);
    for (const auto& [point, value] : limit_values(mask, start, level))
      sums[static_cast<std::size_t>(point.back())] += value * power(q(2), -level);
    const std::vector<Rational> exact = integral_of_solution(mask, start);
    for (std::size_t c = 0; c < 2; ++c) CHECK(abs(sums[c] - exact[c]) < q(1, 1000));
  }
}

TEST_CASE("Supports of functions are exact") {
  const auto supports = [](const LatticeMask& mask, const std::optional<std::vector<Rational>>& integral = {}) {
    return component_supports(mask, *vector_regularity(mask, budget, {.integral = integral}).vector->values);
  };
  using Supports = std::vector<std::optional<Interval>>;
  CHECK(supports(merrien(q(-1, 8), q(1, 2))) == Supports{Interval{-1, 1}, Interval{-1, 1}});
  // a hat and a bubble on one side of it
  const LatticeMask bubble = of_matrices({{{q(1, 2), 0}, {0, 0}}, {{1, 0}, {0, q(1, 4)}}, {{q(1, 2), 0}, {1, q(1, 4)}}},
                                         -1);
  CHECK(supports(bubble) == Supports{Interval{-1, 1}, Interval{0, 1}});
  // one of two functions; a third is 0
  CHECK(supports(hat_beside_spline(), std::vector<Rational>{0, 1}) == Supports{std::nullopt, Interval{-1, 2}});
  // ends that are no integers: phi_2 = the hat of 3x - 1, by three parts
  const LatticeMask thirds = of_matrices({{{q(1, 3), 0}, {0, 0}},
                                          {{q(2, 3), 0}, {0, 0}},
                                          {{1, 0}, {1, 0}},
                                          {{q(2, 3), 0}, {0, 0}},
                                          {{q(1, 3), 0}, {0, 0}}},
                                         -2, 3);
  CHECK(supports(thirds) == Supports{Interval{-1, 1}, Interval{q(-1, 3), q(1, 3)}});
}

TEST_CASE("Values at the ends of their own support do not count") {
  // a hat on [-1, 1] beside the characteristic function of [0, 1], with and without a link between them
  for (const Rational& link : {q(0), q(1, 3)}) {
    const LatticeMask mask = of_matrices({{{q(1, 2), 0}, {0, 0}}, {{1, link}, {0, 1}}, {{q(1, 2), 0}, {0, 1}}}, -1);
    const MultivariateRegularity found = vector_regularity(mask, budget);
    CHECK(found.vector->solutions == 1);
    CHECK(is_exactly(found.exponent, 1));
    CHECK(found.vector->components[1].is_zero);
  }
  // a component without any link to itself is 0, and one that is a part of another has its support
  const LatticeMask dead = of_matrices({{{q(1, 2), 1}, {0, 0}}, {{1, 0}, {0, 0}}, {{q(1, 2), 0}, {0, 0}}}, -1);
  CHECK(vector_regularity(dead, budget).vector->solutions == 1);
  // arity 3, and a support of different ends for each: boxes are found by the links
  const LatticeMask thirds = of_matrices({{{q(1, 3), 0}, {0, 0}},
                                          {{q(2, 3), 0}, {0, 0}},
                                          {{1, 0}, {1, 0}},
                                          {{q(2, 3), 0}, {0, 0}},
                                          {{q(1, 3), 0}, {0, 0}}},
                                         -2, 3);
  CHECK(vector_regularity(thirds, budget).vector->solutions == 1);
}

TEST_CASE("Components that attain the radius of the whole are as exact as the whole") {
  // Quadratic splines with a knot at the midpoint: of the second function alone a smaller space tells.
  const MultivariateRegularity found = vector_regularity(merrien(q(-1, 8), q(-1)), budget);
  REQUIRE(found.vector->components.size() == 2);
  for (const ComponentRegularity& one : found.vector->components) {
    CHECK(is_exactly(one.exponent, 2));
    CHECK(one.exact.is_yes());
  }
}

TEST_CASE("Merrien's scheme is HC^1 for -3 < mu < 1 and lambda = -1/8") {
  const auto truth = [](const Rational& mu) { return hermite_scheme_converges(merrien(q(-1, 8), mu), budget).truth; };
  for (const Rational& mu : {q(-299, 100), q(-1), q(-1, 2), q(0), q(1, 2), q(99, 100)}) CHECK(truth(mu) == Truth::yes);
  for (const Rational& mu : {q(-3), q(-4), q(1), q(101, 100), q(5)}) CHECK(truth(mu) == Truth::no);
  const Regularity found = regularity_of(merrien(q(-1, 8), q(1, 2)), budget, {.hermite = true});
  REQUIRE(found.surface->vector->hermite);
  CHECK(found.converges().is_yes());
  CHECK(found.surface->vector->hermite->order == 1);
  CHECK(found.surface->vector->hermite->next.is_no());
  // Cubic splines: their exponent is 2, which no function with two continuous derivatives has.
  const Regularity cubic = regularity_of(merrien(q(-1, 8), q(-1, 2)), budget, {.hermite = true});
  CHECK(cubic.surface->vector->hermite->order == 1);
  CHECK(cubic.surface->vector->hermite->next.is_no());
}

TEST_CASE("The limit of the slopes has to be the slope of the limit") {
  // Slopes are refined by themselves, values by themselves.
  const LatticeMask apart = of_matrices(
      {{{q(1, 2), 0}, {0, q(1, 4)}}, {{1, 0}, {0, q(1, 2)}}, {{q(1, 2), 0}, {0, q(1, 4)}}}, -1);
  const Decision decision = hermite_scheme_converges(apart, budget);
  CHECK(decision.is_no());
  CHECK(decision.reason == "limit 1 is not the derivative of limit 0");
  CHECK(vector_scheme_converges(apart, budget).is_yes());  // the second number tends to 0
  const LatticeMask zero = of_matrices({{{q(1, 4), 0}, {0, q(1, 16)}}}, 0);
  CHECK(hermite_scheme_converges(zero, budget).is_no());
  CHECK(vector_scheme_converges(zero, budget).is_no());
}

TEST_CASE("A Hermite scheme that keeps no parabolas: coefficients of splines and their differences") {
  // f_i = (c_i, c_i - c_{i-1}, c_i - 2 c_{i-1} + c_{i-2}) of the scheme of the splines of degree 4.
  const LaurentPolynomial a = LaurentPolynomial::parse_mask("[1,5,10,10,5,1]/16@0");
  const LaurentPolynomial difference = LaurentPolynomial::parse_mask("[1,-1]@0");
  std::vector<MultivariatePolynomial> entries(9, MultivariatePolynomial(1));
  for (int k = 0; k < 3; ++k)
    entries[static_cast<std::size_t>(k)] = MultivariatePolynomial::in_variable(1, 0, a * difference.pow(k));
  const LatticeMask splines(entries, Dilation::multiple(1, 2));
  const Regularity found = regularity_of(splines, budget, {.hermite = true});
  CHECK(found.converges().is_yes());
  REQUIRE(found.surface->vector->hermite);
  CHECK(found.surface->vector->hermite->order == 3);
  CHECK(found.surface->vector->hermite->next.is_no());
  // With half the first differences these are no derivatives.
  entries[1] = MultivariatePolynomial::in_variable(1, 0, q(1, 2) * (a * difference));
  CHECK(hermite_scheme_converges({entries, Dilation::multiple(1, 2)}, budget).is_no());
}

TEST_CASE("A scheme may diverge though the solution of its equation is continuous") {
  const LatticeMask hat = of_matrices({{{q(1, 2)}}, {{1}}, {{q(1, 2)}}}, -1), kept = of_matrices({{{1}}}, -1);
  const LatticeMask mask = beside(hat, kept);
  CHECK(vector_regularity(mask, budget).vector->continuous.is_yes());
  CHECK(vector_scheme_converges(mask, budget).is_no());
  CHECK(vector_scheme_converges(beside(hat, hat), budget).is_yes());
  // Differences that shrink beside values that grow, or change their sign.
  const auto times_hat = [](const Rational& c) { return of_matrices({{{c / 2}}, {{c}}, {{c / 2}}}, -1); };
  for (const Rational& c : {q(3, 2), q(-1)}) CHECK(vector_scheme_converges(beside(hat, times_hat(c)), budget).is_no());
  CHECK(vector_scheme_converges(beside(hat, times_hat(q(-1, 2))), budget).is_yes());
  // A rotation that keeps lengths: its eigenvalues are not real.
  const LatticeMask turned = of_matrices({{{0, -1}, {1, 0}}}, -1);
  CHECK(vector_scheme_converges(beside(hat, turned), budget).is_no());
  const Matrix s{{2, 1}, {1, 1}}, inverse{{1, -1}, {-1, 2}};
  CHECK(vector_scheme_converges(in_basis(mask, s, inverse), budget).is_no());
  CHECK(vector_scheme_converges(in_basis(beside(hat, hat), s, inverse), budget).is_yes());
  // The hat function of three times the width: its data on three lattices never meet.
  const LatticeMask wide = of_matrices({{{q(1, 2)}}, {{0}}, {{0}}, {{1}}, {{0}}, {{0}}, {{q(1, 2)}}}, -3);
  CHECK(vector_scheme_converges(beside(wide, hat), budget).is_no());
}

TEST_CASE("Convergence of a mask of numbers is that of a vector of one function") {
  for (const char* text :
       {"[1,3,3,1]/4@0", "[-1,0,9,16,9,0,-1]/16@-3", "[1,1]@0", "[1,1,0,0,1,1]/2@0", "[-1,0,3,3,0,-1]/2@0"}) {
    const LatticeMask numbers(Mask(LaurentPolynomial::parse_mask(text), 2));
    CHECK(vector_scheme_converges(numbers.without_factors(), budget).truth ==
          regularity_of(numbers, budget).converges().truth);
  }
}

TEST_CASE("A mask of numbers as a vector of two halves has the same exponent") {
  // Phi(x) = (phi(2x), phi(2x - 1)): phi(y) = sum of a_k phi(2y - k), so Phi_i(x) = sum over k of a_k phi(4x - 2i - k)
  // and phi(4x - m) is component m mod 2 of Phi(2x - floor(m/2)).
  for (const char* text : {"[1,3,3,1]/4@0", "[-1,0,9,16,9,0,-1]/16@0", "[1,2,1]/2@0"}) {
    const LaurentPolynomial a = LaurentPolynomial::parse_mask(text);
    std::vector<std::vector<Monomial>> terms(4);
    for (long i = 0; i < 2; ++i)
      for (long k = a.lowest(); k <= a.highest(); ++k) {
        const long m = 2 * i + k;
        terms[static_cast<std::size_t>(2 * i + m % 2)].push_back({a.coefficient(k), {m / 2}});
      }
    std::vector<MultivariatePolynomial> entries;
    for (const auto& entry : terms) entries.emplace_back(1, entry);
    const LatticeMask vector(std::move(entries), Dilation::multiple(1, 2));
    const MultivariateRegularity found = vector_regularity(vector, budget);
    const Regularity scalar = regularity_of(LatticeMask(Mask(a, 2)), budget);
    CHECK(found.vector->solutions == 1);
    CHECK(found.exponent.lower == scalar.exponent().lower);
    CHECK(found.exponent.upper == scalar.exponent().upper);
  }
}

}  // namespace
}  // namespace subcert
