#pragma once
/// Pictures of surfaces near vertices.

#include <subcert/analysis/vertex/vertex_surface.hpp>
#include <subcert/schemes/vertices/vertex_rules.hpp>

#include <optional>
#include <string>
#include <vector>

namespace subcert::cli {

/// What is drawn at one valence: nothing where it has no surface.
struct VertexPicture {
  VertexSmoothness smoothness;
  std::optional<VertexSurface> surface;
};

/// The characteristic map, cells in the colours of curvature.
std::string map_svg(const VertexSurface& surface);

/// What colours tell, from -most to most.
std::string curvature_scale(double most);

/// What curvature is multiplied by from one ring to the next, |mu|/lambda^2, as text. Domain: where there is a surface.
std::string curvature_factor(const VertexSmoothness& smoothness);

/// The surfaces side by side, each with its valence. Errors: throws a domain error where there is none, missing_file.
void draw_vertices(const std::string& plot, const VertexScheme& scheme, const std::vector<VertexPicture>& pictures);

/// A page in one file: the facts as they are printed, and for each valence the characteristic map and the surface,
/// which readers turn.
std::string vertex_html(const VertexScheme& scheme, const std::string& facts,
                        const std::vector<VertexPicture>& pictures);

}  // namespace subcert::cli
