#pragma once
/// What stands beyond the ends of open data.

#include <subcert/analysis/symbol/numbers/numbers.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

using subcert::to_text;

/// With first data a b c d ...:
/// regression  the polynomial of the scheme's reproduction degree fitted to the data next to the end
/// reflect     d c b | a b c d, mirrored at the ends of the domain
/// periodic    the data repeated; closed data always are
/// shrink      nothing: only points with complete stencils are made
/// nearest     a a a | a b c d
/// constant    v v v | a b c d
/// Smoothing knows all but shrink; refinement of vectors, of rational numbers and by single steps the first four.
/// Definitions: docs/data.md, docs/smoothing.md.
enum class Boundary { regression, reflect, periodic, shrink, nearest, constant };

/// The name, as `regression`.
std::string to_text(Boundary boundary);

/// Reads a name, or one that Savitzky-Golay filters have made common: `interp` for regression, `mirror` for reflect,
/// `wrap` for periodic.
std::optional<Boundary> parse_boundary(std::string_view name);

/// The names that commands offer, the default first: for refinement, and for smoothing those of the filters.
const std::vector<std::string>& refinement_boundary_names();
const std::vector<std::string>& smoothing_boundary_names();

/// Whether data go on past their ends as they are, nearest or constant.
inline bool continues_data(Boundary boundary) {
  return boundary == Boundary::nearest || boundary == Boundary::constant;
}

/// Throws a domain error for nearest and constant.
void require_refinement_boundary(Boundary boundary);

}  // namespace subcert::data
