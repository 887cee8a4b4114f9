#include "sector_map.hpp"

#include <algorithm>

namespace subcert_check {
namespace {

bool has_sign(const Interval& x, bool positive) { return positive ? x.low > 0 : x.high < 0; }

}  // namespace

SectorRule rule_at(const LatticeMask& mask, const SectorRules& rules, const Point& point) {
  if (const auto own = rules.rules.find(point); own != rules.rules.end()) return own->second;
  SectorRule rule;
  for (const auto& [k, value] : mask.coefficients) {
    const std::int64_t x = point[0] - k[0], y = point[1] - k[1];
    if (x % mask.arity == 0 && y % mask.arity == 0)
      rule.push_back({rules.in_sector({x / mask.arity, y / mask.arity, 0}), {}, {ratio(value, mask.denominator)}});
  }
  require(!rules.is_vertex(point) ||
              std::ranges::all_of(rule, [&](const SectorTerm& term) { return rules.is_vertex(term.at.point); }),
          "the rule of the vertex does not turn");
  return rule;
}

MapRing::MapRing(const LatticeMask& mask, const SectorRules& rules, std::optional<FitBounds> by_fits)
    : fits(std::move(by_fits)), window(mask.window()) {
  std::int64_t beside = 0, reach = 0, own = 0;
  const auto up_to = [](std::int64_t& most, const Point& point) {
    for (const std::int64_t x : point) most = std::max(most, std::abs(x));
  };
  if (fits) window = {fits->window.begin(), fits->window.end()};
  for (const Point& k : window) up_to(beside, k);
  for (std::size_t axis = 0; !fits && axis < 2; ++axis) {
    differences[axis] = mask.of_differences(axis).window();
    for (Point k : differences[axis]) {
      up_to(beside, k);
      --k[axis];
      up_to(beside, k);
    }
  }
  for (const auto& [k, value] : mask.coefficients) up_to(reach, k);
  for (const auto& [point, rule] : rules.rules) up_to(own, point);
  first = 2 * (beside + reach) + own + 1;
}

Interval weight_at(const SectorTerm& term, const ValenceLetters& at, const Intervals& intervals) {
  Interval value{0, 0};
  for (std::size_t k = term.weight.size(); k-- > 0;)
    value = intervals.times(value, at.cosine) + intervals.number(term.weight[k]);
  return term.over_valence ? intervals.times(value, at.share) : value;
}

SectorMap::SectorMap(const LatticeMask& mask, const SectorRules& rules, const MapRing& ring, const ValenceLetters& at,
                     const Frequency& frequency, const Intervals& intervals, const Turning& lambda,
                     const Turning& of_lambda, std::map<Point, Turning> values, const std::optional<NearOne>& near_one,
                     Arithmetic& arithmetic)
    : mask_(mask),
      rules_(rules),
      ring_(ring),
      at_(at),
      frequency_(frequency),
      intervals_(intervals),
      lambda_(lambda),
      of_lambda_(of_lambda),
      known_(std::move(values)),
      near_one_(near_one),
      arithmetic_(arithmetic) {}

Turning SectorMap::turned(const Turning& x, long turns) const {
  return near_one_ ? frequency_.turned_near_one(x, turns, near_one_->delta) : frequency_.turned(x, turns);
}

/// z at a point of the plane around sector 0, outwards from the given ones.
Turning SectorMap::value_at(const Point& point) {
  const SectorPoint at = rules_.in_sector(point);
  auto known = known_.find(at.point);
  if (known == known_.end()) {
    require(open_.insert(at.point).second, "a point depends on itself");
    Turning sum;
    for (const SectorTerm& term : rule_at(mask_, rules_, at.point)) {
      const Turning value = turned(value_at(term.at.point), term.at.turn);  // of all data, whether they turn
      if (!term.frequency || *term.frequency == frequency_.number())
        sum = sum + frequency_.scaled(weight_at(term, at_, intervals_), value);
    }
    if (near_one_) sum.a = sum.a + near_one_->decay;
    known = known_.emplace(at.point, frequency_.times(of_lambda_, sum)).first;
  }
  return turned(known->second, at.turn);
}

/// The data on a window of a square, or their differences along an axis.
std::vector<Turning> SectorMap::data_on(const std::set<Point>& window, const Point& corner, const Point& step) {
  std::vector<Turning> result;
  for (const Point& k : window) {
    const Point at = combine(k, 1, corner);
    result.push_back(step == Point{} ? value_at(at) : value_at(at) - value_at(combine(at, -1, step)));
  }
  return result;
}

/// What is positive in a half plane.
Interval SectorMap::ahead(const Turning& z, std::size_t level) const {
  const Interval one{intervals_.one(), intervals_.one()};
  if (near_one_) return one + intervals_.times(near_one_->delta, z.a);
  const Turning value = frequency_.times(powers_[level], z);
  return value.a + value.b;
}

bool SectorMap::is_ahead_on(const Point& corner, std::size_t level) {
  std::vector<Interval> data;
  for (const Turning& z : data_on(ring_.window, corner, {})) data.push_back(ahead(z, level));
  return is_positive(data);
}

/// Whether limits of these data on a window are positive on its square.
bool SectorMap::is_positive(const std::vector<Interval>& data) const {
  if (ring_.fits) return AffineFit(*ring_.fits, data, intervals_).least() > 0;
  return std::ranges::all_of(data, [](const Interval& x) { return x.low > 0; });
}

bool SectorMap::has_jacobian_by_fits(const Point& corner, bool positive) {
  std::vector<Interval> parts[2];
  for (const Turning& z : data_on(ring_.window, corner, {})) {
    parts[0].push_back(z.a);
    parts[1].push_back(z.b);
  }
  const AffineFit a(*ring_.fits, parts[0], intervals_), b(*ring_.fits, parts[1], intervals_);
  return has_sign(intervals_.times(a.slope(0), b.slope(1)) - intervals_.times(b.slope(0), a.slope(1)), positive);
}

bool SectorMap::has_jacobian(const Point& corner, bool positive) {
  if (ring_.fits) return has_jacobian_by_fits(corner, positive);
  const std::vector<Turning> along_x = data_on(ring_.differences[0], corner, {1, 0, 0}),
                             along_y = data_on(ring_.differences[1], corner, {0, 1, 0});
  return std::ranges::all_of(along_x, [&](const Turning& u) {
    return std::ranges::all_of(along_y, [&](const Turning& v) {
      return has_sign(intervals_.times(u.a, v.b) - intervals_.times(u.b, v.a), positive);
    });
  });
}

/// Where a square is known to be ahead, its parts are.
bool SectorMap::shows(const Point& corner, std::size_t level, std::size_t cuts, bool ahead) {
  arithmetic_.spend(1000);
  ahead = ahead || is_ahead_on(corner, level);
  if (ahead && has_jacobian(corner, true)) return true;
  if (level == cuts) return false;
  const std::int64_t m = mask_.arity;
  for (std::int64_t x = 0; x < m; ++x)
    for (std::int64_t y = 0; y < m; ++y)
      if (!shows({m * corner[0] + x, m * corner[1] + y, 0}, level + 1, cuts, ahead)) return false;
  return true;
}

/// On the ring of squares of sector 0 that all others come from, far enough from the vertex; all that is inside comes
/// from the points.
bool SectorMap::is_regular(std::size_t cuts) {
  powers_ = {{{intervals_.one(), intervals_.one()}, {0, 0}}};
  while (powers_.size() <= cuts) powers_.push_back(frequency_.times(powers_.back(), lambda_));
  const std::int64_t r = ring_.first, end = mask_.arity * r;
  for (std::int64_t x = end; x-- > 0;)  // the data furthest out are known least
    for (std::int64_t y = end; y-- > 0;)
      if (x < r && y < r)
        value_at({x, y, 0});
      else if (!shows({x, y, 0}, 0, cuts, false))
        return false;
  return true;
}

/// On each square some linear form of the map is positive: that of its datum at the corner.
bool SectorMap::has_no_zero_at(std::int64_t radius) {
  const auto has_no_zero_on = [&](const Point& corner) {
    arithmetic_.spend(1000);
    const Turning at = value_at(corner);
    std::vector<Interval> data;
    for (const Turning& z : data_on(ring_.window, corner, {})) data.push_back(frequency_.inner(at, z));
    return is_positive(data);
  };
  for (std::int64_t k = radius; k >= 0; --k)
    if (!has_no_zero_on({radius, k, 0}) || !has_no_zero_on({k, radius, 0})) return false;
  return true;
}

}  // namespace subcert_check
