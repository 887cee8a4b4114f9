#include "characteristic_map.hpp"

#include "kernel_vector.hpp"

#include <subcert/analysis/reproduction/reproduction.hpp>
#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>

#include <algorithm>
#include <set>

namespace subcert::vertex {
namespace {

using Point = Turning<Ball>;

Ball determinant_of(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }

bool is_positive(const Ball& value) { return Ball(0, value.bits()).is_less(value); }

}  // namespace

CellForm::CellForm(const LatticeMask& mask, std::vector<LatticePoint> points)
    : window(std::move(points)),
      positive(vertex::is_positive(mask)),
      bound(sum_bound(mask, window)),
      slopes(window.size(), {Rational(0), Rational(0)}) {
  const PolynomialReproduction found = polynomial_reproduction(mask);
  affine = found.sum_rules >= 2;
  shift = found.parametrization;
  // The coordinates of the window about their means have these moments.
  const Rational count(static_cast<long>(window.size()));
  Rational mean[2] = {0, 0}, moments[2][2] = {{0, 0}, {0, 0}};
  for (const LatticePoint& k : window)
    for (std::size_t v = 0; v < 2; ++v) mean[v] += Rational(k[v]) / count;
  for (const LatticePoint& k : window)
    for (std::size_t v = 0; v < 2; ++v)
      for (std::size_t w = 0; w < 2; ++w) moments[v][w] += (Rational(k[v]) - mean[v]) * (Rational(k[w]) - mean[w]);
  const Rational det = moments[0][0] * moments[1][1] - moments[0][1] * moments[1][0];
  if (!affine || det == 0) return;
  for (std::size_t i = 0; i < window.size(); ++i) {
    const Rational s = Rational(window[i][0]) - mean[0], t = Rational(window[i][1]) - mean[1];
    slopes[i] = {(moments[1][1] * s - moments[0][1] * t) / det, (moments[0][0] * t - moments[1][0] * s) / det};
  }
}

CellForms::CellForms(const LatticeMask& of) : mask(of), values(of, window_of(of)) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (const auto derivative = derivative_mask(mask, axis))
      derivatives.emplace_back(*derivative, window_of(*derivative));
  if (derivatives.size() == 2 && derivatives[0].bound && derivatives[1].bound) return;
  derivatives.clear();
  for (std::size_t axis = 0; values.affine && axis < 2; ++axis)
    if (const auto bound = derivative_bound(mask, values.window, axis)) derivative_bounds.push_back(*bound);
}

std::optional<CharacteristicMap> CharacteristicMap::find(const SectorRules& rules, const ClosedSet& set,
                                                         const CellForms& forms, long frequency, const Ball& lambda,
                                                         const BallField& field) {
  const SectorBlock<BallField> block(rules, set, frequency, field);
  auto shifted = block.matrix();
  for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i][i] = shifted[i][i] - lambda;
  const auto vector = kernel_vector(shifted, field);
  if (!vector) return std::nullopt;
  return of_vector(rules, set, forms, frequency, lambda, *vector, field);
}

std::optional<CharacteristicMap> CharacteristicMap::find(const SectorRules& rules, const ClosedSet& set,
                                                         const CellForms& forms, const Leader::Share& share,
                                                         const Ball& lambda, const BallField& field) {
  if (2 * share.frequency >= rules.valence) return std::nullopt;
  if (share.vector.empty()) return find(rules, set, forms, share.frequency, lambda, field);
  std::vector<Ball> vector;
  for (const CosineField::Number& entry : share.vector) vector.push_back(field.number(entry.polynomial()));
  return of_vector(rules, set, forms, share.frequency, lambda, vector, field);
}

CharacteristicMap CharacteristicMap::of_vector(const SectorRules& rules, const ClosedSet& set, const CellForms& forms,
                                               long frequency, const Ball& lambda, const std::vector<Ball>& vector,
                                               const BallField& field) {
  CharacteristicMap result(rules, forms, frequency, lambda, field);
  result.known_ = SectorBlock<BallField>(rules, set, frequency, field).data(vector);
  // In the half plane of its sector, where it is in one.
  const long far = result.radius();
  const Point middle = result.data_at({far, far});
  if (!is_positive(middle.x + middle.y))
    for (auto& [point, value] : result.known_) value = {-value.x, -value.y};
  return result;
}

