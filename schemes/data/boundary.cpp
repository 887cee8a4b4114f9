#include "boundary.hpp"

#include <algorithm>

namespace subcert::data {

const std::vector<std::string>& boundary_names() {
  static const std::vector<std::string> names{"regression", "reflect", "periodic", "shrink"};
  return names;
}

std::string to_text(Boundary boundary) { return boundary_names()[static_cast<std::size_t>(boundary)]; }

std::optional<Boundary> parse_boundary(std::string_view name) {
  const auto& names = boundary_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Boundary>(found - names.begin());
}

}  // namespace subcert::data
