#pragma once
/// Meshes whose faces make a grid.

#include "mesh_file.hpp"

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <iosfwd>
#include <vector>

namespace subcert::data {

/// The vertices on the grid that the faces make: quadrilaterals on vertices numbered row by row, in any order and
/// orientation: vertex j * columns + i is joined to its neighbours in i and j, in closed directions the last to the
/// first. Axis 0 counts the columns. Where several grids fit, the one with fewer closed directions is taken. The mesh
/// of `file` is empty then. Errors: throws a data error. Cost: faces * log(faces) for each divisor of the vertices.
GridData<double> take_grid(MeshFile& file);

/// Writes what stands before the vertices of such a mesh, and what follows them. Domain: `axes` are two; not STL.
void write_grid_begin(std::ostream& stream, const MeshFile& form, const std::vector<Axis>& axes);
void write_grid_end(std::ostream& stream, const MeshFile& form, const std::vector<Axis>& axes);

/// The mesh of these data. Domain: two axes.
PolygonMesh mesh_of_grid(GridData<double> data);

}  // namespace subcert::data
