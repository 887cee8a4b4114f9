#pragma once
/// What a rule reads where its stencil passes the end of open data.

#include <subcert/analysis/symbol/numbers.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

using subcert::to_text;

/// regression: the least squares polynomial through the nearest complete window, of the scheme's reproduction degree;
/// reflect: the data mirrored at the ends of the domain; periodic: the data repeated (closed data always are);
/// shrink: only points with complete stencils are made. Definitions: docs/data.md.
enum class Boundary { regression, reflect, periodic, shrink };

/// The name, as `regression`.
std::string to_text(Boundary boundary);
std::optional<Boundary> parse_boundary(std::string_view name);
/// All names, the default first.
const std::vector<std::string>& boundary_names();

}  // namespace subcert::data
