#pragma once
/// What `subcert smooth` does with meshes.

#include "smooth_page.hpp"

namespace subcert::cli {

/// Reads a mesh, moves its vertices by the rules of the scheme, `--steps` times, and writes it. Errors: throws a usage
/// error for options that are of samples, else as refine_mesh() and read_mesh_file().
void smooth_mesh_file(const SmoothOptions& options);

}  // namespace subcert::cli
