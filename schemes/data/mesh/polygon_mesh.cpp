#include "polygon_mesh.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>

namespace subcert::data {
namespace {

bool has_repetition(std::span<const std::uint32_t> face) {
  if (face.size() <= 8) {
    for (std::size_t i = 1; i < face.size(); ++i)
      if (std::ranges::find(face.first(i), face[i]) != face.begin() + static_cast<std::ptrdiff_t>(i)) return true;
    return false;
  }
  std::vector<std::uint32_t> sorted(face.begin(), face.end());
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) != sorted.end();
}

}  // namespace

bool PolygonMesh::is_canonical() const {
  return dimension >= 1 && values.size() % dimension == 0 && !first.empty() && first.front() == 0 &&
         first.back() == corners.size() && std::ranges::is_sorted(first) &&
         std::ranges::all_of(corners, [this](std::uint32_t vertex) { return vertex < vertices(); });
}

void require_faces(const PolygonMesh& mesh, const FacePlace& place) {
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    const auto face = mesh.face(f);
    if (face.size() < 3)
      fail(ErrorKind::data, "{}: expected a face of three or more vertices; found {}", place(f), face.size());
    if (has_repetition(face))
      fail(ErrorKind::data, "{}: expected a face of different vertices; found one of them twice", place(f));
  }
}

}  // namespace subcert::data
