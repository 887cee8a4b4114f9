#include "normal_equations.hpp"

namespace subcert::statements {

RationalMatrix design_matrix(const std::vector<Rational>& nodes, const std::vector<Formula>& basis) {
  RationalMatrix design(nodes.size(), basis.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t k = 0; k < basis.size(); ++k) design(i, k) = basis[k]({{"x", nodes[i]}});
  return design;
}

std::vector<Formula> monomials(int degree) {
  std::vector<Formula> result;
  for (int k = 0; k <= degree; ++k) result.push_back(Formula::parse("x^" + std::to_string(k)));
  return result;
}

RationalMatrix solved(const RationalMatrix& a, const RationalMatrix& b) {
  try {
    return solve(a, b);
  } catch (const Error& error) {
    throw Undefined(error.what());
  }
}

RationalMatrix pseudo_inverse(const RationalMatrix& design) {
  const RationalMatrix across = transposed(design);
  return solved(across * design, across);
}

std::vector<Rational> weights_by_normal_equations(const std::vector<Rational>& nodes, const std::vector<Formula>& basis,
                                                  const Rational& x) {
  const RationalMatrix at_x = design_matrix({x}, basis) * pseudo_inverse(design_matrix(nodes, basis));
  std::vector<Rational> weights;
  for (std::size_t i = 0; i < nodes.size(); ++i) weights.push_back(at_x(0, i));
  return weights;
}

std::vector<Rational> equidistant(const Rational& first, const Rational& step, int count) {
  std::vector<Rational> result;
  for (int i = 0; i < count; ++i) result.push_back(first + i * step);
  return result;
}

}  // namespace subcert::statements
