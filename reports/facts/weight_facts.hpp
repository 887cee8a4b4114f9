#pragma once
/// Facts about the values of a weight at vertices.

#include "fact.hpp"

#include <subcert/analysis/vertex/weight_range.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <string>
#include <vector>

namespace subcert::facts {

/// For which values of its letter a scheme has the property at vertices of each valence.
Facts weight_facts(const VertexScheme& scheme, const RegularPart& regular, WeightProperty property,
                   const std::vector<WeightRange>& ranges);

/// Whether all is decided but for single values, the ends.
bool is_decided(const WeightRange& range);

/// `C1` or `bounded-curvature`.
const char* property_text(WeightProperty property);
/// What has that text. Errors: throws a usage Error, which names this place, for any other.
WeightProperty parse_weight_property(const std::string& text, const std::string& place);

/// The polynomial of an end, in c and this letter.
std::string polynomial_text(const WeightEnd& end, char letter);

}  // namespace subcert::facts
