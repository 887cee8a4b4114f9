#pragma once
/// What a scheme does, next to a vertex, to data that turn by a frequency from sector to sector. Inner header.

#include <subcert/analysis/symbol/masks/sector_rules.hpp>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace subcert::vertex {

/// Points of sector 0 with their rules, in lexicographic order, such that no rule has data elsewhere.
struct ClosedSet {
  std::map<LatticePoint, SectorRule> rules;
};

/// The smallest one that holds every point that depends on itself in one step or more: all points outside depend on
/// it, after finitely many steps, alone. Proof: docs/vertices.md.
ClosedSet smallest_closed_set(const SectorRules& rules);

/// The same points with other rules.
ClosedSet with_rules_of(const SectorRules& rules, ClosedSet set);

/// The point of the plane of sector 0 that is the mirror image of a point of it, (x, y) -> (y, x).
SectorPoint mirror_image(const LatticePoint& point, const SectorRules& rules);

/// Whether the rules are the same in all sectors: the mask is its own image under a turn by one sector, and the rule of
/// the vertex tells no sector from another. Exact.
bool turns_with_sectors(const SectorRules& rules);

/// Whether all rules are their own mirror images: those of the points, and the mask. Exact.
bool is_symmetric(const SectorRules& rules, const ClosedSet& set);

/// x + y w, w = exp(2 pi i k/n), with c = cos(2 pi k/n): w^2 = 2 c w - 1.
template <class Number>
struct Turning {
  Number x, y;

  Turning turned(long times, const Number& twice_cosine) const {
    Turning result = *this;
    for (; times > 0; --times) result = Turning{-result.y, result.x + twice_cosine * result.y};
    for (; times < 0; ++times) result = Turning{twice_cosine * result.x + result.y, -result.x};
    return result;
  }
  /// w times the conjugate.
  Turning mirrored() const { return {y, x}; }
  friend Turning operator+(const Turning& a, const Turning& b) { return {a.x + b.x, a.y + b.y}; }
  friend Turning operator-(const Turning& a, const Turning& b) { return {a.x - b.x, a.y - b.y}; }
  friend Turning operator*(const Number& factor, const Turning& a) { return {factor * a.x, factor * a.y}; }
};

/// A number of turns as one of least modulus.
inline long least_turns(long turns, long valence) { return 2 * turns > valence ? turns - valence : turns; }

/// The data of frequency k: z in sector t is w^t times z in sector 0. For 0 < k < n/2 those that are their own mirror
/// images, of which the others are i times: a real space on which the scheme has the eigenvalues of the frequency,
/// without the double count. For k = 0, n/2 all real data.
template <class Field>
class SectorBlock {
 public:
  using Number = typename Field::Number;
  using Matrix = std::vector<std::vector<Number>>;
  /// What an unknown is of z at its point: all of it, where w is real; z itself, which is real; u of z = u (1 + w); or
  /// x or y of z = x + y w, which also gives z at the mirror image.
  enum class Part { all, alone, with_next, x, y };
  struct Unknown {
    LatticePoint point;
    Part part;
  };

  /// Domain: 0 <= k <= n/2; rules that are symmetric. The field gives number(weight) and cosine(k).
  SectorBlock(const SectorRules& rules, const ClosedSet& set, long frequency, const Field& field)
      : rules_(rules), frequency_(frequency), field_(field), twice_cosine_(field.number(2) * field.cosine(frequency)) {
    name_unknowns(set);
    for (const auto& [point, place] : first_) {
      const std::vector<Turning<Number>> image = image_of(set.rules.at(point));
      matrix_.push_back(part(image, true));
      if (place == Place::both) matrix_.push_back(part(image, false));
    }
  }

  const Matrix& matrix() const { return matrix_; }
  std::size_t size() const { return unknowns_; }
  const Unknown& unknown(std::size_t i) const { return named_[i]; }

  /// z on the closed set, from the unknowns.
  std::map<LatticePoint, Turning<Number>> data(const std::vector<Number>& unknowns) const {
    std::map<LatticePoint, Turning<Number>> result;
    for (const auto& [point, form] : forms_) {
      Turning<Number> value = zero();
      for (std::size_t i = 0; i < unknowns_; ++i) value = value + unknowns[i] * form[i];
      result.emplace(point, value);
    }
    return result;
  }

