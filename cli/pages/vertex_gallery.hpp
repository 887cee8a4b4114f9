#pragma once
/// Vertices of several schemes on one page.

#include <subcert/cli/command.hpp>
#include <subcert/cli/pages/vertex_pictures.hpp>

#include <string>
#include <vector>

namespace subcert::cli {

/// A scheme, and what is proved and drawn of it at each valence.
struct VertexPlate {
  VertexScheme scheme;
  RegularPart regular;
  std::vector<VertexPicture> pictures;
};

/// Schemes with rules at vertices and weights of their own, as they are written.
const std::vector<std::string>& vertex_gallery_schemes();

/// With progress. Errors: as VertexScheme::at(), regular_part(). Cost: for each scheme the budget of the options.
std::vector<VertexPlate> make_vertex_plates(const std::vector<VertexScheme>& schemes, const std::vector<int>& valences,
                                            const SearchOptions& options);

/// One page in one file: for each scheme and valence a card with the characteristic map, coloured by curvature, the
/// subdominant eigenvalue, the curvature and whether surfaces are C1. Domain: at least one valence a plate.
std::string vertex_gallery_html(const std::vector<VertexPlate>& plates);

/// {"schemes": [...]}, each as the answer of `vertex`.
Json vertex_plates_json(const std::vector<VertexPlate>& plates);

/// Of all plates: no before unknown.
ExitCode exit_code(const std::vector<VertexPlate>& plates);

}  // namespace subcert::cli