std::optional<CharacteristicMap> CharacteristicMap::find_near_one(const SectorRules& rules, const ClosedSet& set,
                                                                  const CellForms& forms, const Ball& lambda,
                                                                  const Ball& decay, const BallField& field) {
  // All data of a rule turn with w, and their weights sum to 1.
  const auto turns = [](const auto& entry) { return entry.second.rings.empty(); };
  const LatticePoint corner{0, 0};
  if (rules.lattice != SectorLattice::dual || !std::ranges::all_of(rules.rules, turns) || set.rules.count(corner) == 0)
    return std::nullopt;
  CharacteristicMap result(rules, forms, 1, lambda, field);
  const slong bits = field.bits();
  const Ball zero(0, bits), half(Rational(1) / 2, bits);
  result.near_one_ = NearOne{2 - field.cosine(1) * 2, decay};
  // The corner is its own mirror image, a positive multiple of 1 + w: rho = 0 and s = 1/2. The others are the fixed
  // point of an affine map, found from its values at 0 and at the unit vectors.
  std::vector<LatticePoint> points;
  for (const auto& [point, rule] : set.rules)
    if (point != corner) points.push_back(point);
  const auto image_of = [&](std::size_t one) {
    std::vector<Ball> image;
    result.known_ = {{corner, {zero, half}}};
    for (std::size_t i = 0; i < points.size(); ++i)
      result.known_[points[i]] = {Ball(2 * i == one ? 1 : 0, bits), Ball(2 * i + 1 == one ? 1 : 0, bits)};
    for (const LatticePoint& point : points) {
      const Point value = result.new_value(set.rules.at(point));
      image.push_back(value.x);
      image.push_back(value.y);
    }
    return image;
  };
  const std::size_t n = 2 * points.size();
  const std::vector<Ball> constant = image_of(n);
  std::vector<std::vector<Ball>> matrix(n, std::vector<Ball>(n, zero));
  for (std::size_t j = 0; j < n; ++j) {
    const std::vector<Ball> image = image_of(j);
    for (std::size_t i = 0; i < n; ++i) matrix[i][j] = Ball(i == j ? 1 : 0, bits) - (image[i] - constant[i]);
  }
  const auto solution = solve(matrix, constant, bits);
  if (!solution) return std::nullopt;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.known_[points[i]] = {(*solution)[2 * i], (*solution)[2 * i + 1]};
  return result;
}

Turning<Ball> CharacteristicMap::datum_turned(Turning<Ball> value, long times) const {
  if (!near_one_) return value.turned(times, block_.twice_cosine());
  // With e = w - 1 and e^2 = -delta (1 + e).
  for (; times > 0; --times) {
    value.x = value.x - value.y;
    value.y = value.y + near_one_->delta * value.x + 1;
  }
  for (; times < 0; ++times) {
    value.y = value.y - near_one_->delta * value.x - 1;
    value.x = value.x + value.y;
  }
  return value;
}

Turning<Ball> CharacteristicMap::new_value(const SectorRule& rule) const {
  const auto value_at = [&](const LatticePoint& datum) { return data_at(datum); };
  if (!near_one_) return inverse_ * block_.value(rule, value_at);
  Point sum{near_one_->decay, Ball(0, field_.bits())};
  for (const SectorTerm& term : rule.terms)
    sum = sum +
          field_.number(term.weight) * datum_turned(value_at(term.at.point), least_turns(term.at.turn, rules_.valence));
  return inverse_ * sum;
}

Turning<Ball> CharacteristicMap::data_at(const LatticePoint& point) const {
  const SectorPoint at = *in_sector(point, rules_.lattice, rules_.valence);
  auto known = known_.find(at.point);
  if (known == known_.end()) known = known_.emplace(at.point, new_value(rules_.rule_at(at.point))).first;
  return datum_turned(known->second, least_turns(at.turn, rules_.valence));
}

long CharacteristicMap::radius() const {
  long reach = 0, offset = 0, own = 0;
  for (const Monomial& term : rules_.mask.symbol().terms())
    for (const long e : term.exponents) reach = std::max(reach, std::abs(e));
  for (const LatticePoint& point : forms_.values.window)
    for (const long e : point) offset = std::max(offset, std::abs(e));
  for (const auto& [point, rule] : rules_.rules) own = std::max(own, point[0] + point[1]);
  return reach + offset + own + 2;
}

