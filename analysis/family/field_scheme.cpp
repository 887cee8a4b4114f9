#include "field_scheme.hpp"

#include <subcert/analysis/radii/schedule.hpp>
#include <subcert/analysis/regularity/vector_operators.hpp>
#include <subcert/analysis/symbol/support/error.hpp>

namespace subcert {

FieldScheme field_scheme(const QuadraticMask& mask, const Budget& budget) {
  const ParametricMask doubled = without_letters(mask.doubled);
  require(!kept_polynomials(doubled, mask.root).data.empty(),
          "scheme: need one that keeps one vector of constants up to a factor, got another");
  FieldScheme result{annihilating_space(doubled, mask.root), difference_matrices(doubled, mask.root).at({0}), {}};
  const vectors::Operators operators = vectors::operators_of(result.space.basis, result.space.pivots, result.family,
                                                             {mask.doubled, mask.root});
  const NormProof norms = vectors::norms_of(vectors::on_functions(operators, mask.root),
                                            {budget.deadline.after(schedule::vector::norms), budget.memory});
  result.radius = vectors::radius_of(operators, mask.root, budget, norms);
  return result;
}

}  // namespace subcert
