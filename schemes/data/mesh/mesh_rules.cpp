#include "mesh_rules.hpp"

#include <subcert/analysis/limit/limit_values.hpp>
#include <subcert/analysis/symbol/matrices/ball_solvers.hpp>
#include <subcert/analysis/symbol/numbers/balls.hpp>
#include <subcert/analysis/symbol/numbers/interval.hpp>
#include <subcert/analysis/symbol/support/error.hpp>
#include <subcert/analysis/vertex/sector_block.hpp>
#include <subcert/schemes/specification.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace subcert::data {
namespace {

const LatticePoint centre{0, 0}, ray{1, 0}, diagonal{1, 1};

double rounded(const Interval& value) { return ((value.lower + value.upper) / 2).convert_to<double>(); }

/// The weights of a rule by their places.
class RuleWeights {
 public:
  RuleWeights(const SectorRule& rule, const SectorRules& rules) : valence_(rules.valence) {
    for (const auto& [at, weight] : weights_at(rule, rules.lattice, rules.valence))
      weights_.emplace(at, Interval::of(weight));
  }
  Interval at(const LatticePoint& point, long turn = 0) const {
    const auto found = weights_.find({point, point == centre && turn == 0 ? 0 : (turn + valence_) % valence_});
    return found == weights_.end() ? Interval::exactly(0) : found->second;
  }
  /// Of all sectors.
  Interval sum(const LatticePoint& point) const {
    Interval result = Interval::exactly(0);
    for (const auto& [at, weight] : weights_)
      if (at.point == point) result = result + weight;
    return result;
  }
  std::vector<double> ring(const LatticePoint& point) const {
    std::vector<double> result;
    for (long turn = 0; turn < valence_; ++turn) result.push_back(rounded(at(point, turn)));
    return result;
  }

 private:
  long valence_;
  std::map<SectorPoint, Interval> weights_;
};

SectorRule vertex_rule(const SectorRules& rules, MeshSplit split) {
  return split == MeshSplit::middles ? sqrt3_vertex_rule() : rules.rule_at(centre);
}

}  // namespace

std::vector<std::string> schemes_with_mesh_rules() {
  std::vector<std::string> names = schemes_with_vertex_rules();
  // Data beyond the faces at a point; faces that are cut in two.
  std::erase_if(names, [](const std::string& name) { return name == "kobbelt" || name == "four-eight"; });
  return names;
}

bool has_mesh_rules(const std::string& specification) {
  const std::vector<std::string> names = schemes_with_mesh_rules();
  return std::ranges::find(names, specification.substr(0, specification.find(':'))) != names.end();
}

MeshRules::MeshRules(VertexScheme scheme, bool is_checked) : scheme_(std::move(scheme)), is_checked_(is_checked) {
  if (!is_checked_)
    require(has_mesh_rules(specification()), "{}: on meshes a scheme is one of {}", specification(),
            fmt::join(schemes_with_mesh_rules(), ", "));
  const auto lattice = scheme_.written ? scheme_.written->lattice : scheme_.at(4).lattice;
  fits_data_ = !scheme_.written && specification().starts_with("triangular");
  if (!scheme_.written && specification().starts_with("sqrt3"))
    split_ = MeshSplit::middles;
  else if (lattice == SectorLattice::quads)
    split_ = MeshSplit::polygons;
  else if (lattice == SectorLattice::dual)
    split_ = MeshSplit::corners;
  has_edge_rules_ = split_ == MeshSplit::triangles && scheme_.written &&
                    std::ranges::find(scheme_.written->rules, ray, &WrittenRule::point) != scheme_.written->rules.end();
  // Regular vertices have the rules of the mask, whatever is written of others.
  const long regular = regular_valence(lattice);
  const SectorRules rules = scheme_.written ? SectorRules{regular, lattice, scheme_.written->mask}
                                            : scheme_.at(regular);
  if (is_checked_) require_regular(rules);
  if (is_checked_ && has_edge_rules_)
    for (const WrittenRule& rule : scheme_.written->rules)
      if (rule.point == ray && rule.covers(regular))
        fail(ErrorKind::data, "{}{}on meshes edges have the rule of the mask at valence {}; leave it out", rule.place,
             rule.place.empty() ? "" : ": ", regular);
  if (split_ == MeshSplit::corners) return;
  make_regular(rules);
  if (!fits()) make_boundary();
  if (is_checked_ && interpolates_ &&
      std::ranges::find(scheme_.written->rules, centre, &WrittenRule::point) != scheme_.written->rules.end())
    fail(ErrorKind::data, "{}: on meshes an interpolatory mask takes rules of edges, none of vertices",
         specification());
}

