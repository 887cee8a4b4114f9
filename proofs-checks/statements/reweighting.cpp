#include "reweighting.hpp"

#include "normal_equations.hpp"

#include <subcert/schemes/data/l1/l1_regression.hpp>
#include <subcert/schemes/outlier_remainder.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace subcert::statements {
namespace {

std::string square_at(long n, long r, long s) { return at("n", n) + ", " + at("r", r) + ", " + at("s", s); }

/// x^i y^j with i + j <= degree.
std::vector<std::pair<long, long>> exponents(long degree) {
  std::vector<std::pair<long, long>> result;
  for (long total = 0; total <= degree; ++total)
    for (long j = 0; j <= total; ++j) result.emplace_back(total - j, j);
  return result;
}

}  // namespace

WeightedWindow window(long first, long last, int variables) {
  WeightedWindow result;
  for (long s = variables == 1 ? 0 : first; s <= (variables == 1 ? 0 : last); ++s)
    for (long r = first; r <= last; ++r) result.nodes.emplace_back(r, s);
  result.weights.assign(result.nodes.size(), 1);
  result.data.assign(result.nodes.size(), 0);
  return result;
}

WeightedWindow random_window(long first, long last, int variables, unsigned seed) {
  std::mt19937 engine(seed);
  const auto up_to = [&](unsigned long most) { return static_cast<long>(engine() % most + 1); };
  WeightedWindow result = window(first, last, variables);
  for (Rational& weight : result.weights) weight = Rational(up_to(9), up_to(9));
  for (Rational& datum : result.data) datum = Rational(up_to(19) - 10, up_to(9));
  return result;
}

Trial on_random_windows(long first_n, long last_n, bool even, unsigned seeds,
                        const std::function<Trial(long n, const WeightedWindow&, const std::string& where)>& visit) {
  Trial trial;
  for (long n = first_n; n <= last_n; ++n)
    for (unsigned seed = 1; seed <= seeds; ++seed)
      if (!trial.follow(visit(n, random_window(even ? 1 - n : -n, n, 1, seed), weighted_case(n, seed)))) return trial;
  return trial;
}

std::vector<Variable> numbered(const std::string& name, int count) {
  std::vector<Variable> result;
  for (int k = 1; k <= count; ++k) result.push_back({name + std::to_string(k), k});
  return result;
}

std::vector<Formula> numbered_formulas(const Context& context, const std::string& prefix, int count) {
  std::vector<Formula> result;
  for (const Variable& id : numbered(prefix, count)) result.push_back(context.formula(id.name));
  return result;
}

void add_sums(Values& to, const std::string& name, const std::vector<Formula>& terms, const WeightedWindow& window,
              long first, long last) {
  for (std::size_t k = 0; k < terms.size(); ++k)
    to.emplace_back(name + std::to_string(k + 1), sum_over(window, terms[k], first, last));
}

Rational library_value(const WeightedWindow& window, int degree, const Rational& x, const Rational& y) {
  std::vector<data::Position> nodes;
  for (const auto& [r, s] : window.nodes) nodes.push_back({r, s});
  return data::weighted_fit(data::RegressionWindow(nodes, degree, {{x, y}}), window.weights, window.data).front();
}

Rational sum_over(const WeightedWindow& window, const Formula& term, long first, long last, const Values& names) {
  Rational sum = 0;
  for (std::size_t i = 0; i < window.nodes.size(); ++i) {
    const auto [r, s] = window.nodes[i];
    if (r < first || r > last || s < std::min(first, 0L) || s > last) continue;
    Values values{{"r", r}, {"s", s}, {"w", window.weights[i]}, {"f", window.data[i]}};
    values.insert(values.end(), names.begin(), names.end());
    sum += term(values);
  }
  return sum;
}

