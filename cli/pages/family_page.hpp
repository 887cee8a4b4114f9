#pragma once
/// What `subcert analyze` prints of a scheme with a parameter.

#include <subcert/cli/command.hpp>
#include <subcert/schemes/parametric_specification.hpp>

namespace subcert::cli {

struct FamilyPage {
  std::string text;
  Json json;
};

/// What holds for all values of the parameter, and for which values more does.
FamilyPage family_page(const ParametricScheme& scheme);

}  // namespace subcert::cli