/// That the mask is of a split: around its regular vertices it takes the data of one, with weights of its symmetry.
void MeshRules::require_regular(const SectorRules& regular) const {
  using Weights = std::map<SectorPoint, LaurentPolynomial>;
  const long n = regular.valence;
  const auto has = [&](const LatticePoint& point, const std::vector<std::vector<SectorPoint>>& alike) {
    Weights weights;
    for (const SectorTerm& term : regular.rule_at(point).terms) weights[term.at] += term.weight;
    for (const std::vector<SectorPoint>& orbit : alike) {
      const LaurentPolynomial weight = weights[orbit.front()];
      for (const SectorPoint& at : orbit) weights[at] -= weight;
    }
    return std::ranges::all_of(weights, [](const auto& entry) { return entry.second.is_zero(); });
  };
  const auto ring = [&](const LatticePoint& point) {
    std::vector<SectorPoint> result;
    for (long t = 0; t < n; ++t) result.push_back({point, t});
    return result;
  };
  bool fits = regular.mask.arity() == 2;
  if (fits && split_ == MeshSplit::corners) {
    std::vector<std::vector<SectorPoint>> single;
    for (const SectorPoint& at : ring(centre)) single.push_back({at});
    fits = has(centre, single);
  } else if (fits) {
    const bool quads = split_ == MeshSplit::polygons;
    const std::vector<SectorPoint> ends{{centre}, {ray}}, beside{{ray, 1}, {ray, n - 1}},
        across{{diagonal}, {diagonal, n - 1}}, behind{{ray, 2}, {ray, n - 2}};
    const auto joined = [](std::vector<SectorPoint> a, const std::vector<SectorPoint>& b) {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    };
    const std::vector<SectorPoint> corners{{centre}, {ray}, {ray, 1}, {diagonal}};
    fits = quads ? has(centre, {{{centre}}, ring(ray), ring(diagonal)}) && has(ray, {ends, joined(beside, across)}) &&
                       has(diagonal, {corners})
                 : has(centre, {{{centre}}, ring(ray)}) && has(ray, {ends, beside, joined(behind, across)});
  }
  if (!fits)
    fail(ErrorKind::data, "{}: on meshes a mask is one as those of {} are", specification(),
         fmt::join(schemes_with_mesh_rules(), ", "));
}

/// The same of rules that are written down, at one valence.
void MeshRules::require_known_data(const SectorRules& rules) const {
  const std::string where = fmt::format("{}: valence {}", specification(), rules.valence);
  const auto require_data = [&](const LatticePoint& point, const std::vector<LatticePoint>& known) {
    for (const auto& [at, weight] : weights_at(rules.rule_at(point), rules.lattice, rules.valence))
      if (std::ranges::find(known, at.point) == known.end())
        fail(ErrorKind::data, "{}: on meshes the rule of the point {},{} takes no data at {},{}", where, point[0],
             point[1], at.point[0], at.point[1]);
  };
  for (const auto& [point, rule] : rules.rules)
    if (point != centre && !(has_edge_rules_ && point == ray))
      fail(ErrorKind::data, "{}: on meshes the point {},{} has no rule of its own", where, point[0], point[1]);
  if (split_ == MeshSplit::corners)
    require_data(centre, {centre});
  else
    require_data(centre, split_ == MeshSplit::polygons ? std::vector{centre, ray, diagonal} : std::vector{centre, ray});
  if (has_edge_rules_ && rules.valence != regular_valence(rules.lattice)) require_data(ray, {centre, ray});
  if (!vertex::turns_with_sectors(rules) || !vertex::is_symmetric(rules, vertex::smallest_closed_set(rules)))
    fail(ErrorKind::data, "{}: need rules that turn with the sectors and are their own mirror images", where);
}