RationalMatrix normal_matrix(const WeightedWindow& window, const std::vector<Formula>& basis) {
  RationalMatrix result(basis.size(), basis.size());
  for (std::size_t i = 0; i < window.nodes.size(); ++i) {
    const Values node{{"r", window.nodes[i].first}, {"s", window.nodes[i].second}};
    std::vector<Rational> row;
    for (const Formula& member : basis) row.push_back(member(node));
    for (std::size_t k = 0; k < row.size(); ++k)
      for (std::size_t l = 0; l < row.size(); ++l) result(k, l) += row[k] * row[l] * window.weights[i];
  }
  return result;
}

std::vector<Rational> weighted_coefficients(const WeightedWindow& window, const std::vector<Formula>& basis) {
  RationalMatrix right(basis.size(), 1);
  for (std::size_t i = 0; i < window.nodes.size(); ++i)
    for (std::size_t k = 0; k < basis.size(); ++k)
      right(k, 0) += basis[k]({{"r", window.nodes[i].first}, {"s", window.nodes[i].second}}) * window.weights[i] *
                     window.data[i];
  const RationalMatrix solution = solved(normal_matrix(window, basis), right);
  std::vector<Rational> result;
  for (std::size_t k = 0; k < basis.size(); ++k) result.push_back(solution(k, 0));
  return result;
}

Formula coefficient_of_datum(const Formula& term) { return term.replaced("w", f("1")).replaced("f", f("1")); }

Trial is_weighted_datum(const Formula& term, const std::vector<Variable>& names) {
  std::vector<Variable> variables = names;
  variables.push_back({"w", 1});
  variables.push_back({"f", 1});
  return identity(term, coefficient_of_datum(term) * f("w") * f("f"), variables);
}

Trial weighted_moments(const Formula& rule, int degree, const std::vector<Formula>& moments,
                       const std::vector<Variable>& start) {
  Trial trial;
  const Degrees in_node = rule.degrees("r");
  if (!trial.require(degree <= 1 && in_node.denominator == 0 && in_node.numerator <= degree,
                     "the rule is not shown to be linear in r"))
    return trial;
  const Formula constant = rule.replaced("r", f("0")), slope = rule.replaced("r", f("1")) - constant;
  for (std::size_t k = 0; k < moments.size() && !trial.failed(); ++k) {
    const std::string tau = "tau" + std::to_string(k + 1), next = "tau" + std::to_string(k + 2);
    trial.follow(identity(constant * f(tau) + slope * f(next), moments[k], start));
  }
  return trial;
}

Trial adjoint_identity(const std::vector<std::vector<Formula>>& matrix,
                       const std::vector<std::vector<Formula>>& adjoint, const Formula& determinant,
                       const std::vector<Variable>& variables) {
  Trial trial;
  for (std::size_t i = 0; i < matrix.size(); ++i)
    for (std::size_t j = 0; j < matrix.size() && !trial.failed(); ++j) {
      Formula entry = matrix[i][0] * adjoint[0][j];
      for (std::size_t k = 1; k < matrix.size(); ++k) entry = entry + matrix[i][k] * adjoint[k][j];
      trial.follow(identity(entry, i == j ? determinant : f("0"), variables));
    }
  return trial;
}

