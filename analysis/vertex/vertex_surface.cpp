#include "vertex_surface.hpp"

#include "characteristic_map.hpp"
#include "vertex_spectrum.hpp"

#include <subcert/analysis/symbol/support/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace subcert {
namespace {

using namespace vertex;

constexpr slong surface_bits = 256;
constexpr double height_of_picture = 0.35;  // of the radius

using SpacePoint = std::array<double, 3>;

/// The coefficients of 1, x, y, x^2, xy, y^2 that fit heights best; nothing where the points do not tell them.
std::optional<std::array<double, 6>> quadratic_fit(const std::vector<SpacePoint>& points) {
  double system[6][7] = {};
  for (const SpacePoint& p : points) {
    const double x = p[0], y = p[1], terms[7] = {1, x, y, x * x, x * y, y * y, p[2]};
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 7; ++j) system[i][j] += terms[i] * terms[j];
  }
  for (std::size_t k = 0; k < 6; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < 6; ++i)
      if (std::abs(system[i][k]) > std::abs(system[pivot][k])) pivot = i;
    if (!(std::abs(system[pivot][k]) > 1e-9)) return std::nullopt;
    std::swap(system[k], system[pivot]);
    for (std::size_t i = 0; i < 6; ++i) {
      if (i == k) continue;
      const double factor = system[i][k] / system[k][k];
      for (std::size_t j = k; j < 7; ++j) system[i][j] -= factor * system[k][j];
    }
  }
  std::array<double, 6> result{};
  for (std::size_t k = 0; k < 6; ++k) result[k] = system[k][6] / system[k][k];
  return result;
}

class SurfaceOfVertex {
 public:
  SurfaceOfVertex(const SectorRules& rules, const CharacteristicMap& plane, const CharacteristicMap* heights,
                  long frequency, int size)
      : rules_(rules), plane_(plane), heights_(heights), frequency_(frequency), size_(size) {}

  VertexSurface run() {
    const bool dual = rules_.lattice == SectorLattice::dual;
    // Dual sectors share nothing: each has the strip to the next one, and a triangle of the face in the middle.
    first_ = dual ? -1 : 0;
    const auto side = static_cast<std::size_t>(size_ + 1 - first_);
    const double none = std::numeric_limits<double>::quiet_NaN();
    VertexSurface result{rules_.valence,
                         heights_ ? std::optional(frequency_) : std::nullopt,
                         (side + 1) * static_cast<std::size_t>(rules_.valence),
                         side,
                         {},
                         {},
                         0};
    result.points.assign(result.columns * result.rows, {none, none, none});
    result.curvature.assign(result.points.size(), none);
    std::vector<double> outer;
    find_scale();
    for (long t = 0; t < rules_.valence; ++t)
      for (long y = first_; y <= size_; ++y)
        for (long x = first_; x <= size_; ++x) {
          if ((y < 0 && x > 0) || is_beyond(x, y)) continue;
          const std::size_t at = static_cast<std::size_t>(y - first_) * result.columns +
                                 static_cast<std::size_t>(t) * (side + 1) + static_cast<std::size_t>(x - first_);
          result.points[at] = y < 0 ? SpacePoint{0, 0, 0} : place({x, y}, t);
          result.curvature[at] = y < 0 ? curvature({0, 0}) : curvature({x, y});
          if (t == 0 && 2 * distance(x, y) >= size_) outer.push_back(std::abs(result.curvature[at]));
        }
    const auto middle = outer.begin() + static_cast<std::ptrdiff_t>(outer.size() / 2);
    std::nth_element(outer.begin(), middle, outer.end());
    result.scale = 2 * *middle;
    return result;
  }

