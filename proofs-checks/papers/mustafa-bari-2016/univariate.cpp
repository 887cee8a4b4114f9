// Section 2: a-ary schemes from cubic fits to 2n and to 2n+1 data.

#include "checks.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/proofs-checks/statements/normal_equations.hpp>
#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <fmt/ranges.h>

#include <algorithm>

namespace subcert::statements::mustafa_bari_2016 {
namespace {

std::string range(int n, int a) { return "n = 2.." + std::to_string(n) + ", a = 2.." + std::to_string(a); }

/// p_{r,n}/phi_n as a function of n, a, q and r.
Formula weights_2_4(const Context& context) {
  return (context.formula("p") / context.formula("phi")).replaced("omega", context.formula("omega"));
}

Outcome equation_2_4(const Context& context) {
  const int arities = context.reach(4, 6);
  const Fit cubic{weights_2_4(context), "r", {-1, 1}, {1, 0}, {1, 0}, context.formula("position-2n"), 3, 2,
                  {{"a", 1}, {"q", 0}}};
  return fit(cubic, context.reach(4, 8), [&](long) {
    std::vector<Values> cases;
    for (int a = 2; a <= arities; ++a)
      for (int q = 0; q < a; ++q) cases.push_back({{"a", a}, {"q", q}});
    return cases;
  });
}

/// The positions q of one parity of a: 0, then both signs, by size.
std::vector<Values> positions(int first_arity, int last_arity) {
  std::vector<Values> cases;
  for (int a = first_arity; a <= last_arity; a += 2)
    for (int q = (a + 1) % 2; q < a; q += 2) {
      cases.push_back({{"a", a}, {"q", q}});
      if (q > 0) cases.push_back({{"a", a}, {"q", -q}});
    }
  return cases;
}

/// b_{r,n}/psi_n as a function of n, a, q and r.
Formula weights_2_5(const Context& context, Form form) {
  return context.formula("b", form) / context.formula("psi", form);
}

Outcome equation_2_5(const Context& context, int first_arity) {
  const int arities = first_arity + context.reach(2, 4);
  return in_both_forms([&](Form form) {
    const Fit cubic{
        weights_2_5(context, form), "r", {-1, 0}, {1, 0}, {1, 0}, context.formula("position-odd", form), 3, 2,
        {{"a", 1}, {"q", 0}}};
    return fit(cubic, context.reach(4, 8), [&](long) { return positions(first_arity, arities); });
  });
}

/// The places +-first, +-(first+step), ..., +-last, and 0 for odd a.
struct Places {
  Formula first, step, last;  ///< functions of a
};

Places places(const Context& context, const std::string& parity, Form form = Form::printed) {
  return {context.formula(parity + "-first", form), context.formula(parity + "-step", form),
          context.formula(parity + "-last", form)};
}

/// They must be a places at equal distances.
Trial equally_spaced(const Places& printed, bool odd, long most) {
  Trial trial;
  const Rational first = printed.first({}), step = printed.step({});
  for (long a = odd ? 3 : 2; a <= most; a += 2) {
    const Rational last = printed.last({{"a", a}});
    const std::string where = at("a", a) + (odd ? ": from 0 to " : ": from ") + subcert::to_text(first) +
                              " and on by " + subcert::to_text(step) + " to " + subcert::to_text(last);
    trial.require(denominator((last - first) / step) == 1, where + ", which is not reached");
    trial.require((odd ? first : 2 * first) == step, where + " the distances differ");
  }
  // For a = 2b or 2b + 1 there are b - 1 steps on each side.
  const Formula steps = (printed.last - printed.first) / printed.step;
  trial.follow(identity(steps.replaced("a", f(odd ? "2*b + 1" : "2*b")), f("b - 1"), {{"b", 1}}));
  return trial.for_all(odd ? "all odd a >= 3" : "all even a", "a places at equal distances, as an identity in a");
}

Outcome positions_odd_arity(const Context& context) {
  return in_both_forms(
      [&](Form form) { return equally_spaced(places(context, "odd", form), true, context.reach(15, 51)); });
}

Outcome positions_even_arity(const Context& context) {
  Outcome outcome = equally_spaced(places(context, "even"), false, context.reach(16, 50));
  outcome.argument += ". In the order of the rules j = 0, ..., a-1 of (2.5) and (2.6) they are q = 2j - a + 1";
  return outcome;
}

/// Whether 2n data determine a cubic.
bool is_unique(int n) { return kernel(design_matrix(equidistant(-n + 1, 1, 2 * n), monomials(3))).empty(); }

Outcome smallest_size(const Context& context) {
  const Rational printed_bound = context.formula("smallest-n")({});
  const Rational corrected_bound = context.formula("smallest-n", Form::corrected)({});
  Trial printed, corrected;
  for (int n = 1; n <= 6; ++n) {
    const bool unique = is_unique(n);
    printed.require(unique == (n > printed_bound), at("n", n) + ": the cubic fit to " + std::to_string(2 * n) +
                                                       " data is unique, and the paper uses it after (2.6), but " +
                                                       subcert::to_text(printed_bound) + " is not exceeded");
    corrected.require(unique == (n > corrected_bound), at("n", n));
  }
  return printed.outcome(
      corrected.for_all("all n >= 1", "2n different nodes determine a cubic if and only if 2n >= 4"));
}

/// On grids of one, two and three variables fits with one datum more along each axis than the degree; univariate rules
/// with any more.
Outcome any_degree(const Context& context) {
  const int most = context.reach(4, 6);
  Trial trial;
  for (int degree = 0; degree <= most; ++degree) {
    const std::string where = at("degree", degree);
    for (int count = 1; count <= most + 2; ++count)
      trial.require(kernel(design_matrix(equidistant(0, 1, count), monomials(degree))).empty() == (count > degree),
                    where + ", " + std::to_string(count) + " data");
    for (int arity = 2; arity <= 3; ++arity)
      for (int count = std::max(2, degree + 1); count <= degree + 3; ++count)
        trial.require(polynomial_reproduction(regression_mask(ary(arity, count, degree))).reproduction_degree >= degree,
                      where + ", arity " + std::to_string(arity) + ", " + std::to_string(count) + " data");
    if (degree > 3) continue;
    WeightedWindow grid = window(0, degree, 2);
    const Formula polynomial = f("(1 + 2*r - s)^" + std::to_string(degree));
    for (std::size_t i = 0; i < grid.nodes.size(); ++i)
      grid.data[i] = polynomial({{"r", grid.nodes[i].first}, {"s", grid.nodes[i].second}});
    const Rational x(1, 4), y(3, 4);
    trial.equal(library_value(grid, degree, x, y), polynomial({{"r", x}, {"s", y}}), where + ", two variables");
  }
  return trial.for_all(
      "all degrees d, and more than d data along each axis",
      "a polynomial of degree d in each variable that vanishes on a grid with more than d places along "
      "each axis is 0, one variable after the other, so that the fit is unique; it keeps the "
      "polynomials of degree d, so that the rules sum to 1");
}

/// The rule of i takes the datum i + r.
Outcome datum_index(const Context& context) {
  return in_both_forms([&](Form form) {
    return moving_index(context.formula("datum-index", form), "i", "r")
        .for_all("all i and r", "the datum moves with i");
  });
}

Outcome four_point_binary(const Context& context) {
  const Formula weight = weights_2_4(context);
  const Rational a = context.formula("four-point-a")({}), n = context.formula("four-point-n")({});
  Trial trial;
  for (int q : {0, 1}) {
    const auto inserted = weights_by_normal_equations(equidistant(-1, 1, 4), monomials(3), Rational(2 * q + 1, 4));
    for (int r = -1; r <= 2; ++r)
      trial.equal(weight({{"n", n}, {"a", a}, {"q", q}, {"r", r}}), inserted[static_cast<std::size_t>(r + 1)],
                  at("q", q) + ", " + at("r", r));
  }
  trial.require(regression_mask(ary(2, 4, 3)) == regression_mask(dual(2, 3)), "not the dual 4-point scheme");
  return trial.for_all("n = 2, a = 2", "each of the eight weights");
}

/// Bases of the cubics; Gram's polynomials belong to the points -n+1..n.
std::vector<std::pair<std::string, std::vector<Formula>>> bases() {
  const auto basis = [](const char* name, const std::vector<const char*>& texts) {
    std::pair<std::string, std::vector<Formula>> result{name, {}};
    for (const char* text : texts) result.second.push_back(f(text));
    return result;
  };
  return {basis("Gram", {"1", "x - 1/2", "(x - 1/2)^2 - (4*n^2 - 1)/12", "(x - 1/2)^3 - (12*n^2 - 7)/20*(x - 1/2)"}),
          basis("Laguerre", {"1", "1 - x", "(x^2 - 4*x + 2)/2", "(-x^3 + 9*x^2 - 18*x + 6)/6"}),
          basis("Legendre", {"1", "x", "(3*x^2 - 1)/2", "(5*x^3 - 3*x)/2"}),
          basis("Chebyshev", {"1", "x", "2*x^2 - 1", "4*x^3 - 3*x"}),
          basis("Hermite", {"1", "2*x", "4*x^2 - 2", "8*x^3 - 12*x"})};
}

Outcome other_bases(const Context& context) {
  const int most = context.reach(4, 7);
  Trial trial;
  for (const auto& [name, basis] : bases())
    for (int n = 2; n <= most; ++n) {
      std::vector<Formula> of_n;
      for (const Formula& member : basis) of_n.push_back(member.replaced("n", Formula::parse(std::to_string(n))));
      for (const bool even : {true, false})
        for (const Rational& x : {Rational(1, 4), Rational(1, 6), Rational(0)}) {
          const auto nodes = even ? equidistant(-n + 1, 1, 2 * n) : equidistant(-n, 1, 2 * n + 1);
          trial.require(
              weights_by_normal_equations(nodes, of_n, x) == weights_by_normal_equations(nodes, monomials(3), x),
              name + ", " + at("n", n) + ", " + at("x", x));
        }
      // Gram's polynomials are orthogonal over their points.
      if (name == "Gram") {
        const RationalMatrix a = design_matrix(equidistant(-n + 1, 1, 2 * n), of_n);
        const RationalMatrix products = transposed(a) * a;
        for (std::size_t i = 0; i < 4; ++i)
          for (std::size_t j = 0; j < i; ++j)
            trial.equal(0, products(i, j),
                        at("n", n) + ", Gram polynomials " + std::to_string(i) + " and " + std::to_string(j));
      }
    }
  return trial.for_all(
      "all n >= 2",
      "each family has one member of every degree 0, ..., 3 and so spans the cubics, on which the fit does "
      "not depend; compared for n = 2.." +
          std::to_string(most));
}

Outcome sums_2n(const Context& context) {
  return sum_identity({weights_2_4(context), "r", {-1, 1}, {1, 0}}, context.formula("weights-sum"),
                      {{"n", 2}, {"a", 2}, {"q", 0}});
}

Outcome sums_odd(const Context& context) {
  return in_both_forms([&](Form form) {
    return sum_identity({weights_2_5(context, form), "r", {-1, 0}, {1, 0}}, context.formula("weights-sum"),
                        {{"n", 2}, {"a", 2}, {"q", 1}});
  });
}

/// The weights at the two ends of the mask, which the datum 0 gives to the outermost new values.
std::vector<Formula> end_weights(const Context& context, bool even_points) {
  const Formula weight = even_points ? weights_2_4(context) : weights_2_5(context, Form::corrected);
  const auto at_end = [&](const char* q, const char* r) { return weight.replaced("q", f(q)).replaced("r", f(r)); };
  if (even_points) return {at_end("0", "n"), at_end("a - 1", "1 - n")};
  return {at_end("1 - a", "n"), at_end("a - 1", "-n")};
}

/// Width and ends of the support of the basic limit function, in the parameters in which the scheme is symmetric.
Outcome support(const Context& context, const std::string& id, bool even_points) {
  const Formula width = context.formula(id + "-width"), end = context.formula(id + "-end");
  const int sizes = context.reach(6, 10), arities = context.reach(5, 8);
  Trial trial;
  for (int n = 2; n <= sizes && !trial.failed(); ++n)
    for (int a = 2; a <= arities; ++a) {
      const Mask mask = regression_mask(ary(a, even_points ? 2 * n : 2 * n + 1, 3));
      const Interval derived = limit_support(mask);
      const Rational shift = polynomial_reproduction(mask).parametrization.front();
      const Values where{{"n", n}, {"a", a}};
      trial.equal(width(where), derived.upper - derived.lower, to_text(where) + ", width");
      trial.equal(-end(where), derived.lower - shift, to_text(where) + ", left end");
      trial.equal(end(where), derived.upper - shift, to_text(where) + ", right end");
    }
  trial.follow(identity(width * f("a - 1"), f(even_points ? "2*n*a - 1" : "(2*n + 1)*a - 1"), {{"n", 2}, {"a", 2}}));
  trial.follow(identity(f("2") * end, width, {{"n", 2}, {"a", 2}}));
  for (const Formula& weight : end_weights(context, even_points))
    trial.follow(positive(f("0") - weight, {{"n", "2 + x"}, {"a", "2 + y"}}));
  return trial.for_all(
      "all n >= 2, a >= 2",
      "the weights at both ends of the mask are negative, by the signs of their coefficients, so that it has as many "
      "entries as the width times a - 1, and one; compared for " +
          range(sizes, arities) + (even_points ? "" : "; n = 1 has three data and no cubic") +
          ". The interval is the one in which the datum f_j stands at j and the scheme is symmetric; with the new "
          "values at i/a^k it is shifted");
}

/// The smallest size with a cubic is that of the theorem.
Outcome theorem_2_3(const Context& context) {
  const Rational smallest = context.formula("theorem-2.3-n")({});
  Trial trial;
  for (int n = 1; n <= 4; ++n)
    trial.require(is_unique(n) == (n >= smallest), at("n", n) + ": whether the cubic to 2n data is unique");
  return trial.failed() ? Outcome(trial) : support(context, "theorem-2.3", true);
}

/// A rule that copies f_r reproduces x there alone, so that it is evaluated at r.
Outcome approximating(const Context& context) {
  const Formula even = context.formula("position-2n"), odd = context.formula("position-odd");
  const std::vector<std::pair<std::string, std::string>> rules{{"q", "x"}, {"a", "x + 1 + y"}};
  Trial trial = positive(even, rules);
  trial.follow(positive(f("1") - even, rules));
  trial.follow(positive(f("1/2") - odd, rules));
  trial.follow(identity(odd.replaced("q", f("-q")), f("0") - odd, {{"a", 1}, {"q", 0}}));
  const Formula middle = weights_2_5(context, Form::corrected).replaced("q", f("0")).replaced("r", f("0"));
  trial.follow(positive(f("1") - middle, {{"n", "2 + x"}, {"a", "2 + y"}}));
  return trial.for_all("all n >= 2, a >= 2",
                       "the rules reproduce x, so that one that copies f_r stands at r. Those of (2.4) stand between 0 "
                       "and 1, those of (2.5) and (2.6) between -1/2 and 1/2; at 0 the weight of f_0 is below 1");
}

/// In the loose sense of the words: the larger the arity, the smaller the support.
Outcome inverse_proportion(const Context& context) {
  const Formula width = context.formula("theorem-2.3-width"), other = context.formula("theorem-2.4-width");
  Trial trial = identity(width, f("2*n + (2*n - 1)/(a - 1)"), {{"n", 2}, {"a", 2}});
  trial.follow(identity(other, f("2*n + 1 + 2*n/(a - 1)"), {{"n", 2}, {"a", 2}}));
  for (const Formula& one : {width, other})
    trial.follow(positive(one - one.replaced("a", f("a + 1")), {{"n", "2 + x"}, {"a", "2 + y"}}));
  return trial.for_all("all n >= 2, a >= 2",
                       "the widths are 2n + (2n-1)/(a-1) and 2n+1 + 2n/(a-1), which fall as a grows. Word for word, "
                       "as a product of width and arity that stays the same, it would not be so: for n = 2 the widths "
                       "are 7 for a = 2 and 11/2 for a = 3");
}

/// Where a limit is not 0, the values of two levels next to it tend to the same number.
Outcome necessary_condition(const Context& context) {
  const int sizes = context.reach(6, 10), arities = context.reach(5, 8);
  const Rational expected = context.formula("coset-sum")({});
  Trial trial;
  for (int n = 2; n <= sizes; ++n)
    for (int a = 2; a <= arities; ++a)
      for (int points : {2 * n, 2 * n + 1}) {
        const LaurentPolynomial symbol = regression_mask(ary(a, points, 3)).symbol();
        std::vector<Rational> sums(static_cast<std::size_t>(a), 0);
        for (long k = symbol.lowest(); k <= symbol.highest(); ++k)
          sums[static_cast<std::size_t>((k % a + a) % a)] += symbol.coefficient(k);
        for (const Rational& sum : sums)
          trial.equal(expected, sum, at("a", a) + ", " + std::to_string(points) + " points, sum of a rule");
      }
  return trial.for_all("all schemes that converge, not only to 0",
                       "where a limit is not 0, the data next to it and the values made from them tend to the same "
                       "number, so that the weights of each rule sum to 1; compared with the masks of the families, " +
                           range(sizes, arities) + ", 2n and 2n+1 points");
}

/// The letters of the pictures of Figure 2 in the text, where marked, and in the caption: first level, then limits.
Outcome letters_of_figure_2(const Context& context) {
  return in_both_forms([&](Form form) {
    Trial trial;
    for (const std::string part : {"first", "limits"}) {
      const auto text = context.words("figure-2-text-" + part, form), caption = context.words("figure-2-" + part, form);
      trial.require(text == caption,
                    fmt::format("text: ({}), caption: ({})", fmt::join(text, "), ("), fmt::join(caption, "), (")));
    }
    return trial.over("six pictures");
  });
}

}  // namespace

Checks univariate() {
  return {{"figure-2", letters_of_figure_2},
          {"approximating", approximating},
          {"necessary-condition", necessary_condition},
          {"datum-index", datum_index},
          {"eq-2.2", smallest_size},
          {"eq-2.4", equation_2_4},
          {"eq-2.5", [](const Context& c) { return equation_2_5(c, 2); }},
          {"eq-2.5-positions", positions_even_arity},
          {"eq-2.6", [](const Context& c) { return equation_2_5(c, 3); }},
          {"eq-2.6-positions", positions_odd_arity},
          {"four-point", four_point_binary},
          {"bases", other_bases},
          {"any-degree", any_degree},
          {"sums-2n", sums_2n},
          {"sums-odd", sums_odd},
          {"theorem-2.3", theorem_2_3},
          {"theorem-2.4", [](const Context& c) { return support(c, "theorem-2.4", false); }},
          {"inverse-proportion", inverse_proportion}};
}

}  // namespace subcert::statements::mustafa_bari_2016
