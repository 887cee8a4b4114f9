#include "identities.hpp"

#include <subcert/schemes/local_regression.hpp>

#include <algorithm>
#include <cstdlib>

namespace subcert::statements {
namespace {

/// Calls visit on all points of a product grid until it returns false.
void on_grid(const std::vector<Variable>& variables, const std::vector<long>& counts,
             const std::function<bool(const Values&)>& visit) {
  Values point;
  for (const Variable& variable : variables) point.emplace_back(variable.name, Rational(variable.start));
  std::vector<long> at(variables.size(), 0);
  for (;;) {
    if (!visit(point)) return;
    std::size_t i = variables.size();
    while (i > 0 && at[i - 1] + 1 == counts[i - 1]) {
      --i;
      at[i] = 0;
      point[i].second = variables[i].start;
    }
    if (i == 0) return;
    ++at[i - 1];
    point[i - 1].second += 1;
  }
}

/// A bound for the degree of the numerator of left - right.
long difference_degree(const Degrees& left, const Degrees& right) {
  return std::max(left.numerator + right.denominator, right.numerator + left.denominator);
}

Degrees power_degrees(const Degrees& base, long exponent) {
  return {base.numerator * exponent, base.denominator * exponent};
}

/// Degrees in n of a sum over a range of length linear in n, for a term that is a polynomial in the index.
Degrees sum_degrees(const Formula& term, const std::string& n, const std::string& index, long more_in_index) {
  Degrees degrees = term.degrees(n);
  degrees.numerator += term.degrees(index).numerator + more_in_index + 1;
  return degrees;
}

Values with(Values values, const std::string& name, const Rational& value) {
  values.emplace_back(name, value);
  return values;
}

}  // namespace

Trial identity(const Formula& left, const Formula& right, const std::vector<Variable>& variables) {
  std::vector<long> counts;
  for (const Variable& v : variables)
    counts.push_back(difference_degree(left.degrees(v.name), right.degrees(v.name)) + 1);
  Trial trial;
  on_grid(variables, counts,
          [&](const Values& point) { return trial.equal(left(point), right(point), to_text(point)); });
  return trial.for_all("all parameters", "an identity of rational functions");
}

Trial sum_identity(const FiniteSum& sum, const Formula& value, const std::vector<Variable>& variables) {
  Trial trial;
  if (!trial.require(sum.term.degrees(sum.index).denominator == 0, "the term is not a polynomial in " + sum.index))
    return trial;
  std::vector<long> counts;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string& name = variables[i].name;
    const Degrees degrees = i == 0 ? sum_degrees(sum.term, name, sum.index, 0) : sum.term.degrees(name);
    counts.push_back(difference_degree(degrees, value.degrees(name)) + 1);
  }
  on_grid(variables, counts, [&](const Values& point) {
    const long n = static_cast<long>(numerator(point.front().second));
    Rational total = 0;
    for (long j = sum.first(n); j <= sum.last(n); ++j) total += sum.term(with(point, sum.index, j));
    return trial.equal(total, value(point), to_text(point));
  });
  return trial.for_all("all parameters", "a sum of a polynomial over a range that grows linearly with n");
}

Trial positive(const Formula& formula, const std::vector<std::pair<std::string, std::string>>& substitution) {
  const auto variable = [](int i) {
    return MultivariatePolynomial::in_variable(3, i, LaurentPolynomial::monomial(1, 1));
  };
  const std::vector<std::pair<std::string, MultivariatePolynomial>> names{
      {"x", variable(0)}, {"y", variable(1)}, {"z", variable(2)}};
  std::vector<std::pair<std::string, MultivariatePolynomial>> values;
  for (const auto& [name, text] : substitution) {
    const Fraction f = Formula::parse(text).substituted(names);
    values.emplace_back(name, *f.numerator.exact_quotient(f.denominator));
  }
  const auto sign = [](const MultivariatePolynomial& p) {
    const Rational constant = p.coefficient({0, 0, 0});
    for (const auto& term : p.terms())
      if ((constant > 0) != (term.coefficient > 0)) return 0;
    return constant > 0 ? 1 : constant < 0 ? -1 : 0;
  };
  const Fraction fraction = formula.substituted(values);
  Trial trial;
  trial.require(sign(fraction.numerator) * sign(fraction.denominator) > 0,
                "the signs of the coefficients do not show that " + formula.to_latex() + " > 0");
  return trial.for_all("all parameters",
                       "all coefficients have one sign after a substitution of non-negative variables");
}

namespace {

/// The moments of the weights on a grid that is large enough for all of them.
Trial moments(const Fit& fit) {
  Trial trial;
  const Degrees in_index = fit.weight.degrees(fit.index);
  if (!trial.require(
          in_index.denominator == 0 && in_index.numerator <= fit.degree,
          "the weights are not shown to be a polynomial of degree " + std::to_string(fit.degree) + " in " + fit.index))
    return trial;
  std::vector<Variable> variables{{"n", fit.smallest_n}};
  variables.insert(variables.end(), fit.parameters.begin(), fit.parameters.end());
  std::vector<long> counts;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string& name = variables[i].name;
    long most = 0;
    for (long k = 0; k <= fit.degree; ++k) {
      const Degrees sum = i == 0 ? sum_degrees(fit.weight, name, fit.index, k) : fit.weight.degrees(name);
      most = std::max(most, difference_degree(sum, power_degrees(fit.position.degrees(name), k)));
    }
    counts.push_back(most + 1);
  }
  on_grid(variables, counts, [&](const Values& point) {
    const long n = static_cast<long>(numerator(point.front().second));
    std::vector<Rational> sums(static_cast<std::size_t>(fit.degree) + 1, 0);
    for (long j = fit.first(n); j <= fit.last(n); ++j) {
      Rational weight = fit.weight(with(point, fit.index, j));
      for (Rational& sum : sums) {
        sum += weight;
        weight *= fit.node(j);
      }
    }
    Rational expected = 1;
    const Rational x = fit.position(point);
    for (std::size_t k = 0; k < sums.size(); ++k, expected *= x)
      if (!trial.equal(sums[k], expected, to_text(point) + ", moment " + std::to_string(k))) return false;
    return true;
  });
  return trial;
}

}  // namespace

Trial fit(const Fit& fit, long largest_n, const Cases& cases) {
  Trial trial;
  for (long n = fit.smallest_n; n <= largest_n && !trial.failed(); ++n) {
    for (const Values& parameters : cases ? cases(n) : std::vector<Values>{{}}) {
      Values point{{"n", n}};
      point.insert(point.end(), parameters.begin(), parameters.end());
      std::vector<Rational> nodes;
      for (long j = fit.first(n); j <= fit.last(n); ++j) nodes.push_back(fit.node(j));
      const auto derived = regression_weights(nodes, {}, fit.degree, fit.position(point));
      for (long j = fit.first(n); j <= fit.last(n); ++j) {
        const Values where = with(point, fit.index, j);
        if (!trial.equal(fit.weight(where), derived[static_cast<std::size_t>(j - fit.first(n))], to_text(where)))
          return trial;
      }
    }
  }
  trial.follow(moments(fit));
  return trial.for_all(
      "all n >= " + std::to_string(fit.smallest_n),
      "the weights are a polynomial of degree <= " + std::to_string(fit.degree) +
          " in the node and reproduce all monomials up to that degree, for all parameters; also compared "
          "weight by weight with the library up to n = " +
          std::to_string(largest_n));
}

}  // namespace subcert::statements