bool CharacteristicMap::is_plane_on_ring() const {
  std::set<LatticePoint> points;
  const auto add_windows = [&](const CellForm& form) {
    for (const Cell& cell : ring())
      for (const LatticePoint& k : form.window)
        for (const LatticePoint& step : {LatticePoint{0, 0}, {1, 0}, {0, 1}})
          points.insert({cell.x + k[0] - step[0], cell.y + k[1] - step[1]});
  };
  add_windows(forms_.values);
  for (const CellForm& derivative : forms_.derivatives) add_windows(derivative);
  const long m = rules_.mask.arity();
  return std::ranges::all_of(points, [&](const LatticePoint& point) {
    const auto at = in_sector(point, rules_.lattice, rules_.valence);
    if (!at || rules_.rules.count(at->point) > 0) return false;
    std::map<SectorPoint, LaurentPolynomial> rest;  // the mask less the rule
    for (const LatticeMask::Term& term : rules_.mask.terms()) {
      const long x = point[0] - term.exponents[0], y = point[1] - term.exponents[1];
      if (x % m != 0 || y % m != 0) continue;
      const auto datum = in_sector({x / m, y / m}, rules_.lattice, rules_.valence);
      if (!datum) return false;
      rest[*datum] += term.coefficient;
    }
    for (const SectorTerm& term : rules_.rule_at(at->point).terms)
      rest[turned(term.at, at->turn, rules_.lattice, rules_.valence)] -= term.weight;
    return std::ranges::all_of(rest, [](const auto& entry) { return entry.second.is_zero(); });
  });
}

std::vector<CharacteristicMap::Cell> CharacteristicMap::ring() const {
  const long r = radius();
  std::vector<Cell> cells;
  for (long x = r; x < rules_.mask.arity() * r; ++x)
    for (long y = 0; y <= x; ++y) cells.push_back({x, y, 0});
  return cells;
}

std::vector<CharacteristicMap::Cell> CharacteristicMap::children(const Cell& cell) const {
  const long m = rules_.mask.arity();
  std::vector<Cell> result;
  for (long a = 0; a < m; ++a)
    for (long b = 0; b < m; ++b)
      if (m * cell.y + b <= m * cell.x + a) result.push_back({m * cell.x + a, m * cell.y + b, cell.level + 1});
  return result;
}

std::vector<Point> CharacteristicMap::data_on(const Cell& cell, const CellForm& form, const LatticePoint& step) const {
  std::vector<Point> data;
  for (const LatticePoint& k : form.window) {
    const LatticePoint at{cell.x + k[0], cell.y + k[1]};
    data.push_back(step == LatticePoint{0, 0} ? data_at(at) : data_at(at) - data_at(at - step));
  }
  return data;
}

/// d_k = constant + slopes . k + a rest, k relative to the corner of the cell, of which |x| and |y| are at most these.
struct CharacteristicMap::Fit {
  Point constant, slopes[2];
  Ball rest_x, rest_y;
};

/// Any slopes will do; these are least squares.
CharacteristicMap::Fit CharacteristicMap::fitted(const CellForm& form, const std::vector<Point>& data) const {
  const slong bits = field_.bits();
  const Ball zero(0, bits);
  Fit fit{{zero, zero}, {{zero, zero}, {zero, zero}}, zero, zero};
  const auto with_slopes = [&](std::size_t i) {
    Point rest = data[i];
    for (std::size_t v = 0; v < 2; ++v) rest = rest - Ball(form.window[i][v], bits) * fit.slopes[v];
    return rest;
  };
  for (std::size_t i = 0; form.affine && i < data.size(); ++i)
    for (std::size_t v = 0; v < 2; ++v) fit.slopes[v] = fit.slopes[v] + Ball(form.slopes[i][v], bits) * data[i];
  Point low = with_slopes(0), high = low;
  for (std::size_t i = 1; i < data.size(); ++i) {
    const Point rest = with_slopes(i);
    low = {min(low.x, rest.x), min(low.y, rest.y)};
    high = {max(high.x, rest.x), max(high.y, rest.y)};
  }
  const Ball half(Rational(1) / 2, bits);
  fit.constant = half * (low + high);
  fit.rest_x = half * (high.x - low.x);
  fit.rest_y = half * (high.y - low.y);
  return fit;
}

