#include "deciding.hpp"

#include <subcert/analysis/vertex/vertex_smoothness.hpp>
#include <subcert/proofs-checks/number_list.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <fmt/format.h>

namespace subcert::properties {

std::vector<int> valences_of(const std::string& text) {
  return parse_number_list("vertices", text, smallest_valence, largest_valence);
}

Decision smooth_at_vertices(const Scheme& scheme, const Expectation& expectation, const SearchLimits& limits) {
  const std::vector<SectorRules> rules = VertexScheme::named(scheme.specification).at(valences_of(expectation.word));
  const RegularPart regular = regular_part(rules.front(), limits.budget());
  if (!regular.c1.is_yes()) return {regular.c1.truth, "away from vertices: " + regular.c1.reason};
  Decision answer{Truth::yes, fmt::format("C1 at valences {}", expectation.word)};
  for (const VertexSmoothness& one : vertex_smoothness(rules, regular, 1)) {
    const std::string found = fmt::format("at valence {}: {}", one.valence, one.c1.reason);
    if (one.c1.is_no()) return decided(false, found);
    if (!one.c1.is_yes() && answer.is_yes()) answer = {Truth::unknown, found};
  }
  return answer;
}

}  // namespace subcert::properties
