// Section 2: a-ary schemes from cubic fits to 2n and to 2n+1 data.

#include "mustafa_bari_2016.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/proofs-checks/statements/mask_form.hpp>
#include <subcert/proofs-checks/statements/normal_equations.hpp>
#include <subcert/schemes/local_regression.hpp>

namespace subcert::statements::mustafa_bari_2016 {
namespace {

std::string range(int n, int a) { return "n = 2.." + std::to_string(n) + ", a = 2.." + std::to_string(a); }

/// p_{r,n}/phi_n as a function of n, a, q and r.
Formula weights_2_4(const Context& context) {
  return (context.formula("mustafa-bari-2016/p") / context.formula("mustafa-bari-2016/phi"))
      .replaced("omega", context.formula("mustafa-bari-2016/omega"));
}

Outcome equation_2_4(const Context& context) {
  const int arities = context.reach(4, 6);
  const Fit cubic{
      weights_2_4(context), "r", {-1, 1}, {1, 0}, {1, 0}, context.formula("mustafa-bari-2016/position-2n"), 3, 2,
      {{"a", 1}, {"q", 0}}};
  return fit(cubic, context.reach(4, 8),
             [&](long) {
               std::vector<Values> cases;
               for (int a = 2; a <= arities; ++a)
                 for (int q = 0; q < a; ++q) cases.push_back({{"a", a}, {"q", q}});
               return cases;
             })
      .outcome();
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
  return context.formula("mustafa-bari-2016/b", form) / context.formula("mustafa-bari-2016/psi", form);
}

Outcome equation_2_5(const Context& context, int first_arity) {
  const int arities = first_arity + context.reach(2, 4);
  const auto trial = [&](Form form) {
    const Fit cubic{weights_2_5(context, form),
                    "r",
                    {-1, 0},
                    {1, 0},
                    {1, 0},
                    context.formula("mustafa-bari-2016/position-odd", form),
                    3,
                    2,
                    {{"a", 1}, {"q", 0}}};
    return fit(cubic, context.reach(4, 8), [&](long) { return positions(first_arity, arities); });
  };
  return trial(Form::printed).outcome(trial(Form::corrected));
}

/// 0 and +-first, +-(first+step), ..., +-last must be a places at equal distances.
Outcome positions_odd_arity(const Context& context) {
  Trial printed, corrected;
  for (Form form : {Form::printed, Form::corrected}) {
    Trial& trial = form == Form::printed ? printed : corrected;
    const Rational first = context.formula("mustafa-bari-2016/odd-first", form)({});
    const Rational step = context.formula("mustafa-bari-2016/odd-step", form)({});
    for (long a = 3; a <= context.reach(15, 51); a += 2) {
      const Rational last = context.formula("mustafa-bari-2016/odd-last", form)({{"a", a}});
      const Rational steps = (last - first) / step;
      const std::string where = at("a", a) + ": from 0 to " + subcert::to_text(first) + " and on by " +
                                subcert::to_text(step) + " to " + subcert::to_text(last);
      trial.require(denominator(steps) == 1, where + ", which is not reached");
      trial.require(first == step, where + " the distances differ");
      trial.equal(a, 2 * (steps + 1) + 1, where + ", number of positions");
    }
    trial.over("odd a = 3.." + std::to_string(context.reach(15, 51)));
  }
  return printed.outcome(corrected);
}

Outcome positions_even_arity(const Context& context) {
  Trial trial;
  const Rational first = context.formula("mustafa-bari-2016/even-first")({}),
                 step = context.formula("mustafa-bari-2016/even-step")({});
  const int most = context.reach(16, 50);
  for (long a = 2; a <= most; a += 2) {
    const Rational steps = (context.formula("mustafa-bari-2016/even-last")({{"a", a}}) - first) / step;
    trial.require(denominator(steps) == 1 && 2 * first == step, at("a", a) + ": not equally spaced");
    trial.equal(a, 2 * (steps + 1), at("a", a) + ", number of positions");
  }
  return trial.over("even a = 2.." + std::to_string(most)).outcome();
}

Outcome smallest_size(const Context& context) {
  const Rational printed_bound = context.formula("mustafa-bari-2016/smallest-n")({});
  const Rational corrected_bound = context.formula("mustafa-bari-2016/smallest-n", Form::corrected)({});
  Trial printed, corrected;
  for (int n = 1; n <= 6; ++n) {
    const bool unique = kernel(design_matrix(equidistant(-n + 1, 1, 2 * n), monomials(3))).empty();
    printed.require(unique == (n > printed_bound), at("n", n) + ": the cubic fit to " + std::to_string(2 * n) +
                                                       " data is unique, and the paper uses it after (2.6), but " +
                                                       subcert::to_text(printed_bound) + " is not exceeded");
    corrected.require(unique == (n > corrected_bound), at("n", n));
  }
  return printed.outcome(corrected.over("n = 1..6"));
}

Outcome four_point_binary(const Context& context) {
  const Formula weight = weights_2_4(context);
  Trial trial;
  for (int q : {0, 1}) {
    const auto inserted = weights_by_normal_equations(equidistant(-1, 1, 4), monomials(3), Rational(2 * q + 1, 4));
    for (int r = -1; r <= 2; ++r)
      trial.equal(weight({{"n", 2}, {"a", 2}, {"q", q}, {"r", r}}), inserted[static_cast<std::size_t>(r + 1)],
                  at("q", q) + ", " + at("r", r));
  }
  trial.require(regression_mask(ary(2, 4, 3)) == regression_mask(dual(2, 3)), "not the dual 4-point scheme");
  return trial.over("n = 2, a = 2").outcome();
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
  return trial
      .for_all("all n >= 2",
               "each family has one member of every degree 0, ..., 3 and so spans the cubics, on which the fit does "
               "not depend; compared for n = 2.." +
                   std::to_string(most))
      .outcome();
}

Outcome sums_2n(const Context& context) {
  return sum_identity({weights_2_4(context), "r", {-1, 1}, {1, 0}}, f("1"), {{"n", 2}, {"a", 2}, {"q", 0}}).outcome();
}

Outcome sums_odd(const Context& context) {
  const auto trial = [&](Form form) {
    return sum_identity({weights_2_5(context, form), "r", {-1, 0}, {1, 0}}, f("1"), {{"n", 2}, {"a", 2}, {"q", 1}});
  };
  return trial(Form::printed).outcome(trial(Form::corrected));
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
      const Rational shift = polynomial_reproduction(mask).parametrization;
      const Values where{{"n", n}, {"a", a}};
      trial.equal(width(where), derived.upper - derived.lower, to_text(where) + ", width");
      trial.equal(-end(where), derived.lower - shift, to_text(where) + ", left end");
      trial.equal(end(where), derived.upper - shift, to_text(where) + ", right end");
    }
  Outcome outcome = trial.over(range(sizes, arities)).outcome();
  outcome.argument =
      "the interval is the one in which the datum f_j stands at j and the scheme is symmetric; with the new values at "
      "i/a^k it is shifted";
  return outcome;
}

/// Inversely proportional: a times the width would not depend on a.
Outcome inverse_proportion(const Context& context) {
  const Formula width = context.formula("mustafa-bari-2016/theorem-2.3-width");
  const Rational binary = 2 * width({{"n", 2}, {"a", 2}}), ternary = 3 * width({{"n", 2}, {"a", 3}});
  Trial printed, corrected;
  printed.require(binary == ternary, "n = 2: the width " + subcert::to_text(binary / 2) + " for a = 2 and " +
                                         subcert::to_text(ternary / 3) + " for a = 3, times a " +
                                         subcert::to_text(binary) + " and " + subcert::to_text(ternary));
  corrected.follow(identity(width, f("2*n + (2*n - 1)/(a - 1)"), {{"n", 2}, {"a", 2}}));
  Outcome outcome = printed.outcome(corrected.for_all("all n, a", "an identity"));
  if (outcome.verdict == Verdict::misprint) outcome.verdict = Verdict::false_claim;
  outcome.argument = "the width is 2n + (2n-1)/(a-1): it falls with a, but not below 2n";
  return outcome;
}

Outcome necessary_condition(const Context& context) {
  const int sizes = context.reach(6, 10), arities = context.reach(5, 8);
  Trial trial;
  for (int n = 2; n <= sizes; ++n)
    for (int a = 2; a <= arities; ++a)
      for (int points : {2 * n, 2 * n + 1})
        trial.require(is_affine(regression_mask(ary(a, points, 3))),
                      at("a", a) + ", " + std::to_string(points) + " points");
  return trial.over(range(sizes, arities) + ", 2n and 2n+1 points").outcome();
}

}  // namespace