void MeshRules::make_regular(const SectorRules& rules) {
  interpolates_ = RuleWeights(vertex_rule(rules, split_), rules).at(centre) == Interval::exactly(1);
  if (split_ == MeshSplit::middles) {  // the middles of the triangles have a third of each corner
    spoke_centre_ = spoke_ = spoke_beside_ = 1.0 / 3;
    return;
  }
  if (fits()) return;
  const RuleWeights edge(rules.rule_at(ray), rules);
  spoke_centre_ = rounded(edge.at(centre));
  spoke_ = rounded(edge.at(ray));
  spoke_beside_ = rounded(edge.at(ray, 1));
  if (split_ == MeshSplit::triangles) {
    edge_ = {spoke_centre_, spoke_beside_, rounded(edge.at(ray, 2))};
  } else {
    // A face has a quarter of each of its corners, those at the edge lie in two.
    spoke_face_ = rounded(edge.at(diagonal));
    edge_ = {spoke_centre_ - 2 * spoke_face_, 4 * spoke_face_};
  }
}

void MeshRules::make_boundary() {
  if (interpolates_) {  // the rule of four points
    const double outer = edge_.wing, end = 0.5 - outer;
    boundary_ = {1, 0, {outer, end, end, outer}, 1, 0};
    return;
  }
  const std::string arity = split_ == MeshSplit::middles ? ",a=3" : "";
  const Mask mask(make_linear_scheme("bspline:degree=3" + arity).mask.factors().front());
  const auto weight = [&](long at) { return mask.symbol().coefficient(at).convert_to<double>(); };
  const LimitValues limits = limit_values(mask, 0);
  const auto limit = [&](long at) { return limits.at(at).convert_to<double>(); };
  // Symmetric about 0, with a new point at each old one.
  const long a = mask.arity();
  boundary_ = {weight(0), weight(a), {weight(1 + a), weight(1), weight(1 - a), weight(1 - 2 * a)}, limit(0), limit(1)};
}

/// The left eigenvector of the eigenvalue 1 of vertex, mean of the neighbours, mean of those across faces.
VertexWeights MeshRules::limit_of(const SectorRules& rules) const {
  if (interpolates_) return {1, 0};
  if (fits()) return limit_of_fits(rules);
  const RuleWeights vertex(vertex_rule(rules, split_), rules);
  const Interval one = Interval::exactly(1), neighbours = vertex.sum(ray), faces = vertex.sum(diagonal);
  if (split_ != MeshSplit::polygons) {
    Interval own = Interval::exactly(Rational(2, 3));
    if (split_ == MeshSplit::triangles) {
      const RuleWeights edge(rules.rule_at(ray), rules);
      own = edge.sum(ray);
    }
    const Interval y = neighbours / (one - own), total = one + y;
    return {rounded(one / total), rounded(y / total)};
  }
  const RuleWeights edge(rules.rule_at(ray), rules), face(rules.rule_at(diagonal), rules);
  const Interval a = one - edge.sum(ray), b = edge.sum(diagonal), c = face.sum(ray), d = one - face.sum(diagonal);
  // a y - c z = neighbours, d z - b y = faces
  const Interval determinant = a * d - b * c, y = (neighbours * d + faces * c) / determinant,
                 z = (faces * a + neighbours * b) / determinant, total = one + y + z;
  return {rounded(one / total), rounded(y / total), rounded(z / total)};
}

/// The same of four means: of the vertex, its neighbours, those across an edge and those straight behind a neighbour.
/// No rule of theirs takes more (docs/mesh-fits.md).
VertexWeights MeshRules::limit_of_fits(const SectorRules& rules) const {
  constexpr slong bits = 128;
  const std::array<LatticePoint, 3> points{ray, diagonal, LatticePoint{2, 0}};
  const auto ball = [](const Interval& value) { return Ball::containing(value.enclosure(), bits); };
  const RuleWeights vertex(rules.rule_at(centre), rules);
  std::vector<std::vector<Ball>> system;
  std::vector<Ball> right;
  for (const LatticePoint& to : points) {
    right.push_back(ball(vertex.sum(to)));
    std::vector<Ball>& row = system.emplace_back();
    for (const LatticePoint& from : points)
      row.push_back(ball(Interval::exactly(from == to ? 1 : 0) - RuleWeights(rules.rule_at(from), rules).sum(to)));
  }
  const auto y = solve(system, right, bits);
  require(y.has_value(), "{}: its limits at valence {} were not found", specification(), rules.valence);
  const Ball total = (*y)[0] + (*y)[1] + (*y)[2] + 1;
  const auto share = [&](const Ball& part) { return rounded(Interval::of((part / total).enclosure(64))); };
  return {share(Ball(1, bits)), share((*y)[0]), share((*y)[1]), share((*y)[2])};
}

