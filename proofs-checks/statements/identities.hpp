#pragma once
/// Identities of rational functions, proved from finitely many exact values. Why that is a proof:
/// docs/statements.md, section 3.

#include "trial.hpp"

namespace subcert::statements {

/// A variable and the integers start, start + 1, ... at which it is tried.
struct Variable {
  std::string name;
  long start;
};

/// slope n + offset.
struct Line {
  long slope;
  long offset;
  long operator()(long n) const { return slope * n + offset; }
};

/// left = right for all values of the variables where both are defined. Domain: both are defined at the points tried,
/// which follow each start. Errors: throws Undefined otherwise. Cost: the product of the degrees plus 1.
Trial identity(const Formula& left, const Formula& right, const std::vector<Variable>& variables);

/// sum of term over index = first(n), ..., last(n).
struct FiniteSum {
  Formula term;
  std::string index;
  Line first;
  Line last;
};

/// sum = value for all integers n from variables[0].start on, and for all values of the other variables. Domain: as
/// identity, and last(n) >= first(n) - 1 for those n. A term that is not a polynomial in the index fails.
Trial sum_identity(const FiniteSum& sum, const Formula& value, const std::vector<Variable>& variables);

/// formula > 0 wherever its names have the values given as polynomials in x, y, z with x, y, z >= 0 (all real): decided
/// by the signs of the coefficients, so a failure does not refute the claim.
Trial positive(const Formula& formula, const std::vector<std::pair<std::string, std::string>>& substitution);

/// A local polynomial fit whose weights have a closed form: `weight`, a function of n, `index` and the parameters, is
/// the weight of the datum at node(index), for index = first(n), ..., last(n); the fit has this degree and is evaluated
/// at `position`, a function of the parameters and of n. Domain: node.slope is 1 or -1.
struct Fit {
  Formula weight;
  std::string index;
  Line first;
  Line last;
  Line node;
  Formula position;
  int degree;
  long smallest_n;
  std::vector<Variable> parameters;
};

/// The parameters that belong to n, from the smallest on.
using Cases = std::function<std::vector<Values>(long n)>;

/// Compares with regression_weights() for n up to largest_n in all cases, then proves the form for all n >= smallest_n
/// and all values of the parameters: the weights are a polynomial of at most this degree in the node, and the fit
/// reproduces the monomials up to this degree, which characterises them. Cost: proof: a grid as large as the degrees.
Trial fit(const Fit& fit, long largest_n, const Cases& cases = {});

}  // namespace subcert::statements
