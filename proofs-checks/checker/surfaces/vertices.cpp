#include "vertices.hpp"

#include "letters.hpp"
#include "sector_map.hpp"

#include <algorithm>
#include <set>

namespace subcert_check {
namespace {

constexpr std::size_t max_points = 16, max_halvings = 16, max_frequency = 8;
constexpr int finest = 512;  // parts of 1 of the cosines of frequencies

/// cos(k t) as a polynomial in cos t = c.
LetterPolynomial cosine_of(std::size_t k, Arithmetic& arithmetic) {
  LetterPolynomial before{{{}, 1}}, cosine = letter(letter_c);
  if (k == 0) return before;
  for (; k > 1; --k)
    before = std::exchange(cosine,
                           times(letter(letter_c, 2), cosine, arithmetic) + times({{{}, -1}}, before, arithmetic));
  return cosine;
}

/// All valences from one on: what is proved of the eigenvalues and the map for 1/n in intervals, one after another.
class Vertices {
 public:
  Vertices(const LatticeMask& mask, const SectorRules& rules, Reader& reader, const Fields& fields,
           Arithmetic& arithmetic)
      : mask_(mask),
        rules_(rules),
        reader_(reader),
        arithmetic_(arithmetic),
        intervals_(parse_size(fields[0], 64, 1024), arithmetic),
        halvings_(parse_size(fields[1], 0, max_halvings)),
        one_{intervals_.one(), intervals_.one()},
        ring_(mask, rules, std::nullopt) {
    near_ = intervals_.number(parse_rational(fields[2])).low;
  }

  void check() {
    points_ = read_points(reader_, rules_, max_points);
    turning_ = turning(points_, rules_);
    make_polynomials();
    show_between(0, 0);
  }

 private:
  using Polynomials = std::vector<LetterPolynomial>;
  struct Box {
    Letters all, middle;
    bool from_zero;
  };

  /// Of the matrix of frequency k; nothing: of all that no rule names.
  Polynomials polynomial(std::optional<std::size_t> k) {
    const std::vector<Point>& points = k == std::size_t{0} ? points_ : turning_;
    const LetterPolynomial cosine = k ? cosine_of(*k, arithmetic_) : letter(letter_frequency);
    std::vector<std::vector<LetterTurning>> matrix(points.size(), std::vector<LetterTurning>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const SectorTerm& term : rule_at(mask_, rules_, points[i])) {
        const auto datum = std::ranges::find(points, term.at.point);
        if ((term.frequency && term.frequency != k) || (rules_.is_vertex(term.at.point) && k != std::size_t{0}))
          continue;
        require(datum != points.end(), "a rule of the points has data elsewhere");
        LetterTurning weight;
        for (std::size_t power = 0; power < term.weight.size(); ++power)
          if (term.weight[power] != 0)
            weight.a[{static_cast<unsigned>(power), 0, term.over_valence ? 1U : 0U}] = term.weight[power];
        weight = turned(weight, term.at.turn, cosine, arithmetic_);
        LetterTurning& entry = matrix[i][static_cast<std::size_t>(datum - points.begin())];
        entry = entry + weight;
      }
    if (k == std::size_t{0})  // w = 1
      for (auto& row : matrix)
        for (LetterTurning& entry : row) entry = {entry.a + entry.b, {}};
    return characteristic_polynomial(matrix, cosine, arithmetic_);
  }

