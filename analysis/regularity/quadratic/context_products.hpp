#pragma once
/// Products that the forms of contexts show to be large: a wide look where norms of one form do not tell the best from
/// many others. Inner header. Nothing of it is proved.

#include "context_forms.hpp"

namespace subcert::quadratic {

/// Products whose averaged radius is near `radius` or above, found along words whose norms stay above the powers of a
/// little more than the radius. `contexts` gets the forms. Domain: radius > 0, that of a product. Cost: the forms of
/// contexts, for half of the time; then a matrix product and a Cholesky decomposition for each word that is looked at.
std::vector<polytope::Candidate> context_products(const polytope::SearchFamily& family, double radius,
                                                  const Budget& budget, std::optional<ContextForms>& contexts);

}  // namespace subcert::quadratic