namespace {

Trial compared(const GridFit& fit, long n) {
  WeightedWindow nodes = window(fit.first(n), fit.last(n), 2);
  std::vector<Formula> basis;
  for (const auto& [i, j] : exponents(fit.degree))
    basis.push_back(f("r^" + std::to_string(i) + "*s^" + std::to_string(j)));
  Values values;
  for (const Variable& parameter : fit.parameters)
    values.emplace_back(parameter.name, Rational(2 * parameter.start + 1, 3));
  const Rational x = fit.x(values), y = fit.y(values);
  // (A^T A)^-1 e(x, y): the weights are A times this.
  RationalMatrix position(basis.size(), 1);
  for (std::size_t k = 0; k < basis.size(); ++k) position(k, 0) = basis[k]({{"r", x}, {"s", y}});
  const RationalMatrix dual = solved(normal_matrix(nodes, basis), position);
  values.emplace_back("n", n);
  Trial trial;
  for (const auto& [r, s] : nodes.nodes) {
    Rational derived = 0;
    for (std::size_t k = 0; k < basis.size(); ++k) derived += dual(k, 0) * basis[k]({{"r", r}, {"s", s}});
    Values where = values;
    where.emplace_back("r", r);
    where.emplace_back("s", s);
    if (!trial.equal(fit.weight(where), derived, square_at(n, r, s))) break;
  }
  return trial;
}

/// Sums of weight r^i s^j for one n and given parameters.
Trial moments_at(const GridFit& fit, const Values& point) {
  const long n = static_cast<long>(numerator(point.front().second));
  const auto powers = exponents(fit.degree);
  std::vector<Rational> sums(powers.size(), 0);
  for (long r = fit.first(n); r <= fit.last(n); ++r)
    for (long s = fit.first(n); s <= fit.last(n); ++s) {
      Values where = point;
      where.emplace_back("r", r);
      where.emplace_back("s", s);
      const Rational weight = fit.weight(where);
      for (std::size_t k = 0; k < powers.size(); ++k)
        sums[k] += weight * power(Rational(r), powers[k].first) * power(Rational(s), powers[k].second);
    }
  Trial trial;
  const Rational x = fit.x(point), y = fit.y(point);
  for (std::size_t k = 0; k < powers.size(); ++k)
    trial.equal(
        sums[k], power(x, powers[k].first) * power(y, powers[k].second),
        to_text(point) + ", moment " + std::to_string(powers[k].first) + ", " + std::to_string(powers[k].second));
  return trial;
}

/// All points of a product grid, the first variable slowest.
std::vector<Values> grid(const std::vector<Variable>& variables, const std::vector<long>& counts) {
  std::vector<Values> points{{}};
  for (std::size_t i = 0; i < variables.size(); ++i) {
    std::vector<Values> more;
    for (const Values& point : points)
      for (long step = 0; step < counts[i]; ++step) {
        more.push_back(point);
        more.back().emplace_back(variables[i].name, variables[i].start + step);
      }
    points = more;
  }
  return points;
}

}  // namespace

Trial grid_fit(const GridFit& fit, long largest_n) {
  Trial trial;
  for (long n = fit.smallest_n; n <= largest_n && !trial.failed(); ++n) trial.follow(compared(fit, n));
  const Degrees in_node = fit.weight.degrees(std::vector<std::string>{"r", "s"}), in_n = fit.weight.degrees("n");
  if (!trial.require(in_node.denominator == 0 && in_node.numerator <= fit.degree,
                     "the weights are not shown to be a polynomial of degree " + std::to_string(fit.degree)))
    return trial;
  // A sum of r^a s^b over the square has degree a + b + 2 in n.
  std::vector<Variable> variables{{"n", fit.smallest_n}};
  std::vector<long> counts{std::max(in_n.numerator + 2 * fit.degree + 2, in_n.denominator) + 1};
  for (const Variable& parameter : fit.parameters) {
    const Degrees degrees = fit.weight.degrees(parameter.name);
    variables.push_back(parameter);
    counts.push_back(std::max(degrees.numerator, fit.degree + degrees.denominator) + 1);
  }
  for (const Values& point : grid(variables, counts))
    if (!trial.follow(moments_at(fit, point))) break;
  return trial.for_all("all n >= " + std::to_string(fit.smallest_n),
                       "the weights are a polynomial of degree <= " + std::to_string(fit.degree) +
                           " in the node and reproduce all monomials up to that degree, as identities in n; also "
                           "compared with the normal equations up to n = " +
                           std::to_string(largest_n));
}

std::string weighted_case(long n, unsigned seed) { return at("n", n) + ", random weights " + std::to_string(seed); }

