#pragma once
/// Regular volumes and images in legacy VTK files.

#include "number_type.hpp"

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <array>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace subcert::data {

/// An array of numbers at the points, and the keyword that it stands under.
struct VolumeArray {
  std::string name;
  std::string keyword = "SCALARS";  ///< or COLOR_SCALARS, VECTORS, TENSORS, TEXTURE_COORDINATES, FIELD
  std::size_t components = 1;
};

/// Structured points with the numbers of all arrays, one array after another. Where the third dimension is 1 the data
/// have two axes. Canonical: data.dimension is the sum of the components; arrays of FIELD come last.
struct Volume {
  GridData<double> data;
  std::string title;
  std::vector<VolumeArray> arrays;
  std::array<double, 3> origin{0, 0, 0};  ///< of the first data
  std::array<double, 3> spacing{1, 1, 1};
  Encoding encoding = Encoding::text;     ///< or bytes, big-endian
  std::vector<std::string> remarks = {};  ///< what the file has and this has not, a line each
};

/// Reads a file with DATASET STRUCTURED_POINTS, as text or in bytes: all arrays of POINT_DATA, also in FIELD. Where
/// there are none those of CELL_DATA, at the middles of the cells. Normals, lookup tables, METADATA, numbers of points
/// and fields of the data set are not kept. Keywords may be in small letters. With `gaps` numbers may be NaN. Errors:
/// throws a data error. Ref: [VTK, "Simple legacy formats"].
Volume parse_vtk(std::string_view text, const std::string& file, bool gaps = false);

/// Writes such a file piece by piece, with the arrays of `form`, whose data do not matter: what stands before the
/// arrays, then what stands before each array, and its numbers. Origin and spacing follow the axes. Numbers are written
/// as doubles, colours as VTK has them. Errors: those of the stream.
void write_volume_begin(std::ostream& stream, const Volume& form, const std::vector<Axis>& axes);
void write_array_begin(std::ostream& stream, const Volume& form, std::size_t array, std::size_t points);
/// `values`: the numbers of all arrays at these points.
void write_array(std::ostream& stream, const Volume& form, std::size_t array, const double* values, std::size_t points);
void write_array_end(std::ostream& stream, const Volume& form);

/// All of it.
std::string to_text(const Volume& volume);

}  // namespace subcert::data
