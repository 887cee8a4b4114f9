#pragma once
/// The regular parts of schemes with rules at vertices, each made once.

#include <subcert/analysis/vertex/vertex_smoothness.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <map>

namespace subcert::testing {

inline const RegularPart& part_of(const std::string& scheme) {
  static std::map<std::string, RegularPart> known;
  const auto found = known.find(scheme);
  if (found != known.end()) return found->second;
  return known.emplace(scheme, regular_part(vertex_rules(scheme, 3), {Deadline::in(20)})).first->second;
}

}  // namespace subcert::testing
