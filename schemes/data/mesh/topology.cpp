#include "topology.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <map>

namespace subcert::data {
namespace {

std::size_t face_of(const PolygonMesh& mesh, std::uint32_t corner) {
  return static_cast<std::size_t>(std::ranges::upper_bound(mesh.first, corner) - mesh.first.begin()) - 1;
}

[[noreturn]] void refuse(const PolygonMesh& mesh, const FacePlace& place, std::uint32_t corner, std::uint32_t other,
                         const std::string& what) {
  fail(ErrorKind::data, "{}: {}; {} has it, too", place(face_of(mesh, corner)), what, place(face_of(mesh, other)));
}

}  // namespace

Topology::Topology(const PolygonMesh& mesh, const FacePlace& place) {
  if (mesh.faces() > 0 && mesh.has_only(mesh.face(0).size())) {
    sides_ = static_cast<std::uint32_t>(mesh.face(0).size());
  } else {
    next_.resize(mesh.corners.size());
    for (std::size_t f = 0; f < mesh.faces(); ++f)
      for (std::uint32_t h = mesh.first[f]; h < mesh.first[f + 1]; ++h)
        next_[h] = h + 1 == mesh.first[f + 1] ? mesh.first[f] : h + 1;
  }
  join_opposites(mesh, place);
  find_corners(mesh, place);
}

std::uint32_t Topology::previous_of(std::uint32_t h) const {
  if (h > 0 && next_[h - 1] == h) return h - 1;
  while (next_[h] > h) h = next_[h];
  return h;
}

void Topology::join_opposites(const PolygonMesh& mesh, const FacePlace& place) {
  const auto corners = static_cast<std::uint32_t>(mesh.corners.size());
  const auto low = [&](std::uint32_t h) { return std::min(mesh.corners[h], mesh.corners[next(h)]); };
  const auto high = [&](std::uint32_t h) { return std::max(mesh.corners[h], mesh.corners[next(h)]); };
  // The edges at each vertex whose other end has a higher number.
  std::vector<std::uint32_t> begin(mesh.vertices() + 1, 0), list(corners);
  for (std::uint32_t h = 0; h < corners; ++h) ++begin[low(h)];
  for (std::size_t v = 1; v <= mesh.vertices(); ++v) begin[v] += begin[v - 1];
  for (std::uint32_t h = corners; h-- > 0;) list[--begin[low(h)]] = h;
  opposite_.assign(corners, none);
  for (std::size_t v = 0; v < mesh.vertices(); ++v) {
    const auto end = list.begin() + begin[v + 1];
    std::sort(list.begin() + begin[v], end,
              [&](std::uint32_t a, std::uint32_t b) { return std::pair(high(a), a) < std::pair(high(b), b); });
    for (auto at = list.begin() + begin[v]; at != end;) {
      const std::uint32_t h = *at++;
      ++edges_;
      if (at == end || high(*at) != high(h)) continue;
      const std::uint32_t other = *at++;
      if (at != end && high(*at) == high(h))
        refuse(mesh, place, h, *at, "expected edges in one face or two; found one in three or more");
      if (mesh.corners[h] == mesh.corners[other])
        refuse(mesh, place, h, other,
               "expected faces that go around alike, so that two have their edge in opposite directions; found one in "
               "the same direction");
      opposite_[h] = other;
      opposite_[other] = h;
    }
  }
}

void Topology::find_corners(const PolygonMesh& mesh, const FacePlace& place) {
  corner_.assign(mesh.vertices(), none);
  faces_.assign(mesh.vertices(), 0);
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    const std::uint32_t v = mesh.corners[h];
    ++faces_[v];
    if (corner_[v] == none || (is_boundary(h) && !is_boundary(corner_[v]))) corner_[v] = h;
  }
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    // Fans are walked through from their beginnings; of those without one each vertex knows its corner.
    const std::uint32_t v = mesh.corners[h];
    if (h != corner_[v]) continue;
    std::uint32_t count = 1;
    for (std::uint32_t c = turned(h); c != none && c != h; c = turned(c)) ++count;
    if (count == faces_[v]) continue;
    std::vector<std::uint32_t> fan{h};
    for (std::uint32_t c = turned(h); c != none && c != h; c = turned(c)) fan.push_back(c);
    for (std::uint32_t other = 0; other < mesh.corners.size(); ++other)
      if (mesh.corners[other] == v && std::ranges::find(fan, other) == fan.end())
        refuse(mesh, place, h, other,
               "expected vertices at which one fan of faces meets; found one that joins two fans");
  }
}

std::vector<std::uint32_t> Topology::edge_numbers() const {
  std::vector<std::uint32_t> numbers(opposite_.size());
  std::uint32_t count = 0;
  for (std::uint32_t h = 0; h < numbers.size(); ++h)
    numbers[h] = is_boundary(h) || h < opposite(h) ? count++ : numbers[opposite(h)];
  return numbers;
}

void require_no_seams(const PolygonMesh& mesh, const Topology& topology, std::size_t coordinates,
                      const FacePlace& place) {
  using Point = std::vector<double>;
  std::map<std::pair<Point, Point>, std::uint32_t> seen;
  const auto point = [&](std::uint32_t h) {
    const double* const at = mesh.values.data() + mesh.corners[h] * mesh.dimension;
    return Point(at, at + coordinates);
  };
  for (std::uint32_t h = 0; h < mesh.corners.size(); ++h) {
    if (!topology.is_boundary(h)) continue;
    std::pair<Point, Point> ends(point(h), point(topology.next(h)));
    if (ends.second < ends.first) std::swap(ends.first, ends.second);
    const auto [found, is_new] = seen.emplace(std::move(ends), h);
    if (!is_new)
      refuse(mesh, place, found->second, h,
             "expected each vertex once; found an edge of the boundary whose ends are at the same places as those of "
             "another one (--join makes one vertex of equal ones)");
  }
}

}  // namespace subcert::data