Turning<Ball> CharacteristicMap::enclosed(const CellForm& form, const std::vector<Point>& data) const {
  const slong bits = field_.bits();
  const Fit fit = fitted(form, data);
  Point sum = fit.constant;
  const Ball half(Rational(1) / 2, bits), bound(*form.bound, bits);
  for (std::size_t v = 0; form.affine && v < 2; ++v)
    sum = sum + Ball(Rational(Rational(1) / 2 - form.shift[v]), bits).widened(half) * fit.slopes[v];
  return {sum.x.widened(bound * fit.rest_x), sum.y.widened(bound * fit.rest_y)};
}

Truth CharacteristicMap::jacobian_by_hulls(const Cell& cell) const {
  const std::vector<Point> along_x = data_on(cell, forms_.derivatives[0], {1, 0}),
                           along_y = data_on(cell, forms_.derivatives[1], {0, 1});
  bool positive = true, negative = true;
  for (const Point& u : along_x)
    for (const Point& v : along_y) {
      const Ball determinant = determinant_of(u, v);
      positive = positive && is_positive(determinant);
      negative = negative && is_positive(-determinant);
      if (!positive && !negative) return Truth::unknown;
    }
  return positive ? Truth::yes : Truth::no;
}

Truth CharacteristicMap::sign_of_jacobian(const Cell& cell) const {
  std::vector<Point> derivatives;
  if (!forms_.derivatives.empty()) {
    if (forms_.derivatives[0].positive && forms_.derivatives[1].positive)
      if (const Truth sign = jacobian_by_hulls(cell); sign != Truth::unknown) return sign;
    derivatives.push_back(enclosed(forms_.derivatives[0], data_on(cell, forms_.derivatives[0], {1, 0})));
    derivatives.push_back(enclosed(forms_.derivatives[1], data_on(cell, forms_.derivatives[1], {0, 1})));
  } else {
    const Fit fit = fitted(forms_.values, data_on(cell, forms_.values, {0, 0}));
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Ball bound(forms_.derivative_bounds[axis], field_.bits());
      derivatives.push_back(
          {fit.slopes[axis].x.widened(bound * fit.rest_x), fit.slopes[axis].y.widened(bound * fit.rest_y)});
    }
  }
  const Ball determinant = determinant_of(derivatives[0], derivatives[1]);
  return is_positive(determinant) ? Truth::yes : is_positive(-determinant) ? Truth::no : Truth::unknown;
}

Ball CharacteristicMap::values_on(const Cell& cell, const Rational& a, const Rational& b) const {
  const slong bits = field_.bits();
  const auto form = [&](const Point& at) { return Ball(a, bits) * at.x + Ball(b, bits) * at.y; };
  const std::vector<Point> data = data_on(cell, forms_.values, {0, 0});
  if (!forms_.values.positive) return form(enclosed(forms_.values, data));
  Ball hull = form(data.front());
  for (const Point& value : data) hull = join(hull, form(value));
  return hull;
}

Ball CharacteristicMap::half_plane_form_on(const Cell& cell) const {
  return near_one_ ? near_one_->delta * values_on(cell, 1, 0) + 1 : values_on(cell, 1, 1);
}

MapProof CharacteristicMap::prove(int most_levels) const {
  MapProof proof;
  if (!forms_.are_known()) {
    proof.regular.reason = "no bound of the derivatives of the basic limit function was found";
    return proof;
  }
  if (!is_plane_on_ring()) {
    proof.regular.reason = "the rules of the ring are not those of the mask in the plane";
    return proof;
  }
  const auto all = [&](const auto& holds_on) {
    std::vector<Cell> open = ring();
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      const bool holds = holds_on(cell);
      proof.levels = std::max(proof.levels, cell.level);
      ++proof.squares;
      if (holds) continue;
      if (cell.level == most_levels) return false;
      for (const Cell& child : children(cell)) open.push_back(child);
    }
    return true;
  };
  std::optional<Cell> positive, negative;
  const bool regular = all([&](const Cell& cell) {
    const Truth sign = sign_of_jacobian(cell);
    if (sign == Truth::yes && !positive) positive = cell;
    if (sign == Truth::no && !negative) negative = cell;
    return sign == Truth::yes || (sign == Truth::no && !positive);
  });
  std::optional<std::array<Cell, 2>> both;
  if (positive && negative)
    both = {*positive, *negative};
  else if (!regular)
    both = both_signs(most_levels);
  if (both) {
    proof.regular = {Truth::no, "the Jacobian of the characteristic map has both signs"};
    for (const Cell& cell : *both) proof.folds.push_back(small_part_of(cell));
  } else if (regular)
    proof.regular = {Truth::yes, "the Jacobian of the characteristic map is not 0"};
  else
    proof.regular.reason = "the Jacobian of the characteristic map is not proved to keep its sign";
  if (!proof.regular.is_yes()) return proof;
  if (all([&](const Cell& cell) { return is_positive(half_plane_form_on(cell)); }))
    proof.half_plane = {Truth::yes, "each sector is mapped into a half plane"};
  else
    proof.half_plane.reason = "a sector is not proved to be mapped into a half plane";
  return proof;
}

