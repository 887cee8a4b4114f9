// Appendix B.2: generalisations, the least squares schemes S_2n and S_2n+1 for surfaces, Lemma 1.

#include "checks.hpp"

#include <subcert/proofs-checks/statements/reweighting.hpp>
#include <subcert/schemes/grid_regression.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::mustafa_li_2015 {
namespace {

Trial least_squares(const Context& context, const std::string& id, bool even, Form form) {
  const std::vector<Formula> xs = context.list((even ? "surface-x" : "lemma-1-x")),
                             ys = context.list((even ? "surface-y" : "lemma-1-y"));
  const int most = context.reach(4, 8);
  Trial trial;
  for (std::size_t k = 0; k < 4; ++k) {
    Formula weight = context.formula(id + "-" + rule_names[k]);
    if (even) weight = weight.replaced("xi", context.formula("xi"));
    trial.follow(grid_fit({weight, {-1, even ? 1 : 0}, {1, 0}, xs.at(k), ys.at(k), 1, 1, {}}, most));
    for (int n = 1; n <= most && !trial.failed(); ++n) {
      const int points = even ? 2 * n : 2 * n + 1;
      const LatticeMask mask = grid_regression_mask({{points, points}, 1, 2});
      // The library numbers the two outputs about a datum -1 and 0.
      const long first_output = ary(2, points, 1).first_output;
      const long along_x = first_output + static_cast<long>(k % 2), along_y = first_output + static_cast<long>(k / 2);
      for (int r = even ? 1 - n : -n; r <= n; ++r)
        for (int s = even ? 1 - n : -n; s <= n; ++s)
          trial.equal(weight({{"n", n}, {"r", r}, {"s", s}}),
                      mask.symbol().coefficient({along_x - 2 * r, along_y - 2 * s}),
                      "rule " + rule_names[k] + ", " + at("n", n) + ", " + at("r", r) + ", " + at("s", s) + ", mask");
    }
  }
  trial.follow(moving_index(context.formula(id + "-index-i", form), "i", "r"));
  trial.follow(moving_index(context.formula(id + "-index-j", form), "j", "s"));
  return trial.for_all(
      "all n >= 1",
      "the weights are linear in the node and reproduce linear polynomials, as identities in n; the masks "
      "are those of grid:points compared up to n = " +
          std::to_string(most));
}

Outcome least_squares_scheme(const Context& context, const std::string& id, bool even) {
  return in_both_forms([&](Form form) { return least_squares(context, id, even, form); });
}

Outcome lemma_1_positions(const Context& context) {
  const std::vector<Formula> xs = context.list("lemma-1-x"), ys = context.list("lemma-1-y");
  Trial trial = summation_range(context.formula("variant-first"), context.formula("variant-last"), false);
  // (10) is (psi_1 + x psi_2 + y psi_3)/kappa (see eq-10), on whatever nodes; here against random weights.
  for (long n = 1; n <= context.reach(2, 3) && !trial.failed(); ++n) {
    const WeightedWindow data = random_window(-n, n, 2, 4);
    const Values values = sums_of_surface(context, data, -n, n);
    const std::vector<Rational> beta = weighted_coefficients(data, plane);
    for (std::size_t k = 0; k < 4; ++k) {
      Formula term = (f("psi1") + xs.at(k) * f("psi2") + ys.at(k) * f("psi3")) / f("kappa") * f("w") * f("f");
      for (const std::string name : {"1", "2", "3"})
        term = term.replaced("psi" + name, context.formula("eq-11-psi-" + name));
      const Rational derived = beta[0] + (k % 2 == 0 ? -1 : 1) * beta[1] / 4 + (k / 2 == 0 ? -1 : 1) * beta[2] / 4;
      trial.equal(sum_over(data, term, -n, n, values), derived, "rule " + rule_names[k] + ", " + at("n", n));
    }
  }
  return trial.for_all("all n >= 1 and all positive weights",
                       "(10) holds for any nodes; the positions are symmetric about the middle datum");
}

Outcome lemma_1_starting_values(const Context& context) {
  const auto beta = [&](const std::string& k) { return context.formula("lemma-1-beta-" + k); };
  const GridFit ordinary{
      beta("1") + f("x") * beta("2") + f("y") * beta("3"), {-1, 0}, {1, 0}, f("x"), f("y"), 1, 1, {{"x", 0}, {"y", 0}}};
  return grid_fit(ordinary, context.reach(4, 8));
}

/// Whether the grid of n determines polynomials of total degree d.
bool determines(long n, long degree) {
  const WeightedWindow nodes = window(1 - n, n, 2);
  std::vector<Formula> basis;
  for (long i = 0; i <= degree; ++i)
    for (long j = 0; i + j <= degree; ++j) basis.push_back(f("r^" + std::to_string(i) + "*s^" + std::to_string(j)));
  return kernel(normal_matrix(nodes, basis)).empty();
}

/// For which n of a form the observations determine the 6 coefficients of a quadratic.
Trial determined_quadratics(const Context& context, Form form) {
  Trial trial;
  const long smallest = static_cast<long>(numerator(context.formula("higher-degree-n", form)({})));
  for (long n = smallest; n <= 4; ++n)
    trial.require(determines(n, 2), at("n", n) + ": the " + std::to_string(4 * n * n) +
                                        " observations do not determine the 6 coefficients of a quadratic");
  return trial;
}

Outcome higher_degree(const Context& context) {
  Trial trial = determined_quadratics(context, Form::corrected);
  const Rational smallest = context.formula("higher-degree-n", Form::corrected)({});
  trial.require(!determines(static_cast<long>(numerator(smallest)) - 1, 2), "a smaller n determines quadratics, too");
  trial.equal(context.formula("higher-degree-count")({{"n", 3}}), Rational(window(-2, 3, 2).nodes.size()),
              "n = 3, number of observations");
  return trial
      .for_all("degree 2, all n >= 2",
               "2n values of each variable determine polynomials of degree up to 2n - 1; degree d needs 2n > d")
      .but_not("n = 1", determined_quadratics(context, Form::printed));
}

Outcome hyperplanes(const Context& context) {
  const Formula space = context.formula("hyperplane-space");
  Trial trial;
  for (int p = 1; p <= 5; ++p) {
    const std::size_t corners = std::size_t{1} << p;
    RationalMatrix design(corners, static_cast<std::size_t>(p) + 1);
    for (std::size_t i = 0; i < corners; ++i) {
      design(i, 0) = 1;
      for (int k = 0; k < p; ++k) design(i, static_cast<std::size_t>(k) + 1) = Rational((i >> k) & 1);
    }
    trial.equal(space({{"p", p}}), design.columns(), at("p", p) + ", coordinates of an observation");
    trial.require(kernel(design).empty(), at("p", p) + ": the corners of a cube do not determine a hyperplane");
  }
  return trial.for_all(
      "all p and n >= 1",
      "the corners 0 and the p unit vectors determine 1 + p coefficients, so that the weighted normal equations "
      "are positive definite; checked for p = 1..5");
}

}  // namespace

Checks surface_variants() {
  return {{"hyperplane", hyperplanes},
          {"higher-degree", higher_degree},
          {"surface-s-2n", [](const Context& c) { return least_squares_scheme(c, "surface-s-2n", true); }},
          {"lemma-1", lemma_1_positions},
          {"lemma-1-start", lemma_1_starting_values},
          {"surface-s-2n-1", [](const Context& c) { return least_squares_scheme(c, "surface-s-odd", false); }}};
}

}  // namespace subcert::statements::mustafa_li_2015