  void make_polynomials() {
    std::set<std::size_t> named;
    bool rings = false, shares = false;
    meets_ = std::ranges::any_of(points_, [&](const Point& point) { return rules_.is_vertex(point); });
    for (const auto& [point, rule] : rules_.rules)
      for (const SectorTerm& term : rule) {
        rings = rings || term.frequency;
        shares = shares || term.over_valence;
        if (term.frequency) {
          require(*term.frequency <= max_frequency, "a frequency of a rule is too large");
          named.insert(*term.frequency);
        }
        // For n -> infinity the vertex stays, and no other point of the constants differs from one of frequency 1.
        if (rules_.is_vertex(point) ? !term.over_valence && !rules_.is_vertex(term.at.point)
                                    : term.frequency && *term.frequency < 2)
          meets_ = false;
      }
    may_be_one_ = rules_.lattice == SectorLattice::dual && !rings && !shares;
    grows_from_first_ = !named.contains(1);
    first_ = polynomial(1);
    general_ = polynomial(std::nullopt);
    constants_ = polynomial(0);
    for (std::size_t i = constants_.size() - 1; i-- > 0;) constants_[i] = constants_[i] + constants_[i + 1];
    constants_.erase(constants_.begin());  // without the factor x - 1
    for (const std::size_t k : named)
      if (k > 1) named_.push_back(polynomial(k));
  }

  /// Of all n with 1/n between k and k + 1 over 2^depth times the first one, in order from 0 on.
  void show_between(std::size_t k, std::size_t depth) {
    if (holds_on(box_of(k, depth))) return;
    require(depth < halvings_, "smoothness is not shown for all valences");
    show_between(2 * k, depth + 1);
    show_between(2 * k + 1, depth + 1);
  }

  Letters letters_on(const mpq_class& low, const mpq_class& high) const {
    const Interval cosine{intervals_.cosine(high).low, low == 0 ? intervals_.one() : intervals_.cosine(low).high};
    return {cosine, cosine, Interval{intervals_.number(low).low, intervals_.number(high).high}};
  }

  Box box_of(std::size_t k, std::size_t depth) const {
    const mpz_class parts = mpz_class(rules_.valence) << depth;
    const mpq_class low = ratio(k, parts), high = ratio(k + 1, parts), middle = (low + high) / 2;
    return {letters_on(low, high), letters_on(middle, middle), k == 0};
  }

  mpz_class start_of(const Polynomials& p, const Letters& middle, const mpz_class& near) const {
    return approach_zero(values(p, middle, intervals_), near, intervals_);
  }

  /// How a zero that zero_near() has found, where the slope is not 0, changes with a letter.
  Interval change(const Polynomials& p, Letter by, const Letters& at, const Interval& zero) const {
    return -quotient(value_at(derivatives(p, by, at, intervals_), zero, intervals_),
                     slope_at(values(p, at, intervals_), zero, intervals_), intervals_)
                .value();
  }

  /// And with 1/n: c changes by -2 pi sin(2 pi/n), between -40/n and 0.
  Interval slope(const Polynomials& p, const Letters& at, const Interval& zero) const {
    return change(p, letter_share, at, zero) +
           intervals_.times(change(p, letter_c, at, zero), {-40 * at[letter_share].high, 0});
  }

  bool constants_are_behind(const Box& box, const Interval& leader, bool& meets) const {
    const IntervalPolynomial p = values(constants_, box.all, intervals_);
    if (has_zeros_below(p, leader.low, intervals_)) {
      meets = false;
      return true;
    }
    if (!meets) return false;
    const auto zero = zero_near(p, start_of(constants_, box.middle, (leader.low + leader.high) / 2), intervals_);
    if (!zero || zero->low <= -leader.low || !has_zeros_below(deflated(p, *zero, intervals_), leader.low, intervals_))
      return false;
    return slope(first_, box.all, leader).low > slope(constants_, box.all, *zero).high;
  }

  bool grows_on(const Letters& at, const Letters& middle, const Interval& leader, mpz_class& near) const {
    const mpz_class start = start_of(general_, middle, near);
    const IntervalPolynomial p = values(general_, at, intervals_);
    const auto zero = zero_near(p, start, intervals_);
    if (!zero || zero->low <= 0 || !has_zeros_below(deflated(p, *zero, intervals_), leader.low, intervals_))
      return false;
    if (change(general_, letter_frequency, at, *zero).low <= 0) return false;
    near = start;
    return true;
  }

