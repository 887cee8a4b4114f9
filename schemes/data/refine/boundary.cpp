#include "boundary.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <array>

namespace subcert::data {
namespace {

constexpr std::array<std::string_view, 6> names{"regression", "reflect", "periodic", "shrink", "nearest", "constant"};
constexpr std::array<std::string_view, 6> filter_names{"interp", "mirror", "wrap", "", "nearest", "constant"};

}  // namespace

std::string to_text(Boundary boundary) { return std::string(names[static_cast<std::size_t>(boundary)]); }

std::optional<Boundary> parse_boundary(std::string_view name) {
  for (const auto& list : {names, filter_names})
    if (const auto found = std::find(list.begin(), list.end(), name); found != list.end() && !name.empty())
      return static_cast<Boundary>(found - list.begin());
  return std::nullopt;
}

const std::vector<std::string>& refinement_boundary_names() {
  static const std::vector<std::string> offered{"regression", "reflect", "periodic", "shrink", "nearest", "constant"};
  return offered;
}

const std::vector<std::string>& smoothing_boundary_names() {
  static const std::vector<std::string> offered{"interp", "mirror", "nearest", "constant", "wrap"};
  return offered;
}

void require_refinement_boundary(Boundary boundary) {
  require(boundary <= Boundary::shrink, "refine: need boundary regression, reflect, periodic or shrink, got {}",
          to_text(boundary));
}

}  // namespace subcert::data
