#include "parametric_family.hpp"

#include <subcert/analysis/transition/transition.hpp>

namespace subcert {

std::optional<MatrixFamily> ParametricFamily::controls(const Box& box) const {
  const auto masks = mask.controls(box);
  if (!masks) return std::nullopt;
  std::vector<std::vector<RationalMatrix>> families;
  for (const LaurentPolynomial& control : *masks) families.push_back(matrices_of(control));
  std::vector<RationalMatrix> matrices;
  for (std::size_t t = 0; t < families.front().size(); ++t)
    for (std::vector<RationalMatrix>& family : families) matrices.push_back(std::move(family[t]));
  return MatrixFamily(std::move(matrices));
}

ParametricFamily transition_matrices(const ParametricMask& mask) {
  const IndexRange support = mask.support();
  const IndexRange window{0, TransitionWindow(support.last - support.first, mask.arity()).width - 1};
  return {mask, [arity = mask.arity(), first = support.first, window](const LaurentPolynomial& symbol) {
            std::vector<RationalMatrix> matrices;
            for (long t = 0; t < arity; ++t)
              matrices.push_back(transition_block(symbol.shifted(-first), arity, t, window, window));
            return matrices;
          }};
}

ParametricFamily central_matrices(const ParametricMask& mask) {
  const std::vector<LaurentPolynomial>& powers = mask.powers();
  std::vector<LaurentPolynomial> autocorrelation(2 * powers.size() - 1);
  for (std::size_t j = 0; j < powers.size(); ++j)
    for (std::size_t k = 0; k < powers.size(); ++k) autocorrelation[j + k] += powers[j] * powers[k].reversed();
  const IndexRange support = mask.support();
  const long reach = (support.last - support.first) / (mask.arity() - 1);
  const LaurentPolynomial denominator = mask.denominator();
  return {ParametricMask(autocorrelation, mask.arity(), denominator * denominator),
          [arity = mask.arity(), reach](const LaurentPolynomial& symbol) {
            return std::vector{central_matrix(symbol, arity, reach)};
          }};
}

}  // namespace subcert
