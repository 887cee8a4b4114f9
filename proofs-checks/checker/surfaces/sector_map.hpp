// The map z of data around a vertex that turn by w and are lambda times themselves, outwards from some points, and its
// regularity on a ring: Lemma 54, Theorems 55 and 66 in ../../certificates/SPEC.md.
#pragma once

#include "fit.hpp"
#include "hull.hpp"
#include "sector.hpp"
#include "turning.hpp"

namespace subcert_check {

/// The rule of a point of sector 0, or of the vertex: its own, or that of the mask.
SectorRule rule_at(const LatticeMask& mask, const SectorRules& rules, const Point& point);

/// Where limits are looked at, and on which data they and their derivatives along the axes depend: by affine fits, or
/// by hulls of differences.
struct MapRing {
  MapRing(const LatticeMask& mask, const SectorRules& rules, std::optional<FitBounds> by_fits);

  std::optional<FitBounds> fits;
  std::set<Point> window, differences[2];
  std::int64_t first = 0;  // r of Theorem 55
};

/// c = cos(2 pi/n), for all n that are looked at, and 1/n where weights have it.
struct ValenceLetters {
  Interval cosine, share;
};
Interval weight_at(const SectorTerm& term, const ValenceLetters& at, const Intervals& intervals);

/// Of lambda > 0: where it tends to 1, z = 1 + delta rho + s (w - 1) is given by rho and s, delta = 2 - 2c, and
/// (1 - lambda)/delta.
struct NearOne {
  Interval delta, decay;
};

class SectorMap {
 public:
  /// Domain: values at points that all others depend on, 0 at the vertex.
  SectorMap(const LatticeMask& mask, const SectorRules& rules, const MapRing& ring, const ValenceLetters& at,
            const Frequency& frequency, const Intervals& intervals, const Turning& lambda, const Turning& of_lambda,
            std::map<Point, Turning> values, const std::optional<NearOne>& near_one, Arithmetic& arithmetic);

  /// Whether the Jacobian is positive and the map in a half plane, on all squares of the ring or on their parts after
  /// so many cuts.
  bool is_regular(std::size_t cuts);
  /// Whether the Jacobian is positive on a square of the ring or further out, or negative. Domain: w is not real.
  bool has_jacobian(const Point& corner, bool positive);
  /// Whether the map has no zero on the squares whose corners have this largest coordinate. Domain: at least r.
  bool has_no_zero_at(std::int64_t radius);

 private:
  Turning turned(const Turning& x, long turns) const;
  Turning value_at(const Point& point);
  std::vector<Turning> data_on(const std::set<Point>& window, const Point& corner, const Point& step);
  Interval ahead(const Turning& z, std::size_t level) const;
  bool is_ahead_on(const Point& corner, std::size_t level);
  bool is_positive(const std::vector<Interval>& data) const;
  bool has_jacobian_by_fits(const Point& corner, bool positive);
  bool shows(const Point& corner, std::size_t level, std::size_t cuts, bool ahead);

  const LatticeMask& mask_;
  const SectorRules& rules_;
  const MapRing& ring_;
  ValenceLetters at_;
  const Frequency& frequency_;
  const Intervals& intervals_;
  Turning lambda_, of_lambda_;
  std::map<Point, Turning> known_;
  std::optional<NearOne> near_one_;
  Arithmetic& arithmetic_;
  std::vector<Turning> powers_;  // of lambda
  std::set<Point> open_;
};

}  // namespace subcert_check