void add_univariate(PaperStatements& to) {
  to.transcriptions.insert(
      to.transcriptions.end(),
      {
          {"mustafa-bari-2016/smallest-n", "{3 => 1}"},
          {"mustafa-bari-2016/omega", "q + 1/2"},
          {"mustafa-bari-2016/position-2n", "(2*q + 1)/(2*a)"},
          {"mustafa-bari-2016/phi", "8*n*(n^2 - 1)*(4*n^2 - 1)*(4*n^2 - 9)*a^3"},
          {"mustafa-bari-2016/p",
           "280*((3*n^2 - 3)*a^3 + omega*(-6*n^2 + 11)*a^2 - 15*omega^2*a + 10*omega^3)*r^3"
           " + ((-240*n^4 - 480*n^2 + 720)*a^3 + 600*omega*(3*n^2 - 5)*a^2 + 360*omega^2*(2*n^2 + 13)*a - "
           "4200*omega^3)*r^2"
           " + ((-360*n^4 + 960*n^2 - 600)*a^3 + 200*omega*(6*n^4 - 18*n^2 + 11)*a^2 + 600*omega^2*a*(3*n^2 - 5) - "
           "280*omega^3*(6*n^2 - 11))*r"
           " + 24*((6*n^4 - 5*n^2 - 6)*a^3 - 5*omega*(3*n^2 - 5)*a^2 - 10*omega^2*(n^2 + 3)*a + 35*omega^3)*(n^2 - 1)"},
          {"mustafa-bari-2016/position-odd", "q/(2*a)"},
          {"mustafa-bari-2016/psi", "8*n*(n + 2)*(2*n + 3)*(n^2 - 1)*(4*n^2 - 1)*a^3"},
          {"mustafa-bari-2016/b",
           "-35*q*(12*a^2*n^2 + 12*a^2*n - 4*a^2 - 5*q^2)*r^3"
           " {+ => -} 30*a*(n - 1)*(n + 2)*(4*a^2*n^2 + 4*a^2*n - 3*q^2)*r^2"
           " + 5*q*(60*a^2*n^4 + 120*a^2*n^3 - 21*q^2*n^2 - 21*n*q^2 - 60*a^2*n + 7*q^2 + 20*a^2)*r"
           " + 6*n*a*(n + 2)*(n^2 - 1)*(12*a^2*n^2 + 12*a^2*n - 4*a^2 - 5*q^2)"},
          {"mustafa-bari-2016/even-first", "1"},
          {"mustafa-bari-2016/even-step", "2"},
          {"mustafa-bari-2016/even-last", "a - 1"},
          {"mustafa-bari-2016/odd-first", "{1 => 2}"},
          {"mustafa-bari-2016/odd-step", "2"},
          {"mustafa-bari-2016/odd-last", "a - 1"},
          {"mustafa-bari-2016/theorem-2.3-width", "(2*a*n - 1)/(a - 1)"},
          {"mustafa-bari-2016/theorem-2.3-end", "(2*a*n - 1)/(2*(a - 1))"},
          {"mustafa-bari-2016/theorem-2.4-width", "((2*n + 1)*a - 1)/(a - 1)"},
          {"mustafa-bari-2016/theorem-2.4-end", "((2*n + 1)*a - 1)/(2*(a - 1))"},
      });
  const auto add = [&](const Statement& statement) { to.statements.push_back(statement); };
  add({"mustafa-bari-2016/necessary-condition", "section 1, second display",
       "The coset sums of a convergent scheme are 1.", "the derived masks of the families",
       R"(\sum_{j} \gamma_{aj+\mu} = 1, \quad \mu = 0, \dots, a-1)", "", Verdict::holds, necessary_condition});
  add({"mustafa-bari-2016/eq-2.2", "section 2, equations (2.1), (2.2) and (2.3)",
       "A cubic is fitted to 2n data with n > 3.", "for which n the fit is unique",
       R"(r = -n+1, \dots, n \text{ and } n > <<mustafa-bari-2016/smallest-n>>)",
       R"(r = -n+1, \dots, n \text{ and } n > <<mustafa-bari-2016/smallest-n>>)", Verdict::misprint, smallest_size});
  add({"mustafa-bari-2016/eq-2.4", "section 2, equation (2.4)", "The weights of the 2n-point a-ary schemes.",
       "every weight against the local cubic fits at (2q+1)/(2a)",
       R"(f_{ai+q}^{k+1} = \frac{1}{\phi_n} \sum_{r=-n+1}^n p_{r,n} f_r^k, \quad \phi_n = )"
       R"(<<mustafa-bari-2016/phi>>, \quad p_{r,n} = <<mustafa-bari-2016/p>>, \quad \omega = )"
       R"(<<mustafa-bari-2016/omega>>)",
       "", Verdict::holds_for_all, equation_2_4});
  const std::string printed =
      R"(\frac{1}{\psi_n} \sum_{r=-n}^n b_{r,n} f_r^k, \quad \psi_n = <<mustafa-bari-2016/psi>>, \quad b_{r,n} = )"
      R"(<<mustafa-bari-2016/b>>)";
  add({"mustafa-bari-2016/eq-2.5", "section 2.1, equation (2.5)",
       "The weights of the (2n+1)-point schemes of even arity.", "every weight against the local cubic fits at q/(2a)",
       printed, printed, Verdict::misprint, [](const Context& c) { return equation_2_5(c, 2); }});
  add({"mustafa-bari-2016/eq-2.5-positions", "section 2.1, before equation (2.5)", "The positions for even arity.",
       "that there are a of them at equal distances",
       R"(q = \pm 1, \pm 3, \pm 5, \dots, \pm(<<mustafa-bari-2016/even-last>>))", "", Verdict::holds,
       positions_even_arity});
  add({"mustafa-bari-2016/eq-2.6", "section 2.1, equation (2.6)",
       "The weights of the (2n+1)-point schemes of odd arity.", "every weight against the local cubic fits at q/(2a)",
       printed, printed, Verdict::misprint, [](const Context& c) { return equation_2_5(c, 3); }});
  add({"mustafa-bari-2016/eq-2.6-positions", "section 2.1, before equation (2.5), and section 2.2",
       "The positions for odd arity.", "that there are a of them at equal distances",
       R"(q = 0, \pm 1, \pm 3, \pm 5, \dots, \pm(<<mustafa-bari-2016/odd-last>>))",
       R"(q = 0, \pm 2, \pm 4, \dots, \pm(<<mustafa-bari-2016/odd-last>>))", Verdict::misprint, positions_odd_arity});
  add({"mustafa-bari-2016/four-point", "section 2.1, end",
       "For a = 2 and n = 2, (2.4) is the 4-point scheme of Dyn, Floater and Hormann.",
       "weights of cubic interpolation at 1/4 and 3/4", R"(a = 2, \; n = 2)", "", Verdict::holds, four_point_binary});
  add({"mustafa-bari-2016/bases", "section 2.1, end",
       "Gram, Laguerre, Legendre, Chebyshev and Hermite polynomials give the same schemes.",
       "weights by the normal equations in each basis", R"(\text{exactly the same schemes})", "",
       Verdict::holds_for_all, other_bases});
  add({"mustafa-bari-2016/sums-2n", "section 2.2", "The weights (2.4) sum to 1.", "the sum over r for all n, a, q",
       R"(\sum_{r=-n+1}^n \frac{p_{r,n}}{\phi_n} = 1)", "", Verdict::holds_for_all, sums_2n});
  add({"mustafa-bari-2016/sums-odd", "section 2.2", "The weights (2.5) and (2.6) sum to 1.",
       "the sum over r for all n, a, q",
       R"(\sum_{r=-n}^n \frac{b_{r,n}}{\psi_n} = 1, \quad b_{r,n} = <<mustafa-bari-2016/b>>)",
       R"(\sum_{r=-n}^n \frac{b_{r,n}}{\psi_n} = 1, \quad b_{r,n} = <<mustafa-bari-2016/b>>)", Verdict::misprint,
       sums_odd});
  add({"mustafa-bari-2016/theorem-2.3", "Theorem 2.3", "Support of the 2n-point basic limit functions.",
       "width and both ends",
       R"(\kappa = <<mustafa-bari-2016/theorem-2.3-width>>, \quad \pm <<mustafa-bari-2016/theorem-2.3-end>>)", "",
       Verdict::holds, [](const Context& c) { return support(c, "mustafa-bari-2016/theorem-2.3", true); }});
  add({"mustafa-bari-2016/theorem-2.4", "Theorem 2.4", "Support of the (2n+1)-point basic limit functions.",
       "width and both ends",
       R"(\kappa = <<mustafa-bari-2016/theorem-2.4-width>>, \quad \pm <<mustafa-bari-2016/theorem-2.4-end>>)", "",
       Verdict::holds, [](const Context& c) { return support(c, "mustafa-bari-2016/theorem-2.4", false); }});
  add({"mustafa-bari-2016/inverse-proportion", "section 2.2, end",
       "Arity and support width are inversely proportional.", "the width times the arity", R"(\kappa \propto 1/a)",
       R"(\kappa = 2n + \frac{2n-1}{a-1})", Verdict::false_claim, inverse_proportion});
  add({"mustafa-bari-2016/figs-1-5", "Figs. 1-5", "Basic limit functions, curves and surfaces.", "",
       R"(\text{figures})", "", Verdict::not_checkable, [](const Context&) {
         return not_checkable(
             "the control polygons and meshes were not published; the curves of Fig. 1 are drawn without numbers");
       }});
}

}  // namespace subcert::statements::mustafa_bari_2016