  /// All frequencies that no rule names: k from 2 on, so that their cosines are at most 2 c^2 - 1.
  bool general_is_behind(const Box& box, const Interval& leader) const {
    const Interval& c = box.all[letter_c];
    const mpz_class last = 2 * intervals_.times(c, c).high - intervals_.one();
    bool grows = grows_from_first_;
    mpz_class near = (leader.low + leader.high) / 2;
    std::vector<Interval> open{{-intervals_.one(), grows ? c.high : last}};
    while (!open.empty()) {
      const Interval part = open.back();
      open.pop_back();
      const mpz_class centre = (part.low + part.high) / 2;
      Letters at = box.all, middle = box.middle;
      at[letter_frequency] = part;
      middle[letter_frequency] = {centre, centre};
      if (grows && grows_on(at, middle, leader, near)) continue;
      if (part.low >= last || has_zeros_below(values(general_, at, intervals_), leader.low, intervals_)) {
        grows = false;
        continue;
      }
      if (finest * (part.high - part.low) < intervals_.one()) return false;
      open.push_back({part.low, centre});
      open.push_back({centre, part.high});
    }
    return true;
  }

  bool holds_on(const Box& box) {
    const mpz_class start = start_of(first_, box.middle, near_);
    const IntervalPolynomial p = values(first_, box.all, intervals_);
    const auto leader = zero_near(p, start, intervals_);
    if (!leader || leader->low <= 0 || !has_zeros_below(deflated(p, *leader, intervals_), leader->low, intervals_))
      return false;
    std::optional<Interval> growth = growth_;
    if (leader->high >= intervals_.one() || growth) {
      if (!may_be_one_ || (!box.from_zero && !growth)) return false;
      const Interval here = change(first_, letter_c, box.all, *leader);
      if (here.low <= 0) return false;
      growth = growth ? Interval{std::min(growth->low, here.low), std::max(growth->high, here.high)} : here;
    }
    bool meets = meets_;
    if (!general_is_behind(box, *leader) || !constants_are_behind(box, *leader, meets)) return false;
    for (const Polynomials& named : named_)
      if (!has_zeros_below(values(named, box.all, intervals_), leader->low, intervals_)) return false;
    if (!is_regular(box, *leader, growth)) return false;
    growth_ = growth;
    meets_ = meets;
    near_ = start;
    return true;
  }

  bool is_regular(const Box& box, const Interval& leader, const std::optional<Interval>& growth) const {
    const ValenceLetters at{box.all[letter_c], box.all[letter_share]};
    const Frequency frequency(at.cosine, intervals_);
    std::optional<NearOne> near_one;
    if (growth) {
      const mpz_class one = intervals_.one();
      const Interval two{2 * one, 2 * one};
      near_one = NearOne{two - (at.cosine + at.cosine), intervals_.over(*growth, two)};
    }
    auto values = map_on_points(frequency, at, leader, near_one);
    if (!values) return false;
    SectorMap map(mask_, rules_, ring_, at, frequency, intervals_, {leader, {0, 0}},
                  {intervals_.over(one_, leader), {0, 0}}, std::move(*values), near_one, arithmetic_);
    return map.is_regular(0);
  }

