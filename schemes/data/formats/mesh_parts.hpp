#pragma once
// What readers of meshes share.

#include "mesh_file.hpp"
#include "text_lines.hpp"

namespace subcert::data {

constexpr std::size_t most_vertices = 100'000'000;

/// Texts with commas between them.
std::string joined(const std::vector<std::string>& texts);

/// The name of a type in PLY.
std::string ply_name(const NumberType& type);

bool is_normal(const std::string& name);

/// Ends a face of the corners added since the last one. Errors: throws a data error for too many corners in all.
/// `line`: 0 in bytes.
void end_face(MeshFile& mesh, std::size_t line);

/// What was read, complete: drops vertices that no face has, and makes the remarks. Errors: throws a data error where
/// there are no faces, and as require_faces().
MeshFile finished(MeshFile mesh, std::vector<std::string> left_out, const TextLines& lines);

}  // namespace subcert::data