LatticePoint CharacteristicMap::small_part_of(const Cell& cell) const {
  const long m = rules_.mask.arity();
  LatticePoint corner{cell.x, cell.y};
  for (bool is_near = true; is_near; is_near = std::max(corner[0], corner[1]) < far())
    for (long& x : corner) x = m * x + m / 2;
  return corner;
}

auto CharacteristicMap::both_signs(int most_levels) const -> std::optional<std::array<Cell, 2>> {
  const std::vector<Cell> first = ring();
  std::deque<Cell> open(first.begin(), first.end());
  std::optional<Cell> positive, negative;
  for (int left = 8 << most_levels; left > 0 && !open.empty(); --left) {
    const Cell cell = open.front();
    open.pop_front();
    const Truth sign = sign_of_jacobian(cell);
    if (sign == Truth::yes) positive = cell;
    if (sign == Truth::no) negative = cell;
    if (positive && negative) return std::array<Cell, 2>{*positive, *negative};
    if (sign != Truth::unknown || cell.level == most_levels) continue;
    for (const Cell& child : children(cell)) open.push_back(child);
  }
  return std::nullopt;
}

auto CharacteristicMap::side(long place) -> std::deque<Cell> {
  std::deque<Cell> cells;
  for (long y = 0; y <= place; ++y) cells.push_back({place, y, 0});
  return cells;
}

std::optional<ClosedCurve> CharacteristicMap::winds(int most_levels) const {
  if (!forms_.values.bound || !is_plane_on_ring()) return std::nullopt;
  const long r = radius(), m = rules_.mask.arity();
  // Along the squares of one radius: those of the ring with x = m r - 1, and their mirror images.
  if (has_no_zero(side(m * r - 1), most_levels)) return ClosedCurve{m * r - 1, false};
  if (block_.frequency() != 0) return std::nullopt;
  // A real map may have zeros along some curves: others of the ring, and those with x + y = s.
  for (long x = r; x + 1 < m * r; ++x)
    if (has_no_zero(side(x), most_levels)) return ClosedCurve{x, false};
  for (long s = 2 * r; s < 2 * m * r; ++s) {
    std::deque<Cell> cells;
    for (long y = 0; 2 * y <= s; ++y) cells.push_back({s - y, y, 0});
    if (has_no_zero(std::move(cells), 0)) return ClosedCurve{s, true};
  }
  return std::nullopt;
}

std::optional<long> CharacteristicMap::winds_by_small_squares(const ClosedCurve& curve) const {
  const long m = rules_.mask.arity(), most = 8 * far();
  for (long x = m * curve.place + m / 2; x <= most; x = m * x + m / 2)
    if (x >= far() && has_no_zero(side(x), 0)) return x;
  return std::nullopt;
}

bool CharacteristicMap::has_values() const {
  if (!forms_.values.bound || !is_plane_on_ring()) return false;
  const std::vector<Cell> cells = ring();
  return std::ranges::any_of(cells, [&](const Cell& cell) { return has_no_zero({cell}, 0); });
}

bool CharacteristicMap::has_no_zero(std::deque<Cell> open, int most_levels) const {
  while (!open.empty()) {
    const Cell cell = open.front();
    open.pop_front();
    // Some linear form of F keeps its sign: that of the values at the corner.
    const Point at = data_at({cell.x, cell.y});
    Rational a(at.x.middle()), b(at.y.middle());
    if (block_.frequency() == 0) a = b = a + b;  // w is 1, and F real
    if (is_positive(values_on(cell, a, b))) continue;
    if (cell.level == most_levels) return false;
    for (const Cell& child : children(cell)) open.push_back(child);
  }
  return true;
}

}  // namespace subcert::vertex