const std::vector<double>& MeshRules::fit(const MeshFan& fan, bool at_middle) {
  std::vector<double>& weights = fits_[{fan, at_middle}];
  if (weights.empty())
    for (const Enclosure& weight : fan_weights(specification(), fan, at_middle))
      weights.push_back(rounded(Interval::of(weight)));
  return weights;
}

const MeshRules::Kept& MeshRules::kept(std::size_t n) {
  if (n >= by_valence_.size()) by_valence_.resize(n + 1);
  Kept& result = by_valence_[n];
  if (result.is_made) return result;
  const SectorRules rules = scheme_.at(static_cast<long>(n));
  if (is_checked_) require_known_data(rules);
  if (split_ == MeshSplit::corners) {
    result.corner = RuleWeights(rules.rule_at(centre), rules).ring(centre);
  } else {
    const RuleWeights vertex(vertex_rule(rules, split_), rules);
    const Interval itself = vertex.at(centre), across = vertex.sum(diagonal);
    result.vertex = {rounded(itself), rounded(vertex.sum(ray))};
    if (split_ == MeshSplit::polygons)  // in the points in the faces, which have quarters of their corners
      result.vertex = {rounded(itself - across), rounded(vertex.sum(ray) - across * Rational(2)),
                       rounded(across * Rational(4))};
    result.limit = limit_of(rules);
    if (has_edge_rules()) {
      const RuleWeights edge(rules.rule_at(ray), rules);
      result.edge = edge.ring(ray);
      result.edge.insert(result.edge.begin(), rounded(edge.at(centre)));
    }
  }
  result.is_made = true;
  return result;
}

std::optional<TangentWeights> MeshRules::tangents(double angle) const {
  if (interpolates_ || fits() || has_edge_rules_ || split_ == MeshSplit::corners) return std::nullopt;
  const double cosine = std::cos(angle), own = spoke_ + 2 * spoke_beside_ * cosine;
  if (split_ != MeshSplit::polygons) return TangentWeights{own, 0};
  // (x - own) (x - quarter) = 2 quarter spoke_face (1 + cos), the larger root
  const double quarter = 0.25, half = (own + quarter) / 2, difference = (own - quarter) / 2;
  const double radius = half + std::sqrt(difference * difference + 2 * quarter * spoke_face_ * (1 + cosine));
  return TangentWeights{radius, spoke_face_ / (radius - quarter)};
}

std::pair<double, double> MeshRules::across_boundary(std::size_t faces) const {
  const double angle = std::numbers::pi / static_cast<double>(faces);
  if (faces == 1) return {-2, 1};  // the eigenvalue 1/4 of the boundary, whose second difference points inwards
  const TangentWeights inner = *tangents(angle);
  // Columns of the two neighbours on the boundary and of the vertex itself in the equation of the left eigenvector.
  double all_spokes = 0, all_faces = 0;
  for (std::size_t i = 0; i < faces; ++i) {
    const double here = std::sin(static_cast<double>(i) * angle), after = std::sin(static_cast<double>(i + 1) * angle);
    all_spokes += here;
    all_faces += inner.faces * (here + after);
  }
  const double quarter = split_ == MeshSplit::polygons ? 0.25 : 0;
  const double ends = (spoke_beside_ + quarter * inner.faces) * std::sin(angle);
  const double middle = spoke_centre_ * all_spokes + quarter * all_faces;
  // (r - end) l_0 - vertex_neighbour l_c = ends, (r - vertex) l_c - 2 end l_0 = middle
  const double a = inner.radius - boundary_.edge[1], d = inner.radius - boundary_.vertex,
               determinant = a * d - 2 * boundary_.edge[1] * boundary_.vertex_neighbour;
  return {(a * middle + 2 * boundary_.edge[1] * ends) / determinant,
          (d * ends + boundary_.vertex_neighbour * middle) / determinant};
}

}  // namespace subcert::data
