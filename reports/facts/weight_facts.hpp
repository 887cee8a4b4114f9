#pragma once
/// Facts about the values of a weight at vertices.

#include "fact.hpp"

#include <subcert/analysis/vertex/weight_range.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <vector>

namespace subcert::facts {

/// For which values of its letter a scheme has the property at vertices of each valence.
Facts weight_facts(const VertexScheme& scheme, const RegularPart& regular, WeightProperty property,
                   const std::vector<WeightRange>& ranges);

/// Whether all is decided but for single values, the ends.
bool is_decided(const WeightRange& range);

/// `C1` or `bounded-curvature`.
const char* property_text(WeightProperty property);

}  // namespace subcert::facts