Trial weights_of_modulus(const Formula& bracket, const Rational& exponent, const Formula& residual,
                         const std::vector<Variable>& names) {
  // h = B^e and w = B^-e, so that h' = e B^(e-1) B' equals t w if B' = 2t and e = 1/2; B is quadratic in f.
  Trial trial = identity(bracket.replaced("f", f("f + 1")) - bracket.replaced("f", f("f - 1")), f("4") * residual,
                         names);
  trial.follow(identity(bracket - residual * residual, f("delta"), names));
  trial.equal(exponent, Rational(1, 2), "exponent");
  return trial.for_all("all residuals and delta > 0", "h'(t) = t w with h(t) = (t^2 + delta)^(1/2), w = 1/h(t)");
}

Trial smoothed_above_modulus(const Formula& bracket, const Formula& residual, const std::vector<Variable>& names) {
  // t^2 <= t^2 + e^2 = (|t| + e)^2 - 2 |t| e.
  const Formula h_squared = bracket.replaced("delta", f("e^2"));
  Trial trial = identity((residual + f("e")) * (residual + f("e")) - h_squared, f("2*e") * residual, names);
  return trial.for_all("all residuals and delta > 0", "|t| <= (t^2 + delta)^(1/2) <= |t| + delta^(1/2)");
}

Trial fits_go_down(const Formula& bracket, const Formula& residual, const std::vector<Variable>& names) {
  // h h'' = 1 - h'^2 = 1 - t^2/h^2 = delta/h^2.
  Trial trial = identity(bracket - residual * residual, f("delta"), names);
  trial.follow(identity(f("(k^2 + h^2)/(2*k) - h"), f("(h - k)^2/(2*k)"), {{"h", 1}, {"k", 2}}));
  return trial.for_all("all data, delta > 0 and epsilon > 0",
                       "F_delta is strictly convex, as h'' = delta/h^3 > 0, and has one minimiser. A step minimises a "
                       "sum that is nowhere below F_delta and equals it where the step begins, so that F_delta falls "
                       "until the minimiser is met; the coefficients converge to it from every start");
}

Trial advised_fits(const std::vector<Formula>& advised, const std::vector<std::pair<int, int>>& windows) {
  Trial trial;
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational part(1, k == 0 ? 50 : 100), m = advised.at(k)({});
    trial.equal(m, iterations_for_remainder(6, 1, part).value() - 1,
                fmt::format("the fewest m that leave at most {} of an outlier, 6 points, degree 1", part));
    for (const auto& [points, degree] : windows) {
      const auto left = outlier_remainder(points, degree, static_cast<int>(numerator(m)) + 1);
      trial.require(left && *left->upper <= part,
                    fmt::format("{} points, degree {}, m = {}: more than {} is left", points, degree, m, part));
    }
  }
  return trial;
}

Trial entries_of_normal_equations(const std::vector<Formula>& terms, const std::vector<std::string>& expected) {
  Trial trial;
  for (std::size_t k = 0; k < terms.size(); ++k)
    trial.follow(identity(terms[k], f(expected[k]), {{"r", 1}, {"s", 2}, {"w", 3}, {"f", 5}}));
  return trial.for_all("all n and all weights", "term by term the entries of the normal equations");
}

Trial summation_range(const Formula& first, const Formula& last, bool even) {
  Trial trial = identity(first + last, f(even ? "1" : "0"), {{"n", 1}});
  trial.follow(identity(last - first + f("1"), f(even ? "2*n" : "2*n + 1"), {{"n", 1}}));
  return trial;
}

Trial moving_index(const Formula& index, const std::string& axis, const std::string& node) {
  Trial trial;
  for (long step : {0, 1})
    trial.equal(index({{axis, step}, {node, 0}}), step,
                axis + " = " + std::to_string(step) + ", " + node + " = 0, the datum used");
  trial.follow(identity(index, f(axis + " + " + node), {{axis, 0}, {node, 0}}));
  return trial;
}

}  // namespace subcert::statements
