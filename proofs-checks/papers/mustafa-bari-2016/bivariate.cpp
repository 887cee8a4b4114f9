// Section 3: non-tensor product schemes from bivariate cubic fits.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/identities.hpp>
#include <subcert/proofs-checks/statements/normal_equations.hpp>

#include <array>

namespace subcert::statements::mustafa_bari_2016 {
namespace {

constexpr int terms = 10;
/// The powers of x and y that belong to beta_1, ..., beta_10.
constexpr std::array<std::pair<int, int>, terms> powers{
    {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}};

/// f(x, y) = sum of beta_k (x - shift)^i (y - shift)^j f_{r,s} / divisor over the square grid first(n), ..., n.
struct BivariateForm {
  std::vector<Formula> beta;  ///< functions of n, r, s
  Formula divisor;
  Rational shift;
  Line first;
};

Formula swapped(const Formula& formula) {
  return formula.replaced("r", f("t")).replaced("s", f("r")).replaced("t", f("s"));
}

/// The six printed coefficients; the others by exchanging r and s, as the paper says.
BivariateForm form_of(const Context& context, const std::string& id, Form form, const Line& first) {
  const auto read = [&](const std::string& name) {
    return context.formula(id + "-" + name, form)
        .replaced("nu", f("n^2 - 1/4"))
        .replaced("R", f("r - 1/2"))
        .replaced("S", f("s - 1/2"));
  };
  const Formula b1 = read("beta-1"), b2 = read("beta-2"), b4 = read("beta-4"), b5 = read("beta-5"), b7 = read("beta-7"),
                b8 = read("beta-8");
  return {{b1, b2, swapped(b2), b4, b5, swapped(b4), b7, b8, swapped(b8), swapped(b7)},
          read("divisor"),
          context.formula(id + "-shift", form)({}),
          first};
}

std::string beta_at(std::size_t k, long n, long r, long s) {
  return at("n", n) + ", " + at("r", r) + ", " + at("s", s) + ", beta_" + std::to_string(k + 1);
}

/// Every coefficient against the normal equations on the grid for one n.
Trial compared(const BivariateForm& form, long n) {
  std::vector<std::pair<long, long>> nodes;
  for (long r = form.first(n); r <= n; ++r)
    for (long s = form.first(n); s <= n; ++s) nodes.emplace_back(r, s);
  RationalMatrix design(nodes.size(), terms);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t k = 0; k < terms; ++k) {
      const Rational x = Rational(nodes[i].first) - form.shift, y = Rational(nodes[i].second) - form.shift;
      Rational value = 1;
      for (int p = 0; p < powers[k].first; ++p) value *= x;
      for (int p = 0; p < powers[k].second; ++p) value *= y;
      design(i, k) = value;
    }
  const RationalMatrix inverse = pseudo_inverse(design);
  Trial trial;
  for (std::size_t k = 0; k < terms; ++k)
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Values where{{"n", n}, {"r", nodes[i].first}, {"s", nodes[i].second}};
      if (!trial.equal(form.beta[k](where) / form.divisor(where), inverse(k, i),
                       beta_at(k, n, nodes[i].first, nodes[i].second) + " over the divisor"))
        return trial;
    }
  return trial;
}

/// beta_k is a cubic in (r, s), and sum of beta_k (r - shift)^i (s - shift)^j / divisor is 1 for the power of beta_k
/// and 0 for the others: this characterises the fit. Checked for as many n as the degree in n demands.
Trial proved(const BivariateForm& form, long smallest_n) {
  Trial trial;
  for (std::size_t k = 0; k < terms && !trial.failed(); ++k) {
    const Degrees in_node = form.beta[k].degrees(std::vector<std::string>{"r", "s"}), in_n = form.beta[k].degrees("n");
    if (!trial.require(in_node.denominator == 0 && in_n.denominator == 0 && in_node.numerator <= 3,
                       "beta_" + std::to_string(k + 1) + " is not shown to be a cubic in r and s"))
      break;
    // A sum of r^a s^b over the grid has degree a + b + 2 in n; here a + b <= 3 + 3.
    const long degree = std::max(in_n.numerator + 3 + 3 + 2, form.divisor.degrees("n").numerator);
    for (long n = smallest_n; n <= smallest_n + degree && !trial.failed(); ++n) {
      const auto x = MultivariatePolynomial::in_variable(2, 0, LaurentPolynomial::monomial(1, 1));
      const auto y = MultivariatePolynomial::in_variable(2, 1, LaurentPolynomial::monomial(1, 1));
      const MultivariatePolynomial centre(2, form.shift);
      // In powers of r - shift and s - shift.
      const Fraction beta = form.beta[k].substituted(
          {{"n", MultivariatePolynomial(2, n)}, {"r", x + centre}, {"s", y + centre}});
      const Rational scale = beta.denominator.coefficient({0, 0}) * form.divisor({{"n", n}});
      std::vector<Rational> sums(8, 0);  // of (r - shift)^e
      for (long r = form.first(n); r <= n; ++r) {
        Rational value = 1;
        for (Rational& sum : sums) {
          sum += value;
          value *= Rational(r) - form.shift;
        }
      }
      for (std::size_t l = 0; l < terms; ++l) {
        Rational moment = 0;
        for (const auto& term : beta.numerator.terms())
          moment += term.coefficient * sums[static_cast<std::size_t>(term.exponents[0] + powers[l].first)] *
                    sums[static_cast<std::size_t>(term.exponents[1] + powers[l].second)];
        trial.equal(moment / scale, k == l ? 1 : 0,
                    at("n", n) + ", beta_" + std::to_string(k + 1) + ", moment " + std::to_string(l + 1));
      }
    }
  }
  return trial.for_all(
      "all n >= " + std::to_string(smallest_n),
      "each beta is a cubic in the node with the moments that characterise the fit, as identities in n");
}