  /// The new value by a rule, of values that are found by their points.
  template <class ValueAt>
  Turning<Number> value(const SectorRule& rule, const ValueAt& value_at) const {
    Turning<Number> sum = zero();
    for (const SectorTerm& term : rule.terms)
      sum = sum + field_.number(term.weight) * value_at(term.at.point).turned(turns_of(term.at.turn), twice_cosine_);
    for (const RingTerm& ring : rule.rings)
      if (ring.frequency == frequency_) sum = sum + field_.number(ring.weight) * value_at(ring.point);
    return sum;
  }

  long frequency() const { return frequency_; }
  const Number& twice_cosine() const { return twice_cosine_; }

 private:
  enum class Place { real, both };
  using Form = std::vector<Turning<Number>>;

  bool is_real() const { return frequency_ == 0 || 2 * frequency_ == rules_.valence; }
  long turns_of(long turn) const { return least_turns(turn, rules_.valence); }
  Turning<Number> zero() const { return {field_.number(0), field_.number(0)}; }

  /// Each orbit of the mirror has two unknowns, or one where it is one point. Where w is real, all points have one, but
  /// for the vertex, whose value does not turn.
  void name_unknowns(const ClosedSet& set) {
    std::vector<std::pair<LatticePoint, LatticePoint>> orbits;
    std::map<LatticePoint, long> turns;
    for (const auto& [point, rule] : set.rules) {
      const bool is_vertex = rules_.lattice != SectorLattice::dual && point == LatticePoint{0, 0};
      if (is_vertex && frequency_ != 0) {
        forms_[point] = {};
        continue;
      }
      const SectorPoint image = mirror_image(point, rules_);
      if (!is_real() && image.point < point) continue;
      const bool is_alone = is_real() || image.point == point;
      first_.emplace_back(point, is_alone ? Place::real : Place::both);
      unknowns_ += is_alone ? 1 : 2;
    }
    std::size_t next = 0;
    const Number one = field_.number(1);
    for (auto& [point, form] : forms_) form.assign(unknowns_, zero());
    for (const auto& [point, place] : first_) {
      Form form(unknowns_, zero());
      const SectorPoint image = mirror_image(point, rules_);
      form[next].x = one;
      named_.push_back({point, is_real()              ? Part::all
                               : place == Place::both ? Part::x
                               : image.turn == 0      ? Part::with_next
                                                      : Part::alone});
      if (place == Place::both) {
        named_.push_back({point, Part::y});
        form[next + 1].y = one;
        Form other(unknowns_, zero());
        for (std::size_t i = next; i < next + 2; ++i)
          other[i] = form[i].mirrored().turned(-turns_of(image.turn), twice_cosine_);
        forms_[image.point] = std::move(other);
        ++next;
      } else if (!is_real() && image.turn == 0) {
        form[next].y = one;
      }
      ++next;
      forms_[point] = std::move(form);
    }
  }

  Form image_of(const SectorRule& rule) const {
    Form result;
    for (std::size_t i = 0; i < unknowns_; ++i)
      result.push_back(value(rule, [&](const LatticePoint& point) { return forms_.at(point)[i]; }));
    return result;
  }

  /// Where w is real, x + y w is one number.
  std::vector<Number> part(const Form& image, bool first) const {
    std::vector<Number> row;
    for (const Turning<Number>& entry : image)
      row.push_back(!first ? entry.y : !is_real() ? entry.x : frequency_ == 0 ? entry.x + entry.y : entry.x - entry.y);
    return row;
  }

  SectorRules rules_;
  long frequency_;
  Field field_;
  Number twice_cosine_;
  std::size_t unknowns_ = 0;
  std::vector<Unknown> named_;
  std::vector<std::pair<LatticePoint, Place>> first_;
  std::map<LatticePoint, Form> forms_;
  Matrix matrix_;
};

}  // namespace subcert::vertex
