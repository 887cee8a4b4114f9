#pragma once
/// Data files of `subcert refine`: curves, grids, meshes and volumes, read and written in the same form.

#include <subcert/schemes/data/formats/table.hpp>
#include <subcert/schemes/data/formats/volume.hpp>

#include <array>
#include <string>

namespace subcert::cli {

enum class DataKind { curve, matrix, obj, ply, vtk };

/// What a file holds, and what is needed to write one of its kind.
struct DataFile {
  DataKind kind;
  data::GridData<double> data;
  data::Table table = {};    ///< header and separator of a CSV file
  data::Volume volume = {};  ///< title, name, origin and spacing of a VTK file
};

/// Reads a file for a scheme of this many variables: `.obj`, `.ply` and `.vtk` by their endings, else CSV, one point in
/// a row for one variable and a matrix of heights for two; `-` is standard input. `closed` says which directions are; a
/// mesh says so itself. Errors: throws a data error, or missing_file, for the file, a usage error where it does not fit
/// the variables.
DataFile read_data_file(const std::string& path, std::size_t variables, const std::array<bool, 3>& closed);

/// Throws a data error where a direction has fewer points, of those that are closed and those that are not, or is
/// closed and repeats its first points at the end.
void check_data(const DataFile& file, const std::string& path, const std::string& scheme,
                const std::vector<std::size_t>& fewest, const std::vector<std::size_t>& fewest_closed);

/// Writes a file of the same kind with these data.
void write_data(std::ostream& stream, const DataFile& file, const data::GridData<double>& data, int threads);

}  // namespace subcert::cli