/// The value at (shift, shift) for data that are all 1.
Trial keeps_constants(const BivariateForm& form, long n) {
  Rational sum = 0;
  for (long r = form.first(n); r <= n; ++r)
    for (long s = form.first(n); s <= n; ++s) sum += form.beta[0]({{"n", n}, {"r", r}, {"s", s}});
  Trial trial;
  trial.equal(sum / form.divisor({{"n", n}}), 1, at("n", n) + ", all data 1, f(0, 0) = sum of beta_1 over lambda");
  return trial;
}

Outcome equation_3_8(const Context& context) {
  const BivariateForm printed = form_of(context, "eq-3.8", Form::printed, {-1, 1});
  const BivariateForm corrected = form_of(context, "eq-3.8", Form::corrected, {-1, 1});
  const Trial at_two = compared(printed, 2);
  if (at_two.failed()) return {StatementVerdict::false_claim, "", at_two.failure(), "not even for n = 2"};
  Trial of_corrected = compared(corrected, 2);
  for (long n = 3; n <= context.reach(3, 4); ++n) of_corrected.follow(compared(corrected, n));
  of_corrected.follow(proved(corrected, 2));
  of_corrected.for_all("all n >= 2",
                       "cubics in the node with the moments that characterise the fit, as identities in n");
  Trial at_three = keeps_constants(printed, 3);
  at_three.follow(compared(printed, 3));
  Outcome outcome = at_three.outcome(of_corrected);
  outcome.argument = "the printed beta belong to n = 2, where all of them are right; lambda is right for all n. " +
                     outcome.argument;
  return outcome;
}

Outcome equation_3_9(const Context& context) {
  const BivariateForm form = form_of(context, "eq-3.9", Form::printed, {-1, 0});
  Trial trial = compared(form, 2);
  for (long n = 3; n <= context.reach(3, 4); ++n) trial.follow(compared(form, n));
  trial.follow(proved(form, 2));
  return trial.for_all(
      "all n >= 2",
      "each beta is a cubic in the node with the moments that characterise the fit, as identities in n; also "
      "compared with the "
      "normal equations for n = 2.." +
          std::to_string(context.reach(3, 4)));
}

/// The weights of the rule at (x, y).
RationalMatrix rule(const BivariateForm& form, long n, const Rational& x, const Rational& y) {
  const auto size = static_cast<std::size_t>(n - form.first(n) + 1);
  RationalMatrix weights(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      const Values where{
          {"n", n}, {"r", form.first(n) + static_cast<long>(i)}, {"s", form.first(n) + static_cast<long>(j)}};
      for (std::size_t k = 0; k < terms; ++k)
        weights(i, j) += form.beta[k](where) / form.divisor(where) * power(Rational(x - form.shift), powers[k].first) *
                         power(Rational(y - form.shift), powers[k].second);
    }
  return weights;
}

/// Weights that sum to 1, one for each datum, and are no product of weights in x and in y.
Trial non_tensor(const Context& context, const BivariateForm& form, const std::string& points) {
  const std::vector<Formula> xs = context.list("rules-x"), ys = context.list("rules-y");
  const auto n = static_cast<long>(numerator(context.formula("rules-n")({})));
  const Rational count = context.formula(points)({{"n", n}});
  Trial trial;
  trial.equal(context.formula(points + "-drawn")({}), count, at("n", n) + ", number of data");
  for (std::size_t k = 0; k < 4; ++k) {
    const Rational x = xs.at(k)({}), y = ys.at(k)({});
    const RationalMatrix weights = rule(form, n, x, y);
    const std::string where = at("x", x) + ", " + at("y", y);
    Rational sum = 0;
    long used = 0;
    for (std::size_t i = 0; i < weights.rows(); ++i)
      for (std::size_t j = 0; j < weights.columns(); ++j) {
        sum += weights(i, j);
        used += weights(i, j) != 0 ? 1 : 0;
      }
    trial.equal(1, sum, where + ", sum of the weights");
    trial.equal(count, used, where + ", number of weights");
    trial.require(pivot_columns(weights).size() > 1, where + ": the weights are a product");
  }
  return trial.for_all("n = 2, the points (1/4, 1/4), (3/4, 1/4), (1/4, 3/4), (3/4, 3/4)", "each of the four rules");
}

