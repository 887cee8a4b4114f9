// Appendix A: least squares polynomials and masks.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/identities.hpp>
#include <subcert/proofs-checks/statements/normal_equations.hpp>
#include <subcert/schemes/local_regression.hpp>

#include <stdexcept>

namespace subcert::statements::dyn_2015 {
namespace {

/// X_n = {-2n+2, -2n+4, ..., 2n-2} and the odd numbers from -2n+1 to 2n-1.
std::vector<Rational> even_points(int n) { return equidistant(-2 * n + 2, 2, 2 * n - 1); }
std::vector<Rational> odd_points(int n) { return equidistant(-2 * n + 1, 2, 2 * n); }

/// Nodes without order or symmetry, and data.
std::vector<Rational> scattered(int m) {
  std::vector<Rational> nodes;
  for (int i = 0; i < m; ++i) nodes.push_back(Rational((7 * i * i + 3 * i) % 31, 5) - 2 + Rational(i, 64));
  return nodes;
}
Rational datum(std::size_t i) { return Rational(static_cast<long>(i * i % 11) - 4, static_cast<long>(1 + i % 3)); }

Rational applied(const std::vector<Rational>& weights) {
  Rational sum = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * datum(i);
  return sum;
}

/// Monic orthogonal polynomials over the nodes, as their values at the nodes and at further points; squares of the
/// norms.
struct Orthogonal {
  std::vector<std::vector<Rational>> at_nodes;
  std::vector<std::vector<Rational>> at_points;
  std::vector<Rational> squared_norms;
};

Rational product(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  Rational sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Gram and Schmidt on the monomials. A polynomial of norm 0 ends the family: it is kept with its norm.
Orthogonal orthogonal(const std::vector<Rational>& nodes, const std::vector<Rational>& points, int degree) {
  Orthogonal family;
  for (int k = 0; k <= degree; ++k) {
    std::vector<Rational> nodal, other;
    for (const Rational& x : nodes) nodal.push_back(power(x == 0 && k == 0 ? Rational(1) : x, k));
    for (const Rational& x : points) other.push_back(power(x == 0 && k == 0 ? Rational(1) : x, k));
    for (std::size_t l = 0; l < family.at_nodes.size(); ++l) {
      const Rational share = product(nodal, family.at_nodes[l]) / family.squared_norms[l];
      for (std::size_t i = 0; i < nodal.size(); ++i) nodal[i] -= share * family.at_nodes[l][i];
      for (std::size_t i = 0; i < other.size(); ++i) other[i] -= share * family.at_points[l][i];
    }
    family.squared_norms.push_back(product(nodal, nodal));
    family.at_nodes.push_back(nodal);
    family.at_points.push_back(other);
    if (family.squared_norms.back() == 0) break;
  }
  return family;
}

Outcome normal_equations(const Context& context) {
  const int most = context.reach(8, 12);
  Trial trial;
  for (int m = 1; m <= most; ++m)
    for (int d = 0; d < m; ++d)
      for (const Rational& x : {Rational(0), Rational(3, 7)}) {
        const auto nodes = scattered(m);
        trial.equal(applied(weights_by_normal_equations(nodes, monomials(d), x)),
                    applied(regression_weights(nodes, {}, d, x)), at("m", m) + ", " + at("d", d) + ", " + at("x", x));
      }
  return trial.for_all("all m > d >= 0 and distinct nodes",
                       "the normal equations set the gradient of a convex function to 0, and A^T A is invertible; "
                       "values compared for m = 1.." +
                           std::to_string(most) + ", d = 0..m-1, scattered nodes");
}

Outcome invertible(const Context& context) {
  const int most = context.reach(8, 12);
  Trial trial;
  for (int m = 1; m <= most; ++m)
    for (int d = 0; d < m; ++d) {
      const RationalMatrix a = design_matrix(scattered(m), monomials(d));
      trial.require(kernel(transposed(a) * a).empty(), at("m", m) + ", " + at("d", d));
    }
  return trial.for_all("all m > d >= 0 and distinct nodes",
                       few_zeros + "tried for m = 1.." + std::to_string(most) + ", d = 0..m-1, scattered nodes");
}

/// beta by the pseudo-inverse that the remark gives for d >= m, in the order of its factors; interpolation is asked
/// for.
Trial interpolates_beyond(bool printed_order, int most) {
  Trial trial;
  for (int m = 2; m <= most && !trial.failed(); ++m)
    for (int d = m; d <= m + 2; ++d) {
      const RationalMatrix a = design_matrix(scattered(m), monomials(d));
      const RationalMatrix inverse = solved(a * transposed(a), RationalMatrix::identity(a.rows()));
      const std::string where = at("m", m) + ", " + at("d", d);
      if (printed_order) {
        const bool fits = inverse.columns() == transposed(a).rows();
        if (!trial.require(fits, where + ": (A A^T)^-1 has " + std::to_string(inverse.columns()) +
                                     " columns and A^T has " + std::to_string(transposed(a).rows()) +
                                     " rows, so that their product does not exist"))
          return trial;
        continue;
      }
      if (!trial.require(a * (transposed(a) * inverse) == RationalMatrix::identity(a.rows()),
                         where + ": p* does not interpolate"))
        return trial;
    }
  return trial.over("m = 2.." + std::to_string(most) + ", d = m..m+2, scattered nodes");
}

Outcome remark_9(const Context& context) {
  const int most = context.reach(6, 10);
  return interpolates_beyond(true, most).outcome(interpolates_beyond(false, most));
}

Outcome remark_9_interpolation(const Context& context) {
  const int most = context.reach(8, 12);
  Trial trial;
  for (int m = 1; m <= most; ++m) {
    const auto nodes = scattered(m);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      trial.equal(applied(weights_by_normal_equations(nodes, monomials(m - 1), nodes[i])), datum(i),
                  at("m", m) + ", node " + std::to_string(i + 1));
  }
  return trial.for_all("all m and distinct nodes",
                       "the interpolating polynomial has no residuals, and it is unique; values compared for m = 1.." +
                           std::to_string(most));
}

/// The solution of smallest norm in two bases differs away from the nodes.
Outcome remark_9_basis(const Context&) {
  const auto nodes = equidistant(0, 1, 2);
  const auto value = [&](const std::vector<Formula>& basis, const Rational& x) {
    const RationalMatrix a = design_matrix(nodes, basis);
    const RationalMatrix weights = design_matrix({x}, basis) *
                                   (transposed(a) * solved(a * transposed(a), RationalMatrix::identity(2)));
    return Rational(weights(0, 0));
  };
  const std::vector<Formula> chebyshev{f("1"), f("x"), f("2*x^2 - 1")};
  Trial trial;
  for (long x : {0, 1}) trial.equal(value(monomials(2), x), value(chebyshev, x), at("x", x) + ", a node");
  trial.require(value(monomials(2), 2) != value(chebyshev, 2), "the two bases agree at x = 2");
  return trial.over("nodes 0 and 1, d = 2: monomials give " + subcert::to_text(value(monomials(2), 2)) +
                    " at x = 2 for the data 1, 0, Chebyshev polynomials " + subcert::to_text(value(chebyshev, 2)));
}

/// L^j is orthogonal to all lower degrees. That leaves a line, and two polynomials of norm 1 on it.
Outcome unique_family(const Context& context) {
  const int most = context.reach(6, 9);
  Trial printed, corrected;
  for (int m = 1; m <= most; ++m)
    for (int j = 0; j < m; ++j) {
      const RationalMatrix values = design_matrix(scattered(m), monomials(j));
      std::vector<std::vector<Rational>> line{{1}};
      if (j > 0) line = kernel(transposed(design_matrix(scattered(m), monomials(j - 1))) * values);
      const std::string where = at("m", m) + ", " + at("j", j);
      corrected.require(line.size() == 1, where + ": the polynomials orthogonal to lower degrees are no line");
      Rational squares = 0;
      for (std::size_t i = 0; i < values.rows(); ++i) {
        Rational value = 0;
        for (std::size_t k = 0; k < values.columns(); ++k) value += values(i, k) * line[0][k];
        squares += value * value;
      }
      corrected.require(squares != 0, where + ": the polynomial has norm 0");
      printed.require(squares == 0, where + ": with L^" + std::to_string(j) + " its negative satisfies (A.4), too");
    }
  return printed.outcome(corrected.over("m = 1.." + std::to_string(most) + ", all degrees below m, scattered nodes"));
}

Outcome expansion(const Context& context) {
  const int most = context.reach(8, 12);
  Trial trial;
  for (int m = 1; m <= most; ++m)
    for (int d = 0; d < m; ++d) {
      const auto nodes = scattered(m);
      const Rational x(2, 3);
      const Orthogonal family = orthogonal(nodes, {x}, d);
      Rational value = 0;
      for (std::size_t j = 0; j < family.at_nodes.size(); ++j)
        value += applied(family.at_nodes[j]) * family.at_points[j][0] / family.squared_norms[j];
      trial.equal(value, applied(regression_weights(nodes, {}, d, x)), at("m", m) + ", " + at("d", d));
    }
  return trial.for_all("all m > d >= 0 and distinct nodes",
                       "the fit is the orthogonal projection of the data; values compared for m = 1.." +
                           std::to_string(most) + ", d = 0..m-1, scattered nodes, x = 2/3");
}

Outcome proposition_10(const Context& context) {
  const int most = context.reach(8, 12);
  Trial trial;
  for (int m = 1; m <= most; ++m)
    for (int d = 0; d < m; ++d)
      for (const Rational& a : {Rational(2), Rational(-3, 5)}) {
        const auto nodes = scattered(m);
        const Rational b(4, 9), x(2, 3);
        std::vector<Rational> moved;
        for (const Rational& node : nodes) moved.push_back(a * node + b);
        trial.equal(applied(regression_weights(moved, {}, d, a * x + b)), applied(regression_weights(nodes, {}, d, x)),
                    at("m", m) + ", " + at("d", d) + ", " + at("a", a));
      }
  return trial.for_all(
      "all m, d and affine maps",
      "orthonormal families are carried over by composition, as printed; compared for m = 1.." + std::to_string(most));
}

/// Which degrees of Corollary 11, and how (A.7) is summed for d = 2n-1: as printed, or up to the degree 2n-2 of the
/// last polynomial over X_n.
enum class Degrees11 { below, last_as_printed, last_as_corrected };

/// (A.7) and its odd counterpart against the derived masks.
Trial corollary_11(int most, Degrees11 which) {
  Trial trial;
  for (int n = 1; n <= most && !trial.failed(); ++n)
    for (int d = which == Degrees11::below ? 1 : 2 * n - 1; d < 2 * n - (which == Degrees11::below ? 1 : 0); ++d) {
      const auto nodes = even_points(n), odd = odd_points(n);
      const Orthogonal family = orthogonal(nodes, {0}, which == Degrees11::last_as_corrected ? 2 * n - 2 : d);
      const Orthogonal odd_family = orthogonal(odd, {0}, d);
      for (std::size_t j = 0; j < family.squared_norms.size(); ++j)
        if (!trial.require(family.squared_norms[j] != 0,
                           at_n_d(n, d) + ": X_n has " + std::to_string(nodes.size()) +
                               (nodes.size() == 1 ? " point" : " points") + ", and every polynomial of degree " +
                               std::to_string(j) +
                               " that is orthogonal to those of lower degree vanishes on them, so that L_n^" +
                               std::to_string(j) + " does not exist"))
          return trial;
      const Mask mask = regression_mask(primal(n, d));
      const auto coefficient = [](const Orthogonal& all, std::size_t i) {
        Rational sum = 0;
        for (std::size_t j = 0; j < all.at_nodes.size(); ++j)
          sum += all.at_nodes[j][i] * all.at_points[j][0] / all.squared_norms[j];
        return sum;
      };
      for (int i = -n + 1; i <= n - 1; ++i)
        if (!trial.equal(coefficient(family, static_cast<std::size_t>(-i + n - 1)), mask.symbol().coefficient(2 * i),
                         at_n_d(n, d) + ", coefficient " + std::to_string(2 * i)))
          return trial;
      for (int i = -n; i <= n - 1; ++i)
        if (!trial.equal(coefficient(odd_family, static_cast<std::size_t>(-i - 1 + n)),
                         mask.symbol().coefficient(2 * i + 1),
                         at_n_d(n, d) + ", coefficient " + std::to_string(2 * i + 1)))
          return trial;
    }
  return trial;
}

Outcome corollary_11(const Context& context) {
  const int most = context.reach(5, 9);
  Trial trial = corollary_11(most, Degrees11::below);
  trial.follow(corollary_11(most, Degrees11::last_as_corrected));
  return trial
      .for_all(
          "all n >= 1, d = 1..2n-2 as printed, d = 2n-1 with the first sum up to 2n-2",
          "(A.5) for data 1 at one node and 0 at the others, moved by Proposition 10; compared for " + range(1, most))
      .but_not("d = 2n-1", corollary_11(most, Degrees11::last_as_printed));
}

/// The families of d + 1 orthonormal polynomials over both point sets.
Trial families(int n, int d) {
  Trial trial;
  for (const auto& points : {even_points(n), odd_points(n)})
    trial.require(orthogonal(points, {}, d).squared_norms.back() != 0,
                  at_n_d(n, d) + ": " + std::to_string(points.size()) +
                      (points.size() == 1 ? " point is" : " points are") + " too few for " + std::to_string(d + 1) +
                      " orthonormal polynomials");
  return trial;
}

Outcome families(const Context& context) {
  const int most = context.reach(5, 8);
  Trial trial;
  for (int n = 2; n <= most; ++n)
    for (int d = 1; d <= n; ++d) trial.follow(families(n, d));
  return trial.for_all("all n >= d >= 1 with n >= 2", "d + 1 <= n + 1 <= 2n - 1 points; tried for " + range(2, most))
      .but_not("n = d = 1", families(1, 1));
}

/// The affine map of the proof: which point is phi(j)?
Outcome corollary_11_proof(const Context& context) {
  return in_both_forms([&](Form form) {
    const Formula map = context.formula("cor-11-map", form), point = context.formula("cor-11-point", form);
    Trial trial;
    for (int n = 1; n <= 4; ++n)
      for (int k = 0; k <= 3; ++k)
        for (int i = 0; i <= 3; ++i)
          for (int j = -2 * n + 2; j <= 2 * n - 2; j += 2) {
            const Values where{{"n", n}, {"k", k}, {"i", i}, {"j", j}};
            trial.equal(point(where), map({{"k", k}, {"i", i}, {"x", j}}), to_text(where) + ": the point t and phi(j)");
          }
    return trial.over("n = 1..4, k = 0..3, i = 0..3");
  });
}

Outcome low_degrees(const Context& context) {
  const Formula even = context.formula("l1-norm-even"), odd = context.formula("l1-norm-odd");
  const Formula even_0 = context.formula("l0-norm-even"), odd_0 = context.formula("l0-norm-odd");
  Trial trial = sum_identity({f("(2*j)^2"), "j", {-1, 1}, {1, -1}}, even, {{"n", 1}});
  trial.follow(sum_identity({f("(2*j - 1)^2"), "j", {-1, 1}, {1, 0}}, odd, {{"n", 1}}));
  trial.follow(sum_identity({f("1 + 0*j"), "j", {-1, 1}, {1, -1}}, even_0, {{"n", 1}}));
  trial.follow(sum_identity({f("1 + 0*j"), "j", {-1, 1}, {1, 0}}, odd_0, {{"n", 1}}));
  for (int n = 2; n <= context.reach(6, 12); ++n) {
    trial.equal(even({{"n", n}}), orthogonal(even_points(n), {}, 1).squared_norms[1], at("n", n) + ", L_n^1");
    trial.equal(odd({{"n", n}}), orthogonal(odd_points(n), {}, 1).squared_norms[1], at("n", n) + ", hat L_n^1");
  }
  trial.for_all("all n >= 2; L_n^0 and both polynomials over the odd points for all n >= 1",
                "the squared norms of 1 and x over both point sets, as sums that are identities in n");
  return trial.but_not("n = 1, where X_1 = {0} has no L_1^1", families(1, 1));
}

Outcome remark_12(const Context& context) {
  const int most = context.reach(6, 10);
  Trial trial;
  for (int n = 1; n <= most; ++n)
    for (const auto& nodes : {even_points(n), odd_points(n)}) {
      const Orthogonal family = orthogonal(nodes, {0}, static_cast<int>(nodes.size()) - 1);
      for (std::size_t j = 0; j < family.at_nodes.size(); ++j) {
        const int sign = j % 2 == 0 ? 1 : -1;
        for (std::size_t i = 0; i < nodes.size(); ++i)
          trial.equal(sign * family.at_nodes[j][nodes.size() - 1 - i], family.at_nodes[j][i],
                      at("n", n) + ", degree " + std::to_string(j));
        if (sign < 0)
          trial.equal(0, family.at_points[j][0], at("n", n) + ", degree " + std::to_string(j) + ", value at 0");
      }
    }
  return trial.for_all(
      "all n and degrees",
      "over a symmetric point set p(-x) is orthogonal in the same way, so the monic polynomials have the "
      "parity of their degree; compared for " +
          range(1, most));
}

/// The Moore-Penrose pseudo-inverse of a matrix whose columns or rows are independent.
RationalMatrix moore_penrose(const RationalMatrix& a) {
  const RationalMatrix turned = transposed(a);
  return a.columns() > a.rows() ? turned * solved(a * turned, RationalMatrix::identity(a.rows())) : pseudo_inverse(a);
}

Outcome proposition_13(const Context& context) {
  const int most = context.reach(5, 9);
  Trial trial;
  for (int n = 1; n <= most && !trial.failed(); ++n)
    for (int d = 1; d < 2 * n; ++d) {
      const RationalMatrix even = moore_penrose(design_matrix(even_points(n), monomials(d))),
                           odd = moore_penrose(design_matrix(odd_points(n), monomials(d)));
      const Mask mask = regression_mask(primal(n, d));
      for (std::size_t i = 0; i < even.columns(); ++i)
        trial.equal(even(0, i), mask.symbol().coefficient(2 * n - 2 - 2 * static_cast<long>(i)),
                    at_n_d(n, d) + ", entry " + std::to_string(i + 1) + " of the first row");
      for (std::size_t i = 0; i < odd.columns(); ++i)
        trial.equal(odd(0, i), mask.symbol().coefficient(2 * n - 1 - 2 * static_cast<long>(i)),
                    at_n_d(n, d) + ", entry " + std::to_string(i + 1) + " of the second row");
    }
  return trial.for_all("all n >= 1 and d < 2n, with the Moore-Penrose pseudo-inverse of (A.2)",
                       "the first row gives the value of the fit at 0; for d = 2n-1, where Remark 9 is needed, 0 is a "
                       "node, so that it is a unit vector; compared for " +
                           range(1, most));
}

/// Whether A^T A and its counterpart over the odd points can be inverted.
Trial inverses(int n, int d) {
  Trial trial;
  for (const auto& points : {even_points(n), odd_points(n)}) {
    const RationalMatrix a = design_matrix(points, monomials(d));
    trial.require(kernel(transposed(a) * a).empty(),
                  at_n_d(n, d) + ": A has " + std::to_string(a.rows()) + (a.rows() == 1 ? " row and " : " rows and ") +
                      std::to_string(a.columns()) + " columns, so that A^T A has no inverse");
  }
  return trial;
}

Outcome cost_of_proposition_13(const Context& context) {
  const int most = context.reach(5, 9);
  Trial trial, last;
  for (int n = 1; n <= most; ++n) {
    for (int d = 1; d < 2 * n - 1; ++d) trial.follow(inverses(n, d));
    last.follow(inverses(n, 2 * n - 1));
  }
  return trial.for_all("all n >= 1 and d <= 2n-2", few_zeros + "tried for " + range(1, most)).but_not("d = 2n-1", last);
}

}  // namespace

Checks appendix() {
  return {{"eq-a1-a2", normal_equations},
          {"invertible", invertible},
          {"remark-9-interpolation", remark_9_interpolation},
          {"remark-9", remark_9},
          {"remark-9-basis", remark_9_basis},
          {"eq-a4", unique_family},
          {"eq-a5", expansion},
          {"proposition-10", proposition_10},
          {"families", [](const Context& c) { return families(c); }},
          {"corollary-11", [](const Context& c) { return corollary_11(c); }},
          {"corollary-11-proof", corollary_11_proof},
          {"low-degrees", low_degrees},
          {"remark-12", remark_12},
          {"proposition-13", proposition_13},
          {"proposition-13-cost", cost_of_proposition_13}};
}

}  // namespace subcert::statements::dyn_2015
