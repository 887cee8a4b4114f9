#pragma once
/// Polygons on numbered vertices.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace subcert::data {

/// Faces are lists of vertices, counted from 0, that go around them. Coordinate c of vertex v is
/// values[v * dimension + c]; the corners of face f are corners[first[f]], ..., corners[first[f + 1] - 1].
/// Canonical: dimension >= 1 divides values.size(); first rises from 0 to corners.size(); corners < vertices().
struct PolygonMesh {
  std::vector<double> values;
  std::size_t dimension = 3;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> first{0};

  std::size_t vertices() const { return values.size() / dimension; }
  std::size_t faces() const { return first.size() - 1; }
  std::span<const std::uint32_t> face(std::size_t f) const {
    return std::span(corners).subspan(first[f], first[f + 1] - first[f]);
  }
  /// The corners that were added since the last face are one.
  void end_face() { first.push_back(static_cast<std::uint32_t>(corners.size())); }
  /// Whether all faces have so many corners.
  bool has_only(std::size_t sides) const {
    for (std::size_t f = 0; f < faces(); ++f)
      if (first[f + 1] - first[f] != sides) return false;
    return true;
  }
  bool is_canonical() const;
};

/// Where a face stands, for errors.
using FacePlace = std::function<std::string(std::size_t face)>;

/// Throws a data error for a face with less than three vertices, or with one of them twice.
void require_faces(const PolygonMesh& mesh, const FacePlace& place);

}  // namespace subcert::data