/// The four rules of f_{2i,2j}, f_{2i+1,2j}, f_{2i,2j+1}, f_{2i+1,2j+1} stand a quarter from the middle of the grid.
Outcome points_16(const Context& context) {
  const std::vector<Formula> xs = context.list("rules-x"), ys = context.list("rules-y");
  Trial trial = non_tensor(context, form_of(context, "eq-3.8", Form::printed, {-1, 1}), "points-2n");
  for (long k = 0; k < 4; ++k) {
    const auto place = static_cast<std::size_t>(k);
    trial.equal(xs.at(place)({}), Rational(1, 4) + Rational(k % 2, 2), "rule " + std::to_string(k) + ", x");
    trial.equal(ys.at(place)({}), Rational(1, 4) + Rational(k / 2, 2), "rule " + std::to_string(k) + ", y");
  }
  Outcome outcome = trial;
  outcome
      .argument += "; the printed beta are right for n = 2; f^k stands for the new values, as the data have no level";
  return outcome;
}

/// A product u(r) v(s) that fits cubics has the cubic fits of one variable as factors (docs/statements.md, proposition
/// 3). Where the second Gram polynomial of the m nodes does not vanish their weights have degree 2 or 3 in the node.
Outcome no_products(const Context& context) {
  const Formula largest = f("(m^2 - 1)/12");  // of (x - middle)^2 below the zero
  Trial trial;
  for (const char* axis : {"rules-x", "rules-y"})
    for (const Formula& place : context.list(axis))
      for (const Formula& middle : {f("1/2"), f("0")})
        trial.follow(positive(largest - (place - middle) * (place - middle), {{"m", "4 + x"}}));
  return trial.for_all("all n >= 2, both grids",
                       "factors of weights that are products would be the cubic fits in one variable, whose weights "
                       "have degree 2 or 3 in the node, as the second Gram polynomial does not vanish at the places of "
                       "the rules; but a cubic fit in two variables has weights of total degree 3 at most");
}

/// The grids first..n in two or three variables that determine a cubic.
bool determines_cubics(long first, long n, int variables) {
  std::vector<std::vector<long>> nodes{{}}, exponents{{}};
  for (int v = 0; v < variables; ++v) {
    std::vector<std::vector<long>> more, higher;
    for (const auto& node : nodes)
      for (long x = first; x <= n; ++x) {
        more.push_back(node);
        more.back().push_back(x);
      }
    for (const auto& exponent : exponents) {
      long used = 0;
      for (long e : exponent) used += e;
      for (long e = 0; used + e <= 3; ++e) {
        higher.push_back(exponent);
        higher.back().push_back(e);
      }
    }
    nodes = more;
    exponents = higher;
  }
  RationalMatrix design(nodes.size(), exponents.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t k = 0; k < exponents.size(); ++k) {
      design(i, k) = 1;
      for (std::size_t v = 0; v < nodes[i].size(); ++v)
        for (long e = 0; e < exponents[k][v]; ++e) design(i, k) *= nodes[i][v];
    }
  return kernel(design).empty();
}

Outcome smallest_grid(const Context& context) {
  const Rational bound = context.formula("grids-n")({});
  Trial trial;
  for (long n = 1; n <= 3; ++n)
    for (long first : {-n + 1, -n})
      trial.require(determines_cubics(first, n, 2) == (n > bound), at("n", n) + ", grid from " + std::to_string(first));
  return trial.for_all("all n >= 1",
                       "four values of each variable determine a polynomial of degree 3 in each, and so do "
                       "more; for n = 1 the 4 or 9 data do not determine 10 coefficients");
}

Outcome volumes(const Context& context) {
  const Rational bound = context.formula("volumes-bound")({});
  Trial printed, corrected;
  for (long n = 1; n <= 2; ++n)
    for (long first : {-n + 1, -n}) {
      const bool determined = determines_cubics(first, n, 3);
      corrected.require(determined == (n > bound), at("n", n) + ", grid from " + std::to_string(first));
      if (determined)
        printed.require(first > bound, at("n", n) + ": the grid from " + std::to_string(first) +
                                           " determines a cubic, but holds t = " + std::to_string(first));
    }
  return printed.outcome(corrected.for_all("all n >= 1",
                                           "four values of each variable determine a polynomial of degree 3 in each, "
                                           "and so do more; n = 1 has too few; compared for n = 1, 2"));
}

}  // namespace

Checks bivariate() {
  return {{"non-tensor", no_products},
          {"grids", smallest_grid},
          {"eq-3.8", equation_3_8},
          {"16-point", points_16},
          {"eq-3.9", equation_3_9},
          {"25-point",
           [](const Context& c) {
             return Outcome(non_tensor(c, form_of(c, "eq-3.9", Form::printed, {-1, 0}), "points-odd"));
           }},
          {"volumes", volumes}};
}

}  // namespace subcert::statements::mustafa_bari_2016
