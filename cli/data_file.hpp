#pragma once
/// Data files of `subcert refine`: curves, grids, meshes and volumes, read and written in the same form.

#include <subcert/schemes/data/formats/grid_mesh.hpp>
#include <subcert/schemes/data/formats/row_lines.hpp>
#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/formats/volume.hpp>

#include <array>
#include <functional>
#include <string>

namespace subcert::cli {

enum class DataKind { curve, matrix, mesh, volume };

/// What a file holds, and what is needed to write one of its kind.
struct DataFile {
  DataKind kind;
  data::GridData<double> data;
  data::Table table = {};     ///< header and separator of a CSV file
  data::MeshFile mesh = {};   ///< properties, format and encoding of a mesh, without its numbers
  data::Volume volume = {};   ///< arrays, title, origin, spacing and encoding of a VTK file, without its numbers
  data::RowLines lines = {};  ///< of the rows of a CSV file

  /// What the numbers of a point are called; empty where they have no names.
  std::vector<std::string> names() const;
  /// What was done to the file that nobody asked for, a line each.
  const std::vector<std::string>& remarks() const { return kind == DataKind::mesh ? mesh.remarks : volume.remarks; }
};

/// Reads a file for a scheme of this many variables: meshes and `.vtk` by their endings, else CSV, one point in
/// a row for one variable and a matrix of heights for two; `-` is standard input. `closed` says which directions are; a
/// mesh says so itself. With `pieces` the text of curves is not held, nor told to listeners. Errors: throws a data
/// error, or missing_file, for the file, a usage error where it does not fit the variables.
DataFile read_data_file(const std::string& path, std::size_t variables, const std::array<bool, 3>& closed,
                        bool pieces = false);

/// Reads a mesh of any topology, to be written in the format that the ending of `out` names, if it does. `join` joins
/// vertices that are equal. Errors: as above.
data::MeshFile read_mesh_file(const std::string& path, const std::string& out, bool join);

/// The same for heights or volumes, whatever the number of their axes; a mesh is refused.
DataFile read_grid_file(const std::string& path, data::Missing missing);

/// Throws a data error where a direction has fewer points, of those that are closed and those that are not, or is
/// closed and repeats its first points at the end.
void check_data(const DataFile& file, const std::string& path, const std::string& scheme,
                const std::vector<std::size_t>& fewest, const std::vector<std::size_t>& fewest_closed);

/// Gives points in their order, a piece at a time, to the function; of matrices whole rows. It may be asked again.
using PointSource = std::function<void(const std::function<void(const double* values, std::size_t points)>&)>;

/// Writes a file of the same kind with points on these axes, piece by piece. Cost: of a volume, the source is asked
/// once for each array.
void write_data(std::ostream& stream, const DataFile& file, const std::vector<data::Axis>& axes,
                const PointSource& source, int threads);

}  // namespace subcert::cli
