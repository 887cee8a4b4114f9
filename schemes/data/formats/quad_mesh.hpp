#pragma once
/// Surfaces as meshes of quadrilaterals in OBJ and PLY files.

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <string>
#include <string_view>

namespace subcert::data {

/// Reads the vertices `v x y z` and the faces `f` of an OBJ file, or the vertex and face elements of an ASCII PLY file.
/// The faces must make a grid with vertices numbered row by row, in any order and orientation: vertex j * columns + i
/// is joined to its neighbours in i and j, in closed directions the last to the first. Axis 0 counts the columns.
/// Errors: throws a data error. Cost: faces * log(faces).
GridData<double> parse_obj(std::string_view text, const std::string& file);
GridData<double> parse_ply(std::string_view text, const std::string& file);

/// The text of the same kind of file. Domain: two axes, three coordinates. Errors: throws a domain error.
std::string to_obj(const GridData<double>& surface);
std::string to_ply(const GridData<double>& surface);

}  // namespace subcert::data