  /// z, by all equations A z = lambda z but the first one. It is 1 at the first point, 1 + w in the dual lattice.
  std::optional<std::map<Point, Turning>> map_on_points(const Frequency& frequency, const ValenceLetters& at,
                                                        const Interval& leader,
                                                        const std::optional<NearOne>& near_one) const {
    const std::size_t n = turning_.size(), size = 2 * (n - 1);
    const Interval nothing{0, 0}, half{intervals_.one() / 2, intervals_.one() / 2};
    const bool dual = rules_.lattice == SectorLattice::dual;
    const Turning first = near_one ? Turning{nothing, half} : Turning{one_, dual ? one_ : nothing};
    const auto turned = [&](const Turning& x, long turns) {
      return near_one ? frequency.turned_near_one(x, turns, near_one->delta) : frequency.turned(x, turns);
    };
    std::vector<std::vector<Interval>> system(size, std::vector<Interval>(size + 1));  // = the last column
    for (std::size_t i = 1; i < n; ++i) {
      Turning known{near_one ? near_one->decay : nothing, nothing};
      for (const SectorTerm& term : rule_at(mask_, rules_, turning_[i])) {
        if ((term.frequency && *term.frequency != 1) || rules_.is_vertex(term.at.point)) continue;
        const std::size_t j = static_cast<std::size_t>(std::ranges::find(turning_, term.at.point) - turning_.begin());
        const Interval weight = weight_at(term, at, intervals_);
        const Turning fixed = turned(j == 0 ? first : Turning{}, term.at.turn);
        known = known + frequency.scaled(weight, fixed);
        if (j == 0) continue;
        const Turning of_one[]{turned({one_, nothing}, term.at.turn), turned({nothing, one_}, term.at.turn)};
        for (std::size_t part = 0; part < 2; ++part) {
          const Turning image = frequency.scaled(weight, linear_part(of_one[part], fixed, near_one.has_value()));
          Interval &a = system[2 * i - 2][2 * j - 2 + part], &b = system[2 * i - 1][2 * j - 2 + part];
          a = a - image.a;
          b = b - image.b;
        }
      }
      for (std::size_t part = 0; part < 2; ++part) {
        Interval& diagonal = system[2 * i - 2 + part][2 * i - 2 + part];
        diagonal = diagonal + leader;
        system[2 * i - 2 + part][size] = part == 0 ? known.a : known.b;
      }
    }
    const auto solution = solved(std::move(system));
    if (!solution) return std::nullopt;
    std::map<Point, Turning> result;
    for (const Point& point : points_) result[point] = {};  // stays so at the vertex
    result[turning_[0]] = first;
    for (std::size_t i = 1; i < n; ++i) result[turning_[i]] = {(*solution)[2 * i - 2], (*solution)[2 * i - 1]};
    return result;
  }

  static Turning linear_part(const Turning& image, const Turning& of_nothing, bool affine) {
    return affine ? image - of_nothing : image;
  }

  /// By elimination, with the pivot furthest from 0.
  std::optional<std::vector<Interval>> solved(std::vector<std::vector<Interval>> rows) const {
    const std::size_t n = rows.size();
    const auto from_zero = [](const Interval& x) { return std::max(x.low, mpz_class(-x.high)); };
    for (std::size_t k = 0; k < n; ++k) {
      const auto pivot = std::max_element(
          rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(),
          [&](const auto& x, const auto& y) { return from_zero(x[k]) < from_zero(y[k]); });
      std::iter_swap(rows.begin() + static_cast<std::ptrdiff_t>(k), pivot);
      const Interval divisor = rows[k][k];
      for (std::size_t j = k; j <= n; ++j) {
        const auto entry = quotient(rows[k][j], divisor, intervals_);
        if (!entry) return std::nullopt;
        rows[k][j] = *entry;
      }
      for (std::size_t i = 0; i < n; ++i) {
        if (i == k) continue;
        const Interval factor = rows[i][k];
        for (std::size_t j = k; j <= n; ++j) rows[i][j] = rows[i][j] - intervals_.times(factor, rows[k][j]);
      }
    }
    std::vector<Interval> result;
    for (const auto& row : rows) result.push_back(row.back());
    return result;
  }

  const LatticeMask& mask_;
  const SectorRules& rules_;
  Reader& reader_;
  Arithmetic& arithmetic_;
  Intervals intervals_;
  std::size_t halvings_;
  Interval one_;
  MapRing ring_;
  std::vector<Point> points_, turning_;  // the second without the vertex
  Polynomials first_, general_, constants_;
  std::vector<Polynomials> named_;
  bool may_be_one_ = false, grows_from_first_ = false;
  // of the intervals so far
  mpz_class near_;                  // the leader
  bool meets_ = false;              // it grew away from the largest other eigenvalue of the constants
  std::optional<Interval> growth_;  // it tends to 1, and grows with c by so much
};

}  // namespace

void check_vertices(const LatticeMask& mask, const SectorRules& rules, Reader& reader, Arithmetic& arithmetic) {
  Vertices(mask, rules, reader, reader.take("vertices", 3, 3), arithmetic).check();
}

}  // namespace subcert_check