 private:
  bool has_triangles() const { return rules_.lattice == SectorLattice::triangles; }
  /// In edges from the vertex.
  long distance(long x, long y) const { return has_triangles() ? x + y : std::max(x, y); }
  /// Triangles end with the line x + y = size. The corner of a square beyond is put on it.
  bool is_beyond(long x, long y) const {
    return has_triangles() && (x + y > size_ + 1 || (x + y > size_ && (x == 0 || y == 0)));
  }
  SpacePoint place(const LatticePoint& at, long turn) const {
    if (!has_triangles() || at[0] + at[1] <= size_) return point(at, turn);
    const SpacePoint a = point({at[0] - 1, at[1]}, turn), b = point({at[0], at[1] - 1}, turn);
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
  }
  /// Re z turned by its frequency, and for the plane Im z.
  static std::array<double, 2> turned_value(const Turning<Ball>& z, long frequency, long valence, long turn) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(frequency) / static_cast<double>(valence);
    const double here = angle * static_cast<double>(turn), x = z.x.middle(), y = z.y.middle();
    return {x * std::cos(here) + y * std::cos(here + angle), x * std::sin(here) + y * std::sin(here + angle)};
  }
  SpacePoint point(const LatticePoint& at, long turn) const {
    const auto [x, y] = turned_value(plane_.data_at(at), 1, rules_.valence, turn);
    const double height = heights_ ? turned_value(heights_->data_at(at), frequency_, rules_.valence, turn)[0] : 0;
    return {x * plane_scale_, y * plane_scale_, height * height_scale_};
  }
  void find_scale() {
    double radius = 0, height = 0;
    for (long t = 0; t < rules_.valence; ++t)
      for (long x = 0; x <= size_; ++x)
        for (const LatticePoint& at : {LatticePoint{size_, x}, LatticePoint{x, size_}}) {
          if (distance(at[0], at[1]) > size_) continue;
          const SpacePoint p = point(at, t);
          radius = std::max(radius, std::hypot(p[0], p[1]));
          height = std::max(height, std::abs(p[2]));
        }
    plane_scale_ = 1 / radius;
    height_scale_ = height > 0 ? height_of_picture / height : 1;
  }
  /// The same in all sectors but for heights, so in the first of those: of the points around it, or, beside the vertex,
  /// where some of them are opposite of the sector, of the next one.
  double curvature(LatticePoint at) const {
    if (!heights_) return 0;
    if (at == LatticePoint{0, 0} && rules_.lattice != SectorLattice::dual) at = {1, 0};
    std::vector<SpacePoint> around;
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        if (in_sector({at[0] + i, at[1] + j}, rules_.lattice, rules_.valence))
          around.push_back(point({at[0] + i, at[1] + j}, 0));
    const SpacePoint centre = point(at, 0);
    double size = 0;
    for (const SpacePoint& p : around) size = std::max(size, std::hypot(p[0] - centre[0], p[1] - centre[1]));
    for (SpacePoint& p : around)
      for (std::size_t c = 0; c < 2; ++c) p[c] = (p[c] - centre[c]) / size;
    const auto fit = quadratic_fit(around);
    if (!fit) return 0;
    const auto& [value, dx, dy, xx, xy, yy] = *fit;
    const double slope = 1 + (dx * dx + dy * dy) / (size * size);
    const double gauss = (4 * xx * yy - xy * xy) / std::pow(size, 4) / (slope * slope);
    return std::copysign(std::sqrt(std::abs(gauss)), gauss);
  }

  const SectorRules& rules_;
  const CharacteristicMap& plane_;
  const CharacteristicMap* heights_;
  long frequency_;
  long size_;
  long first_ = 0;
  double plane_scale_ = 1, height_scale_ = 1;
};

}  // namespace

std::optional<VertexSurface> vertex_surface(const SectorRules& rules, const RegularPart& regular,
                                            const VertexSmoothness& smoothness, int size) {
  require(size >= 4, "surface near a vertex: need 4 points or more along a ray, got {}", size);
  require(smoothness.valence == rules.valence, "surface near a vertex: need what is said of valence {}, got {}",
          rules.valence, smoothness.valence);
  if (!regular.forms || smoothness.frequency != 1 || !smoothness.subdominant.is_bounded() || rules.valence < 3)
    return std::nullopt;
  const ClosedSet set = smallest_closed_set(rules);
  const auto spectrum = vertex_spectrum(rules, set, surface_bits);
  const auto leader = spectrum ? leader_of(*spectrum, rules, set) : std::nullopt;
  if (!leader) return std::nullopt;
  const BallField field(rules.valence, surface_bits);
  const auto plane = CharacteristicMap::find(rules, set, *regular.forms, leader->largest().front(), leader->value,
                                             field);
  if (!plane) return std::nullopt;
  const long frequency = spectrum->groups.size() > 1 ? spectrum->groups[1].frequency : 0;
  const auto heights = [&]() -> std::optional<CharacteristicMap> {
    if (!spectrum->has_simple_leader() || spectrum->groups.size() < 2) return std::nullopt;
    const auto& value = spectrum->groups[1].value;
    const Ball mu = value.real();
    if (arb_contains_zero(mu.get()) != 0 || arb_contains_zero(imaginary_part(value).get()) == 0) return std::nullopt;
    return CharacteristicMap::find(rules, set, *regular.forms, frequency, mu, field);
  }();
  return SurfaceOfVertex(rules, *plane, heights ? &*heights : nullptr, frequency, size).run();
}

}  // namespace subcert
