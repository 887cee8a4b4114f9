#pragma once
/// Regular volumes and images in legacy VTK files.

#include <subcert/schemes/data/refine/grid_data.hpp>

#include <array>
#include <string>
#include <string_view>

namespace subcert::data {

/// Structured points with one array. Where the third dimension is 1 the data have two axes.
struct Volume {
  GridData<double> data;
  std::string title;
  std::string name;                       ///< of the array
  std::array<double, 3> origin{0, 0, 0};  ///< of the first data
  std::array<double, 3> spacing{1, 1, 1};
};

/// Reads an ASCII file with DATASET STRUCTURED_POINTS and one array, SCALARS with 1 to 4 components or VECTORS, as
/// POINT_DATA. Errors: throws a data error. Ref: [VTK, "Simple legacy formats"].
Volume parse_vtk(std::string_view text, const std::string& file);

/// The text of such a file; the origin and the spacing follow the axes.
std::string to_vtk(const Volume& volume);

}  // namespace subcert::data
