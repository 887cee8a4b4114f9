#include "creases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace subcert::data {
namespace {

/// Twice the area times the normal of a polygon, plane or not.
std::array<double, 3> area_vector(const PolygonMesh& mesh, std::size_t f) {
  const auto face = mesh.face(f);
  const double* const origin = mesh.values.data() + face[0] * mesh.dimension;
  std::array<double, 3> sum{};
  for (std::size_t k = 1; k + 1 < face.size(); ++k) {
    const double* const p = mesh.values.data() + face[k] * mesh.dimension;
    const double* const q = mesh.values.data() + face[k + 1] * mesh.dimension;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t d = (c + 1) % 3, e = (c + 2) % 3;
      sum[c] += (p[d] - origin[d]) * (q[e] - origin[e]) - (p[e] - origin[e]) * (q[d] - origin[d]);
    }
  }
  return sum;
}

}  // namespace

Creases::Creases(const PolygonMesh& mesh, const Topology& topology, std::vector<bool> sharp)
    : topology_(topology), sharp_(std::move(sharp)) {
  if (sharp_.empty()) return;
  edges_.assign(mesh.vertices(), 0);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    if (!is_sharp(h)) continue;
    ++edges_[mesh.corners[h]];
    if (topology.is_boundary(h)) ++edges_[mesh.corners[topology.next(h)]];
  }
}

bool Creases::has_ends() const { return std::ranges::count(edges_, 1U) > 0; }

std::vector<bool> edges_sharper_than(double degrees, const PolygonMesh& mesh, const Topology& topology) {
  std::vector<std::array<double, 3>> normals;
  std::vector<std::uint32_t> face_of(mesh.corners.size());
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    normals.push_back(area_vector(mesh, f));
    std::fill(face_of.begin() + mesh.first[f], face_of.begin() + mesh.first[f + 1], static_cast<std::uint32_t>(f));
  }
  std::vector<bool> sharp(mesh.corners.size(), false);
  const double limit = std::cos(degrees * std::numbers::pi / 180);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    if (topology.is_boundary(h)) continue;
    const auto &a = normals[face_of[h]], &b = normals[face_of[topology.opposite(h)]];
    const double lengths = std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
    sharp[h] = lengths > 0 && a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < limit * lengths;
  }
  return sharp;
}

}  // namespace subcert::data
